#include "bench/report_command.hpp"

#include "bench/report/performance_page.hpp"
#include "bench/support/build_info.hpp"
#include "bench/support/files.hpp"
#include "bench/support/result.hpp"
#include "bench/usage_error.hpp"

#include <planetree/error.hpp>

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdio>
#include <filesystem>

namespace planetree::bench {

namespace fs = std::filesystem;

CLI::App* addReportCommand(CLI::App& app, ReportCommand& command) {
  CLI::App* const report =
      app.add_subcommand("report", "Renew the figures and plots of docs/performance.md");
  report
      ->add_option("json", command.json,
                   "Results of rivals and render; of what is in several files, the last one counts")
      ->required()
      ->type_name("FILE");
  report
      ->add_option("--page", command.page,
                   "Page to change between its lines <!-- figures: begin --> and "
                   "<!-- figures: end -->; the rest of it stays")
      ->required()
      ->type_name("FILE");
  report->add_option("--plots", command.plots, "Folder to write the plots to")
      ->required()
      ->type_name("FOLDER");
  report->add_option("--machine", command.machine,
                     "What the results were measured on, if it was not this machine");
  return report;
}

namespace {

std::vector<Result> resultsOf(const std::vector<std::string>& files) {
  std::vector<Result> all;
  for (const std::string& file : files) {
    const auto results = resultsFromJson(readTextFile(file), file);
    if (results.empty()) {
      throw Error(ErrorCode::MalformedFile, "holds no results",
                  "Write it anew with planetree-bench rivals --json.", {.file = file});
    }
    all.insert(all.end(), results.begin(), results.end());
  }
  return all;
}

}  // namespace

int runReportCommand(const ReportCommand& command) {
  const std::vector<Result> results = resultsOf(command.json);
  const std::string page = readTextFile(command.page);
  // The page links to the plots from where it stands.
  const fs::path pageFolder = fs::absolute(command.page).parent_path();
  const fs::path folder = fs::proximate(command.plots, pageFolder);
  const std::string machineName = command.machine.empty() ? machine() : command.machine;
  const PerformanceFigures figures = performanceFigures(results, machineName, folder.string());
  const std::string renewed = withFigures(page, figures.markdown, command.page);
  for (const Plot& plot : figures.plots) {
    const fs::path file = fs::path(command.plots) / plot.name;
    writeWholeFile(file, plot.svg);
    fmt::print(stderr, "wrote {}\n", file.string());
  }
  writeWholeFile(command.page, renewed);
  fmt::print(stderr, "wrote {}\n", command.page);
  return kDone;
}

}  // namespace planetree::bench

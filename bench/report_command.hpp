#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace planetree::bench {

/// The options of `planetree-bench report`.
struct ReportCommand {
  std::vector<std::string> json;
  std::string page;
  std::string plots;
  std::string machine;
};

CLI::App* addReportCommand(CLI::App& app, ReportCommand& command);

/// Renews the figures of a page and the plots it shows; returns the exit status. Throws `Error`.
int runReportCommand(const ReportCommand& command);

}  // namespace planetree::bench

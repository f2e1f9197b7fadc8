#include "bench/render_command.hpp"

#include "bench/render/measure_pictures.hpp"
#include "bench/support/build_info.hpp"
#include "bench/support/files.hpp"
#include "bench/support/picture_tables.hpp"
#include "bench/support/talk.hpp"
#include "bench/usage_error.hpp"

#include <fmt/format.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <cstdio>

namespace planetree::bench {

namespace {

/// Each number once; 0 is all that the machine has.
std::vector<unsigned> distinctThreadCounts(const std::vector<unsigned>& asked) {
  std::vector<unsigned> counts;
  for (const unsigned number : asked) {
    const unsigned count = number == 0 ? hardwareThreads() : number;
    if (std::find(counts.begin(), counts.end(), count) == counts.end())
      counts.push_back(count);
  }
  return counts;
}

void addTo(std::vector<Result>& results, const std::vector<Result>& more) {
  results.insert(results.end(), more.begin(), more.end());
}

}  // namespace

CLI::App* addRenderCommand(CLI::App& app, RenderCommand& command) {
  CLI::App* const render = app.add_subcommand(
      "render", "Measure pictures with several numbers of threads, part by part");
  render
      ->add_option(
          "scenes", command.scenes,
          "Scenes and models to take pictures of, as planetree render does without options")
      ->required()
      ->type_name("SCENE");
  render
      ->add_option("--threads", command.threadCounts,
                   "Numbers of threads to measure with; 0 is all of the machine's")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(0u, 1024u))
      ->capture_default_str();
  render
      ->add_option("--repetitions", command.repetitions,
                   "Rounds in which each number of threads is measured once; the best counts")
      ->check(CLI::Range(1u, 1000u))
      ->capture_default_str();
  render->add_option("--width", command.width, "Width of the pictures")
      ->check(CLI::Range(1u, 10'000u))
      ->capture_default_str();
  render->add_option("--json", command.json, "File to write the results to; - is standard output")
      ->type_name("FILE");
  return render;
}

int runRenderCommand(const RenderCommand& command) {
  const bool writesJson = !command.json.empty();
  if (writesJson)
    checkIsWritable(command.json);
  for (const auto& file : command.scenes)
    checkIsReadable(file);
  warnOfUnfitMachine();

  const PictureSettings settings{.threadCounts = distinctThreadCounts(command.threadCounts),
                                 .rounds = command.repetitions,
                                 .width = command.width,
                                 .say = say};
  std::vector<Result> results;
  addTo(results, measureRayMesh(settings));
  for (const auto& file : command.scenes) {
    addTo(results, measurePicture(file, settings));
    // After each scene: what was measured stays if a later one fails.
    if (writesJson && isReplacedWhenWritten(command.json))
      writeWholeFile(command.json, toJson(results));
  }
  if (writesJson && !isReplacedWhenWritten(command.json))
    writeWholeFile(command.json, toJson(results));
  std::FILE* const place = command.json == kStandardOutput ? stderr : stdout;
  fmt::print(place, "{}", headLine());
  for (const Table& table : pictureTables(results))
    fmt::print(place, "\n{}", toText(table));
  return kDone;
}

}  // namespace planetree::bench

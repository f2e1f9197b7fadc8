#include "bench/render_command.hpp"
#include "bench/report_command.hpp"
#include "bench/rivals_command.hpp"
#include "bench/scene_command.hpp"
#include "bench/support/files.hpp"
#include "bench/usage_error.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace {

using namespace planetree::bench;

constexpr const char* kExamples = R"(Examples:
  planetree-bench rivals bunny.obj                            rays, with all engines there are
  planetree-bench rivals --measure build --json b.json *.ply  build times, kept
  planetree-bench rivals --measure batch --threads 1,2 *.ply  many rays in one call
  planetree-bench render scene.ray bunny.obj                  pictures, by numbers of threads
  planetree-bench scene terrain -o terrain.ply                a scene to measure with
)";

int run(int argc, char** argv) {
  CLI::App app("Measures planetree beside other libraries", "planetree-bench");
  app.footer(kExamples);
  app.require_subcommand(1);
  RivalsCommand rivals;
  RenderCommand render;
  SceneCommand scene;
  ReportCommand report;
  const CLI::App* const rivalsApp = addRivalsCommand(app, rivals);
  const CLI::App* const renderApp = addRenderCommand(app, render);
  const CLI::App* const sceneApp = addSceneCommand(app, scene);
  addReportCommand(app, report);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what(), "See planetree-bench --help, and COMMAND --help.");
  }
  if (rivalsApp->parsed())
    return runRivalsCommand(rivals);
  if (renderApp->parsed())
    return runRenderCommand(render);
  if (sceneApp->parsed())
    return runSceneCommand(scene);
  return runReportCommand(report);
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit is then an error of the write, which removes what is half-written.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int status = run(argc, argv);
    finishStandardOutput();
    return status;
  } catch (const UsageError& error) {
    fmt::print(stderr, "planetree-bench: {}\n", error.what());
    return kWrongUsage;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr,
               "planetree-bench: out of memory. Try a smaller scene, or fewer --engines.\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "planetree-bench: {}\n", error.what());
  }
  return kFailed;
}

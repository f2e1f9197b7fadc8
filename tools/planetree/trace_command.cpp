#include "trace_command.hpp"

#include "exit_status.hpp"
#include "json_text.hpp"
#include "model.hpp"
#include "progress_line.hpp"
#include "ray_files/byte_source.hpp"
#include "ray_files/ray_reader.hpp"
#include "talk.hpp"
#include "trace_rays.hpp"
#include "usage_error.hpp"

#include <planetree/error.hpp>

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace planetree::tool {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFooter = R"(Rays:
  CSV           ox,oy,oz,dx,dy,dz on each line, or on each with tMin,tMax
                besides; a header, blank lines and # comments may be there
  .npy          an N x 6 or N x 8 array; float32, or float64, which is traced
                in double
  Every t is in units of the direction's length. Rays with a NaN, an infinite
  origin or direction, or no direction are misses.

Hits, one for each ray, in their order:
  t,geometry,primitive,u,v,nx,ny,nz
                the primitive is the triangle, counted from 0; (u, v) are the
                weights of its second and third corner, (nx, ny, nz) its
                normal. A miss has t = inf and -1 for the ids
  hit           with --any: 1 or 0, in .npy a bool
  ray,t,...     with --all: a row for each hit, and none for a miss; the ray is
                counted from 0
  A .npy file is an array of records with these names.

Examples:
  planetree trace bunny.obj rays.csv
      what each ray hits first, on standard output
  planetree trace bunny.obj rays.npy -o hits.npy
      from NumPy and back: numpy.load("hits.npy")["t"]
  planetree trace room.ply rays.npy --any -o shadow.npy
      only whether there is a hit
  planetree trace part.stl rays.csv --all --crossings
      where each ray enters and leaves a closed part, edges counted once
  make-rays | planetree trace bunny.obj - --quiet | use-hits
      as a part of a pipeline

Exit status: 0 done, 1 failed, 2 wrong usage.
)";

std::string_view formatName(TableFormat format) noexcept {
  return format == TableFormat::Csv ? "csv" : "npy";
}

std::optional<TableFormat> formatOfName(const fs::path& path) {
  const std::string extension = lowerCaseExtension(path);
  if (extension == ".csv")
    return TableFormat::Csv;
  if (extension == ".npy")
    return TableFormat::Npy;
  return std::nullopt;
}

void refuseToReplace(const fs::path& input, std::string_view what, const fs::path& output) {
  std::error_code missing;
  if (fs::equivalent(input, output, missing) && fs::is_regular_file(output, missing)) {
    throw UsageError(fmt::format("-o {}: that is {}", output.string(), what),
                     "Give the hits another name.");
  }
}

void checkOptionsAgree(const TraceCommand& command) {
  checkRayLimits(command.limits);
  if (command.isAnyHit && command.isAllHits)
    throw UsageError("--any and --all: a ray has one answer, or many", "Leave out one of them.");
  if (command.model == kStandardInput && command.rays == kStandardInput) {
    throw UsageError("- twice: the model and the rays cannot both be standard input",
                     "Give one of them as a file.");
  }
  refuseToReplace(command.model, "the model", command.hits);
  refuseToReplace(command.rays, "the file of the rays", command.hits);
  const auto promised = formatOfName(command.hits);
  if (command.format && promised && *command.format != *promised) {
    throw UsageError(fmt::format("-o {}: --format {} is something else", command.hits.string(),
                                 formatName(*command.format)),
                     "Leave out --format, or change the name.");
  }
}

/// What was asked for; else what the name of the file promises; else the format of the rays.
TableFormat chosenFormat(const TraceCommand& command, const RayReader& rays) {
  if (command.format)
    return *command.format;
  return formatOfName(command.hits).value_or(rays.format());
}

/// Told before the model is read, so that nobody waits in vain.
void checkOutputTakes(TableFormat format, const TraceCommand& command, const RayReader& rays) {
  if (format == TableFormat::Csv)
    return;
  const bool isTerminal = command.hits == kStandardOutput && ::isatty(STDOUT_FILENO) == 1;
  if (isTerminal) {
    throw UsageError("standard output is a terminal, and .npy is not text",
                     "Write to a file with -o hits.npy, or give --format csv.");
  }
  if (canOverwriteStart(command.hits))
    return;
  if (command.isAllHits) {
    throw UsageError(
        "--format npy: such a table begins with its length, which is not known before all hits are "
        "found, and a pipe has no way back to its start",
        "Write to a file with -o hits.npy, or give --format csv.");
  }
  if (!rays.rayCount()) {
    throw UsageError(
        "--format npy: such a table begins with its length, which CSV rays do not tell beforehand, "
        "and a pipe has no way back to its start",
        "Write to a file with -o hits.npy, give .npy rays, or give --format csv.");
  }
}

RayQuery queryOf(const TraceCommand& command) noexcept {
  return command.isAnyHit    ? RayQuery::AnyHit
         : command.isAllHits ? RayQuery::AllHits
                             : RayQuery::ClosestHit;
}

std::string_view queryName(RayQuery query) noexcept {
  switch (query) {
    case RayQuery::AnyHit:
      return "any";
    case RayQuery::AllHits:
      return "all";
    default:
      return "closest";
  }
}

/// The run in numbers.
struct Summary {
  const TraceCommand& command;
  TableFormat format;
  bool isDouble;
  Json mesh;
  Json build;
  Json tree;
  TraceReport trace;
  double traceSeconds;
};

Json summaryJson(const Summary& summary) {
  const TraceCommand& command = summary.command;
  return {
      {"model", command.model.string()},
      {"rays", command.rays.string()},
      {"hits", command.hits.string()},
      {"format", formatName(summary.format)},
      {"query", queryName(queryOf(command))},
      {"precision", summary.isDouble ? "double" : "float"},
      {"mesh", summary.mesh},
      {"build", summary.build},
      {"tree", summary.tree},
      {"ray_count", summary.trace.rayCount},
      {"hit_count", summary.trace.hitCount},
      {"row_count", summary.trace.rowCount},
      {"invalid_ray_count", summary.trace.invalidRayCount},
      {"trace_seconds", summary.traceSeconds},
  };
}

void saySummary(const Talk& talk, const Summary& summary) {
  const TraceReport& trace = summary.trace;
  const double seconds = std::max(summary.traceSeconds, 1e-9);
  talk.say(fmt::format("traced {} in {}, {} hit, in {:.2f} s: {:.2f} million rays per second",
                       counted(trace.rayCount, "ray"), summary.isDouble ? "double" : "float",
                       grouped(trace.hitCount), summary.traceSeconds,
                       static_cast<double>(trace.rayCount) / seconds / 1e6));
  if (trace.invalidRayCount > 0) {
    talk.say(fmt::format("  {} can hit nothing: a number is not finite, or the direction is zero",
                         counted(trace.invalidRayCount, "ray")));
  }
  const fs::path& path = summary.command.hits;
  talk.say(fmt::format("wrote {} ({})", path == kStandardOutput ? "standard output" : path.string(),
                       byteText(trace.byteCount)));
}

/// Standard output carries the hits or the summary, never both.
bool isJsonOnStandardError(const TraceCommand& command) {
  return command.run.isJson && command.hits == kStandardOutput;
}

/// The ids of a table are 32-bit numbers with a sign.
void checkIdsFit(std::uint64_t triangleCount, const std::string& model) {
  if (triangleCount > std::numeric_limits<std::int32_t>::max()) {
    throw Error(ErrorCode::CapacityExceeded,
                fmt::format("has {}, and a table of hits can number 2^31 - 1",
                            counted(triangleCount, "triangle")),
                "Divide the model.", {.file = model});
  }
}

template <std::floating_point T>
int traceInto(TableFormat format, RayReader& rays, const TraceCommand& command, const Talk& talk) {
  Model<T> model = readModel<T>(command.model, talk);
  checkIdsFit(model.mesh.faces.size(), model.name);
  const MeshSize size{.faceCount = model.mesh.faces.size(),
                      .vertexCount = model.mesh.positions.size()};
  Json mesh = meshJson(size, model.report);
  const BuildOptions build = buildOptions(command.tree, command.run);
  const auto tree = buildModelTree(std::move(model), build, buildControl(command.run), talk);
  OutputFile hits(command.hits);

  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  TraceReport report;
  {
    ProgressLine progress("tracing", talk.showsProgress());
    report = traceRays(tree, rays, hits,
                       {.query = queryOf(command),
                        .options = command.query,
                        .limits = command.limits,
                        .format = format,
                        .threadCount = command.run.threadCount,
                        .reportProgress = [&](double done) { progress.update(done); }});
  }
  hits.complete();

  const Summary summary{
      .command = command,
      .format = format,
      .isDouble = std::same_as<T, double>,
      .mesh = std::move(mesh),
      .build = buildJson(build, tree.report()),
      .tree = treeJson(tree.statistics()),
      .trace = report,
      .traceSeconds = std::chrono::duration<double>(Clock::now() - start).count()};
  saySummary(talk, summary);
  if (command.run.isJson)
    printJson(summaryJson(summary), isJsonOnStandardError(command));
  return kDone;
}

void addTableOptions(CLI::App& app, TraceCommand& command) {
  addValue(app, "MODEL", command.model, parsePath,
           "Model to trace: PLY, STL, OBJ, OFF, glTF, COLLADA, FBX, 3DS or one of many others; "
           "- is standard input")
      ->required()
      ->type_name("");
  addValue(app, "RAYS", command.rays, parsePath,
           "Rays as CSV or .npy, told apart by content; - is standard "
           "input")
      ->required()
      ->type_name("");
  addValue(app, "-o,--output", command.hits, parsePath,
           "File for the hits, replacing an older one; - is standard "
           "output")
      ->type_name("FILE")
      ->default_str(kStandardOutput);
  addValue(app, "--format", command.format, parseTableFormat,
           "Format of the hits; otherwise as the name of the file "
           "says, or that of the rays")
      ->type_name("csv|npy");
}

}  // namespace

CLI::App* addTraceCommand(CLI::App& app, TraceCommand& command) {
  CLI::App& trace = *app.add_subcommand("trace", "Find what the rays of a file hit");
  trace.footer(kFooter);
  addTableOptions(trace, command);
  addQueryFlags(trace, command.isAnyHit, command.isDouble);
  trace
      .add_flag("--all", command.isAllHits,
                "Find every hit of a ray, each once, by distance and then by number")
      ->group("Query");
  addQueryOptions(trace, command.query);
  addRayLimits(trace, command.limits);
  addTreeOptions(trace, command.tree);
  addRunOptions(trace, command.run);
  addJsonOption(trace, command.run);
  return &trace;
}

int runTraceCommand(const TraceCommand& command) {
  checkOptionsAgree(command);
  checkIsWritable(command.hits);
  const std::unique_ptr<RayReader> rays = openRays(command.rays);
  const TableFormat format = chosenFormat(command, *rays);
  checkOutputTakes(format, command, *rays);
  // Talk beside the summary would keep programs from reading it.
  const Talk talk(command.run.isQuiet || isJsonOnStandardError(command));
  return command.isDouble || rays->isDouble() ? traceInto<double>(format, *rays, command, talk)
                                              : traceInto<float>(format, *rays, command, talk);
}

}  // namespace planetree::tool

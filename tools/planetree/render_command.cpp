#include "render_command.hpp"

#include "exit_status.hpp"
#include "interruption.hpp"
#include "output_file.hpp"
#include "picture_file.hpp"
#include "picture_metadata.hpp"
#include "picture_plan.hpp"
#include "progress_line.hpp"
#include "render_summary.hpp"
#include "subject.hpp"
#include "talk.hpp"

#include <planetree/error.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <string>

namespace planetree::tool {

namespace {

using Clock = std::chrono::steady_clock;

/// Standard output carries the picture or the summary, never both.
bool isJsonOnStandardError(const RenderCommand& command) {
  return command.run.isJson && isStandardOutput(command);
}

Subject buildWithProgress(const RenderCommand& command, const SubjectSource& source,
                          const Talk& talk) {
  ProgressLine line("building the tree", talk.showsProgress());
  BuildControl control = buildControl(command.run);
  control.onProgress = [&line](const BuildProgress& progress) { line.update(progress.done); };
  return source.build({.options = buildOptions(command.tree, command.run),
                       .control = control,
                       .query = {.cullsBackFaces = command.cullsBackFaces}});
}

/// What has been made so far takes the place of what was made before. That it cannot be written is
/// said in the end, if it is still so.
void writePreview(const FinishedPicture& picture) try {
  writeFile(outputPath(picture.command), encodePicture(picture).bytes);
} catch (const Error&) {
}

render::Rendering renderWithProgress(const RenderCommand& command, const Subject& subject,
                                     const PicturePlan& plan, const Talk& talk) {
  ProgressLine progress("rendering", talk.showsProgress());
  render::RenderSettings settings = renderSettings(command, subject, plan);
  settings.keepsGoing = [&progress](double done) {
    progress.update(done);
    return keptInterruption() == 0;
  };
  if (command.previewSeconds) {
    settings.previewSeconds = *command.previewSeconds;
    settings.onPreview = [&](const render::Rendering& soFar) {
      writePreview({command, subject, plan, soFar});
    };
  }
  return renderImage(*subject.tracer, settings);
}

/// "12 %"; nothing and everything are said only where they are true.
std::string percentText(double done) {
  if (done < 0.01)
    return "less than 1 %";
  return fmt::format("{:.0f} %", std::floor(std::min(100.0 * done, 99.0)));
}

std::string interruptedLine(const RenderCommand& command, const render::Rendering& rendering) {
  const std::string path = outputPath(command).string();
  if (rendering.isComplete)
    return fmt::format("planetree: interrupted, and {} is complete", path);
  return fmt::format("planetree: interrupted, and {} has {} of the picture", path,
                     percentText(rendering.done));
}

void writePicture(const FinishedPicture& picture, const Talk& talk) {
  const RenderCommand& command = picture.command;
  const Clock::time_point start = Clock::now();
  const PictureFile file = encodePicture(picture);
  writeFile(outputPath(command), file.bytes);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  talk.say(fmt::format("wrote {} ({} x {}, {})",
                       isStandardOutput(command) ? "standard output" : outputPath(command).string(),
                       file.size.width, file.size.height, byteText(file.bytes.size())));
  const RunTimes times = runTimes(picture, seconds);
  if (command.showsTimes)
    talk.say(timesText(times));
  if (command.run.isJson)
    printJson(summaryJson(picture, file, times), isJsonOnStandardError(command));
}

void sayView(const RenderCommand& command, const PicturePlan& plan, const Talk& talk) {
  const std::string up = command.up == render::UpAxis::Z ? " --up z" : "";
  if (plan.view)
    talk.say("view: the camera of the scene" + up);
  else
    talk.say("view: --camera " + cameraText(plan.camera) + up);
}

int renderSubject(const RenderCommand& command, const Subject& subject, const Talk& talk) {
  const PicturePlan plan = planPicture(command, subject);
  sayView(command, plan, talk);
  std::string line;
  {
    // A reader of standard output takes what it gets for the whole picture.
    std::optional<InterruptionDelay> delay;
    if (!isStandardOutput(command))
      delay.emplace();
    const render::Rendering rendering = renderWithProgress(command, subject, plan, talk);
    if (rendering.done > 0.0) {
      sayRendering(talk, plan.mode, rendering);
      writePicture({command, subject, plan, rendering}, talk);
      line = interruptedLine(command, rendering);
    }
  }
  endByKeptInterruption(line);
  return kDone;
}

}  // namespace

int runRenderCommand(const RenderCommand& command) {
  checkOptionsAgree(command);
  checkIsWritable(outputPath(command));
  // Talk beside the summary would keep programs from reading it.
  const Talk talk(command.run.isQuiet || isJsonOnStandardError(command));
  const SubjectSourcePtr source = readSource(command, talk);
  const Subject subject = buildWithProgress(command, *source, talk);
  source->sayBuilt(talk, subject);
  return renderSubject(command, subject, talk);
}

}  // namespace planetree::tool

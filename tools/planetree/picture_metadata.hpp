#pragma once

#include "picture_plan.hpp"
#include "render_command.hpp"
#include "subject.hpp"

#include "render/file/metadata.hpp"
#include "render/render_image.hpp"

#include <string>
#include <string_view>

namespace planetree::tool {

/// A picture that was made, and of what.
struct FinishedPicture {
  const RenderCommand& command;
  const Subject& subject;
  const PicturePlan& plan;
  const render::Rendering& rendering;
};

/// What the file of a picture says about it. Nothing in it depends on the machine, on the number of
/// threads or on the time of day; the time is there only if the environment variable
/// SOURCE_DATE_EPOCH gives one (https://reproducible-builds.org/specs/source-date-epoch/). Throws
/// `UsageError` if that is no time.
[[nodiscard]] render::Metadata pictureMetadata(const FinishedPicture& picture);

/// The command that makes the same picture again, wherever the file goes to.
[[nodiscard]] std::string reproducingCommand(const FinishedPicture& picture);

/// A word as a shell reads it back. It is always UTF-8 without control characters, whatever the
/// bytes of `text` are.
[[nodiscard]] std::string shellWord(std::string_view text);

/// Whether the text is UTF-8 and has no control characters.
[[nodiscard]] bool isPlainText(std::string_view text) noexcept;

}  // namespace planetree::tool

#pragma once

#include "picture_plan.hpp"
#include "render_command.hpp"
#include "subject.hpp"

#include "render/file/metadata.hpp"
#include "render/render_image.hpp"

#include <string>
#include <string_view>
#include <vector>

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

/// One tree of a contact sheet.
struct SheetTree {
  std::string preset;
  const Subject& subject;
};

/// What the file of a contact sheet says about it. `picture` is the first row's, `heatRange` what
/// the colours of all rows stand for, and `arguments` what `planetree compare` is asked for
/// besides. The times and speeds on the sheet are of the machine, and no other run has the very
/// same.
[[nodiscard]] render::Metadata sheetMetadata(const FinishedPicture& picture,
                                             const std::vector<SheetTree>& trees,
                                             const render::ValueRange& heatRange,
                                             std::string_view arguments);

/// The command that makes the same picture again, wherever the file goes to.
[[nodiscard]] std::string reproducingCommand(const FinishedPicture& picture);

/// A word as a shell reads it back. It is always UTF-8 without control characters, whatever the
/// bytes of `text` are.
[[nodiscard]] std::string shellWord(std::string_view text);

/// Whether the text is UTF-8 and has no control characters.
[[nodiscard]] bool isPlainText(std::string_view text) noexcept;

}  // namespace planetree::tool

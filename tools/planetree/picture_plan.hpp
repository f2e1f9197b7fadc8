#pragma once

#include "render_command.hpp"
#include "subject.hpp"

#include "render/camera.hpp"
#include "render/framing.hpp"
#include "render/image.hpp"
#include "render/render_image.hpp"
#include "scene/view.hpp"

#include <optional>

namespace planetree::tool {

/// What the command leaves to the subject, decided.
struct PicturePlan {
  render::RenderMode mode = render::RenderMode::AmbientOcclusion;
  render::ImageSize size;
  std::optional<scene::View> view;  ///< takes the place of `camera`
  render::Camera camera;

  /// The part that the file has, without a legend.
  [[nodiscard]] render::ImageSize fileSize(const RenderCommand& command) const noexcept {
    return command.crop ? command.crop->size : size;
  }
};

/// Throws `UsageError` for options that contradict each other, whatever the subject is.
void checkOptionsAgree(const RenderCommand& command);
/// The same, but not for those of the file and of heat.
void checkPictureOptions(const RenderCommand& command);

/// The scene, the model or the still life. Throws `Error` if it cannot be read, and `UsageError` if
/// it is found not to have what the options are about.
[[nodiscard]] SubjectSourcePtr readSource(const RenderCommand& command, const Talk& talk);

/// Throws `UsageError` if the crop window is not within the picture, or the tree has no cells to
/// draw.
[[nodiscard]] PicturePlan planPicture(const RenderCommand& command, const Subject& subject);

[[nodiscard]] render::RenderSettings renderSettings(const RenderCommand& command,
                                                    const Subject& subject,
                                                    const PicturePlan& plan);

}  // namespace planetree::tool

#pragma once

#include "render_command.hpp"
#include "subject.hpp"

#include "render/camera.hpp"
#include "render/framing.hpp"
#include "render/image.hpp"
#include "render/render_image.hpp"
#include "scene/scene_description.hpp"
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

/// Whether the materials of the subject are needed.
[[nodiscard]] bool wantsScene(const RenderCommand& command);

/// Throws `UsageError` for options that contradict each other, whatever the subject is.
void checkOptionsAgree(const RenderCommand& command);

/// The same, once it is known what the scene has. To be asked before long work.
void checkOptionsFit(const RenderCommand& command, const scene::SceneDescription& description);

/// How a subject without a camera is to be looked at.
[[nodiscard]] render::Framing framing(const RenderCommand& command);

/// What the command takes its picture of, in a tree. Throws `Error` if it cannot be read or has
/// nothing to show, and `UsageError` if the options do not fit it.
[[nodiscard]] Subject makeSubject(const RenderCommand& command, const Talk& talk);

/// Throws `UsageError` if the crop window is not within the picture, or the tree has no cells to
/// draw.
[[nodiscard]] PicturePlan planPicture(const RenderCommand& command, const Subject& subject);

[[nodiscard]] render::RenderSettings renderSettings(const RenderCommand& command,
                                                    const Subject& subject,
                                                    const PicturePlan& plan);

}  // namespace planetree::tool

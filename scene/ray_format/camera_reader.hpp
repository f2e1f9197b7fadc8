#pragma once

#include "scene/ray_format/token_reader.hpp"
#include "scene/view.hpp"

namespace planetree::scene::ray_format {

/// Reads the cameras of a scene. Each changes what it says and leaves the rest of the view.
class CameraReader {
 public:
  /// What stands behind "camera".
  void read(TokenReader& tokens);

  [[nodiscard]] const View& view() const noexcept { return view_; }

 private:
  struct Given;
  void turn(TokenReader& tokens, const Given& given);

  View view_;
  // The picture's frame: x to the right, y up, z to the viewer.
  Vec3d x_{1, 0, 0};
  Vec3d y_{0, 1, 0};
  Vec3d z_{0, 0, 1};
  double height_ = 1.0;
  double aspectRatio_ = 1.0;
  bool isFirst_ = true;
};

}  // namespace planetree::scene::ray_format

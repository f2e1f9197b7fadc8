#pragma once

namespace planetree::render {

/// A point of the plane.
struct Point2 {
  double x = 0.0;
  double y = 0.0;
};

}  // namespace planetree::render

#include "scene/ray_format/camera_reader.hpp"

#include "scene/affine.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace planetree::scene::ray_format {
namespace {

constexpr const BlockSyntax& kSyntax = blockNamed("camera");

/// Vectors of scenes have few digits; what is nearer than that to 1, or 0, is meant to be it.
constexpr double kTolerance = 1e-2;

struct PlacedVector {
  Vec3d value;
  TextPlace place;
};

struct PlacedQuaternion {
  std::array<double, 4> value;
  TextPlace place;
};

double positive(TokenReader& tokens, const Token& keyword, double limit,
                const std::string& expected) {
  tokens.expectEquals(keyword);
  const Token token = tokens.peek();
  const double value = tokens.number();
  if (!(value > 0.0 && value < limit))
    throw tokens.unexpected(token, expected, "Choose another " + std::string(keyword.text));
  return value;
}

void remarkUnlessUnit(TokenReader& tokens, const PlacedVector& vector, const std::string& name) {
  if (std::fabs(length(vector.value) - 1.0) > kTolerance) {
    tokens.remark(vector.place, "\"" + name +
                                    "\" does not have unit length; it is used as it is, which "
                                    "scales the picture");
  }
}

std::array<double, 4> unit(const std::array<double, 4>& q, double norm) {
  return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
}

}  // namespace

struct CameraReader::Given {
  std::optional<PlacedVector> viewdir;
  std::optional<PlacedVector> updir;
  std::optional<PlacedQuaternion> quaternion;
};

void CameraReader::read(TokenReader& tokens) {
  if (!isFirst_) {
    tokens.remark(tokens.peek().place,
                  "there is more than one camera; what the later one says counts");
  }
  isFirst_ = false;

  Given given;
  tokens.block(kSyntax, [&](const Token& keyword) {
    if (keyword.text == "position") {
      view_.eye = tokens.vectorOf(keyword);
    } else if (keyword.text == "viewdir") {
      given.viewdir = {tokens.vectorOf(keyword), keyword.place};
    } else if (keyword.text == "updir") {
      given.updir = {tokens.vectorOf(keyword), keyword.place};
    } else if (keyword.text == "quaternian") {
      tokens.expectEquals(keyword);
      given.quaternion = {tokens.fourNumbers(), keyword.place};
    } else if (keyword.text == "fov") {
      const double degrees = positive(tokens, keyword, 180.0, "an angle between 0 and 180 degrees");
      height_ = 2.0 * std::tan(degrees * std::numbers::pi / 360.0);
    } else {
      aspectRatio_ = positive(tokens, keyword, HUGE_VAL, "a ratio above 0");
    }
  });
  turn(tokens, given);

  view_.look = -z_;
  view_.u = x_ * (height_ * aspectRatio_);
  view_.v = y_ * height_;
}

void CameraReader::turn(TokenReader& tokens, const Given& given) {
  if (given.viewdir && !given.updir) {
    throw tokens.malformed(given.viewdir->place, "\"viewdir\" is given, but not \"updir\"",
                           "Give both, or neither");
  }
  if (given.updir && !given.viewdir) {
    throw tokens.malformed(given.updir->place, "\"updir\" is given, but not \"viewdir\"",
                           "Give both, or neither");
  }
  if (given.quaternion && given.viewdir) {
    throw tokens.malformed(given.quaternion->place,
                           "\"quaternian\" is given, and so are \"viewdir\" and \"updir\"",
                           "Give one or the other");
  }
  if (given.viewdir) {
    const PlacedVector& viewdir = *given.viewdir;
    const PlacedVector& updir = *given.updir;
    z_ = -viewdir.value;
    y_ = updir.value;
    x_ = cross(y_, z_);
    const double sine = length(cross(normalized(y_), normalized(z_)));
    if (!(sine > 0.0) || !isFinite(x_)) {
      throw tokens.malformed(viewdir.place,
                             "\"viewdir\" and \"updir\" are zero, parallel or too large",
                             "Choose two unit vectors at a right angle");
    }
    remarkUnlessUnit(tokens, viewdir, "viewdir");
    remarkUnlessUnit(tokens, updir, "updir");
    if (std::fabs(dot(normalized(y_), normalized(z_))) > kTolerance) {
      tokens.remark(viewdir.place,
                    "\"viewdir\" and \"updir\" are not perpendicular, which slants the picture");
    }
  }
  if (given.quaternion) {
    const std::array<double, 4>& q = given.quaternion->value;
    const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(norm > 0.0) || !std::isfinite(norm)) {
      throw tokens.malformed(given.quaternion->place, "\"quaternian\" is zero or too large",
                             "No rotation is (0, 0, 0, 1)");
    }
    if (std::fabs(norm - 1.0) > kTolerance)
      tokens.remark(given.quaternion->place,
                    "\"quaternian\" does not have unit length; it is made to");
    const Affine rotation = Affine::rotation(unit(q, norm));
    x_ = rotation.column(0);
    y_ = rotation.column(1);
    z_ = rotation.column(2);
  }
}

}  // namespace planetree::scene::ray_format

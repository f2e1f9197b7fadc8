#include "import/assimp/light_sender.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace planetree::importing {
namespace {

std::optional<LightKind> kindOf(const aiLight& light, bool isPhotometric) noexcept {
  switch (light.mType) {
    case aiLightSource_POINT:
      return isPhotometric ? LightKind::PhotometricPoint : LightKind::Point;
    case aiLightSource_DIRECTIONAL:
      return isPhotometric ? LightKind::PhotometricDirectional : LightKind::Directional;
    case aiLightSource_SPOT:
      return isPhotometric ? LightKind::PhotometricSpot : LightKind::Spot;
    case aiLightSource_AREA:
      return LightKind::Area;
    case aiLightSource_AMBIENT:
      return LightKind::Ambient;
    default:
      return std::nullopt;
  }
}

std::array<double, 3> numbersOf(const aiColor3D& colour) noexcept {
  return {static_cast<double>(colour.r), static_cast<double>(colour.g),
          static_cast<double>(colour.b)};
}

}  // namespace

const Placement* LightSender::placementOf(const aiString& name) const {
  for (const PlacedNode& placed : nodes_) {
    if (placed.node->mName == name)
      return &placed.placement;
  }
  writer_.say(MessageKind::Remark,
              std::string("there is no node for the light or camera ") + name.C_Str());
  return nullptr;
}

void LightSender::send(const aiLight& light) const {
  const std::optional<LightKind> kind = kindOf(light, isGltf_);
  if (!kind)
    return writer_.say(MessageKind::Remark, "a light of unknown kind is not read");
  const Placement* const placement = placementOf(light.mName);
  if (!placement)
    return;
  const bool isAmbient = *kind == LightKind::Ambient;
  const aiColor3D colour =
      isAmbient && !light.mColorAmbient.IsBlack() ? light.mColorAmbient : light.mColorDiffuse;
  writer_.say(MessageKind::Light, Payload()
                                      .add(*kind)
                                      .add(placement->point(light.mPosition))
                                      .add(placement->direction(light.mDirection))
                                      .add(numbersOf(colour))
                                      .add(static_cast<double>(light.mAttenuationConstant))
                                      .add(static_cast<double>(light.mAttenuationLinear))
                                      .add(static_cast<double>(light.mAttenuationQuadratic)));
}

void LightSender::send(const aiCamera& camera) const {
  if (camera.mOrthographicWidth > 0) {
    writer_.say(MessageKind::Remark, "an orthographic camera is not read");
    return;
  }
  const Placement* const placement = placementOf(camera.mName);
  if (!placement)
    return;
  auto angle = static_cast<double>(camera.mHorizontalFOV);
  const auto aspect = static_cast<double>(camera.mAspect);
  aiVector3D position = camera.mPosition;
  if (isGltf_) {
    // Two faults of assimp 5.2: the angle across is the one upward times the width divided by the
    // height, and the position, which the node has already, is told a second time.
    const double upward = aspect > 0 ? angle / aspect : angle;
    angle = 2 * std::atan(std::tan(upward / 2) * (aspect > 0 ? aspect : 1.0));
    position = aiVector3D();
  }
  writer_.say(MessageKind::Camera, Payload()
                                       .add(placement->point(position))
                                       .add(placement->direction(camera.mLookAt))
                                       .add(placement->direction(camera.mUp))
                                       .add(angle)
                                       .add(aspect));
}

}  // namespace planetree::importing

#include "subject.hpp"

#include "model.hpp"

#include "render/still_life.hpp"

#include <planetree/build_tree.hpp>

#include <utility>

namespace planetree::tool {

Subject readModelSubject(const std::filesystem::path& path, const BuildOptions& options,
                         const render::Framing& framing, const Talk& talk) {
  Model<float> model = readModel<float>(path, talk);
  // Before the tree: a mesh that cannot be shown has no camera either, and building says why.
  const auto camera = frameCamera(render::visiblePoints(model.mesh.view()), framing);
  auto tree = buildModelTree(std::move(model), options, talk);
  return {.tracer = std::make_unique<render::TreeTracer<Face<float>>>(std::move(tree)),
          .camera = camera.value_or(render::Camera{}),
          .albedos = {}};
}

Subject makeStillLifeSubject(const BuildOptions& options, const render::Framing& framing,
                             const Talk& talk) {
  const render::StillLife stillLife = render::makeStillLife();
  const auto camera = frameCamera(stillLife.outline, framing);
  auto tree = buildTree(stillLife.scene, options);
  talk.say("no model given: a still life of spheres, boxes, cones, cylinders, squares and a knot");
  sayTree(talk, tree.report(), tree.statistics(), "object");
  return {.tracer = std::make_unique<render::TreeTracer<AnyObject<float>>>(std::move(tree)),
          .camera = camera.value_or(render::Camera{}),
          .albedos = stillLife.albedos};
}

}  // namespace planetree::tool

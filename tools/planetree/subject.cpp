#include "subject.hpp"

#include "model.hpp"

#include "render/still_life.hpp"

#include <planetree/build_tree.hpp>

#include <utility>

namespace planetree::tool {

namespace {

template <Object O>
void takeTree(Subject& subject, KdTree<O> tree) {
  subject.options = tree.options();
  subject.report = tree.report();
  subject.statistics = tree.statistics();
  subject.tracer = std::make_unique<render::TreeTracer<O>>(std::move(tree));
}

}  // namespace

Subject readModelSubject(const std::filesystem::path& path, const BuildOptions& options,
                         const BuildControl& control, const render::Framing& framing,
                         const Talk& talk) {
  Model<float> model = readModel<float>(path, talk);
  Subject subject;
  subject.name = path.filename().string();
  // Before the tree: a mesh that cannot be shown has no camera either, and building says why.
  subject.camera =
      frameCamera(render::visiblePoints(model.mesh.view()), framing).value_or(render::Camera{});
  subject.mesh =
      meshJson({.faceCount = model.mesh.faces.size(), .vertexCount = model.mesh.positions.size()},
               model.report);
  takeTree(subject, buildModelTree(std::move(model), options, control, talk));
  return subject;
}

Subject makeStillLifeSubject(const BuildOptions& options, const BuildControl& control,
                             const render::Framing& framing, const Talk& talk) {
  render::StillLife stillLife = render::makeStillLife();
  talk.say("no model given: a still life of spheres, boxes, cones, cylinders, squares and a knot");
  Subject subject;
  subject.name = "still life";
  subject.camera = frameCamera(stillLife.outline, framing).value_or(render::Camera{});
  subject.albedos = std::move(stillLife.albedos);
  takeTree(subject, buildTree(stillLife.scene, options, control));
  sayTree(talk, subject.report, subject.statistics, "object");
  return subject;
}

}  // namespace planetree::tool

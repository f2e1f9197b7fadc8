#include "bench/rivals/engines.hpp"

#include <planetree/build_tree.hpp>

#include "traversal/count_wide_steps.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace planetree::bench {

namespace {

/// Plain rays in their order, and plain hits.
template <class O>
class PlanetreeBatch final : public Batch {
 public:
  PlanetreeBatch(const KdTree<O>& tree, const RaySet& set, std::size_t callSize)
      : tree_(tree), rays_(set.rays), asksForAnyHit_(asksForAnyHit(set.kind)), callSize_(callSize) {
    if (asksForAnyHit_)
      answers_.occluded.resize(rays_.size());
    else
      answers_.hits.resize(rays_.size());
  }

  void trace(unsigned threadCount) override {
    const BatchOptions options = {.threadCount = threadCount};
    for (std::size_t begin = 0; begin < rays_.size(); begin += callSize_) {
      const std::size_t count = std::min(callSize_, rays_.size() - begin);
      const auto rays = rays_.subspan(begin, count);
      if (asksForAnyHit_)
        tree_.areOccluded(rays, std::span(answers_.occluded).subspan(begin, count), options);
      else
        tree_.findIntersections(rays, std::span(answers_.hits).subspan(begin, count), options);
    }
  }

  void readAnswers(Answers& answers) const override { answers = answers_; }

 private:
  const KdTree<O>& tree_;
  std::span<const Rayf> rays_;
  bool asksForAnyHit_;
  std::size_t callSize_;
  Answers answers_;
};

template <class O>
class PlanetreeStructure final : public Structure {
 public:
  using T = ScalarOf<O>;

  explicit PlanetreeStructure(KdTree<O> tree) : tree_(std::move(tree)) {}

  void findIntersections(std::span<const Rayf> rays, std::span<Hitf> hits) const override {
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = inFloat(tree_.findIntersection(rayIn<T>(rays[i])).value_or(Hit<T>{}));
  }

  void findOcclusions(std::span<const Rayf> rays, std::span<std::uint8_t> occluded) const override {
    for (std::size_t i = 0; i < rays.size(); ++i)
      occluded[i] = tree_.isOccluded(rayIn<T>(rays[i])) ? 1 : 0;
  }

  /// The rays are in float: those of a tree of doubles are turned into doubles one by one.
  [[nodiscard]] std::unique_ptr<Batch> makeBatch(const RaySet& set,
                                                 std::size_t callSize) const override {
    if constexpr (std::is_same_v<T, float>)
      return std::make_unique<PlanetreeBatch<O>>(tree_, set, callSize);
    else
      return nullptr;
  }

  [[nodiscard]] Steps countSteps(std::span<const Rayf> rays, bool forAnyHit) const override {
    detail::WideSteps steps;
    if constexpr (std::is_same_v<T, float>) {
      for (const Rayf& ray : rays) {
        (forAnyHit ? detail::countStepsToAny : detail::countStepsToNearest)(tree_.view(), ray,
                                                                            steps);
      }
    }
    return {.nodes = steps.nodes, .blocks = steps.blocks};
  }

 private:
  KdTree<O> tree_;
};

template <class O>
std::unique_ptr<Structure> structureOf(KdTree<O> tree) {
  return std::make_unique<PlanetreeStructure<O>>(std::move(tree));
}

template <class T>
class PlanetreeEngine final : public Engine {
 public:
  PlanetreeEngine(std::string mode, BuildOptions options, bool isDefault)
      : mode_(std::move(mode)), options_(options), isDefault_(isDefault) {}

  [[nodiscard]] std::string name() const override { return "planetree"; }
  [[nodiscard]] std::string mode() const override { return mode_; }
  [[nodiscard]] bool isDefault() const override { return isDefault_; }
  [[nodiscard]] bool isExact() const override { return true; }
  [[nodiscard]] Precision precision() const override {
    return kIsFloat ? Precision::Float : Precision::Double;
  }
  /// Leaves name faces, and the triangle test looks their corners up. A tree of doubles looks into
  /// a copy of its own.
  [[nodiscard]] bool queriesReadMesh() const override { return kIsFloat; }
  /// The shapes of scenes are in float.
  [[nodiscard]] bool takesShapes() const override { return kIsFloat; }
  [[nodiscard]] bool takesBatches() const override { return kIsFloat; }
  [[nodiscard]] bool countsSteps() const override { return std::is_same_v<T, float>; }

  [[nodiscard]] std::unique_ptr<Structure> build(const SceneObjects& objects,
                                                 unsigned threadCount) const override {
    BuildOptions options = options_;
    options.threadCount = threadCount;
    if constexpr (kIsFloat)
      return objects.visit([&](auto input) { return structureOf(buildTree(input, options)); });
    else
      return structureOf(buildTree(meshIn<T>(*objects.mesh()), options));
  }

 private:
  static constexpr bool kIsFloat = std::is_same_v<T, float>;

  std::string mode_;
  BuildOptions options_;
  bool isDefault_;
};

}  // namespace

EngineList planetreeEngines() {
  EngineList engines;
  engines.push_back(
      std::make_unique<PlanetreeEngine<float>>("balanced-watertight", BuildOptions{}, true));
  return engines;
}

EngineList planetreeEnginesByName() {
  EngineList engines;
  for (const auto& [mode, options] : {std::pair("fast-watertight", BuildOptions::fast()),
                                      std::pair("high-watertight", BuildOptions::high()),
                                      std::pair("textbook-watertight", BuildOptions::textbook())})
    engines.push_back(std::make_unique<PlanetreeEngine<float>>(mode, options, false));
  engines.push_back(std::make_unique<PlanetreeEngine<double>>("balanced-watertight-float64",
                                                              BuildOptions{}, false));
  return engines;
}

}  // namespace planetree::bench

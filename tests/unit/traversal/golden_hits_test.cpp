#include "traversal/search_wide.hpp"

#include <planetree/planetree.hpp>

#include "support/brute_force.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// One number for the bits of some thousand hits. Every instruction set, compiler and machine must
/// give it: comparisons on one machine would not see if all of them went astray together.
///
/// The numbers stand for the answers, and answers never change: a new number says that a promise
/// was broken, or that the promise has changed, which docs/numerics.md must then say.
namespace planetree::detail {
namespace {

constexpr std::uint64_t kGoldenFloat = 0xB9240F1E15552C8B;
constexpr std::uint64_t kGoldenDouble = 0x69DD3C127820A38E;

constexpr std::size_t kRayCount = 1500;

/// Numbers from sums, products and quotients alone, whose bits the standards fix; never from the
/// mathematical library, whose last bit is each system's own.
class Numbers {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11u) * 0x1p-53);
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  template <class T>
  Vec3<T> point(double reach) {
    const double x = between(-reach, reach);
    const double y = between(-reach, reach);
    const double z = between(-reach, reach);
    return Vec3<T>(Vec3d{x, y, z});
  }

 private:
  std::mt19937_64 engine_{2'026u};
};

/// Some soup, and three sheets whose faces share edges and vertices, through the middle of it.
template <class T>
TriangleMesh<T> makeMesh(Numbers& numbers) {
  TriangleMesh<T> mesh;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Vec3<T> middle = numbers.point<T>(1.0);
    for (int corner = 0; corner < 3; ++corner)
      mesh.positions.push_back(middle + numbers.point<T>(0.2));
    mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  constexpr std::uint32_t kSide = 8;
  for (const Axis across : kAxes) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (std::uint32_t i = 0; i <= kSide; ++i) {
      for (std::uint32_t j = 0; j <= kSide; ++j) {
        const double u = 0.25 * i - 1.0;
        const double v = 0.25 * j - 1.0;
        Vec3d position{0.125, u, v};
        std::swap(position.x, position[across]);
        mesh.positions.push_back(Vec3<T>(position));
        if (i == kSide || j == kSide)
          continue;
        const std::uint32_t corner = first + i * (kSide + 1) + j;
        mesh.faces.push_back({corner, corner + 1, corner + kSide + 2});
        mesh.faces.push_back({corner, corner + kSide + 2, corner + kSide + 1});
      }
    }
  }
  return mesh;
}

template <class T>
using AnyShape = std::variant<Sphere<T>, Box<T>, Cylinder<T>, Cone<T>, Square<T>>;

template <class T>
std::vector<AnyShape<T>> makeShapes(Numbers& numbers) {
  std::vector<AnyShape<T>> shapes;
  for (int i = 0; i < 20; ++i) {
    const Vec3<T> place = numbers.point<T>(1.0);
    const Vec3<T> along = numbers.point<T>(0.3);
    const Vec3<T> aside = numbers.point<T>(0.3);
    const T size = static_cast<T>(numbers.between(0.02, 0.2));
    shapes.push_back(Sphere<T>{.center = place, .radius = size});
    shapes.push_back(Box<T>{.lower = along, .upper = along + Vec3<T>{size, size, T(0.1)}});
    shapes.push_back(Cylinder<T>{.base = aside, .axis = along, .radius = size});
    shapes.push_back(Cone<T>{.base = place, .axis = aside, .bottomRadius = size});
    shapes.push_back(Square<T>{.center = aside, .edgeU = along, .edgeV = aside});
  }
  return shapes;
}

/// Rays at random, at vertices and along the axes, some of them short.
template <class T>
std::vector<Ray<T>> makeRays(Numbers& numbers, const TriangleMesh<T>& mesh) {
  std::vector<Ray<T>> rays;
  for (std::size_t i = 0; i < kRayCount; ++i) {
    const Vec3<T> origin = numbers.point<T>(2.0);
    const Vec3<T> vertex = mesh.positions[numbers.below(mesh.positions.size())];
    Ray<T> ray{.origin = origin, .direction = numbers.point<T>(1.0)};
    if (i % 4 == 1)
      ray.direction = vertex - origin;
    if (i % 4 == 2) {
      ray.direction = {};
      ray.direction[kAxes[numbers.below(3)]] = i % 8 == 2 ? T(1) : T(-1);
      ray.origin = vertex - ray.direction * T(2);
    }
    if (i % 5 == 0)
      ray.tMax = static_cast<T>(numbers.between(0.0, 2.0));
    rays.push_back(ray);
  }
  return rays;
}

/// Fowler, Noll, Vo: FNV-1a, of 64 bits.
class Checksum {
 public:
  template <class T>
  void add(const std::optional<Hit<T>>& hit, bool isOfAMesh) {
    addWord(hit ? 1 : 0);
    if (!hit)
      return;
    addNumber(hit->t);
    // The parameters of round shapes are angles, from the mathematical library.
    if (isOfAMesh) {
      addNumber(hit->u);
      addNumber(hit->v);
    }
    for (const Axis axis : kAxes)
      addNumber(hit->normal[axis]);
    addWord(hit->geometry);
    addWord(hit->primitive);
    addWord(hit->part);
  }
  void add(bool isOccluded) { addWord(isOccluded ? 1 : 0); }

  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  template <class T>
  void addNumber(T number) {
    if constexpr (std::is_same_v<T, float>)
      addWord(std::bit_cast<std::uint32_t>(number));
    else
      addWord(std::bit_cast<std::uint64_t>(number));
  }
  void addWord(std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) {
      value_ = (value_ ^ (word & 0xFFu)) * 0x100'0000'01B3u;
      word >>= 8u;
    }
  }

  std::uint64_t value_ = 0xCBF2'9CE4'8422'2325u;
};

/// A mesh and shapes in one tree, and rays to meet them.
template <class T>
struct GoldenScene {
  KdTree<AnyObject<T>> tree;
  std::vector<Ray<T>> rays;

  GoldenScene() {
    Numbers numbers;
    TriangleMesh<T> mesh = makeMesh<T>(numbers);
    std::vector<AnyShape<T>> shapes = makeShapes<T>(numbers);
    rays = makeRays<T>(numbers, mesh);
    Scene<T> scene;
    scene.add(std::move(mesh));
    scene.add(std::move(shapes));
    tree = buildTree(scene);
  }

  /// Of the answers of two functions, which are asked in turn.
  template <class FindIntersection, class IsOccluded>
  [[nodiscard]] std::uint64_t checksum(const FindIntersection& findIntersection,
                                       const IsOccluded& isOccluded) const {
    Checksum sum;
    for (const Ray<T>& ray : rays) {
      const std::optional<Hit<T>> hit = findIntersection(ray);
      sum.add(hit, hit && hit->geometry == 0);
      sum.add(isOccluded(ray));
    }
    return sum.value();
  }

  [[nodiscard]] std::uint64_t bruteForceChecksum() const {
    std::optional<Hit<T>> last;
    return checksum([&](const Ray<T>& ray) { return last = test::bruteForce(tree, ray); },
                    [&](const Ray<T>&) { return last.has_value(); });
  }
  [[nodiscard]] std::uint64_t treeChecksum() const {
    return checksum([&](const Ray<T>& ray) { return tree.findIntersection(ray); },
                    [&](const Ray<T>& ray) { return tree.isOccluded(ray); });
  }
  /// Counted queries walk the binary form.
  [[nodiscard]] std::uint64_t binaryFormChecksum() const {
    StepCounts steps;
    return checksum([&](const Ray<T>& ray) { return tree.findIntersection(ray, steps); },
                    [&](const Ray<T>& ray) { return tree.isOccluded(ray, steps); });
  }
};

TEST(GoldenHits, BruteForceHasTheirBitsOnEveryMachine) {
  EXPECT_EQ(GoldenScene<float>().bruteForceChecksum(), kGoldenFloat);
  EXPECT_EQ(GoldenScene<double>().bruteForceChecksum(), kGoldenDouble);
}

TEST(GoldenHits, BothFormsOfTheTreeHaveTheirBits) {
  EXPECT_EQ(GoldenScene<float>().treeChecksum(), kGoldenFloat);
  EXPECT_EQ(GoldenScene<float>().binaryFormChecksum(), kGoldenFloat);
  EXPECT_EQ(GoldenScene<double>().treeChecksum(), kGoldenDouble);
}

TEST(GoldenHits, EveryInstructionSetHasTheirBits) {
  const GoldenScene<float> scene;
  const TreeView<float> view = scene.tree.view();
  for (const Kernels& kernels : supportedKernels()) {
    std::size_t answeredCount = 0;
    const auto findIntersection = [&](const Rayf& ray) -> std::optional<Hitf> {
      const Query<float> query(view, ray, ray.tMin, ray.tMax);
      Hitf hit;
      const std::optional<bool> found = searchWide<NearestHit>(query, hit, kernels);
      if (!found)
        return scene.tree.findIntersection(ray);
      ++answeredCount;
      return *found ? std::optional(hit) : std::nullopt;
    };
    const auto isOccluded = [&](const Rayf& ray) {
      const Query<float> query(view, ray, ray.tMin, ray.tMax);
      Hitf unused;
      return searchWide<AnyHit>(query, unused, kernels).value_or(false);
    };
    EXPECT_EQ(scene.checksum(findIntersection, isOccluded), kGoldenFloat) << kernels.name;
    EXPECT_EQ(answeredCount, kRayCount) << kernels.name;
  }
}

/// So that the numbers stand for something.
TEST(GoldenHits, AreOfTrianglesAndOfShapesAndSomeAreMissed) {
  const GoldenScene<float> scene;
  std::size_t counts[3] = {};
  for (const Rayf& ray : scene.rays) {
    const auto hit = scene.tree.findIntersection(ray);
    ++counts[hit ? hit->geometry : 2u];
  }
  for (const std::size_t count : counts)
    EXPECT_GT(count, kRayCount / 20);
}

}  // namespace
}  // namespace planetree::detail

#include <planetree/planetree.hpp>

#include "support/hard_cases.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace planetree::test {
namespace {

struct WithoutScalar {
  Box3 bounds() const { return {}; }
};

struct ThrowingIntersect {
  using Scalar = float;
  Box3 bounds() const { return {}; }
  std::optional<Hitf> intersect(const Rayf&, float, float) const { return {}; }
};

static_assert(Object<Sphere<float>> && Object<Face<double>> && Object<AnyObject<float>>);
static_assert(Object<const Sphere<float>*> && Object<std::unique_ptr<Geometry<double>>>);
static_assert(Object<std::shared_ptr<const Geometry<float>>>);
static_assert(Object<std::variant<Sphere<float>, std::unique_ptr<Geometry<float>>>>);
static_assert(!Object<int> && !Object<int*> && !Object<WithoutScalar> &&
              !Object<std::variant<int>>);
static_assert(!Object<ThrowingIntersect>, "intersect must be noexcept");
static_assert(std::is_same_v<ScalarOf<std::variant<Box<double>, Sphere<double>>>, double>);

const Rayf kDown{{0.25f, 0.25f, 5}, {0, 0, -1}};

TEST(Objects, ValuesPointersAndVariantsGiveTheSameHit) {
  const Sphere<float> sphere{{0, 0, 0}, 1};
  const auto expected = buildTree(std::vector{sphere}).findIntersection(kDown);
  ASSERT_TRUE(expected);
  EXPECT_EQ(buildTree(std::vector<const Sphere<float>*>{&sphere}).findIntersection(kDown),
            expected);
  std::vector<std::unique_ptr<Geometry<float>>> geometries;
  geometries.push_back(makeGeometry(sphere));
  EXPECT_EQ(buildTree(std::move(geometries)).findIntersection(kDown), expected);
  using Any = std::variant<Box<float>, Sphere<float>>;
  EXPECT_EQ(buildTree(std::vector<Any>{sphere}).findIntersection(kDown), expected);
  Scene<float> scene;
  scene.add(sphere);
  EXPECT_EQ(buildTree(scene).findIntersection(kDown), expected);
}

TEST(Objects, NullPointersAreSkippedAndCounted) {
  std::vector<std::shared_ptr<Geometry<float>>> geometries(3);
  geometries[1] = makeGeometry(Sphere<float>{{0, 0, 0}, 1});
  const auto tree = buildTree(std::move(geometries));
  EXPECT_EQ(tree.objectCount(), 3u);
  ASSERT_EQ(tree.report().skippedCount, 2u);
  EXPECT_EQ(tree.report().skipped[0].primitive, 0u);
  EXPECT_EQ(tree.report().skipped[1].primitive, 2u);
  EXPECT_EQ(tree.report().skipped[0].reason, SkipReason::Empty);
  EXPECT_EQ(tree.findIntersection(kDown)->primitive, 1u);
}

TEST(Objects, OwnedOnesLiveAsLongAsTheTree) {
  KdTree<Face<float>> copy;
  EXPECT_FALSE(copy.findIntersection(kDown));
  {
    TriangleMesh<float> mesh;
    detail::addTriangle<float>(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const KdTree<Face<float>> tree = buildTree(std::move(mesh));
    copy = tree;
  }
  EXPECT_EQ(copy.findIntersection(kDown)->t, 5.0f);
  KdTree<AnyObject<float>> fromScene;
  {
    Scene<float> scene;
    scene.add(std::vector<Sphere<float>>{{{0, 0, 0}, 1}});
    fromScene = buildTree(scene);
  }
  EXPECT_TRUE(fromScene.findIntersection(kDown));
}

TEST(Objects, CanBeAskedForAfterTheirTreeWasMovedFrom) {
  KdTree<Sphere<float>> tree = buildTree(std::vector<Sphere<float>>{{{0, 0, 0}, 1}});
  const KdTree<Sphere<float>> taken = std::move(tree);
  EXPECT_TRUE(taken.findIntersection(kDown));
  EXPECT_TRUE(tree.findIntersection(kDown)) << "moving copies";  // NOLINT(bugprone-use-after-move)
}

TEST(Objects, ComeInSpansOfConstAndOthers) {
  std::vector<Sphere<float>> spheres = {{{0, 0, 0}, 1}};
  EXPECT_TRUE(buildTree(std::span(spheres)).findIntersection(kDown));
  EXPECT_TRUE(buildTree(std::span(std::as_const(spheres))).findIntersection(kDown));
  Scene<float> scene;
  scene.add(std::span(spheres));
  scene.add(std::span(std::as_const(spheres)));
  EXPECT_TRUE(buildTree(scene).findIntersection(kDown));
}

// A tree of faces looks them up in their mesh, so lists of faces must not pass for one.
static_assert(ObjectByItself<Sphere<float>> && !ObjectByItself<Face<float>>);

TEST(Objects, LeavesListThem) {
  const std::vector<Sphere<float>> spheres = {{{0, 0, 0}, 1}, {{5, 0, 0}, 2}};
  BuildOptions oneLeaf;
  oneLeaf.depthLimit = 1;
  const auto tree = buildTree(std::span<const Sphere<float>>(spheres), oneLeaf);
  ASSERT_TRUE(tree.root().isLeaf());
  std::vector<float> radii;
  for (const Sphere<float>& sphere : tree.objects(tree.root().leaf()))
    radii.push_back(sphere.radius);
  EXPECT_EQ(radii, (std::vector{1.0f, 2.0f}));
  EXPECT_EQ(&tree.object(0, 1), &spheres[1]);
}

TEST(Objects, OfASceneAreReachedThroughHandles) {
  Scene<double> scene;
  TriangleMesh<double> mesh;
  detail::addTriangle<double>(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  detail::addTriangle<double>(mesh, {0, 0, 1}, {1, 0, 1}, {0, 1, 1});
  EXPECT_EQ(scene.add(Sphere<double>{{0, 0, 5}, 1}), 0u);
  EXPECT_EQ(scene.add(mesh), 1u);
  BuildOptions oneLeaf;
  oneLeaf.depthLimit = 1;
  const auto tree = buildTree(scene, oneLeaf);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ids;
  for (const AnyObject<double> object : tree.objects(tree.root().leaf())) {
    ids.emplace_back(object.geometry(), object.primitive());
  }
  EXPECT_EQ(ids, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 0}, {1, 0}, {1, 1}}));
  const AnyObject<double> face = tree.object(1, 1);
  EXPECT_EQ(face.bounds(), (Box3{{0, 0, 1}, {1, 1, 1}}));
  EXPECT_EQ(face.clippedBounds({{0, 0, 0}, {0.5f, 2, 2}}).upper.x, 0.5f);
  EXPECT_EQ(face.planarSide(Axis::Z), 1);
  const auto hit = face.intersect({{0.25, 0.25, 5}, {0, 0, -1}}, 0, 10);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 4.0);
  EXPECT_EQ(hit->geometry, 1u);
  EXPECT_EQ(hit->primitive, 1u);
}

TEST(Objects, ASceneMayChangeAfterItsTreeIsBuilt) {
  Scene<float> scene;
  scene.add(Sphere<float>{{0, 0, 0}, 1});
  const auto tree = buildTree(scene);
  scene.add(Sphere<float>{{0, 0, 3}, 1});
  EXPECT_EQ(tree.geometryCount(), 1u);
  EXPECT_EQ(buildTree(scene).findIntersection(kDown)->geometry, 1u);
  EXPECT_EQ(tree.findIntersection(kDown)->geometry, 0u);
}

TEST(Objects, AMeshViewTakesAnyStride) {
  struct Vertex {
    float weight;
    Vec3f position;
    char tag;
  };
  struct Triangle {
    std::uint16_t material;
    FaceIndices indices;
  };
  const std::vector<Vertex> vertices = {
      {1, {0, 0, 0}, 'a'}, {2, {1, 0, 0}, 'b'}, {3, {0, 1, 0}, 'c'}};
  const std::vector<Triangle> triangles = {{7, {0, 1, 2}}};
  const TriangleMeshView<float> view(&vertices[0].position, sizeof(Vertex), vertices.size(),
                                     &triangles[0].indices, sizeof(Triangle), triangles.size());
  const auto hit = buildTree(view).findIntersection(kDown);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 5.0f);
  EXPECT_EQ(hit->u, 0.25f);
  EXPECT_EQ(hit->v, 0.25f);
  EXPECT_EQ(hit->normal, (Vec3f{0, 0, 1}));
}

TEST(Objects, AUsersExceptionWhileBoundingReachesTheCaller) {
  struct Broken {
    using Scalar = float;
    Box3 bounds() const { throw std::runtime_error("no bounds today"); }
    std::optional<Hitf> intersect(const Rayf&, float, float) const noexcept { return {}; }
  };
  EXPECT_THROW((void)buildTree(std::vector<Broken>(5000)), std::runtime_error);
}

TEST(Objects, AskingAgainBehindEachHitFindsAllOfThem) {
  std::vector<Sphere<double>> spheres;
  for (int i = 0; i < 5; ++i)
    spheres.push_back({{0, 0, 3.0 * i}, 1});
  const auto tree = buildTree(std::move(spheres));
  Rayd ray{{0, 0, -10}, {0, 0, 1}};
  std::vector<double> distances;
  while (const auto hit = tree.findIntersection(ray)) {
    distances.push_back(hit->t);
    ray.tMin = nextUp(hit->t);
  }
  EXPECT_EQ(distances, (std::vector<double>{9, 11, 12, 14, 15, 17, 18, 20, 21, 23}));
}

TEST(Errors, SayWhereAndWhatToTry) {
  const Error error(ErrorCode::MalformedFile, "the index is not a number", "Export it again.",
                    {.file = "a.obj", .line = 12, .face = 3});
  EXPECT_STREQ(error.what(), "a.obj:12: face 3: the index is not a number. Export it again.");
  EXPECT_EQ(error.code(), ErrorCode::MalformedFile);
  EXPECT_EQ(error.line(), 12);
  EXPECT_EQ(error.face(), 3);
  EXPECT_EQ(errorCodeName(error.code()), "malformed-file");
  const Error inLine(ErrorCode::MalformedFile, "this is no keyword", "Remove it.",
                     {.file = "a.ray", .line = 3, .column = 14});
  EXPECT_STREQ(inLine.what(), "a.ray:3:14: this is no keyword. Remove it.");
  EXPECT_EQ(inLine.column(), 14);
  const Error plain(ErrorCode::InvalidOption, "leafSize is odd", "");
  EXPECT_STREQ(plain.what(), "leafSize is odd");
  EXPECT_EQ(plain.face(), Error::kNone);
}

TEST(Errors, HaveACodeWithANameOfItsOwn) {
  const std::vector<std::pair<ErrorCode, std::string>> names = {
      {ErrorCode::FileNotReadable, "file-not-readable"},
      {ErrorCode::FileNotWritable, "file-not-writable"},
      {ErrorCode::UnknownFormat, "unknown-format"},
      {ErrorCode::MalformedFile, "malformed-file"},
      {ErrorCode::InvalidGeometry, "invalid-geometry"},
      {ErrorCode::InvalidOption, "invalid-option"},
      {ErrorCode::CapacityExceeded, "capacity-exceeded"},
      {ErrorCode::MemoryLimitExceeded, "memory-limit-exceeded"},
      {ErrorCode::Cancelled, "cancelled"},
  };
  for (const auto& [code, name] : names)
    EXPECT_EQ(errorCodeName(code), name);
}

}  // namespace
}  // namespace planetree::test

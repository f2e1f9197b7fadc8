#include "support/random.hpp"
#include "unit/shape/random_shapes.hpp"

#include <planetree/shape/shapes.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <utility>
#include <variant>

// A shape answers alike however it is handed over: by value, in a variant, behind a pointer, or as
// a `Geometry`.
namespace planetree::test {
namespace {

template <class T>
using AnyOf = std::variant<Triangle<T>, Sphere<T>, Box<T>, Square<T>, Cylinder<T>, Cone<T>>;

static_assert(Object<AnyOf<float>> && Object<AnyOf<double>>);
static_assert(Object<Sphere<float>*> && Object<const Sphere<float>*>);
static_assert(Object<std::shared_ptr<Geometry<double>>> && Shape<Geometry<double>>);
static_assert(Object<std::variant<Sphere<float>, std::unique_ptr<Geometry<float>>>>);
static_assert(std::same_as<ScalarOf<AnyOf<double>>, double>);
static_assert(ShapeWithClippedBounds<Sphere<float>> && ShapeWithClippedBounds<Box<float>>);
static_assert(ShapeWithClippedBounds<Square<float>> && ShapeWithClippedBounds<Triangle<float>>);
static_assert(ShapeWithPlanarSide<Square<float>> && ShapeWithPlanarSide<Triangle<float>>);

template <class O, class S>
void expectSameAnswers(const O& object, const S& shape, const Ray<ScalarOf<O>>& ray,
                       const Box3& cell) {
  using T = ScalarOf<O>;
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  EXPECT_EQ(objectBounds(object), shape.bounds());
  EXPECT_EQ(objectClippedBounds(object, cell), objectClippedBounds(shape, cell));
  for (const Axis axis : kAxes) {
    EXPECT_EQ(objectPlanarSide(object, axis), objectPlanarSide(shape, axis));
  }
  EXPECT_EQ(objectIntersect(object, ray, T(0), kInfinity), shape.intersect(ray, T(0), kInfinity));
}

template <class S>
class Wrapped : public ::testing::Test {};
using AllShapes = ::testing::Types<Sphere<float>, Sphere<double>, Box<float>, Box<double>,
                                   Square<float>, Square<double>, Cylinder<float>, Cylinder<double>,
                                   Cone<float>, Cone<double>, Triangle<float>, Triangle<double>>;
TYPED_TEST_SUITE(Wrapped, AllShapes);

TYPED_TEST(Wrapped, AnswersLikeThePlainShape) {
  using T = typename TypeParam::Scalar;
  SCOPED_TRACE(describeSeed());
  Random random;
  for (int i = 0; i < 200 && !::testing::Test::HasFailure(); ++i) {
    const TypeParam shape = randomShape<TypeParam>(random);
    const Ray<T> ray = randomRay(shape, random);
    const Box3 cell = randomCell(shape.bounds(), random);
    expectSameAnswers(shape, shape, ray, cell);
    expectSameAnswers(&shape, shape, ray, cell);
    expectSameAnswers(AnyOf<T>(shape), shape, ray, cell);
    expectSameAnswers(std::make_unique<TypeParam>(shape), shape, ray, cell);
    expectSameAnswers(std::make_shared<AnyOf<T>>(shape), shape, ray, cell);
    expectSameAnswers(GeometryOf<TypeParam>(shape), shape, ray, cell);
    expectSameAnswers(makeGeometry(shape), shape, ray, cell);
    const std::shared_ptr<const Geometry<T>> shared = makeGeometry(shape);
    expectSameAnswers(shared, shape, ray, cell);
  }
}

TEST(NullPointer, IsAnObjectWithoutAnything) {
  const Sphere<float>* const none = nullptr;
  EXPECT_EQ(objectBounds(none), Box3{});
  EXPECT_EQ(objectPlanarSide(none, Axis::X), 0);
  EXPECT_EQ(objectIntersect(none, Rayf{{0, 0, -5}, {0, 0, 1}}, 0.0f, 100.0f), std::nullopt);
  EXPECT_TRUE(objectClippedBounds(std::unique_ptr<Geometry<float>>(), Box3{}).isEmpty());
}

TEST(GeometryOf, GivesItsShapeBack) {
  const Sphere<double> sphere{{1, 2, 3}, 4};
  EXPECT_EQ(GeometryOf<Sphere<double>>(sphere).shape(), sphere);
}

/// A user's class on the virtual base that leaves out what is optional.
class Slab final : public Geometry<float> {
 public:
  [[nodiscard]] Box3 bounds() const override { return {{-1, -1, 0}, {1, 1, 0}}; }
  [[nodiscard]] std::optional<Hitf> intersect(const Rayf&, float, float) const noexcept override {
    return std::nullopt;
  }
};

TEST(Geometry, ClipsItsBoundsUnlessOverridden) {
  const Slab slab;
  EXPECT_EQ(slab.clippedBounds({{0, 0, -1}, {9, 9, 9}}), (Box3{{0, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(slab.planarSide(Axis::Z), 0);
}

}  // namespace
}  // namespace planetree::test

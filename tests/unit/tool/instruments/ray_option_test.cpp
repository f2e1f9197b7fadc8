#include "instruments/ray_option.hpp"

#include "usage_error.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace planetree::tool {
namespace {

template <class T>
Ray<T> ray(const std::string& text, const RayLimits& limits = {}) {
  return parseRay<T>({"--ray", text}, limits);
}

TEST(ParseRay, ReadsSixOrEightNumbers) {
  const Rayf six = ray<float>("1,2,3,4,5,6", {.tMin = -1.0, .tMax = 7.0});
  EXPECT_EQ(six.origin, (Vec3f{1, 2, 3}));
  EXPECT_EQ(six.direction, (Vec3f{4, 5, 6}));
  EXPECT_EQ(six.tMin, -1.0f);
  EXPECT_EQ(six.tMax, 7.0f);
  const Rayd eight = ray<double>("1,2,3,4,5,6,7,inf", {.tMin = -1.0, .tMax = 7.0});
  EXPECT_EQ(eight.tMin, 7.0);
  EXPECT_EQ(eight.tMax, std::numeric_limits<double>::infinity());
}

TEST(ParseRay, TakesBlanksSignsAndExponents) {
  const Rayf read = ray<float>(" +1 ,\t-2e1, 0.5,0,-0,1e-3");
  EXPECT_EQ(read.origin, (Vec3f{1, -20, 0.5f}));
  EXPECT_EQ(read.direction.z, 1e-3f);
}

TEST(ParseRay, RoundsOnceToThePrecision) {
  EXPECT_EQ(ray<float>("0.1,0,0,0,0,1").origin.x, 0.1f);
  EXPECT_EQ(ray<double>("0.1,0,0,0,0,1").origin.x, 0.1);
  EXPECT_EQ(ray<float>("1e-60,0,0,0,0,1").origin.x, 0.0f) << "what is too small becomes zero";
  EXPECT_EQ(ray<float>("0,0,0,0,0,1,0,1e60").tMax, std::numeric_limits<float>::infinity());
}

TEST(ParseRay, MayBeginWhereItEnds) {
  EXPECT_EQ(ray<float>("0,0,0,0,0,1,2,2").tMin, 2.0f);
}

TEST(ParseRay, RefusesWhatIsNoRay) {
  for (const char* text :
       {"", ",", "1,2,3,4,5", "1,2,3,4,5,6,7", "1,2,3,4,5,6,7,8,9", "1,2,3,4,5,", "1,2,3,4,5,+-6",
        "1,2,3,4,5,6 7", "1,2,3,0,0,0", "nan,2,3,4,5,6", "1,2,3,4,5,inf", "1,2,3,4,5,6,nan,1",
        "1,2,3,4,5,6,2,1", "1e60,2,3,4,5,6"})
    EXPECT_THROW(static_cast<void>(ray<float>(text)), UsageError) << text;
  EXPECT_THROW(static_cast<void>(ray<double>("1e999,2,3,4,5,6")), UsageError);
}

}  // namespace
}  // namespace planetree::tool

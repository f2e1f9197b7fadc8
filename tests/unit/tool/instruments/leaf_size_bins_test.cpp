#include "instruments/leaf_size_bins.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace planetree::tool {
namespace {

TEST(LeafSizeBins, OfNoLeavesAreNone) {
  EXPECT_TRUE(leafSizeBins({}).empty());
}

TEST(LeafSizeBins, HaveOneForEachSizeFromZeroWhileTheyFit) {
  const std::vector<LeafSizeCount> sizes = {{2, 5}, {4, 7}};
  const std::vector<LeafSizeBin> bins = leafSizeBins(sizes);
  ASSERT_EQ(bins.size(), 5u);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    EXPECT_EQ(bins[i].lowest, i);
    EXPECT_FALSE(bins[i].isRange());
    EXPECT_EQ(bins[i].leafCount, i == 2 ? 5u : i == 4 ? 7u : 0u);
  }
}

TEST(LeafSizeBins, HoldEveryLeafOnce) {
  const std::vector<LeafSizeCount> sizes = {{0, 1},
                                            {7, 2},
                                            {8, 4},
                                            {15, 8},
                                            {16, 16},
                                            {1'000'000, 32},
                                            {std::numeric_limits<std::uint32_t>::max(), 64}};
  const std::vector<LeafSizeBin> bins = leafSizeBins(sizes);
  std::uint64_t leafCount = 0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    leafCount += bins[i].leafCount;
    EXPECT_EQ(bins[i].lowest, i == 0 ? 0 : bins[i - 1].highest + 1) << "no gap";
  }
  EXPECT_EQ(leafCount, 127u);
  EXPECT_EQ(bins[8].leafCount, 12u) << "8 to 15";
  EXPECT_EQ(bins.back().leafCount, 64u);
}

TEST(SizeText, NamesRanges) {
  EXPECT_EQ(sizeText({7, 7, 1}), "7");
  EXPECT_EQ(sizeText({1024, 2047, 1}), "1,024–2,047");
}

}  // namespace
}  // namespace planetree::tool

#include "support/large_pages.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace planetree::detail {
namespace {

TEST(LargePages, HoldWhatIsWrittenFromEndToEnd) {
  constexpr std::size_t kLargePage = std::size_t{1} << 21u;
  for (const std::size_t size : {std::size_t{1}, std::size_t{4096}, kLargePage - 1, kLargePage,
                                 kLargePage + 1, 3 * kLargePage - 100, 5 * kLargePage}) {
    SCOPED_TRACE(size);
    LargePages pages(size);
    ASSERT_NE(pages.data(), nullptr);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(pages.data()) % LargePages::kAlignment, 0u);
    std::memset(pages.data(), 7, size);
    const std::byte* const data = pages.data();
    LargePages moved = std::move(pages);
    EXPECT_EQ(moved.data(), data);
    EXPECT_EQ(moved.data()[size - 1], std::byte{7});
    LargePages other;
    EXPECT_EQ(other.data(), nullptr);
    other = std::move(moved);
    EXPECT_EQ(other.data()[0], std::byte{7});
  }
}

}  // namespace
}  // namespace planetree::detail

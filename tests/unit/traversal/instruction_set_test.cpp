#include <planetree/traversal/instruction_set.hpp>

#include "isa/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <string_view>

namespace planetree {
namespace {

TEST(InstructionSets, HaveKnownNamesEachOnceAndScalarLast) {
  const std::set<std::string_view> known = {"scalar", "sse4", "avx2", "avx512", "neon"};
  std::set<std::string_view> seen;
  for (const std::string_view name : supportedInstructionSets()) {
    EXPECT_TRUE(known.contains(name)) << name;
    EXPECT_TRUE(seen.insert(name).second) << name;
  }
  ASSERT_FALSE(seen.empty());
  EXPECT_EQ(supportedInstructionSets().back(), "scalar");
}

TEST(InstructionSets, TheActiveOneIsWhatWasAskedForIfThereIsSuchAndElseTheBest) {
  const auto supported = supportedInstructionSets();
  const std::string_view requested = requestedInstructionSet();
  const bool isSupported =
      std::find(supported.begin(), supported.end(), requested) != supported.end();
  EXPECT_EQ(activeInstructionSet(), isSupported ? requested : supported.front());
}

TEST(InstructionSets, TheActiveOneIsWhatQueriesUseAndDoesNotChange) {
  const std::string before(activeInstructionSet());
  EXPECT_EQ(detail::activeKernels().name, before);
  const std::string requested(requestedInstructionSet());
  ::setenv("PLANETREE_ISA", before == "scalar" ? "none" : "scalar", 1);
  EXPECT_EQ(activeInstructionSet(), before);
  EXPECT_EQ(detail::activeKernels().name, before);
  if (requested.empty())
    ::unsetenv("PLANETREE_ISA");
  else
    ::setenv("PLANETREE_ISA", requested.c_str(), 1);
}

}  // namespace
}  // namespace planetree

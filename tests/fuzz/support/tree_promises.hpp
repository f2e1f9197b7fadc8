#pragma once

#include <planetree/build_tree.hpp>
#include <planetree/error.hpp>
#include <planetree/kd_tree.hpp>
#include <planetree/node/validate_tree.hpp>

#include "support/promise.hpp"
#include "support/take_options.hpp"

#include <cstdint>
#include <optional>
#include <string>

/// What holds of every build.
namespace planetree::fuzz {

/// Enough for any tree of a small input with sensible options; others may ask for trees beyond all
/// measure, and are refused.
inline constexpr std::uint64_t kMemoryLimit = std::uint64_t{1} << 21;

template <Object O>
void requireSoundTree(const KdTree<O>& tree) {
  const auto fault =
      validateTree(tree.nodes(), tree.view().references, tree.bounds(), tree.objectCount());
  require(!fault, "a tree is sound", [&fault] { return *fault; });
  const BuildReport& report = tree.report();
  require(report.skippedCount <= report.objectCount, "skipped objects are counted, too");
  require(report.skipped.size() <= report.skippedCount, "no more are named than skipped");
  require(report.referenceCount == tree.view().references.size(), "references are counted");
  require(report.peakBytes <= kMemoryLimit, "a build keeps within its memory");
  require(tree.statistics().depth <= kMaxTreeDepth, "no path is too long");
}

/// The tree, unless the options are such as to be refused.
template <class Objects>
[[nodiscard]] auto buildOrRefuse(const Objects& objects, const BuildOptions& options)
    -> std::optional<decltype(buildTree(objects, options))> {
  BuildControl control;
  control.memoryLimit = kMemoryLimit;
  try {
    const auto tree = buildTree(objects, options, control);
    require(areValid(options), "options out of range are refused");
    requireSoundTree(tree);
    return tree;
  } catch (const Error& error) {
    const auto details = [&error] { return std::string(error.what()); };
    require(!error.advice().empty(), "an error gives advice", details);
    if (areValid(options))
      require(error.code() == ErrorCode::MemoryLimitExceeded, "options in range are taken",
              details);
    else
      require(error.code() == ErrorCode::InvalidOption, "options out of range are named", details);
    return std::nullopt;
  }
}

}  // namespace planetree::fuzz

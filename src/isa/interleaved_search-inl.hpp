// Rays that have little in common, each on its own way through the wide form of a tree, in turns.
// Compiled once for each instruction set; hence no include guard but the one of Highway.

#if defined(PLANETREE_INTERLEAVED_SEARCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLANETREE_INTERLEAVED_SEARCH_INL
#undef PLANETREE_INTERLEAVED_SEARCH_INL
#else
#define PLANETREE_INTERLEAVED_SEARCH_INL
#endif

#include "isa/wide_traversal-inl.hpp"

#include <hwy/highway.h>
#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Searches with several prepared rays at a time. Each step of a ray waits for the one before, and
/// for memory; those of different rays do not wait for each other. As many steps to nodes as
/// possible are made one behind the other, without a branch that depends on what they find.
template <class Goal>
class InterleavedSearch {
 public:
  /// Measured: 4 and 8 are slower, 24 no faster.
  static constexpr std::size_t kMostRays = 16;

  explicit HWY_INLINE InterleavedSearch(const WideTree& tree) : tree_(tree) {}

  /// `next()` gives the next query, or null if there is none left; `putOff(query, stack, size)`
  /// puts on the stack where it begins, the nearest on top, and returns the new size;
  /// `finish(query, found)` is told when one is answered.
  template <class Next, class PutOff, class Finish>
  HWY_INLINE void run(const Next& next, const PutOff& putOff, const Finish& finish) {
    // Sets of walkers: bit i stands for number i.
    std::uint32_t atNodes = 0;
    std::uint32_t atLeaves = 0;
    for (std::uint32_t i = 0; i < kMostRays; ++i) {
      WideQuery* const query = next();
      if (query == nullptr)
        break;
      start(walkers_[i], *query, putOff);
      atLeaves |= 1u << i;
    }
    while (atLeaves != 0) {
      for (std::uint32_t rest = atLeaves; rest != 0; rest &= rest - 1) {
        const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(rest);
        Walker& walker = walkers_[i];
        bool isBusy = true;
        while (isBusy && visitLeaves(walker)) {
          finish(*walker.query, walker.found);
          WideQuery* const query = next();
          isBusy = query != nullptr;
          if (isBusy)
            start(walker, *query, putOff);
        }
        atNodes |= (isBusy ? 1u : 0u) << i;
      }
      atLeaves = 0;
      // As long as most of them are at nodes.
      while (hwy::PopCount(atNodes) > hwy::PopCount(atLeaves)) {
        std::uint32_t stillAtNodes = 0;
        for (std::uint32_t rest = atNodes; rest != 0; rest &= rest - 1) {
          const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(rest);
          stillAtNodes |= step(walkers_[i]) << i;
        }
        atLeaves |= atNodes & ~stillAtNodes;
        atNodes = stillAtNodes;
      }
    }
  }

 private:
  /// Of a node all, of a block five would do: to tell them apart costs more.
  static constexpr std::size_t kFetchedLines = sizeof(WideNode) / 64;

  struct Walker {
    WideQuery* query;
    std::size_t size;
    WideChild child;
    bool found;
    Stack stack;
    ShearedBlock sheared;
  };

  template <class PutOff>
  HWY_INLINE void start(Walker& walker, WideQuery& query, const PutOff& putOff) {
    walker.query = &query;
    walker.found = false;
    walker.stack.tNear[0] = -std::numeric_limits<float>::infinity();
    walker.stack.children[0] = WideChild::end().word();
    walker.size = putOff(query, walker.stack, 1) - 1;
    walker.child = WideChild::fromWord(walker.stack.children[walker.size]);
  }

  /// From a node to the next child; 1 if that is a node, else 0.
  HWY_INLINE std::uint32_t step(Walker& walker) {
    const WideQuery& query = *walker.query;
    Stack& stack = walker.stack;
    const WideRay ray(query);
    const WideNode& node = tree_.nodes[walker.child.nodeIndex()];
    std::size_t size = walker.size;
    const std::uint32_t below = stack.children[size - 1];
    BoxTest test;
    ray.test(node, hn::Set(FloatTag(), query.hitT), test);
    walker.child = WideChild::fromWord(
        Goal::kStopsAtAnyHit ? pushUnordered(node, test, below, stack, size)
                             : pushNearestLast(node, query.octant, test, below, stack, size));
    walker.size = size - 1;
    prefetch(walker.child);
    return 1u ^ walker.child.word() >> 31u;
  }

  /// Fetches what the ray looks at when it is its turn again. Which kind that is no branch can
  /// foresee.
  HWY_INLINE void prefetch(WideChild child) const {
    const auto nodes = reinterpret_cast<std::uintptr_t>(tree_.nodes.data());
    const auto blocks = reinterpret_cast<std::uintptr_t>(tree_.blocks.data());
    const std::uintptr_t node = nodes + child.nodeIndex() * sizeof(WideNode);
    const std::uintptr_t block = blocks + child.firstBlock() * sizeof(TriangleBlock);
    const auto isLeaf = std::uintptr_t{0} - static_cast<std::uintptr_t>(child.word() >> 31u);
    const auto* const first = reinterpret_cast<const char*>((block & isLeaf) | (node & ~isLeaf));
    for (std::size_t line = 0; line < kFetchedLines; ++line)
      hwy::Prefetch(first + 64 * line);
  }

  /// Tests blocks until the next child is a node; true if the query is answered.
  HWY_INLINE bool visitLeaves(Walker& walker) {
    WideQuery& query = *walker.query;
    Stack& stack = walker.stack;
    WideChild child = walker.child;
    while (!child.isNode()) {
      if (child.isObject())
        return true;
      const TriangleBlock* const first = tree_.blocks.data() + child.firstBlock();
      for (const TriangleBlock* block = first; block < first + child.blockCount(); ++block) {
        const BlockRay blockRay(query);
        const auto answer = blockRay.template test<Goal>(*block, walker.sheared);
        if (Goal::kStopsAtAnyHit && answer.certain != 0) {
          walker.found = true;
          return true;
        }
        std::uint32_t lanes = answer.candidates;
        if (lanes != 0 && !Goal::kStopsAtAnyHit)
          lanes &= ~lanesOf(*block, query.hitObject);
        if (lanes == 0)
          continue;
        const float end = query.hitT;
        walker.found |= testCandidates<Goal>(query, *block, walker.sheared, lanes);
        if (Goal::kStopsAtAnyHit && walker.found)
          return true;
        if (query.hitT < end)
          walker.size = dropBeyond(query.hitT, stack, walker.size);
      }
      child = WideChild::fromWord(stack.children[--walker.size]);
    }
    walker.child = child;
    return false;
  }

  const WideTree& tree_;
  Walker walkers_[kMostRays];
};

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

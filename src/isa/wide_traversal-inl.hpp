// The loop over the wide form of a tree, compiled once for each instruction set; hence no include
// guard but the one of Highway. What differs between sets is how many of the sixteen lanes of a
// node or a block one vector holds.

#if defined(PLANETREE_WIDE_TRAVERSAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLANETREE_WIDE_TRAVERSAL_INL
#undef PLANETREE_WIDE_TRAVERSAL_INL
#else
#define PLANETREE_WIDE_TRAVERSAL_INL
#endif

#include <planetree/node/node_layout.hpp>

#include "traversal/wide_query.hpp"

#include <hwy/cache_control.h>
#include <hwy/highway.h>
#include <cstddef>
#include <type_traits>
#include <utility>

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kLaneCount = WideNode::kSlotCount;
static_assert(kLaneCount == TriangleBlock::kLaneCount);
static_assert(kLaneCount == TriangleBlock::kPositionCount);

constexpr std::size_t kLanesPerVector = HWY_MIN(kLaneCount, HWY_LANES(float));
constexpr std::size_t kVectorCount = kLaneCount / kLanesPerVector;

using FloatTag = hn::FixedTag<float, kLanesPerVector>;
using WordTag = hn::FixedTag<std::uint32_t, kLanesPerVector>;
using Floats = hn::Vec<FloatTag>;
using Words = hn::Vec<WordTag>;
using Mask = hn::Mask<FloatTag>;

/// Calls `visit` for each of the vectors that sixteen lanes take, with its number as a constant:
/// compilers keep arrays in registers only if all indices are known early.
template <class Visit, std::size_t... kIndices>
HWY_INLINE void forEachVector(std::index_sequence<kIndices...>, const Visit& visit) {
  (visit(std::integral_constant<std::size_t, kIndices>()), ...);
}
template <class Visit>
HWY_INLINE void forEachVector(const Visit& visit) {
  forEachVector(std::make_index_sequence<kVectorCount>(), visit);
}

/// Sixteen floats, in as many vectors as that takes. The constructor is written out, as is that of
/// `BoxTest`: one that the compiler makes would be compiled for no instruction set in particular,
/// and could not call those of vectors.
struct Lanes {
  HWY_INLINE Lanes() {}

  Floats vectors[kVectorCount];
};

HWY_INLINE std::uint32_t bitsOf(const Mask (&masks)[kVectorCount]) {
  std::uint32_t all = 0;
  forEachVector([&](auto i) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(FloatTag(), masks[i], bytes);
    const std::uint32_t bits = bytes[0] | std::uint32_t{bytes[1]} << 8u;
    all |= bits << (i * kLanesPerVector);
  });
  return all;
}

/// Subtrees that were put off, the nearest on top. One vector more than can be in use: pushing
/// always writes whole vectors.
struct Stack {
  static constexpr std::size_t kCapacity = (kMaxTreeDepth + 1) * kLaneCount;

  HWY_ALIGN float tNear[kCapacity];
  HWY_ALIGN std::uint32_t children[kCapacity];
};

/// For each mask of eight lanes, the kept ones first.
struct KeptLanes {
  std::uint8_t lanes[256][8] = {};

  constexpr KeptLanes() {
    for (std::size_t mask = 0; mask < 256; ++mask) {
      std::size_t count = 0;
      for (std::uint8_t lane = 0; lane < 8; ++lane) {
        if ((mask >> lane & 1u) != 0)
          lanes[mask][count++] = lane;
      }
    }
  }
};
constexpr KeptLanes kKeptLanes;

/// Where a ray enters and leaves the boxes of a node.
struct BoxTest {
  HWY_INLINE BoxTest() {}

  Lanes tNear;
  Lanes tFar;
};

class WideRay {
 public:
  explicit HWY_INLINE WideRay(const WideQuery& query)
      : inverseX_(hn::Set(FloatTag(), query.inverse[0])),
        inverseY_(hn::Set(FloatTag(), query.inverse[1])),
        inverseZ_(hn::Set(FloatTag(), query.inverse[2])),
        nearX_(hn::Set(FloatTag(), query.nearOffset[0])),
        nearY_(hn::Set(FloatTag(), query.nearOffset[1])),
        nearZ_(hn::Set(FloatTag(), query.nearOffset[2])),
        farX_(hn::Set(FloatTag(), query.farOffset[0])),
        farY_(hn::Set(FloatTag(), query.farOffset[1])),
        farZ_(hn::Set(FloatTag(), query.farOffset[2])),
        tMin_(hn::Set(FloatTag(), query.tMin)),
        planesX_(planesAlong(query, 0)),
        planesY_(planesAlong(query, 1)),
        planesZ_(planesAlong(query, 2)) {}

  /// FMA is welcome here: the slack in the offsets covers any way to round.
  HWY_INLINE void test(const WideNode& node, Floats tMax, BoxTest& result) const {
    const FloatTag d;
    const float* const planes = &node.planes[0][0];
    forEachVector([&](auto i) {
      const float* const nearPlanes = planes + i * kLanesPerVector;
      const auto at = [&](std::size_t offset) { return hn::Load(d, nearPlanes + offset); };
      const Floats nearX = hn::MulAdd(at(planesX_), inverseX_, nearX_);
      const Floats nearY = hn::MulAdd(at(planesY_), inverseY_, nearY_);
      const Floats nearZ = hn::MulAdd(at(planesZ_), inverseZ_, nearZ_);
      const Floats farX = hn::MulAdd(at(planesX_ ^ kLaneCount), inverseX_, farX_);
      const Floats farY = hn::MulAdd(at(planesY_ ^ kLaneCount), inverseY_, farY_);
      const Floats farZ = hn::MulAdd(at(planesZ_ ^ kLaneCount), inverseZ_, farZ_);
      result.tNear.vectors[i] = hn::Max(hn::Max(nearX, nearY), hn::Max(nearZ, tMin_));
      result.tFar.vectors[i] = hn::Min(hn::Min(farX, farY), hn::Min(farZ, tMax));
    });
  }

 private:
  /// Offset of the planes that the ray meets first; with one bit flipped, of the others.
  static HWY_INLINE std::size_t planesAlong(const WideQuery& query, std::size_t axis) {
    return (2 * axis + (query.octant >> axis & 1u)) * kLaneCount;
  }

  Floats inverseX_, inverseY_, inverseZ_;
  Floats nearX_, nearY_, nearZ_;
  Floats farX_, farY_, farZ_;
  Floats tMin_;
  std::size_t planesX_, planesY_, planesZ_;
};

/// The slots whose boxes the ray meets, one bit for each.
HWY_INLINE std::uint32_t findMet(const BoxTest& test) {
  Mask isMet[kVectorCount];
  forEachVector([&](auto i) { isMet[i] = hn::Le(test.tNear.vectors[i], test.tFar.vectors[i]); });
  return bitsOf(isMet);
}

HWY_INLINE const std::uint32_t* childWords(const WideNode& node) {
  return reinterpret_cast<const std::uint32_t*>(node.children.data());
}

/// Picks one of sixteen floats for each lane.
HWY_INLINE Floats pick(const Lanes& from, Words indices) {
  const FloatTag d;
  const WordTag words;
  if constexpr (kVectorCount == 1) {
    return hn::TableLookupLanes(from.vectors[0], hn::IndicesFromVec(d, indices));
  } else if constexpr (kVectorCount == 2) {
    const auto inVector = hn::And(indices, hn::Set(words, kLanesPerVector - 1));
    const auto lookup = hn::IndicesFromVec(d, inVector);
    const auto isUpper = hn::RebindMask(d, hn::Ne(inVector, indices));
    return hn::IfThenElse(isUpper, hn::TableLookupLanes(from.vectors[1], lookup),
                          hn::TableLookupLanes(from.vectors[0], lookup));
  } else {
    HWY_ALIGN float table[kLaneCount];
    forEachVector([&](auto i) { hn::Store(from.vectors[i], d, table + i * kLanesPerVector); });
    HWY_ALIGN std::uint32_t lanes[kLanesPerVector];
    hn::Store(indices, words, lanes);
    HWY_ALIGN float picked[kLanesPerVector];
    for (std::size_t i = 0; i < kLanesPerVector; ++i)
      picked[i] = table[lanes[i]];
    return hn::Load(d, picked);
  }
}

/// Moves the lanes that the mask keeps to the front.
template <class Tag, class Vector>
HWY_INLINE Vector keep(Tag tag, Vector vector, hn::Mask<Tag> mask) {
  if constexpr (kVectorCount == 1) {
    return hn::Compress(vector, mask);
  } else {
    // Highway has the same table in a form that some compilers copy to the stack at each use.
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, mask, bits);
    const hn::Rebind<std::uint8_t, WordTag> bytes;
    const Words lanes = hn::PromoteTo(WordTag(), hn::LoadU(bytes, kKeptLanes.lanes[bits[0]]));
    return hn::TableLookupLanes(vector, hn::IndicesFromVec(tag, lanes));
  }
}

/// Pushes the children whose boxes the ray meets, in any order; returns the new size of the stack.
HWY_INLINE std::size_t pushUnordered(const WideNode& node, const BoxTest& test, Stack& stack,
                                     std::size_t size) {
  const WordTag words;
  if constexpr (kVectorCount <= 2) {
    forEachVector([&](auto i) {
      const auto isMet = hn::RebindMask(words, hn::Le(test.tNear.vectors[i], test.tFar.vectors[i]));
      const Words children = hn::Load(words, childWords(node) + i * kLanesPerVector);
      hn::StoreU(keep(words, children, isMet), words, stack.children + size);
      size += hn::CountTrue(words, isMet);
    });
  } else {
    const std::uint32_t bits = findMet(test);
    for (std::size_t slot = 0; slot < kLaneCount; ++slot) {
      stack.children[size] = childWords(node)[slot];
      size += bits >> slot & 1u;
    }
  }
  return size;
}

/// By how much the words of an order are shifted to unpack them.
HWY_ALIGN constexpr std::uint32_t kSlotShifts[kLaneCount] = {0,  0,  4,  4,  8,  8,  12, 12,
                                                             16, 16, 20, 20, 24, 24, 28, 28};

/// Pushes the children whose boxes the ray meets so that the nearest comes to lie on top. The order
/// is that of the cells, which is known beforehand: nothing is sorted, and nothing depends on how
/// many there are, so that no branch can be mispredicted.
HWY_INLINE std::size_t pushNearestLast(const WideNode& node, std::uint32_t octant,
                                       const BoxTest& test, Stack& stack, std::size_t size) {
  const FloatTag d;
  const WordTag words;
  const SlotOrder& order = node.orders[octant];
  if constexpr (kVectorCount <= 2) {
    // Both words of the order side by side in each pair of lanes: see SlotOrder.
    const hn::Repartition<std::uint64_t, WordTag> longWords;
    const Words packed = hn::BitCast(words, hn::Set(longWords, order.word()));
    Lanes children;
    forEachVector([&](auto i) {
      children.vectors[i] = hn::BitCast(d, hn::Load(words, childWords(node) + i * kLanesPerVector));
    });
    forEachVector([&](auto i) {
      const Words slots =
          hn::And(hn::Shr(packed, hn::Load(words, kSlotShifts + i * kLanesPerVector)),
                  hn::Set(words, kLaneCount - 1));
      const Floats tNear = pick(test.tNear, slots);
      const Mask isMet = hn::Le(tNear, pick(test.tFar, slots));
      const Floats ordered = pick(children, slots);
      hn::StoreU(keep(d, tNear, isMet), d, stack.tNear + size);
      hn::StoreU(hn::BitCast(words, keep(d, ordered, isMet)), words, stack.children + size);
      size += hn::CountTrue(d, isMet);
    });
  } else {
    HWY_ALIGN float tNear[kLaneCount];
    forEachVector(
        [&](auto i) { hn::Store(test.tNear.vectors[i], d, tNear + i * kLanesPerVector); });
    const std::uint32_t bits = findMet(test);
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      const std::size_t slot = order[i];
      stack.tNear[size] = tNear[slot];
      stack.children[size] = childWords(node)[slot];
      size += bits >> slot & 1u;
    }
  }
  return size;
}

/// The edge functions of sixteen triangles: see triangle_intersection.hpp. Plain multiplications
/// and subtractions only, so that each is rounded as it is in the test of a single triangle.
class BlockRay {
 public:
  explicit HWY_INLINE BlockRay(const WideQuery& query)
      : query_(query),
        originX_(hn::Set(FloatTag(), query.originX)),
        originY_(hn::Set(FloatTag(), query.originY)),
        originZ_(hn::Set(FloatTag(), query.originZ)),
        shearX_(hn::Set(FloatTag(), query.shearX)),
        shearY_(hn::Set(FloatTag(), query.shearY)) {}

  /// The lanes whose edge functions do not have both signs: those that can be hit, and no others
  /// but such as have a zero that only exact arithmetic decides.
  HWY_INLINE std::uint32_t findCandidates(const TriangleBlock& block) const {
    const FloatTag d;
    Lanes x;
    Lanes y;
    forEachVector([&](auto i) {
      const std::size_t at = i * kLanesPerVector;
      const Floats z = hn::Sub(hn::Load(d, block.positions[query_.kz] + at), originZ_);
      x.vectors[i] = hn::Sub(hn::Sub(hn::Load(d, block.positions[query_.kx] + at), originX_),
                             hn::Mul(shearX_, z));
      y.vectors[i] = hn::Sub(hn::Sub(hn::Load(d, block.positions[query_.ky] + at), originY_),
                             hn::Mul(shearY_, z));
    });
    Mask isCandidate[kVectorCount];
    forEachVector([&](auto i) {
      const Words a = cornersOf(block, 0, i);
      const Words b = cornersOf(block, 1, i);
      const Words c = cornersOf(block, 2, i);
      const Floats ax = pick(x, a);
      const Floats ay = pick(y, a);
      const Floats bx = pick(x, b);
      const Floats by = pick(y, b);
      const Floats cx = pick(x, c);
      const Floats cy = pick(y, c);
      const Floats u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
      const Floats v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
      const Floats w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
      const Floats zero = hn::Zero(d);
      const Floats least = hn::Min(hn::Min(u, v), w);
      const Floats greatest = hn::Max(hn::Max(u, v), w);
      isCandidate[i] = hn::Or(hn::Ge(least, zero), hn::Le(greatest, zero));
    });
    return bitsOf(isCandidate) & block.usedLanes;
  }

 private:
  static HWY_INLINE Words cornersOf(const TriangleBlock& block, std::size_t corner,
                                    std::size_t vector) {
    const hn::Rebind<std::uint8_t, WordTag> bytes;
    return hn::PromoteTo(WordTag(),
                         hn::LoadU(bytes, block.corners[corner] + vector * kLanesPerVector));
  }

  const WideQuery& query_;
  Floats originX_, originY_, originZ_;
  Floats shearX_, shearY_;
};

struct ShearedCorner {
  float x;
  float y;
  float z;
};

/// The test of one triangle, rounded as in `intersectTriangle`. Returns whether `query` has a new
/// best hit.
HWY_INLINE bool acceptTriangle(WideQuery& query, const TriangleBlock& block, std::uint32_t lane) {
  const auto shear = [&](std::size_t which) -> ShearedCorner {
    const std::size_t i = block.corners[which][lane];
    const float z = block.positions[query.kz][i] - query.originZ;
    return {block.positions[query.kx][i] - query.originX - query.shearX * z,
            block.positions[query.ky][i] - query.originY - query.shearY * z, z};
  };
  const ShearedCorner a = shear(0);
  const ShearedCorner b = shear(1);
  const ShearedCorner c = shear(2);
  const auto edge = [](float ax, float by, float bx, float ay) {
    return static_cast<double>(ax) * static_cast<double>(by) -
           static_cast<double>(bx) * static_cast<double>(ay);
  };
  const double u = edge(c.x, b.y, c.y, b.x);
  const double v = edge(a.x, c.y, a.y, c.x);
  const double w = edge(b.x, a.y, b.y, a.x);
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0))
    return false;
  const double sum = u + v + w;
  if (sum == 0.0)
    return false;
  const double z =
      u * static_cast<double>(a.z) + v * static_cast<double>(b.z) + w * static_cast<double>(c.z);
  const auto t = static_cast<float>(z / (sum * static_cast<double>(query.directionZ)));
  // A NaN fails both comparisons.
  if (!(t >= query.tMin && t <= query.hitT))
    return false;
  const std::uint32_t object = block.objects[lane];
  const bool isTie = t == query.hitT;
  if (isTie && query.hitObject <= object && query.hitObject != 0xFFFF'FFFFu)
    return false;
  if (query.sees != nullptr && !query.sees(query, object))
    return false;
  query.hitT = t;
  query.hitObject = object;
  query.hitBlock = &block;
  query.hitLane = lane;
  query.hitWeights[0] = u;
  query.hitWeights[1] = v;
  query.hitWeights[2] = w;
  return true;
}

/// Tests the triangles of some blocks; returns whether one of them became the best hit.
template <bool kStopsAtAnyHit>
HWY_INLINE bool testBlocks(WideQuery& query, const BlockRay& ray, WideChild child) {
  const TriangleBlock* block = query.blocks + child.firstBlock();
  bool found = false;
  for (std::uint32_t rest = child.blockCount(); rest > 0; --rest, ++block) {
    std::uint32_t candidates = ray.findCandidates(*block);
    while (candidates != 0) {
      const auto lane = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(candidates));
      candidates &= candidates - 1;
      // A triangle is often met again in the next cell.
      if (block->objects[lane] == query.hitObject)
        continue;
      if (acceptTriangle(query, *block, lane)) {
        found = true;
        if (kStopsAtAnyHit)
          return true;
      }
    }
  }
  return found;
}

/// How far a query has come.
struct Progress {
  Stack stack;
  std::size_t size = 1;  ///< of the stack
  bool found = false;

  /// Takes the next subtree from the stack that may hold a hit before the best one; at the same t
  /// a lower object may still win. False if there is none.
  template <bool kStopsAtAnyHit>
  HWY_INLINE bool pop(float hitT, WideChild& child) {
    do {
      if (size == 0)
        return false;
      --size;
    } while (!kStopsAtAnyHit && stack.tNear[size] > hitT);
    child = WideChild::fromWord(stack.children[size]);
    return true;
  }

  /// Fetches the node that comes next if nothing is found before: the cells of a ray follow each
  /// other, so that it is likely to be wanted, and far away in a large tree.
  HWY_INLINE void prefetchNext(const WideQuery& query) const {
    if (size == 0)
      return;
    const WideChild next = WideChild::fromWord(stack.children[size - 1]);
    if (!next.isNode())
      return;
    const WideNode& node = query.nodes[next.nodeIndex()];
    for (const auto& planes : node.planes)
      hwy::Prefetch(planes);
    hwy::Prefetch(node.children.data());
    hwy::Prefetch(&node.orders[query.octant]);
  }
};

/// Goes on until the query is answered, then returns false, or until the next thing to do is to
/// test the object of `child`. Calls nothing, so that the ray can stay in registers.
template <bool kStopsAtAnyHit>
HWY_INLINE bool goToObjects(WideQuery& query, Progress& progress, WideChild& child) {
  const WideRay boxRay(query);
  const BlockRay blockRay(query);
  Floats tMax = hn::Set(FloatTag(), query.hitT);
  while (progress.pop<kStopsAtAnyHit>(query.hitT, child)) {
    if (query.isLargeTree)
      progress.prefetchNext(query);
    if (child.isNode()) {
      const WideNode& node = query.nodes[child.nodeIndex()];
      BoxTest test;
      boxRay.test(node, tMax, test);
      progress.size =
          kStopsAtAnyHit ? pushUnordered(node, test, progress.stack, progress.size)
                         : pushNearestLast(node, query.octant, test, progress.stack, progress.size);
    } else if (child.isObject()) {
      return true;
    } else if (testBlocks<kStopsAtAnyHit>(query, blockRay, child)) {
      progress.found = true;
      if (kStopsAtAnyHit)
        return false;
      tMax = hn::Set(FloatTag(), query.hitT);
    }
  }
  return false;
}

template <bool kStopsAtAnyHit>
HWY_INLINE bool traverse(WideQuery& query) {
  Progress progress;
  progress.stack.tNear[0] = query.tMin;
  progress.stack.children[0] = query.root.word();
  WideChild child;
  while (goToObjects<kStopsAtAnyHit>(query, progress, child)) {
    if (query.testObject(query, child.reference())) {
      progress.found = true;
      if (kStopsAtAnyHit)
        return true;
    }
  }
  return progress.found;
}

inline bool findNearest(WideQuery& query) noexcept {
  return traverse<false>(query);
}

inline bool findAny(WideQuery& query) noexcept {
  return traverse<true>(query);
}

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

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

#include "isa/distance_bounds-inl.hpp"
#include "isa/kernels.hpp"
#include "isa/prepare_ray-inl.hpp"
#include "traversal/wide_query.hpp"

#include <hwy/cache_control.h>
#include <hwy/highway.h>
#include <cmath>
#include <cstddef>
#include <limits>
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

/// One bit for each lane.
HWY_INLINE std::uint32_t bitsOf(Mask mask) {
#if HWY_TARGET == HWY_AVX3
  // Through memory, as Highway hands them out, they would come several cycles later.
  return mask.raw;
#else
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(FloatTag(), mask, bytes);
  return bytes[0] | std::uint32_t{bytes[1]} << 8u;
#endif
}
HWY_INLINE std::uint32_t bitsOf(const Mask (&masks)[kVectorCount]) {
  std::uint32_t all = 0;
  forEachVector([&](auto i) { all |= bitsOf(masks[i]) << (i * kLanesPerVector); });
  return all;
}

/// Subtrees that were put off, the nearest on top. Room for one node more than can be in use:
/// pushing always writes whole vectors. The lowest entry ends the search.
struct Stack {
  static constexpr std::size_t kCapacity = (kMaxWideDepth + 1) * kLaneCount;

  HWY_ALIGN float tNear[kCapacity];
  HWY_ALIGN std::uint32_t children[kCapacity];
  HWY_ALIGN std::uint32_t ordered[kLaneCount];  ///< children of a node as the ray meets them
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

/// Takes from the stack what begins beyond the best hit. Done once for each new hit, so that what
/// is popped need not be looked at: few hits are found on the way to the nearest, many subtrees
/// popped. At the same t a lower object may still win. Returns the new size of the stack.
HWY_INLINE std::size_t dropBeyond(float hitT, Stack& stack, std::size_t size) {
  const FloatTag d;
  const WordTag words;
  std::size_t kept = 0;
  if constexpr (kVectorCount <= 2) {
    const Floats tMax = hn::Set(d, hitT);
    for (std::size_t i = 0; i < size; i += kLanesPerVector) {
      const Floats tNear = hn::LoadU(d, stack.tNear + i);
      const Words children = hn::LoadU(words, stack.children + i);
      const Mask isUsed = hn::FirstN(d, size - i);
      const Mask isKept = hn::And(hn::Le(tNear, tMax), isUsed);
      hn::StoreU(keep(d, tNear, isKept), d, stack.tNear + kept);
      hn::StoreU(keep(words, children, hn::RebindMask(words, isKept)), words,
                 stack.children + kept);
      kept += hn::CountTrue(d, isKept);
    }
  } else {
    for (std::size_t i = 0; i < size; ++i) {
      stack.tNear[kept] = stack.tNear[i];
      stack.children[kept] = stack.children[i];
      kept += stack.tNear[i] <= hitT ? 1u : 0u;
    }
  }
  return kept;
}

/// The highest of the slots that the mask has a bit for; 0 if it has none.
HWY_INLINE std::size_t highestSlot(std::uint32_t bits) {
  return highestBit(bits | 1u);
}

/// Pushes the children whose boxes the ray meets, in any order, but for the last of them, which is
/// returned; without any, `below`, what was on top. Not read back from the stack: what comes next
/// then depends on the tests alone, not on what was just stored.
HWY_INLINE std::uint32_t pushUnordered(const WideNode& node, const BoxTest& test,
                                       std::uint32_t below, Stack& stack, std::size_t& size) {
  const WordTag words;
  const std::uint32_t bits = findMet(test);
  const std::uint32_t last = childWords(node)[highestSlot(bits)];
  if constexpr (kVectorCount <= 2) {
    forEachVector([&](auto i) {
      const auto isMet = hn::RebindMask(words, hn::Le(test.tNear.vectors[i], test.tFar.vectors[i]));
      const Words children = hn::Load(words, childWords(node) + i * kLanesPerVector);
      hn::StoreU(keep(words, children, isMet), words, stack.children + size);
      size += hn::CountTrue(words, isMet);
    });
  } else {
    for (std::size_t slot = 0; slot < kLaneCount; ++slot) {
      stack.children[size] = childWords(node)[slot];
      size += bits >> slot & 1u;
    }
  }
  return bits != 0 ? last : below;
}

/// By how much the words of an order are shifted to unpack them.
HWY_ALIGN constexpr std::uint32_t kSlotShifts[kLaneCount] = {0,  0,  4,  4,  8,  8,  12, 12,
                                                             16, 16, 20, 20, 24, 24, 28, 28};

/// Pushes the children whose boxes the ray meets so that the nearest comes to lie on top, and
/// returns it, or `below` if there is none. The order is that of the cells, which is known
/// beforehand: nothing is sorted, and nothing depends on how many there are, so that no branch can
/// be mispredicted. The nearest is looked up among all children, which are ordered while the boxes
/// are still tested: from the stack it would come back only after these.
HWY_INLINE std::uint32_t pushNearestLast(const WideNode& node, std::uint32_t octant,
                                         const BoxTest& test, std::uint32_t below, Stack& stack,
                                         std::size_t& size) {
  const FloatTag d;
  const WordTag words;
  const SlotOrder& order = node.orders[octant];
  std::uint32_t bits = 0;
  if constexpr (kVectorCount <= 2) {
    // Both words of the order side by side in each pair of lanes: see SlotOrder.
    const hn::Repartition<std::uint64_t, WordTag> longWords;
    const Words packed = hn::BitCast(words, hn::Set(longWords, order.word()));
    Lanes children;
    forEachVector([&](auto i) {
      children.vectors[i] = hn::BitCast(d, hn::Load(words, childWords(node) + i * kLanesPerVector));
    });
    Mask isMet[kVectorCount];
    forEachVector([&](auto i) {
      const Words slots =
          hn::And(hn::Shr(packed, hn::Load(words, kSlotShifts + i * kLanesPerVector)),
                  hn::Set(words, kLaneCount - 1));
      const Floats ordered = pick(children, slots);
      hn::Store(hn::BitCast(words, ordered), words, stack.ordered + i * kLanesPerVector);
      const Floats tNear = pick(test.tNear, slots);
      isMet[i] = hn::Le(tNear, pick(test.tFar, slots));
      hn::StoreU(keep(d, tNear, isMet[i]), d, stack.tNear + size);
      hn::StoreU(hn::BitCast(words, keep(d, ordered, isMet[i])), words, stack.children + size);
      size += hn::CountTrue(d, isMet[i]);
    });
    bits = bitsOf(isMet);
  } else {
    HWY_ALIGN float tNear[kLaneCount];
    forEachVector(
        [&](auto i) { hn::Store(test.tNear.vectors[i], d, tNear + i * kLanesPerVector); });
    const std::uint32_t met = findMet(test);
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      const std::size_t slot = order[i];
      stack.tNear[size] = tNear[slot];
      stack.ordered[i] = childWords(node)[slot];
      stack.children[size] = stack.ordered[i];
      const std::uint32_t isMet = met >> slot & 1u;
      size += isMet;
      bits |= isMet << i;
    }
  }
  const std::uint32_t nearest = stack.ordered[highestSlot(bits)];
  return bits != 0 ? nearest : below;
}

/// The edge functions of sixteen triangles: see triangle_intersection.hpp. Plain multiplications
/// and subtractions only, so that each is rounded as it is in the test of a single triangle.
class BlockRay {
 public:
  explicit HWY_INLINE BlockRay(const WideQuery& query)
      : query_(query),
        rows_{query.axes[0] * TriangleBlock::kPositionCount,
              query.axes[1] * TriangleBlock::kPositionCount,
              query.axes[2] * TriangleBlock::kPositionCount} {
    constexpr float kBeyondAll = 2.0f;
    // In this order a NaN stays, with which nothing is hit.
    least_ = larger(-kBeyondAll, query.tMin * query.depthPerT);
    greatest_ = smaller(kBeyondAll, query.hitT * query.depthPerT);
  }

  /// Which lanes of a block may be hit.
  struct BlockAnswer {
    std::uint32_t candidates;  ///< nothing but exact arithmetic decides
    std::uint32_t certain;     ///< surely hit within the interval; none if they are handed over
  };

  /// Candidates are the lanes whose edge functions do not have both signs: those that can be hit,
  /// and no others but such as have a zero that only exact arithmetic decides; if they are handed
  /// over, also those whose signs may be wrong because corners are rounded.
  ///
  /// Otherwise most of those that are hit outside the interval are left out, and it is known of
  /// most of the others that they are hit: if any hit will do, the search is over. The interval
  /// ends at the best hit so far.
  ///
  /// `sheared` gets the corners if there are candidates, for what comes then.
  template <class Goal>
  HWY_INLINE BlockAnswer test(const TriangleBlock& block, ShearedBlock& sheared) const {
    const FloatTag d;
    Lanes x;
    Lanes y;
    Lanes z;
    forEachVector([&](auto i) {
      const std::size_t at = i * kLanesPerVector;
      const auto fromOrigin = [&](std::size_t axis) {
        return hn::Sub(hn::Load(d, &block.positions[0][0] + rows_[axis] + at),
                       everywhere(query_.origin[axis]));
      };
      z.vectors[i] = fromOrigin(2);
      x.vectors[i] = hn::Sub(fromOrigin(0), hn::Mul(everywhere(query_.shear[0]), z.vectors[i]));
      y.vectors[i] = hn::Sub(fromOrigin(1), hn::Mul(everywhere(query_.shear[1]), z.vectors[i]));
    });
    Edges edges[kVectorCount];
    Mask isCandidate[kVectorCount];
    forEachVector([&](auto i) {
      Edges& e = edges[i];
      const Words a = cornersOf(block, 0, i);
      const Words b = cornersOf(block, 1, i);
      const Words c = cornersOf(block, 2, i);
      e.ax = pick(x, a);
      e.ay = pick(y, a);
      e.bx = pick(x, b);
      e.by = pick(y, b);
      e.cx = pick(x, c);
      e.cy = pick(y, c);
      e.u = hn::Sub(hn::Mul(e.cx, e.by), hn::Mul(e.cy, e.bx));
      e.v = hn::Sub(hn::Mul(e.ax, e.cy), hn::Mul(e.ay, e.cx));
      e.w = hn::Sub(hn::Mul(e.bx, e.ay), hn::Mul(e.by, e.ax));
      e.least = hn::Min(hn::Min(e.u, e.v), e.w);
      e.greatest = hn::Max(hn::Max(e.u, e.v), e.w);
      if constexpr (Goal::kHandsOver) {
        const Floats slack = slackOf(e);
        isCandidate[i] = hn::Or(hn::Ge(e.least, hn::Neg(slack)), hn::Le(e.greatest, slack));
      } else {
        const Floats zero = hn::Zero(d);
        isCandidate[i] = hn::Or(hn::Ge(e.least, zero), hn::Le(e.greatest, zero));
      }
    });
    BlockAnswer lanes = {bitsOf(isCandidate) & block.usedLanes, 0};
    if (lanes.candidates == 0)
      return lanes;
    forEachVector([&](auto i) {
      hn::Store(x.vectors[i], d, sheared.x + i * kLanesPerVector);
      hn::Store(y.vectors[i], d, sheared.y + i * kLanesPerVector);
      hn::Store(z.vectors[i], d, sheared.z + i * kLanesPerVector);
    });
    if constexpr (!Goal::kHandsOver)
      testDepths(block, z, edges, lanes);
    return lanes;
  }

 private:
  // docs/numerics.md, section 3.
  static constexpr float kDepthSlack = 16.0f * 0x1p-24f;
  static constexpr float kTiniest = 0x1p-120f;

  /// The sheared corners of triangles, and their edge functions.
  struct Edges {
    HWY_INLINE Edges() {}

    Floats ax, ay, bx, by, cx, cy;
    Floats u, v, w;
    Floats least, greatest;  ///< of u, v and w
  };

  /// Takes from the candidates what is hit outside the interval, and finds those that are surely
  /// hit within: docs/numerics.md, section 3.
  HWY_INLINE void testDepths(const TriangleBlock& block, const Lanes& z,
                             const Edges (&edges)[kVectorCount], BlockAnswer& lanes) const {
    const FloatTag d;
    Lanes depth;
    forEachVector(
        [&](auto i) { depth.vectors[i] = hn::Mul(z.vectors[i], everywhere(query_.depthPerZ)); });
    Mask isPossible[kVectorCount];
    Mask isCertain[kVectorCount];
    forEachVector([&](auto i) {
      const Edges& e = edges[i];
      // Of the squares, not of the edge functions: their errors grow with these.
      const Floats squares =
          hn::Add(hn::MulAdd(e.ax, e.ax, hn::MulAdd(e.bx, e.bx, hn::Mul(e.cx, e.cx))),
                  hn::MulAdd(e.ay, e.ay, hn::MulAdd(e.by, e.by, hn::Mul(e.cy, e.cy))));
      const Floats slack = hn::MulAdd(squares, hn::Set(d, kDepthSlack), hn::Set(d, kTiniest));
      const Floats u = hn::Abs(e.u);
      const Floats v = hn::Abs(e.v);
      const Floats w = hn::Abs(e.w);
      const Floats sum = hn::Add(hn::Add(u, v), w);
      const Floats weighted =
          hn::MulAdd(u, pick(depth, cornersOf(block, 0, i)),
                     hn::MulAdd(v, pick(depth, cornersOf(block, 1, i)),
                                hn::Mul(w, pick(depth, cornersOf(block, 2, i)))));
      const Floats start = hn::Mul(sum, everywhere(least_));
      const Floats end = hn::Mul(sum, everywhere(greatest_));
      const Floats earliest = hn::Sub(weighted, slack);
      const Floats latest = hn::Add(weighted, slack);
      isPossible[i] = hn::And(hn::Ge(latest, start), hn::Le(earliest, end));
      // Of edge functions that are not zero the signs are right, and those of the test in double.
      const Floats zero = hn::Zero(d);
      const Mask haveOneSign = hn::Or(hn::Gt(e.least, zero), hn::Lt(e.greatest, zero));
      isCertain[i] = hn::And(haveOneSign, hn::And(hn::Ge(earliest, start), hn::Le(latest, end)));
    });
    lanes.candidates &= bitsOf(isPossible);
    lanes.certain = lanes.candidates & bitsOf(isCertain);
  }

  /// How large an edge function of rounded corners may be and still have the wrong sign:
  /// docs/numerics.md, section 3.
  HWY_INLINE Floats slackOf(const Edges& e) const {
    const Floats a = hn::Max(hn::Abs(e.ax), hn::Abs(e.ay));
    const Floats b = hn::Max(hn::Abs(e.bx), hn::Abs(e.by));
    const Floats c = hn::Max(hn::Abs(e.cx), hn::Abs(e.cy));
    return hn::Mul(hn::Max(hn::Max(a, b), c), hn::Set(FloatTag(), query_.edgeSlack));
  }

  static HWY_INLINE Words cornersOf(const TriangleBlock& block, std::size_t corner,
                                    std::size_t vector) {
    const hn::Rebind<std::uint8_t, WordTag> bytes;
    return hn::PromoteTo(WordTag(),
                         hn::LoadU(bytes, block.corners[corner] + vector * kLanesPerVector));
  }

  /// Numbers stay in memory, where operations on vectors can read them: the registers are for what
  /// the tests of boxes need.
  static HWY_INLINE Floats everywhere(float number) { return hn::Set(FloatTag(), number); }

  const WideQuery& query_;
  std::size_t rows_[3];  ///< where the positions along the sheared axes stand
  float least_, greatest_;
};

/// The test of one triangle, rounded as in `intersectTriangle`. Returns whether `query` has a new
/// best hit.
HWY_INLINE bool acceptTriangle(WideQuery& query, const TriangleBlock& block,
                               const ShearedBlock& sheared, std::uint32_t lane) {
  const ShearedCorner a = sheared[block.corners[0][lane]];
  const ShearedCorner b = sheared[block.corners[1][lane]];
  const ShearedCorner c = sheared[block.corners[2][lane]];
  const auto edge = [](float ax, float by, float bx, float ay) {
    return static_cast<double>(ax) * static_cast<double>(by) -
           static_cast<double>(bx) * static_cast<double>(ay);
  };
  const double u = edge(c.x, b.y, c.y, b.x);
  const double v = edge(a.x, c.y, a.y, c.x);
  const double w = edge(b.x, a.y, b.y, a.x);
  // Which sign they have no branch can foresee, but most candidates are hit.
  const double least = smaller(smaller(u, v), w);
  const double greatest = larger(larger(u, v), w);
  const double sum = u + v + w;
  if (static_cast<int>(least < 0.0) + static_cast<int>(greatest > 0.0) == 2 || sum == 0.0)
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
  query.hitT = t;
  query.hitObject = object;
  query.hitBlock = &block;
  query.hitLane = lane;
  query.hitWeights[0] = u;
  query.hitWeights[1] = v;
  query.hitWeights[2] = w;
  return true;
}

/// The lanes with this object: a triangle is often met again in the next cell.
HWY_INLINE std::uint32_t lanesOf(const TriangleBlock& block, std::uint32_t object) {
  const WordTag words;
  Mask isObject[kVectorCount];
  forEachVector([&](auto i) {
    const Words objects = hn::Load(words, block.objects.data() + i * kLanesPerVector);
    isObject[i] = hn::RebindMask(FloatTag(), hn::Eq(objects, hn::Set(words, object)));
  });
  return bitsOf(isObject);
}

/// Tests triangles of a block, those that `lanes` has a bit for; returns whether one of them became
/// the best hit.
template <class Goal>
HWY_INLINE bool testCandidates(WideQuery& query, const TriangleBlock& block,
                               const ShearedBlock& sheared, std::uint32_t lanes) {
  bool found = false;
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto lane = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes));
    found |= acceptTriangle(query, block, sheared, lane);
    if (Goal::kStopsAtAnyHit && found)
      return true;
  }
  return found;
}

/// The same where the query decides, with the corners of the mesh.
HWY_INLINE bool handOverCandidates(WideQuery& query, const TriangleBlock& block,
                                   const ShearedBlock& sheared, std::uint32_t lanes) {
  Candidates candidates;
  for (; lanes != 0; lanes &= lanes - 1) {
    const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes);
    DistanceBounds bounds = {-std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::infinity()};
    if (query.cornersAreRounded) {
      // To look up the corners in the mesh costs more than both bounds.
      bounds = boundByCorners(query, block, sheared, lane);
      if (!bounds.areInside(query) && !bounds.areOutside(query))
        bounds = boundByWeights(query, block, sheared, lane);
      if (bounds.areOutside(query))
        continue;
    }
    candidates.objects[candidates.count] = block.objects[lane];
    candidates.earliest[candidates.count++] = bounds.lower;
  }
  return candidates.count != 0 && query.tests.testCandidates(query, candidates);
}

/// Fetches the node on top of the stack, which comes next if nothing is found before: the cells of
/// a ray follow each other, so that it is likely to be wanted, and far away in a large tree.
HWY_INLINE void prefetchNext(const WideNode* nodes, std::uint32_t octant, WideChild next) {
  if (!next.isNode())
    return;
  const WideNode& node = nodes[next.nodeIndex()];
  for (const auto& planes : node.planes)
    hwy::Prefetch(planes);
  hwy::Prefetch(node.children.data());
  hwy::Prefetch(&node.orders[octant]);
}

/// Why a walk through the tree pauses.
enum class Pause {
  Candidates,  ///< there may be hits in a block
  Object,      ///< an object is to be tested that is in no block
  Hit,         ///< there is a hit, and any will do
  End          ///< the query is answered
};

/// How far a query has come.
struct Progress {
  Stack stack;
  std::size_t size = 0;  ///< of the stack
  bool found = false;

  const TriangleBlock* block = nullptr;  ///< the one tested last
  ShearedBlock sheared;                  ///< its corners, if it has candidates
  std::uint32_t lanes = 0;               ///< its candidates
  std::uint32_t restCount = 0;           ///< blocks behind it, still to be tested
  WideChild object = {};

  HWY_INLINE void push(float tNear, WideChild child) {
    stack.tNear[size] = tNear;
    stack.children[size++] = child.word();
  }
};

/// The same for goals that count.
struct CountedProgress : Progress {
  WideSteps steps;
};
template <class Goal>
using ProgressOf = std::conditional_t<Goal::kCounts, CountedProgress, Progress>;

/// Goes on until there is something to do that needs no vectors. A function of its own, which calls
/// nothing: only then do compilers keep all that it needs of the ray in registers. To fill these
/// again takes fewer cycles than what is spared in between.
template <class Goal>
HWY_NOINLINE Pause walk(const WideQuery& query, ProgressOf<Goal>& progress) {
  const WideRay boxRay(query);
  const BlockRay blockRay(query);
  const Floats tMax = hn::Set(FloatTag(), query.hitT);
  const WideNode* const nodes = query.tree.nodes.data();
  const TriangleBlock* const blocks = query.tree.blocks.data();
  const bool isLarge = query.tree.isLarge;
  Stack& stack = progress.stack;
  std::size_t size = progress.size;
  const TriangleBlock* block = progress.block;
  std::uint32_t restCount = progress.restCount;
  while (true) {
    for (; restCount > 0; --restCount) {
      ++block;
      if constexpr (Goal::kCounts)
        ++progress.steps.blocks;
      const auto answer = blockRay.test<Goal>(*block, progress.sheared);
      if (Goal::kStopsAtAnyHit && answer.certain != 0)
        return Pause::Hit;
      std::uint32_t lanes = answer.candidates;
      if (lanes != 0 && !Goal::kStopsAtAnyHit)
        lanes &= ~lanesOf(*block, query.hitObject);
      if (lanes != 0) {
        progress.size = size;
        progress.block = block;
        progress.lanes = lanes;
        progress.restCount = restCount - 1;
        return Pause::Candidates;
      }
    }
    WideChild child = WideChild::fromWord(stack.children[--size]);
    while (child.isNode()) {
      const std::uint32_t below = stack.children[size - 1];
      if (isLarge)
        prefetchNext(nodes, query.octant, WideChild::fromWord(below));
      const WideNode& node = nodes[child.nodeIndex()];
      if constexpr (Goal::kCounts)
        ++progress.steps.nodes;
      BoxTest test;
      boxRay.test(node, tMax, test);
      child = WideChild::fromWord(
          Goal::kStopsAtAnyHit ? pushUnordered(node, test, below, stack, size)
                               : pushNearestLast(node, query.octant, test, below, stack, size));
      --size;
    }
    if (child.isObject()) {
      progress.size = size;
      progress.restCount = 0;
      progress.object = child;
      return child.isEnd() ? Pause::End : Pause::Object;
    }
    block = blocks + child.firstBlock() - 1;
    restCount = child.blockCount();
  }
}

/// Of a ray that is prepared, once and not each time that the walk goes on.
HWY_INLINE void scaleDepths(WideQuery& query) {
  const float half = 0.5f / query.reach;
  query.depthPerT = half * std::fabs(query.directionZ);
  query.depthPerZ = std::copysign(half, query.directionZ);
}

/// Searches below a node or a leaf, with a prepared ray.
template <class Goal>
HWY_INLINE bool searchBelow(WideQuery& query, ProgressOf<Goal>& progress, WideChild start) {
  progress.push(-std::numeric_limits<float>::infinity(), WideChild::end());
  progress.push(query.tMin, start);
  while (true) {
    const float end = query.hitT;
    const Pause pause = walk<Goal>(query, progress);
    if (Goal::kStopsAtAnyHit && pause == Pause::Hit)
      return true;
    if (pause == Pause::End)
      return progress.found;
    if (pause == Pause::Object)
      progress.found |= query.tests.testObject(query, progress.object.objectNumber());
    else if constexpr (Goal::kHandsOver)
      progress.found |=
          handOverCandidates(query, *progress.block, progress.sheared, progress.lanes);
    else
      progress.found |=
          testCandidates<Goal>(query, *progress.block, progress.sheared, progress.lanes);
    if (Goal::kStopsAtAnyHit && progress.found)
      return true;
    if (query.hitT < end)
      progress.size = dropBeyond(query.hitT, progress.stack, progress.size);
  }
}

template <class Goal>
HWY_INLINE bool search(WideQuery& query, ProgressOf<Goal>& progress) {
  if (query.ray != nullptr && !prepareRay(query)) {
    query.isOutOfRange = true;
    return false;
  }
  scaleDepths(query);
  return searchBelow<Goal>(query, progress, query.tree.root);
}

template <class Goal>
bool search(WideQuery& query) noexcept {
  Progress progress;
  return search<Goal>(query, progress);
}

template <class Goal>
bool count(WideQuery& query, WideSteps& steps) noexcept {
  CountedProgress progress;
  const bool found = search<Goal>(query, progress);
  steps.nodes += progress.steps.nodes;
  steps.blocks += progress.steps.blocks;
  return found;
}

struct Nearest {
  static constexpr bool kStopsAtAnyHit = false;
  static constexpr bool kHandsOver = false;  ///< whether `WideTests::testCandidates` decides
  static constexpr bool kCounts = false;     ///< whether steps are counted
};
struct Any {
  static constexpr bool kStopsAtAnyHit = true;
  static constexpr bool kHandsOver = false;
  static constexpr bool kCounts = false;
};
struct NearestCounted : Nearest {
  static constexpr bool kCounts = true;
};
struct AnyCounted : Any {
  static constexpr bool kCounts = true;
};
struct NearestHandedOver {
  static constexpr bool kStopsAtAnyHit = false;
  static constexpr bool kHandsOver = true;
  static constexpr bool kCounts = false;
};
struct AnyHandedOver {
  static constexpr bool kStopsAtAnyHit = true;
  static constexpr bool kHandsOver = true;
  static constexpr bool kCounts = false;
};

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

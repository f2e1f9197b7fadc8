// Packets of rays in the wide form of a tree, compiled once for each instruction set; hence no
// include guard but the one of Highway.

#if defined(PLANETREE_PACKET_TRAVERSAL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PLANETREE_PACKET_TRAVERSAL_INL
#undef PLANETREE_PACKET_TRAVERSAL_INL
#else
#define PLANETREE_PACKET_TRAVERSAL_INL
#endif

#include "isa/interleaved_search-inl.hpp"
#include "isa/packet_rays-inl.hpp"
#include "isa/ray_bundles-inl.hpp"
#include "isa/wide_traversal-inl.hpp"
#include "traversal/ray_packet.hpp"

#include <hwy/highway.h>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>

HWY_BEFORE_NAMESPACE();
namespace planetree::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// With fewer rays that go the same way, or such that go apart so far (in parts of the largest
/// component), each is searched for on its own: the bounds of all would meet nearly everything.
constexpr std::size_t kFewestInPacket = 6;
constexpr float kMostSpread = 0.25f;
/// With no more rays below a node each goes on by itself. Measured: 0, 2, 3 and 5 are slower.
constexpr std::size_t kMostOnTheirOwn = 1;

// Numbers in double, as many as a vector holds.
constexpr std::size_t kDoublesPerVector = HWY_MIN(kLaneCount, HWY_LANES(double));
using DoubleTag = hn::FixedTag<double, kDoublesPerVector>;
using Doubles = hn::Vec<DoubleTag>;
/// As many floats as doubles.
using NarrowTag = hn::FixedTag<float, kDoublesPerVector>;
using Narrow = hn::Vec<NarrowTag>;
/// Vectors of doubles for one of floats.
constexpr std::size_t kPartCount = kLanesPerVector / kDoublesPerVector;
static_assert(kPartCount == 1 || kPartCount == 2);

/// The places in an order, from the farthest on, of slots whose boxes are met.
HWY_INLINE std::uint32_t findMetInOrder(const SlotOrder& order, const BoxTest& test) {
  if constexpr (kVectorCount <= 2) {
    const WordTag words;
    const hn::Repartition<std::uint64_t, WordTag> longWords;
    const Words packed = hn::BitCast(words, hn::Set(longWords, order.word()));
    Mask isMet[kVectorCount];
    forEachVector([&](auto i) {
      const Words slots =
          hn::And(hn::Shr(packed, hn::Load(words, kSlotShifts + i * kLanesPerVector)),
                  hn::Set(words, kLaneCount - 1));
      isMet[i] = hn::Le(pick(test.tNear, slots), pick(test.tFar, slots));
    });
    return bitsOf(isMet);
  } else {
    const std::uint32_t met = findMet(test);
    std::uint32_t ordered = 0;
    for (std::size_t i = 0; i < kLaneCount; ++i)
      ordered |= (met >> order[i] & 1u) << i;
    return ordered;
  }
}

/// Subtrees that were put off, the nearest on top, and for which rays.
struct PacketStack {
  static constexpr std::size_t kCapacity = (kMaxWideDepth + 1) * kLaneCount;

  RayNumbers tNear[kCapacity];
  std::uint32_t children[kCapacity];
  std::uint32_t rays[kCapacity];
};

/// The best hits so far.
struct PacketHits {
  HWY_ALIGN std::uint32_t block[kLaneCount];
  HWY_ALIGN std::uint32_t lane[kLaneCount];
  HWY_ALIGN double weights[3][kLaneCount];
};

/// A corner as each ray sees it.
struct PacketCorner {
  RayNumbers x, y, z;
};

/// Room that one packet after the other uses.
struct PacketRoom {
  PacketStack stack;
  PacketCorner corners[TriangleBlock::kPositionCount];  ///< of a block
  Progress progress;
};

/// A ray of a packet on its own.
struct OwnQuery : WideQuery {
  using WideQuery::WideQuery;

  std::size_t packet;
  std::size_t ray;
};

/// What a ray had put off when it left its packet, the nearest last.
struct OwnStack {
  /// More than rays of measured scenes ever had put off; beyond it a ray stays in its packet.
  static constexpr std::size_t kCapacity = 32;

  std::size_t size;
  float tNear[kCapacity];
  std::uint32_t children[kCapacity];
};

/// Answers a packet: rays that go the same way together, the others each on its own.
template <class Goal>
class PacketSearch {
 public:
  /// With what else must outlive it. Returns the rays that are left for `queryOf`.
  HWY_INLINE std::uint32_t begin(const WideTree& tree, RayPacket& packet, std::size_t packetIndex,
                                 PacketRoom& room) {
    tree_ = &tree;
    packet_ = &packet;
    packetIndex_ = packetIndex;
    room_ = &room;
    packet.hits = 0;
    packet.flatHits = 0;
    alive_ = 0;
    left_ = 0;
    tMaxIsOld_ = true;
    const WordTag words;
    forEachVector([&](auto i) {
      hn::Store(hn::Set(words, 0xFFFF'FFFFu), words, packet.hitObject + i * kLanesPerVector);
      hn::Store(hn::Zero(words), words, hits_.block + i * kLanesPerVector);
      hn::Store(hn::Zero(words), words, hits_.lane + i * kLanesPerVector);
    });
    const std::uint32_t asked = preparePacket(tree, packet, rays_);
    if (asked == 0)
      return 0;
    const std::uint32_t together = findLikeFirst(rays_, asked);
    const bool areTogether = sizeOf(together) >= kFewestInPacket && searchTogether(together);
    return areTogether ? (asked & ~together) | left_ : asked;
  }

  /// Puts on a stack where a ray goes on that is left.
  HWY_INLINE std::size_t putOff(std::size_t ray, Stack& stack, std::size_t size) const {
    if ((left_ >> ray & 1u) == 0) {
      stack.tNear[size] = packet_->tMin[ray];
      stack.children[size++] = tree_->root.word();
      return size;
    }
    const OwnStack& own = stacks_[ray];
    for (std::size_t i = 0; i < own.size; ++i) {
      stack.tNear[size] = own.tNear[i];
      stack.children[size++] = own.children[i];
    }
    return size;
  }

  /// A query of a ray that is prepared.
  HWY_INLINE OwnQuery& queryOf(std::size_t ray) {
    void* const place = queries_ + ray * sizeof(OwnQuery);
    auto* const query =
        new (place) OwnQuery(*tree_, kNoTests, packet_->tMin[ray], packet_->hitT[ray]);
    query->packet = packetIndex_;
    query->ray = ray;
    setAxes(rays_.mainAxisOf(ray), query->axes);
    for (std::size_t k = 0; k < 3; ++k) {
      query->origin[k] = rays_.origin[k].of[ray];
      query->inverse[k] = rays_.inverse[k].of[ray];
      query->nearOffset[k] = rays_.nearOffset[k].of[ray];
      query->farOffset[k] = rays_.farOffset[k].of[ray];
    }
    query->shear[0] = rays_.shear[0].of[ray];
    query->shear[1] = rays_.shear[1].of[ray];
    query->directionZ = rays_.directionZ.of[ray];
    query->depthPerT = rays_.depthPerT.of[ray];
    query->depthPerZ = rays_.depthPerZ.of[ray];
    query->reach = rays_.reach.of[ray];
    query->octant = rays_.octantOf(ray);
    query->hitObject = packet_->hitObject[ray];
    return *query;
  }

  /// What such a query found.
  HWY_INLINE void takeOver(const WideQuery& query, std::size_t ray) {
    packet_->hits |= 1u << ray;
    if constexpr (Goal::kStopsAtAnyHit) {
      alive_ &= ~(1u << ray);
    } else {
      packet_->hitT[ray] = query.hitT;
      tMaxIsOld_ = true;
      packet_->hitObject[ray] = query.hitObject;
      hits_.block[ray] = static_cast<std::uint32_t>(query.hitBlock - tree_->blocks.data());
      hits_.lane[ray] = query.hitLane;
      for (std::size_t corner = 0; corner < 3; ++corner)
        hits_.weights[corner][ray] = query.hitWeights[corner];
    }
  }

  /// Weights and normals of the best hits, rounded as for a single ray.
  HWY_INLINE void finish() {
    const DoubleTag d;
    const NarrowTag narrow;
    if (packet_->hits == 0)
      return;
    // Of rays without a hit those of some triangle: nobody looks at what comes of it.
    HWY_ALIGN float corners[9][kLaneCount];
    for (std::size_t ray = 0; ray < kLaneCount; ++ray) {
      const TriangleBlock& block = tree_->blocks[hits_.block[ray]];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::size_t position = block.corners[corner][hits_.lane[ray]];
        for (std::size_t a = 0; a < 3; ++a)
          corners[3 * corner + a][ray] = block.positions[a][position];
      }
    }
    std::uint32_t isFlat = 0;
    for (std::size_t at = 0; at < kLaneCount; at += kDoublesPerVector) {
      const Doubles u = hn::Load(d, hits_.weights[0] + at);
      const Doubles v = hn::Load(d, hits_.weights[1] + at);
      const Doubles w = hn::Load(d, hits_.weights[2] + at);
      const Doubles sum = hn::Add(hn::Add(u, v), w);
      hn::Store(hn::DemoteTo(narrow, hn::Div(v, sum)), narrow, packet_->u + at);
      hn::Store(hn::DemoteTo(narrow, hn::Div(w, sum)), narrow, packet_->v + at);

      const auto side = [&](std::size_t corner, std::size_t a) {
        const auto wide = [&](std::size_t i) {
          return hn::PromoteTo(d, hn::Load(narrow, corners[i] + at));
        };
        return hn::Sub(wide(3 * corner + a), wide(a));
      };
      const Doubles px = side(1, 0), py = side(1, 1), pz = side(1, 2);
      const Doubles qx = side(2, 0), qy = side(2, 1), qz = side(2, 2);
      const Doubles nx = hn::Sub(hn::Mul(py, qz), hn::Mul(pz, qy));
      const Doubles ny = hn::Sub(hn::Mul(pz, qx), hn::Mul(px, qz));
      const Doubles nz = hn::Sub(hn::Mul(px, qy), hn::Mul(py, qx));
      const Doubles zero = hn::Zero(d);
      isFlat |=
          setOf(d, hn::And(hn::And(hn::Eq(nx, zero), hn::Eq(ny, zero)), hn::Eq(nz, zero)), at);
      const Doubles square = hn::Add(hn::Add(hn::Mul(nx, nx), hn::Mul(ny, ny)), hn::Mul(nz, nz));
      const Doubles scale = hn::Div(hn::Set(d, 1.0), hn::Sqrt(square));
      hn::Store(hn::DemoteTo(narrow, hn::Mul(nx, scale)), narrow, packet_->normal[0] + at);
      hn::Store(hn::DemoteTo(narrow, hn::Mul(ny, scale)), narrow, packet_->normal[1] + at);
      hn::Store(hn::DemoteTo(narrow, hn::Mul(nz, scale)), narrow, packet_->normal[2] + at);
    }
    packet_->flatHits = isFlat & packet_->hits;
  }

 private:
  static constexpr WideTests kNoTests = {};

  HWY_INLINE const RayNumbers& tMin() const {
    return reinterpret_cast<const RayNumbers&>(packet_->tMin);
  }
  HWY_INLINE RayNumbers& hitT() { return reinterpret_cast<RayNumbers&>(packet_->hitT); }

  /// False if they go apart too far.
  HWY_INLINE bool searchTogether(std::uint32_t together) {
    const auto first = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(together));
    setAxes(rays_.mainAxisOf(first), axes_);
    octant_ = rays_.octantOf(first);
    const ShearedBundle sheared(rays_, axes_, together);
    if (!(sheared.spread() <= kMostSpread))
      return false;
    const RayBundle bundle(rays_, tMin(), octant_, together);
    alive_ = together;
    size_ = 0;
    tMaxIsOld_ = true;
    push(tree_->root, together, tMin());
    PacketStack& stack = room_->stack;
    while (true) {
      --size_;
      WideChild child = WideChild::fromWord(stack.children[size_]);
      std::uint32_t rays = stack.rays[size_] & alive_ & notBehind(stack.tNear[size_]);
      // The nearest child of a node is not looked up on the stack, where it would be later.
      while (rays != 0 && child.isNode() && sizeOf(rays) > kMostOnTheirOwn)
        rays = visitNode(tree_->nodes[child.nodeIndex()], bundle, rays, child);
      if (rays != 0) {
        if (sizeOf(rays) <= kMostOnTheirOwn)
          leave(child, rays);
        else
          visitBlocks(child, sheared, rays);
      }
      if (size_ == 0 || (Goal::kStopsAtAnyHit && alive_ == 0))
        break;
    }
    return true;
  }

  static HWY_INLINE void setAxes(std::uint32_t main, std::uint32_t (&axes)[3]) {
    const Axis x = nextAxis(static_cast<Axis>(main));
    axes[0] = static_cast<std::uint32_t>(x);
    axes[1] = static_cast<std::uint32_t>(nextAxis(x));
    axes[2] = main;
  }

  HWY_INLINE void push(WideChild child, std::uint32_t rays, const RayNumbers& tNear) {
    room_->stack.children[size_] = child.word();
    room_->stack.rays[size_] = rays;
    room_->stack.tNear[size_++] = tNear;
  }

  HWY_INLINE std::uint32_t notBehind(const RayNumbers& tNear) {
    Mask isBefore[kVectorCount];
    forEachVector([&](auto i) { isBefore[i] = hn::Le(tNear[i], hitT()[i]); });
    return bitsOf(isBefore);
  }

  /// Puts off the children that rays meet, but for the nearest, which `child` becomes. Returns the
  /// rays that meet this one.
  HWY_INLINE std::uint32_t visitNode(const WideNode& node, const RayBundle& bundle,
                                     std::uint32_t rays, WideChild& child) {
    BoxTest test;
    bundle.test(node, tMax(), test);
    const SlotOrder& order = node.orders[octant_];
    std::uint32_t nearestRays = 0;
    // From the farthest to the nearest, so that this one comes to lie on top.
    for (std::uint32_t met = findMetInOrder(order, test); met != 0; met &= met - 1) {
      const std::size_t slot = order[hwy::Num0BitsBelowLS1Bit_Nonzero32(met)];
      const std::uint32_t meeting = pushIfMet(node, slot, rays);
      nearestRays = meeting != 0 ? meeting : nearestRays;
      child = meeting != 0 ? WideChild::fromWord(childWords(node)[slot]) : child;
    }
    size_ -= nearestRays != 0 ? 1u : 0u;
    return nearestRays;
  }

  /// Returns the rays that meet the child, which is put off if there are any.
  HWY_INLINE std::uint32_t pushIfMet(const WideNode& node, std::size_t slot, std::uint32_t rays) {
    const FloatTag d;
    const auto plane = [&](std::size_t a, std::uint32_t isFar) {
      return hn::Set(d, node.planes[2 * a + ((octant_ >> a & 1u) ^ isFar)][slot]);
    };
    Mask isMet[kVectorCount];
    forEachVector([&](auto i) {
      const auto along = [&](std::size_t a, std::uint32_t isFar) {
        const RayNumbers& offset = isFar != 0 ? rays_.farOffset[a] : rays_.nearOffset[a];
        return hn::MulAdd(plane(a, isFar), rays_.inverse[a][i], offset[i]);
      };
      const Floats tNear =
          hn::Max(hn::Max(along(0, 0), along(1, 0)), hn::Max(along(2, 0), tMin()[i]));
      const Floats tFar =
          hn::Min(hn::Min(along(0, 1), along(1, 1)), hn::Min(along(2, 1), hitT()[i]));
      room_->stack.tNear[size_].put(i, tNear);
      isMet[i] = hn::Le(tNear, tFar);
    });
    const std::uint32_t meeting = bitsOf(isMet) & rays;
    room_->stack.children[size_] = childWords(node)[slot];
    room_->stack.rays[size_] = meeting;
    size_ += meeting != 0 ? 1u : 0u;
    return meeting;
  }

  HWY_INLINE void visitBlocks(WideChild child, const ShearedBundle& sheared, std::uint32_t rays) {
    const std::uint32_t end = child.firstBlock() + child.blockCount();
    for (std::uint32_t index = child.firstBlock(); index < end; ++index) {
      const TriangleBlock& block = tree_->blocks[index];
      const std::uint32_t met = sheared.findMet(block);
      std::uint32_t needed = 0;  // corners
      for (std::uint32_t lanes = met; lanes != 0; lanes &= lanes - 1) {
        const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes);
        for (std::size_t corner = 0; corner < 3; ++corner)
          needed |= 1u << block.corners[corner][lane];
      }
      for (; needed != 0; needed &= needed - 1)
        shear(block, hwy::Num0BitsBelowLS1Bit_Nonzero32(needed));
      // First all are tested, then decided: which of them have candidates no branch can foresee.
      std::uint32_t candidates[TriangleBlock::kLaneCount];
      std::uint32_t withCandidates = 0;
      for (std::uint32_t lanes = met; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(lanes));
        candidates[lane] = findCandidates(block, lane) & rays;
        withCandidates |= (candidates[lane] != 0 ? 1u : 0u) << lane;
      }
      for (; withCandidates != 0; withCandidates &= withCandidates - 1) {
        const auto lane =
            static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(withCandidates));
        decide(block, index, lane, candidates[lane]);
      }
      if constexpr (Goal::kStopsAtAnyHit) {
        rays &= alive_;
        if (rays == 0)
          return;
      }
    }
  }

  HWY_INLINE void shear(const TriangleBlock& block, std::size_t position) {
    const FloatTag d;
    PacketCorner& corner = room_->corners[position];
    forEachVector([&](auto i) {
      const auto fromOrigin = [&](std::size_t k) {
        return hn::Sub(hn::Set(d, block.positions[axes_[k]][position]), rays_.origin[k][i]);
      };
      const Floats z = fromOrigin(2);
      corner.z.put(i, z);
      corner.x.put(i, hn::Sub(fromOrigin(0), hn::Mul(rays_.shear[0][i], z)));
      corner.y.put(i, hn::Sub(fromOrigin(1), hn::Mul(rays_.shear[1][i], z)));
    });
  }

  [[nodiscard]] HWY_INLINE const PacketCorner& cornerOf(const TriangleBlock& block,
                                                        std::uint32_t lane,
                                                        std::size_t corner) const {
    return room_->corners[block.corners[corner][lane]];
  }

  /// As `BlockRay::test`, with the roles of rays and triangles exchanged.
  HWY_INLINE std::uint32_t findCandidates(const TriangleBlock& block, std::uint32_t lane) const {
    const FloatTag d;
    const PacketCorner& a = cornerOf(block, lane, 0);
    const PacketCorner& b = cornerOf(block, lane, 1);
    const PacketCorner& c = cornerOf(block, lane, 2);
    Mask isCandidate[kVectorCount];
    forEachVector([&](auto i) {
      const Floats u = hn::Sub(hn::Mul(c.x[i], b.y[i]), hn::Mul(c.y[i], b.x[i]));
      const Floats v = hn::Sub(hn::Mul(a.x[i], c.y[i]), hn::Mul(a.y[i], c.x[i]));
      const Floats w = hn::Sub(hn::Mul(b.x[i], a.y[i]), hn::Mul(b.y[i], a.x[i]));
      const Floats zero = hn::Zero(d);
      isCandidate[i] =
          hn::Or(hn::Ge(hn::Min(hn::Min(u, v), w), zero), hn::Le(hn::Max(hn::Max(u, v), w), zero));
    });
    return bitsOf(isCandidate);
  }

  /// As `acceptTriangle`, for the rays of a set.
  HWY_INLINE void decide(const TriangleBlock& block, std::uint32_t index, std::uint32_t lane,
                         std::uint32_t rays) {
    const std::uint32_t object = block.objects[lane];
    const PacketCorner& a = cornerOf(block, lane, 0);
    const PacketCorner& b = cornerOf(block, lane, 1);
    const PacketCorner& c = cornerOf(block, lane, 2);
    const FloatTag d;
    const WordTag words;
    std::uint32_t accepted = 0;
    forEachVector([&](auto i) {
      const std::size_t at = i * kLanesPerVector;
      Doubles u[kPartCount], v[kPartCount], w[kPartCount];
      Narrow t[kPartCount];
      for (std::size_t part = 0; part < kPartCount; ++part) {
        const std::size_t from = at + part * kDoublesPerVector;
        t[part] = intersect(a, b, c, from, u[part], v[part], w[part]);
      }
      // With a NaN nothing is accepted.
      const Floats nearest = joined(t);
      const Floats best = hitT()[i];
      const Words bestObject = hn::Load(words, packet_->hitObject + at);
      const Mask isLower = hn::RebindMask(d, hn::Lt(hn::Set(words, object), bestObject));
      const Mask isBetter = hn::Or(hn::Lt(nearest, best), hn::And(hn::Eq(nearest, best), isLower));
      const Mask isAccepted =
          hn::And(hn::And(isBetter, hn::Ge(nearest, tMin()[i])), maskOf(d, rays, at));
      const std::uint32_t set = setOf(d, isAccepted, 0);
      accepted |= set << at;
      if constexpr (!Goal::kStopsAtAnyHit) {
        // Whole vectors are written, as they are read again soon.
        hitT().put(i, hn::IfThenElse(isAccepted, nearest, best));
        const auto write = [&](std::uint32_t word, std::uint32_t* to) {
          const auto areAccepted = hn::RebindMask(words, isAccepted);
          hn::Store(hn::IfThenElse(areAccepted, hn::Set(words, word), hn::Load(words, to + at)),
                    words, to + at);
        };
        write(object, packet_->hitObject);
        write(index, hits_.block);
        write(lane, hits_.lane);
        for (std::size_t part = 0; part < kPartCount; ++part) {
          const std::size_t from = at + part * kDoublesPerVector;
          const DoubleTag wide;
          const auto areAccepted = maskOf(wide, set, part * kDoublesPerVector);
          hn::BlendedStore(u[part], areAccepted, wide, hits_.weights[0] + from);
          hn::BlendedStore(v[part], areAccepted, wide, hits_.weights[1] + from);
          hn::BlendedStore(w[part], areAccepted, wide, hits_.weights[2] + from);
        }
      }
    });
    packet_->hits |= accepted;
    if constexpr (Goal::kStopsAtAnyHit)
      alive_ &= ~accepted;
    else
      tMaxIsOld_ |= accepted != 0;
  }

  /// Where rays meet the plane of a triangle, as many rays from this one on as there are doubles in
  /// a vector, and the weights of the corners there; NaN for those that miss it.
  HWY_INLINE Narrow intersect(const PacketCorner& a, const PacketCorner& b, const PacketCorner& c,
                              std::size_t from, Doubles& u, Doubles& v, Doubles& w) const {
    const DoubleTag d;
    const NarrowTag narrow;
    const auto wide = [&](const RayNumbers& numbers) {
      return hn::PromoteTo(d, hn::Load(narrow, numbers.of + from));
    };
    const auto edge = [](Doubles px, Doubles qy, Doubles qx, Doubles py) {
      return hn::Sub(hn::Mul(px, qy), hn::Mul(qx, py));
    };
    const Doubles ax = wide(a.x), ay = wide(a.y);
    const Doubles bx = wide(b.x), by = wide(b.y);
    const Doubles cx = wide(c.x), cy = wide(c.y);
    u = edge(cx, by, cy, bx);
    v = edge(ax, cy, ay, cx);
    w = edge(bx, ay, by, ax);
    const Doubles zero = hn::Zero(d);
    const Doubles sum = hn::Add(hn::Add(u, v), w);
    const auto isOutside =
        hn::And(hn::Lt(hn::Min(hn::Min(u, v), w), zero), hn::Gt(hn::Max(hn::Max(u, v), w), zero));
    const auto isHit = hn::AndNot(isOutside, hn::Ne(sum, zero));
    const Doubles z =
        hn::Add(hn::Add(hn::Mul(u, wide(a.z)), hn::Mul(v, wide(b.z))), hn::Mul(w, wide(c.z)));
    const Doubles t = hn::Div(z, hn::Mul(sum, wide(rays_.directionZ)));
    const Doubles none = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
    return hn::DemoteTo(narrow, hn::IfThenElse(isHit, t, none));
  }

  static HWY_INLINE Floats joined(const Narrow (&parts)[kPartCount]) {
#if HWY_TARGET == HWY_SCALAR
    return parts[0];
#else
    return hn::Combine(FloatTag(), parts[1], parts[0]);
#endif
  }

  /// The end of the longest ray.
  HWY_INLINE float tMax() {
    if (tMaxIsOld_)
      tMax_ = rangeOf(hitT(), alive_).greatest;
    tMaxIsOld_ = false;
    return tMax_;
  }

  // --- rays on their own ---

  /// Rays that have no company below this child, which stands on the stack at `size_`, leave the
  /// packet with all that they have put off, or, if that is too much, search there and come back.
  HWY_INLINE void leave(WideChild child, std::uint32_t rays) {
    for (; rays != 0; rays &= rays - 1) {
      const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero32(rays);
      if (size_ >= OwnStack::kCapacity) {
        searchAlone(child, ray);
        continue;
      }
      OwnStack& own = stacks_[ray];
      own.size = 0;
      for (std::size_t i = 0; i <= size_; ++i) {
        own.tNear[own.size] = room_->stack.tNear[i].of[ray];
        own.children[own.size] = room_->stack.children[i];
        const bool isNear = own.tNear[own.size] <= packet_->hitT[ray];
        own.size += (room_->stack.rays[i] >> ray & 1u) & (isNear ? 1u : 0u);
      }
      left_ |= 1u << ray;
      alive_ &= ~(1u << ray);
    }
  }

  HWY_NOINLINE void searchAlone(WideChild child, std::size_t ray) {
    WideQuery& query = queryOf(ray);
    room_->progress.size = 0;
    room_->progress.found = false;
    room_->progress.restCount = 0;
    if (searchBelow<Goal>(query, room_->progress, child))
      takeOver(query, ray);
  }

  const WideTree* tree_;
  RayPacket* packet_;
  std::size_t packetIndex_;
  PacketRoom* room_;
  PacketRays rays_;
  std::uint32_t axes_[3];  ///< of the rays that are searched for together
  std::uint32_t octant_;
  std::uint32_t alive_;  ///< those of them that still look for something
  float tMax_;           ///< the end of the longest of them
  bool tMaxIsOld_;
  std::size_t size_;    ///< of the stack
  std::uint32_t left_;  ///< rays that have left the packet
  OwnStack stacks_[kLaneCount];
  PacketHits hits_;
  alignas(OwnQuery) std::byte queries_[kLaneCount * sizeof(OwnQuery)];
};

template <class Goal>
void searchPackets(const WideTree& tree, RayPacket* packets, std::size_t count) noexcept {
  static_assert(sizeof(PacketRoom) + RayPacket::kGroupSize * sizeof(PacketSearch<Goal>) +
                    sizeof(InterleavedSearch<Goal>) <
                500'000);  // the stack that trace_batch.hpp speaks of
  PacketRoom room;
  PacketSearch<Goal> searches[RayPacket::kGroupSize];
  std::uint32_t rest[RayPacket::kGroupSize];
  for (std::size_t i = 0; i < count; ++i)
    loadRows(packets[i]);
  for (std::size_t i = 0; i < count; ++i)
    rest[i] = searches[i].begin(tree, packets[i], i, room);

  std::size_t packet = 0;
  const auto next = [&]() -> WideQuery* {
    while (packet < count && rest[packet] == 0)
      ++packet;
    if (packet == count)
      return nullptr;
    const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero32(rest[packet]);
    rest[packet] &= rest[packet] - 1;
    return &searches[packet].queryOf(ray);
  };
  const auto finish = [&](const WideQuery& query, bool found) {
    const auto& own = static_cast<const OwnQuery&>(query);
    if (found)
      searches[own.packet].takeOver(own, own.ray);
  };
  const auto putOff = [&](const WideQuery& query, Stack& stack, std::size_t size) {
    const auto& own = static_cast<const OwnQuery&>(query);
    return searches[own.packet].putOff(own.ray, stack, size);
  };
  InterleavedSearch<Goal>(tree).run(next, putOff, finish);

  if constexpr (!Goal::kStopsAtAnyHit) {
    for (std::size_t i = 0; i < count; ++i)
      searches[i].finish();
  }
}

}  // namespace planetree::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

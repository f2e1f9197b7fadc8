#include "node/divide_leaf.hpp"

#include "support/assert.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace planetree::detail {
namespace {

/// More objects than this are not sorted: to look at all positions would not pay.
constexpr std::size_t kMostSwept = 4096;
constexpr std::size_t kMostSweptOfBins = 16;

/// What a block holds on average of faces that share their corners.
constexpr double kFacesPerBlock = 12.0;

/// A block is divided further where rays start: the walls of a room fit into one, but a ray inside
/// meets but one of them. What a slot for each part costs, in terms of a block for all; and how
/// much of the visits must begin inside for a division to be tried at all.
constexpr double kSlotCost = 0.03;
constexpr double kLeastOfOrigins = 0.5;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// From here on parts are halved, so that cuts of single objects cannot make the tree too deep: a
/// leaf has less than 2^32 objects.
constexpr std::size_t kMaxSweptDepth = kMaxLeafDivisions - 32;

}  // namespace

void LeafDivider::divide(std::span<const std::uint32_t> objects, std::span<const Box3> boxes,
                         LeafPacker* packer, std::vector<Part>& parts,
                         std::vector<TriangleBlock>& blocks) {
  boxes_ = boxes;
  packer_ = packer;
  objects_ = objects;
  places_.resize(boxes.size());
  std::iota(places_.begin(), places_.end(), 0u);
  divideRange(0, boxes.size(), 0, parts, blocks);
}

void LeafDivider::divideRange(std::size_t begin, std::size_t end, std::size_t depth,
                              std::vector<Part>& parts, std::vector<TriangleBlock>& blocks) {
  const auto places = std::span(places_).subspan(begin, end - begin);
  const std::size_t index = parts.size();
  const std::size_t firstBlock = blocks.size();
  const Box3 bounds = boundsOf(places);
  parts.push_back({.bounds = bounds});
  if (places.empty())
    return;
  if (!fitsIntoOne(places)) {
    PLANETREE_ASSERT(depth < kMaxLeafDivisions);
    const auto [axis, leftCount] = cut(places, depth);
    parts[index].axis = axis;
    divideRange(begin, begin + leftCount, depth + 1, parts, blocks);
    parts[index].right = static_cast<std::uint32_t>(parts.size());
    divideRange(begin + leftCount, end, depth + 1, parts, blocks);
  } else if (packer_ == nullptr) {
    parts[index].first = objects_[places.front()];
  } else {
    parts.pop_back();
    const bool mayDivide = depth + places.size() <= kMaxLeafDivisions &&
                           weight_.ofOrigins(bounds) > kLeastOfOrigins * bounds.surfaceArea();
    addBlocks(begin, end, mayDivide ? kSlotCost * weight_(bounds) : kInfinity, parts, blocks);
    return;
  }
  if (packer_ != nullptr) {
    parts[index].first = static_cast<std::uint32_t>(firstBlock);
    parts[index].blockCount = static_cast<std::uint32_t>(blocks.size() - firstBlock);
  }
}

double LeafDivider::addBlocks(std::size_t begin, std::size_t end, double slotCost,
                              std::vector<Part>& parts, std::vector<TriangleBlock>& blocks) {
  const auto places = std::span(places_).subspan(begin, end - begin);
  const std::size_t index = parts.size();
  const auto firstBlock = static_cast<std::uint32_t>(blocks.size());
  parts.push_back({.bounds = boundsOf(places), .first = firstBlock, .blockCount = 1});
  const double costOfOne = weight_(parts[index].bounds) + slotCost;
  if (places.size() > 1 && slotCost < kInfinity) {
    const auto [axis, leftCount] = findBestCut(places);
    double cost = addBlocks(begin, begin + leftCount, slotCost, parts, blocks);
    const auto right = static_cast<std::uint32_t>(parts.size());
    cost += addBlocks(begin + leftCount, end, slotCost, parts, blocks);
    if (cost < costOfOne) {
      parts[index].axis = axis;
      parts[index].right = right;
      parts[index].blockCount = static_cast<std::uint32_t>(blocks.size()) - firstBlock;
      return cost;
    }
    parts.resize(index + 1);
    blocks.resize(firstBlock);
  }
  blocks.push_back(packer_->pack(places));
  return costOfOne;
}

bool LeafDivider::fitsIntoOne(std::span<const std::uint32_t> places) {
  if (packer_ == nullptr || places.size() > TriangleBlock::kLaneCount)
    return places.size() == 1;
  countBlocks(places, leftCounts_);
  return leftCounts_.back() == 1;
}

LeafDivider::Cut LeafDivider::cut(std::span<std::uint32_t> places, std::size_t depth) {
  if (depth >= kMaxSweptDepth)
    return halve(places);
  if (places.size() <= (cuts_ == LeafCuts::Bins ? kMostSweptOfBins : kMostSwept))
    return findBestCut(places);
  const double perTest = packer_ != nullptr ? kFacesPerBlock : 1.0;
  const std::optional<Cut> found = bins_.divide(boxes_, centersOf(places), places, perTest);
  return found ? *found : halve(places);
}

LeafDivider::Cut LeafDivider::halve(std::span<std::uint32_t> places) {
  const Box3 centers = centersOf(places);
  const Axis axis = longestAxis(centers);
  if (centers.size()[axis] > 0.0f)
    sortAlong(axis, places);
  return {axis, places.size() / 2};
}

LeafDivider::Cut LeafDivider::findBestCut(std::span<std::uint32_t> places) {
  const std::size_t count = places.size();
  const Vec3f spread = centersOf(places).size();
  Cut best;
  double bestCost = kInfinity;
  std::size_t bestImbalance = 0;
  order_.assign(places.begin(), places.end());
  leftWeights_.resize(count);
  rightWeights_.resize(count);
  for (const Axis axis : kAxes) {
    // Without any spread all orders are alike; one of them has to do.
    if (!(spread[axis] > 0.0f) && (axis != Axis::Z || best.leftCount != 0))
      continue;
    sortAlong(axis, order_);
    countBlocks(order_, leftCounts_);
    sumUpWeights(order_, leftWeights_);
    backwards_.assign(order_.rbegin(), order_.rend());
    countBlocks(backwards_, rightCounts_);
    sumUpWeights(backwards_, rightWeights_);
    bool isImproved = false;
    for (std::size_t i = 1; i < count; ++i) {
      const double cost = leftWeights_[i - 1] * leftCounts_[i - 1] +
                          rightWeights_[count - i - 1] * rightCounts_[count - i - 1];
      const std::size_t imbalance = std::max(i, count - i);
      if (cost > bestCost || (cost == bestCost && imbalance >= bestImbalance))
        continue;
      best = {axis, i};
      bestCost = cost;
      bestImbalance = imbalance;
      isImproved = true;
    }
    if (isImproved)
      bestOrder_ = order_;
  }
  std::copy(bestOrder_.begin(), bestOrder_.end(), places.begin());
  return best;
}

void LeafDivider::sumUpWeights(std::span<const std::uint32_t> places,
                               std::span<double> weights) const noexcept {
  // No box is empty here, which `Box3::extend` would look for.
  Box3 box;
  for (std::size_t i = 0; i < places.size(); ++i) {
    box.extend(boxes_[places[i]].lower);
    box.extend(boxes_[places[i]].upper);
    weights[i] = weight_(box);
  }
}

void LeafDivider::sortAlong(Axis axis, std::span<std::uint32_t> places) {
  words_.resize(places.size());
  const std::span<std::uint64_t> words = words_.values();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const float center = centerAlong(boxes_[places[i]], axis);
    words[i] = std::uint64_t{orderedBits(center)} << 32u | places[i];
  }
  sorter_.sort(words);
  for (std::size_t i = 0; i < places.size(); ++i)
    places[i] = static_cast<std::uint32_t>(words[i]);
}

void LeafDivider::countBlocks(std::span<const std::uint32_t> places,
                              std::vector<std::uint32_t>& counts) {
  counts.resize(places.size());
  if (packer_ != nullptr)
    packer_->countBlocks(places, counts);
  else
    std::iota(counts.begin(), counts.end(), 1u);
}

Box3 LeafDivider::boundsOf(std::span<const std::uint32_t> places) const noexcept {
  Box3 bounds;
  for (const std::uint32_t place : places)
    bounds.extend(boxes_[place]);
  return bounds;
}

Box3 LeafDivider::centersOf(std::span<const std::uint32_t> places) const noexcept {
  Box3 centers;
  for (const std::uint32_t place : places) {
    const Box3& box = boxes_[place];
    centers.extend(
        Vec3f{centerAlong(box, Axis::X), centerAlong(box, Axis::Y), centerAlong(box, Axis::Z)});
  }
  return centers;
}

}  // namespace planetree::detail

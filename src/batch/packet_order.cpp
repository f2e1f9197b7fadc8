#include "batch/packet_order.hpp"

#include <cmath>

namespace planetree::detail {
namespace {

/// Pictures with fewer rows or columns gain nothing.
constexpr std::size_t kFewestRows = 4;
constexpr std::size_t kFewestColumns = 8;
/// No row is looked for that is longer.
constexpr std::size_t kMostColumns = std::size_t{1} << 16;
/// How many times as far the end of a row is from the beginning of the next as one ray from its
/// neighbour, at least, and the beginnings of two rows, at most.
constexpr double kLeastJump = 6.0;
constexpr double kMostRowStep = 4.0;

/// How far rays are from each other, where they start and at the other end of the scene.
template <class T>
class RayDistance {
 public:
  RayDistance(const RayColumns<T>& rays, double reach) noexcept : rays_(rays), reach_(reach) {}

  [[nodiscard]] double between(std::size_t i, std::size_t k) const noexcept {
    double square = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double start =
          static_cast<double>(rays_.origin[a][i]) - static_cast<double>(rays_.origin[a][k]);
      const double turn = reach_ * (static_cast<double>(rays_.direction[a][i]) -
                                    static_cast<double>(rays_.direction[a][k]));
      square += start * start + turn * turn;
    }
    return std::sqrt(square);
  }

 private:
  const RayColumns<T>& rays_;
  double reach_;
};

/// The length of the first row, or 0. Comparisons with NaN are written to fail.
template <class T>
std::size_t findWidth(const RayColumns<T>& rays, const RayDistance<T>& distance) noexcept {
  const std::size_t most = std::min(rays.count / kFewestRows, kMostColumns);
  if (most < kFewestColumns)
    return 0;
  double step = distance.between(0, 1);
  std::size_t width = 1;
  for (; width <= most; ++width) {
    const double next = distance.between(width - 1, width);
    if (next > kLeastJump * step)
      break;
    if (!(next * kLeastJump >= step))
      return 0;
    step = next;
  }
  if (width < kFewestColumns || width > most || rays.count % width != 0)
    return 0;
  const bool areRowsAlike = distance.between(0, width) <= kMostRowStep * step &&
                            distance.between(width, 2 * width) <= kMostRowStep * step &&
                            distance.between(2 * width - 1, 2 * width) > kLeastJump * step;
  return areRowsAlike ? width : 0;
}

}  // namespace

template <class T>
PacketOrder::PacketOrder(const RayColumns<T>& rays, const Box3& bounds) noexcept
    : rayCount_(rays.count),
      packetCount_((rays.count + RayPacket::kRayCount - 1) / RayPacket::kRayCount) {
  const Vec3f size = bounds.isEmpty() ? Vec3f{} : bounds.size();
  const double reach = static_cast<double>(std::max({size.x, size.y, size.z}));
  width_ = findWidth(rays, RayDistance<T>(rays, reach));
  if (width_ == 0)
    return;
  packetsPerRow_ = (width_ + kSide - 1) / kSide;
  packetCount_ = packetsPerRow_ * ((rayCount_ / width_ + kSide - 1) / kSide);
}

template PacketOrder::PacketOrder(const RayColumns<float>&, const Box3&) noexcept;
template PacketOrder::PacketOrder(const RayColumns<double>&, const Box3&) noexcept;

}  // namespace planetree::detail

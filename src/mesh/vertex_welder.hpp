#pragma once

#include "mesh/mesh_builder.hpp"

#include <planetree/geometry/vec3.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace planetree::detail {

/// Makes one vertex of equal positions. Equal means the same bits, so that no two distinct corners
/// are ever merged; only the two zeros count as one. A hash table with open addressing that holds
/// vertex indices: the positions stay in the builder.
template <std::floating_point T>
class VertexWelder {
 public:
  explicit VertexWelder(MeshBuilder<T>& builder) : builder_(builder), slots_(kFirstSlots, kFree) {}

  /// The vertex at this position; it is added if there is none.
  [[nodiscard]] std::uint32_t vertexAt(const Vec3<T>& position) {
    if (2 * builder_.positions().size() >= slots_.size())
      grow();
    const Key key = keyOf(position);
    std::uint32_t& slot = slotOf(key);
    if (slot == kFree)
      slot = builder_.addVertex(position);
    return slot;
  }

 private:
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  using Key = std::array<Bits, 3>;

  static constexpr std::size_t kFirstSlots = 1024;  // any power of two
  static constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

  static Key keyOf(const Vec3<T>& position) noexcept {
    const auto bits = [](T x) { return std::bit_cast<Bits>(x == T(0) ? T(0) : x); };
    return {bits(position.x), bits(position.y), bits(position.z)};
  }

  /// Multiplies by the golden ratio (Knuth, "The Art of Computer Programming", volume 3, 6.4), and
  /// folds the high half down after each word: coordinates often differ in their high bits alone.
  static std::size_t hash(const Key& key) noexcept {
    constexpr std::uint64_t kGoldenRatio = 0x9E37'79B9'7F4A'7C15u;
    std::uint64_t h = 0;
    for (const Bits word : key) {
      h = (h ^ word) * kGoldenRatio;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }

  /// The slot that holds the vertex with this key, or the free one where it belongs.
  std::uint32_t& slotOf(const Key& key) noexcept {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash(key) & mask;
    while (slots_[i] != kFree && keyOf(builder_.positions()[slots_[i]]) != key)
      i = (i + 1) & mask;
    return slots_[i];
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    const auto count = static_cast<std::uint32_t>(builder_.positions().size());
    for (std::uint32_t i = 0; i < count; ++i)
      slotOf(keyOf(builder_.positions()[i])) = i;
  }

  MeshBuilder<T>& builder_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace planetree::detail

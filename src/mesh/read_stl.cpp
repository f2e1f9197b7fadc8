#include "mesh/mesh_readers.hpp"
#include "mesh/vertex_welder.hpp"
#include "support/byte_order.hpp"
#include "support/parse_number.hpp"
#include "support/text_lines.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// 3D Systems, "Stereolithography interface specification", 1989. Normals are not looked at: the
// order of the corners says which side is outside. Where the text promises more than people keep,
// we take what is clear: several solids in a file, keywords in any case, and loops of any length.

namespace planetree::detail {
namespace {

// The layout of binary files: a header of free text, the number of facets, the facets.
constexpr std::size_t kCountOffset = 80;
constexpr std::size_t kFacetsOffset = 84;
constexpr std::size_t kFacetSize = 50;  // normal and three corners, float; 2 bytes of free use
constexpr std::size_t kFirstCornerOffset = 12;

std::uint64_t facetCount(std::span<const std::byte> bytes) noexcept {
  return loadNumber<std::uint32_t>(bytes.data() + kCountOffset, std::endian::little);
}

template <std::floating_point T>
Vec3<T> loadPosition(const std::byte* from) noexcept {
  const auto component = [from](std::size_t i) {
    return static_cast<T>(loadNumber<float>(from + i * sizeof(float), std::endian::little));
  };
  return {component(0), component(1), component(2)};
}

void checkSize(const MeshInput& input) {
  const std::string advice = "The file is truncated or damaged: copy or export it again";
  const std::uint64_t size = input.bytes.size();
  if (size < kFacetsOffset)
    throw input.malformed("the file ends within its header", advice);
  const std::uint64_t needed = kFacetsOffset + kFacetSize * facetCount(input.bytes);
  if (size == needed)
    return;
  throw input.malformed("the header promises " + std::to_string(facetCount(input.bytes)) +
                            " triangles, which take " + std::to_string(needed) +
                            " bytes, but the file has " + std::to_string(size),
                        advice);
}

constexpr bool isSameKeyword(std::string_view word, std::string_view lowerCase) noexcept {
  const auto isSame = [](char a, char b) {
    return a == b || (a >= 'A' && a <= 'Z' && a + 32 == b);
  };
  return std::equal(word.begin(), word.end(), lowerCase.begin(), lowerCase.end(), isSame);
}

template <std::floating_point T>
class StlTextReader {
 public:
  StlTextReader(const MeshInput& input, MeshBuilder<T>& builder)
      : input_(input), lines_(input.bytes), builder_(builder), welder_(builder) {}

  void read() {
    expect("solid");
    do {
      skipName();
      readSolid();
      skipName();
    } while (beginsNextSolid());
  }

 private:
  void readSolid() {
    while (true) {
      const std::string_view word = takeRequired();
      if (isSameKeyword(word, "endsolid"))
        return;
      if (!isSameKeyword(word, "facet"))
        throw unexpected(word, "facet");
      readFacet();
    }
  }

  void readFacet() {
    const std::int64_t line = lines_.number();
    expect("normal");
    // Many files have an undefined normal here, spelled in many ways.
    for (int i = 0; i < 3; ++i)
      static_cast<void>(takeRequired());
    expect("outer");
    expect("loop");
    readLoop();
    expect("endfacet");
    builder_.addPolygon(corners_, line);
  }

  void readLoop() {
    corners_.clear();
    while (true) {
      const std::string_view word = takeRequired();
      if (isSameKeyword(word, "endloop"))
        return;
      if (!isSameKeyword(word, "vertex"))
        throw unexpected(word, "vertex");
      Vec3<T> position;
      for (const Axis axis : kAxes)
        position[axis] = takeNumber();
      corners_.push_back(welder_.vertexAt(position));
    }
  }

  bool beginsNextSolid() {
    const std::string_view word = take();
    if (word.empty())
      return false;
    if (!isSameKeyword(word, "solid"))
      throw unexpected(word, "solid");
    return true;
  }

  /// The rest of the line of a solid is its name.
  void skipName() noexcept { rest_ = {}; }

  /// The next word, on this line or a later one; empty at the end of the file.
  std::string_view take() noexcept {
    while (true) {
      const std::string_view word = takeWord(rest_);
      if (!word.empty() || !lines_.next())
        return word;
      rest_ = lines_.line();
    }
  }

  std::string_view takeRequired() {
    const std::string_view word = take();
    if (!word.empty())
      return word;
    throw input_.malformed("the file ends before \"endsolid\"",
                           "The file is truncated: copy it again", lines_.number());
  }

  T takeNumber() {
    const std::string_view word = takeRequired();
    const std::optional<T> number = parseNumber<T>(word);
    if (!number)
      throw input_.notANumber(word, lines_.number());
    if (isTooLarge(word, *number))
      builder_.countTooLarge(1);
    return *number;
  }

  void expect(std::string_view keyword) {
    const std::string_view word = takeRequired();
    if (!isSameKeyword(word, keyword))
      throw unexpected(word, keyword);
  }

  Error unexpected(std::string_view word, std::string_view keyword) const {
    return input_.malformed("there is " + quoted(word) + " where " + quoted(keyword) + " belongs",
                            "The file is damaged or not written well: export it again",
                            lines_.number());
  }

  const MeshInput& input_;
  TextLines lines_;
  std::string_view rest_;  ///< of the present line
  MeshBuilder<T>& builder_;
  VertexWelder<T> welder_;
  std::vector<std::int64_t> corners_;  ///< of the facet at hand
};

}  // namespace

bool isStlBinary(std::span<const std::byte> bytes) noexcept {
  return bytes.size() >= kFacetsOffset &&
         bytes.size() == kFacetsOffset + kFacetSize * facetCount(bytes);
}

template <std::floating_point T>
void readStlText(const MeshInput& input, MeshBuilder<T>& builder) {
  StlTextReader<T>(input, builder).read();
}

template <std::floating_point T>
void readStlBinary(const MeshInput& input, MeshBuilder<T>& builder) {
  checkSize(input);
  const std::uint64_t count = facetCount(input.bytes);
  builder.reserveTriangles(count);
  VertexWelder<T> welder(builder);
  for (std::uint64_t facet = 0; facet < count; ++facet) {
    const std::byte* const bytes = input.bytes.data() + kFacetsOffset + facet * kFacetSize;
    std::array<std::int64_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::byte* const corner = bytes + kFirstCornerOffset + i * 3 * sizeof(float);
      corners[i] = welder.vertexAt(loadPosition<T>(corner));
    }
    builder.addPolygon(corners);
  }
}

template void readStlText<float>(const MeshInput&, MeshBuilder<float>&);
template void readStlText<double>(const MeshInput&, MeshBuilder<double>&);
template void readStlBinary<float>(const MeshInput&, MeshBuilder<float>&);
template void readStlBinary<double>(const MeshInput&, MeshBuilder<double>&);

}  // namespace planetree::detail

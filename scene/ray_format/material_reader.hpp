#pragma once

#include "scene/ray_format/texture_reader.hpp"
#include "scene/ray_format/token_reader.hpp"
#include "scene/scene_description.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace planetree::scene::ray_format {

/// Reads materials into the list of the scene, where they are known by their indices.
class MaterialReader {
 public:
  /// The index of the outermost default.
  static constexpr std::uint32_t kBlack = 0;

  /// `scene` must outlive it, and have no materials yet.
  MaterialReader(SceneDescription& scene, TextureReader& textures);

  /// "= { ... }" or "= name". What is not given is that of the surrounding material.
  [[nodiscard]] std::uint32_t readAssignment(TokenReader& tokens, const Token& keyword,
                                             std::uint32_t surrounding);
  /// The same without the "=".
  [[nodiscard]] std::uint32_t read(TokenReader& tokens, std::uint32_t surrounding);

 private:
  struct Named {
    std::uint32_t index;
    TextPlace place;
  };

  [[nodiscard]] std::uint32_t readBlock(TokenReader& tokens, std::uint32_t surrounding);
  [[nodiscard]] ColourSource readColour(TokenReader& tokens);
  /// An image, which takes this factor, or what `readPlain()` returns.
  template <class ReadPlain>
  [[nodiscard]] NumberSource readNumber(TokenReader& tokens, double factorOfMap,
                                        ReadPlain readPlain);
  [[nodiscard]] std::uint32_t readMap(TokenReader& tokens);
  [[nodiscard]] std::uint32_t find(const TokenReader& tokens, const Token& name) const;

  SceneDescription& scene_;
  TextureReader& textures_;
  std::map<std::string, Named, std::less<>> named_;
};

}  // namespace planetree::scene::ray_format

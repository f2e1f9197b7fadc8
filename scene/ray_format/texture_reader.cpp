#include "scene/ray_format/texture_reader.hpp"

#include "support/text_lines.hpp"

#include <string>
#include <string_view>

namespace planetree::scene::ray_format {
namespace {

/// What the error says is wrong, without its place and its advice.
std::string problemOf(const Error& error) {
  std::string_view text = error.what();
  const std::string begin = error.file() + ": ";
  if (text.starts_with(begin))
    text.remove_prefix(begin.size());
  const std::string end = ". " + error.advice();
  if (text.ends_with(end))
    text.remove_suffix(end.size());
  return std::string(text);
}

}  // namespace

std::uint32_t TextureReader::read(const TokenReader& tokens, const Token& file) {
  const std::filesystem::path path = (folder_ / file.text).lexically_normal();
  const auto known = indices_.find(path);
  if (known != indices_.end())
    return known->second;
  try {
    scene_.textures.push_back(readTexture(path));
  } catch (const Error& error) {
    throw Error(
        error.code(),
        "the texture " + planetree::detail::quoted(file.text) +
            " cannot be read: " + problemOf(error),
        error.advice(),
        Error::Place{
            .file = tokens.fileName(), .line = file.place.line, .column = file.place.column});
  }
  const auto index = static_cast<std::uint32_t>(scene_.textures.size() - 1);
  indices_.emplace(path, index);
  return index;
}

}  // namespace planetree::scene::ray_format

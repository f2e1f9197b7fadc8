#include "scene/json_format/texture_table.hpp"

#include "scene/json_format/value_reader.hpp"

#include <vector>

namespace planetree::scene::json_format {

std::filesystem::path filePathOf(const JsonText& text, const Value& value,
                                 const std::filesystem::path& folder, std::string_view what) {
  const std::string& name = stringOf(text, value, what);
  if (name.empty() || name.find('\0') != std::string::npos) {
    throw text.malformed(value.offset, std::string(what) + " is no name of a file",
                         "Give a path, relative to the folder of the scene.");
  }
  return folder / name;
}

Error errorOfFile(const JsonText& text, const Value& value, std::string_view what,
                  const Error& error) {
  std::string problem = error.what();
  // The advice is told apart.
  const std::string end = ". " + error.advice();
  if (!error.advice().empty() && problem.ends_with(end))
    problem.resize(problem.size() - end.size());
  return {error.code(), std::string(what) + " cannot be used: " + problem, error.advice(),
          text.placeOf(value.offset)};
}

std::uint32_t TextureTable::read(const Value& value) {
  const std::filesystem::path path = filePathOf(text_, value, folder_, "\"texture\"");
  const auto next = static_cast<std::uint32_t>(scene_.textures.size());
  const auto [entry, isNew] = indices_.try_emplace(path.string(), next);
  if (isNew) {
    try {
      scene_.textures.push_back(readers_.texture(path));
    } catch (const Error& error) {
      throw errorOfFile(text_, value, "the texture", error);
    }
  }
  return entry->second;
}

std::uint32_t TextureTable::addColour(const Vec3d& colour) {
  scene_.textures.emplace_back(1, 1, std::vector<Vec3f>{Vec3f(colour)});
  return static_cast<std::uint32_t>(scene_.textures.size() - 1);
}

}  // namespace planetree::scene::json_format

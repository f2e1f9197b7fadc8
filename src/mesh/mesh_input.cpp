#include "mesh/mesh_input.hpp"

#include "support/text_lines.hpp"

namespace planetree::detail {

Error MeshInput::malformed(const std::string& problem, const std::string& advice,
                           std::int64_t line) const {
  return Error(ErrorCode::MalformedFile, problem, advice, Error::Place{name, line});
}

Error MeshInput::notANumber(std::string_view word, std::int64_t line) const {
  const bool hasComma = word.find(',') != std::string_view::npos;
  return malformed(quoted(word) + " is not a number",
                   hasComma ? "Write the file again with points, not commas, in its numbers"
                            : "The file is damaged or not written well: export it again",
                   line);
}

Error MeshInput::notAnInteger(std::string_view word, std::int64_t line) const {
  return malformed(quoted(word) + " is not a whole number",
                   "The file is damaged or not written well: export it again", line);
}

}  // namespace planetree::detail

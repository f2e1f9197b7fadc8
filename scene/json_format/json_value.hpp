#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace planetree::scene::json_format {

struct Member;
struct Value;

using Array = std::vector<Value>;
/// In the order of the file.
using Object = std::vector<Member>;

/// A value of a JSON file that knows where it stands, so that an error in what it means can name
/// the place as well as one in how it is written.
struct Value {
  std::variant<std::nullptr_t, bool, double, std::string, Array, Object>
      content;             ///< null at first
  std::size_t offset = 0;  ///< of its first byte in the file
};

struct Member {
  std::string key;
  std::size_t keyOffset = 0;
  Value value;
};

}  // namespace planetree::scene::json_format

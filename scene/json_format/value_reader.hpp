#pragma once

#include "scene/json_format/json_text.hpp"
#include "scene/json_format/json_value.hpp"
#include "scene/json_format/object_syntax.hpp"

#include <planetree/geometry/vec3.hpp>

#include <string>
#include <string_view>

/// Values as the scene takes them. Each function throws `Error` with line and column for what is
/// none; `what` is what it is called: "the field of view".
namespace planetree::scene::json_format {

/// An object whose keys are those of its syntax, and the required ones are all there.
class ObjectReader {
 public:
  ObjectReader(const JsonText& text, const Value& value, const ObjectSyntax& syntax);

  /// Null if the key is not there.
  [[nodiscard]] const Value* find(std::string_view key) const noexcept;
  /// For required keys.
  [[nodiscard]] const Value& at(std::string_view key) const noexcept { return *find(key); }

 private:
  const Object* object_;
};

[[nodiscard]] const Object& objectOf(const JsonText& text, const Value& value,
                                     std::string_view what);
[[nodiscard]] const Array& arrayOf(const JsonText& text, const Value& value, std::string_view what);
[[nodiscard]] const std::string& stringOf(const JsonText& text, const Value& value,
                                          std::string_view what);
[[nodiscard]] bool boolOf(const JsonText& text, const Value& value, std::string_view what);
[[nodiscard]] double numberOf(const JsonText& text, const Value& value, std::string_view what);
[[nodiscard]] double positiveNumberOf(const JsonText& text, const Value& value,
                                      std::string_view what);
/// Zero or more.
[[nodiscard]] double amountOf(const JsonText& text, const Value& value, std::string_view what);
/// [x, y, z].
[[nodiscard]] Vec3d vectorOf(const JsonText& text, const Value& value, std::string_view what);
/// The same, but not all zero, and of a length that can be told; the length is made 1.
[[nodiscard]] Vec3d directionOf(const JsonText& text, const Value& value, std::string_view what);
/// Three positive numbers, or one for all.
[[nodiscard]] Vec3d sizesOf(const JsonText& text, const Value& value, std::string_view what);
/// [red, green, blue], none of them negative, or "#rrggbb".
[[nodiscard]] Vec3d colourOf(const JsonText& text, const Value& value, std::string_view what);

/// The wrong kind of value: "... must be a number, not a string".
[[nodiscard]] Error wrongType(const JsonText& text, const Value& value, std::string_view what,
                              std::string_view expected);

/// `known`, if it is near `typed`, as advice: "Did you mean \"camera\"?"; else all that there are.
[[nodiscard]] std::string adviceOf(std::string_view typed, const std::vector<std::string>& known);

/// A name as errors show it: in quotes, and not too much of it.
[[nodiscard]] std::string inQuotes(std::string_view name);

}  // namespace planetree::scene::json_format

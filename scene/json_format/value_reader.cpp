#include "scene/json_format/value_reader.hpp"

#include "scene/value_ranges.hpp"
#include "support/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace planetree::scene::json_format {

namespace {

std::string_view kindOf(const Value& value) noexcept {
  constexpr std::array<std::string_view, 6> kKinds = {"null",     "true or false", "a number",
                                                      "a string", "a list",        "an object"};
  return kKinds[value.content.index()];
}

std::string joined(std::string_view before, std::string_view after) {
  return std::string(before) + std::string(after);
}

template <class Kind>
const Kind& contentOf(const JsonText& text, const Value& value, std::string_view what,
                      std::string_view expected) {
  if (const auto* content = std::get_if<Kind>(&value.content))
    return *content;
  throw wrongType(text, value, what, expected);
}

bool contains(std::span<const std::string_view> keys, std::string_view key) noexcept {
  return std::ranges::find(keys, key) != keys.end();
}

/// The bytes of "#rrggbb".
bool readHexadecimal(std::string_view digits, std::array<std::uint8_t, 3>& bytes) noexcept {
  if (digits.size() != 7 || digits.front() != '#')
    return false;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char* const first = digits.data() + 1 + 2 * i;
    const auto [end, error] = std::from_chars(first, first + 2, bytes[i], 16);
    if (error != std::errc{} || end != first + 2)
      return false;
  }
  return true;
}

}  // namespace

ObjectReader::ObjectReader(const JsonText& text, const Value& value, const ObjectSyntax& syntax)
    : object_(&objectOf(text, value, joined("the ", syntax.name))) {
  for (const Member& member : *object_) {
    if (contains(syntax.required, member.key) || contains(syntax.optional, member.key))
      continue;
    std::vector<std::string> known(syntax.required.begin(), syntax.required.end());
    known.insert(known.end(), syntax.optional.begin(), syntax.optional.end());
    throw text.malformed(
        member.keyOffset,
        joined("a " + std::string(syntax.name), " has no key ") + inQuotes(member.key),
        adviceOf(member.key, known));
  }
  for (const std::string_view key : syntax.required) {
    if (find(key) == nullptr) {
      throw text.malformed(value.offset, joined("the ", syntax.name) + " has no " + inQuotes(key),
                           joined("Give its ", inQuotes(key) + "."));
    }
  }
}

const Value* ObjectReader::find(std::string_view key) const noexcept {
  const auto member = std::ranges::find(*object_, key, &Member::key);
  return member == object_->end() ? nullptr : &member->value;
}

const Object& objectOf(const JsonText& text, const Value& value, std::string_view what) {
  return contentOf<Object>(text, value, what, "an object");
}

const Array& arrayOf(const JsonText& text, const Value& value, std::string_view what) {
  return contentOf<Array>(text, value, what, "a list");
}

const std::string& stringOf(const JsonText& text, const Value& value, std::string_view what) {
  return contentOf<std::string>(text, value, what, "a string");
}

bool boolOf(const JsonText& text, const Value& value, std::string_view what) {
  return contentOf<bool>(text, value, what, "true or false");
}

double numberOf(const JsonText& text, const Value& value, std::string_view what) {
  return contentOf<double>(text, value, what, "a number");
}

double positiveNumberOf(const JsonText& text, const Value& value, std::string_view what) {
  const double number = numberOf(text, value, what);
  if (!isPositive(number)) {
    throw text.malformed(value.offset, joined(what, " must be greater than 0"),
                         "Give a positive number.");
  }
  return number;
}

double amountOf(const JsonText& text, const Value& value, std::string_view what) {
  const double number = numberOf(text, value, what);
  if (!isAmount(number))
    throw text.malformed(value.offset, joined(what, " is negative"), "Give 0 or more.");
  return number;
}

Vec3d vectorOf(const JsonText& text, const Value& value, std::string_view what) {
  const Array& items = contentOf<Array>(text, value, what, "a list of three numbers");
  if (items.size() != 3) {
    throw text.malformed(value.offset,
                         joined(what, " has " + std::to_string(items.size()) + " numbers"),
                         "Give three, as in [0, 1, 0].");
  }
  return {numberOf(text, items[0], what), numberOf(text, items[1], what),
          numberOf(text, items[2], what)};
}

Vec3d directionOf(const JsonText& text, const Value& value, std::string_view what) {
  const Vec3d vector = vectorOf(text, value, what);
  const Vec3d direction = normalized(vector);
  if (direction == Vec3d{0, 0, 0}) {
    throw text.malformed(value.offset, joined(what, " is no direction"),
                         "Give three numbers that are not all 0.");
  }
  return direction;
}

Vec3d sizesOf(const JsonText& text, const Value& value, std::string_view what) {
  if (std::holds_alternative<double>(value.content)) {
    const double size = positiveNumberOf(text, value, what);
    return {size, size, size};
  }
  const Array& items = contentOf<Array>(text, value, what, "a number or a list of three");
  const Vec3d sizes = vectorOf(text, value, what);
  for (const Value& item : items)
    static_cast<void>(positiveNumberOf(text, item, what));
  return sizes;
}

Vec3d colourOf(const JsonText& text, const Value& value, std::string_view what) {
  if (const auto* digits = std::get_if<std::string>(&value.content)) {
    std::array<std::uint8_t, 3> bytes{};
    if (!readHexadecimal(*digits, bytes)) {
      throw text.malformed(value.offset, joined(what, " is no colour: ") + inQuotes(*digits),
                           "Give [red, green, blue] from 0 to 1, or \"#rrggbb\".");
    }
    return Vec3d{bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
  }
  const Array& items = contentOf<Array>(text, value, what, "[red, green, blue] or \"#rrggbb\"");
  const Vec3d colour = vectorOf(text, value, what);
  for (const Value& item : items)
    static_cast<void>(amountOf(text, item, what));
  return colour;
}

Error wrongType(const JsonText& text, const Value& value, std::string_view what,
                std::string_view expected) {
  return text.malformed(
      value.offset,
      joined(what, " must be ") + joined(expected, ", not ") + std::string(kindOf(value)),
      joined("Give ", expected) + ".");
}

std::string adviceOf(std::string_view typed, const std::vector<std::string>& known) {
  if (const auto nearest = detail::nearestName(typed.substr(0, 64), known))
    return "Did you mean " + inQuotes(*nearest) + "?";
  constexpr std::size_t kMostListed = 12;
  std::string names;
  for (std::size_t i = 0; i < std::min(known.size(), kMostListed); ++i)
    names += (names.empty() ? "" : ", ") + inQuotes(known[i]);
  if (known.size() > kMostListed)
    names += ", ...";
  return names.empty() ? "There is none yet." : "There are " + names + ".";
}

std::string inQuotes(std::string_view name) {
  constexpr std::size_t kLongest = 60;
  std::size_t length = std::min(name.size(), kLongest);
  // Not in the middle of a character.
  while (length < name.size() && (static_cast<unsigned char>(name[length]) & 0xC0u) == 0x80u)
    --length;
  std::string shown = "\"";
  for (const char c : name.substr(0, length))
    shown += static_cast<unsigned char>(c) < 0x20u ? '?' : c;
  shown += name.size() > length ? "...\"" : "\"";
  return shown;
}

}  // namespace planetree::scene::json_format

#include "ray_files/hit_table.hpp"

#include "ray_files/npy_header.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <charconv>
#include <concepts>
#include <cstring>

namespace planetree::tool {

namespace {

constexpr char kByteOrder = std::endian::native == std::endian::little ? '<' : '>';

/// Ids as signed numbers: `kNoId` is -1.
std::int32_t signedId(std::uint32_t id) noexcept {
  return static_cast<std::int32_t>(id);
}

std::string csvHeader(const Occlusion& /*of*/) {
  return "hit\n";
}

template <class T>
std::string csvHeader(const Hit<T>& /*of*/) {
  return "t,geometry,primitive,u,v,nx,ny,nz\n";
}

template <class T>
std::string csvHeader(const NumberedHit<T>& of) {
  return "ray," + csvHeader(of.hit);
}

std::string npyFields(const Occlusion& /*of*/) {
  return "('hit', '|b1')";
}

template <class T>
std::string npyFields(const Hit<T>& /*of*/) {
  const std::string real = fmt::format("{}f{}", kByteOrder, sizeof(T));
  const std::string id = fmt::format("{}i{}", kByteOrder, sizeof(std::int32_t));
  return fmt::format(
      "('t', '{0}'), ('geometry', '{1}'), ('primitive', '{1}'), ('u', '{0}'), ('v', '{0}'), "
      "('nx', '{0}'), ('ny', '{0}'), ('nz', '{0}')",
      real, id);
}

template <class T>
std::string npyFields(const NumberedHit<T>& of) {
  return fmt::format("('ray', '{}i{}'), {}", kByteOrder, sizeof(std::int64_t), npyFields(of.hit));
}

template <class Number>
void appendText(std::string& text, Number number, char end) {
  constexpr std::size_t kLongest = 32;  // more than the 24 characters of a double
  std::array<char, kLongest> digits;
  const auto [last, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), last);
  text += end;
}

void appendCsv(std::string& text, const Occlusion& answer) {
  text += answer.isHit ? "1\n" : "0\n";
}

template <class T>
void appendCsv(std::string& text, const Hit<T>& hit) {
  appendText(text, hit.t, ',');
  appendText(text, signedId(hit.geometry), ',');
  appendText(text, signedId(hit.primitive), ',');
  appendText(text, hit.u, ',');
  appendText(text, hit.v, ',');
  appendText(text, hit.normal.x, ',');
  appendText(text, hit.normal.y, ',');
  appendText(text, hit.normal.z, '\n');
}

template <class T>
void appendCsv(std::string& text, const NumberedHit<T>& answer) {
  appendText(text, answer.ray, ',');
  appendCsv(text, answer.hit);
}

template <class Number>
void appendBytes(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  bytes.append(raw.data(), raw.size());
}

void appendNpy(std::string& bytes, const Occlusion& answer) {
  bytes += answer.isHit ? '\1' : '\0';
}

template <class T>
void appendNpy(std::string& bytes, const Hit<T>& hit) {
  appendBytes(bytes, hit.t);
  appendBytes(bytes, signedId(hit.geometry));
  appendBytes(bytes, signedId(hit.primitive));
  appendBytes(bytes, hit.u);
  appendBytes(bytes, hit.v);
  appendBytes(bytes, hit.normal.x);
  appendBytes(bytes, hit.normal.y);
  appendBytes(bytes, hit.normal.z);
}

template <class T>
void appendNpy(std::string& bytes, const NumberedHit<T>& answer) {
  appendBytes(bytes, static_cast<std::int64_t>(answer.ray));
  appendNpy(bytes, answer.hit);
}

}  // namespace

template <class Answer>
std::string tableHeader(TableFormat format, std::uint64_t count) {
  return format == TableFormat::Csv
             ? csvHeader(Answer{})
             : makeNpyHeader(fmt::format("[{}]", npyFields(Answer{})), count);
}

template <class Answer>
void appendRows(std::string& table, TableFormat format, std::span<const Answer> answers) {
  for (const Answer& answer : answers) {
    if (format == TableFormat::Csv) {
      appendCsv(table, answer);
    } else {
      appendNpy(table, answer);
    }
  }
}

template std::string tableHeader<Hitf>(TableFormat, std::uint64_t);
template std::string tableHeader<Hitd>(TableFormat, std::uint64_t);
template std::string tableHeader<NumberedHit<float>>(TableFormat, std::uint64_t);
template std::string tableHeader<NumberedHit<double>>(TableFormat, std::uint64_t);
template std::string tableHeader<Occlusion>(TableFormat, std::uint64_t);
template void appendRows<Hitf>(std::string&, TableFormat, std::span<const Hitf>);
template void appendRows<Hitd>(std::string&, TableFormat, std::span<const Hitd>);
template void appendRows<NumberedHit<float>>(std::string&, TableFormat,
                                             std::span<const NumberedHit<float>>);
template void appendRows<NumberedHit<double>>(std::string&, TableFormat,
                                              std::span<const NumberedHit<double>>);
template void appendRows<Occlusion>(std::string&, TableFormat, std::span<const Occlusion>);

}  // namespace planetree::tool

#include "ray_files/npy_ray_reader.hpp"

#include "ray_files/npy_header.hpp"

#include "support/byte_order.hpp"
#include "support/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace planetree::tool {

namespace {

/// No header of an array of numbers is longer, and a damaged length must not ask for gigabytes.
constexpr std::uint32_t kLongestHeader = 1 << 16;

constexpr const char* kSaveAgain = "Save the rays again with numpy.save.";

template <class Number>
Number loadLittle(std::string_view bytes) noexcept {
  return detail::loadNumber<Number>(reinterpret_cast<const std::byte*>(bytes.data()),
                                    std::endian::little);
}

std::string shapeText(const std::vector<std::uint64_t>& shape) {
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

}  // namespace

NpyRayReader::NpyRayReader(ByteSource source) : source_(std::move(source)) {
  readHeader();
  checkSize();
}

void NpyRayReader::readHeader() {
  const auto take = [this](std::size_t count) {
    const std::string bytes = source_.take(count);
    if (bytes.size() < count)
      refuseNpy(source_.name(), "ends within its header", kSaveAgain);
    return bytes;
  };
  const std::string start = take(kNpyMagic.size() + 2);
  const auto version = static_cast<unsigned char>(start[kNpyMagic.size()]);
  if (version < 1 || version > 3) {
    refuseNpy(source_.name(), fmt::format("is a .npy file of the unknown version {}", version),
              "Save it as version 1.0: numpy.lib.format.write_array(file, rays, version=(1, 0)).");
  }
  const std::uint32_t length = version == 1
                                   ? loadLittle<std::uint16_t>(take(sizeof(std::uint16_t)))
                                   : loadLittle<std::uint32_t>(take(sizeof(std::uint32_t)));
  if (length > kLongestHeader)
    refuseNpy(source_.name(), fmt::format("claims a header of {} bytes", length), kSaveAgain);

  const NpyHeader header = parseNpyHeader(take(length), source_.name());
  takeType(header.type);
  takeShape(header.shape);
  // With at most one row, both orders are the same bytes.
  if (header.isFortranOrder && rayCount_ > 1) {
    refuseNpy(source_.name(), "is in Fortran order, column after column",
              "Save it row after row: numpy.save(file, numpy.ascontiguousarray(rays)).");
  }
}

void NpyRayReader::takeType(const std::string& type) {
  if (type.empty()) {
    refuseNpy(source_.name(), "is an array of records",
              "Convert it with numpy.lib.recfunctions.structured_to_unstructured.");
  }
  const bool isFloat = type == "<f4" || type == ">f4";
  isDouble_ = type == "<f8" || type == ">f8";
  if (!isFloat && !isDouble_) {
    refuseNpy(
        source_.name(),
        fmt::format("has numbers of the type {}, not float32 or float64", detail::quoted(type)),
        "Convert them: numpy.save(file, rays.astype(numpy.float32)).");
  }
  order_ = type.front() == '>' ? std::endian::big : std::endian::little;
}

void NpyRayReader::takeShape(const std::vector<std::uint64_t>& shape) {
  const bool isTable = shape.size() == 2 && (shape[1] == 6 || shape[1] == 8);
  if (!isTable) {
    refuseNpy(source_.name(),
              fmt::format("has the shape {} instead of (N, 6) or (N, 8)", shapeText(shape)),
              "Each row is a ray: origin and direction, then tMin and tMax if wanted.");
  }
  rayCount_ = shape[0];
  columnCount_ = static_cast<std::size_t>(shape[1]);
}

/// A file that is too short is refused before any work is done for it.
void NpyRayReader::checkSize() const {
  if (!source_.size())
    return;
  const std::uint64_t presentCount = (*source_.size() - source_.position()) / rowBytes();
  if (presentCount < rayCount_)
    refuseTruncated(presentCount);
}

void NpyRayReader::refuseTruncated(std::uint64_t presentCount) const {
  refuseNpy(
      source_.name(),
      fmt::format("ends after {} of the {} rays that its header promises", presentCount, rayCount_),
      "It was not written to its end: save the rays again.");
}

std::size_t NpyRayReader::rowBytes() const noexcept {
  return columnCount_ * (isDouble_ ? sizeof(double) : sizeof(float));
}

std::optional<double> NpyRayReader::progress() const noexcept {
  if (rayCount_ == 0)
    return 1.0;
  return static_cast<double>(readCount_) / static_cast<double>(rayCount_);
}

bool NpyRayReader::next(RayBlock& block, const KeepsGoing& keepsGoing) {
  const std::uint64_t wantedCount =
      std::min<std::uint64_t>(kBlockBytes / rowBytes(), rayCount_ - readCount_);
  if (wantedCount == 0) {
    checkEnd(keepsGoing);
    return false;
  }
  const std::size_t wantedBytes = static_cast<std::size_t>(wantedCount) * rowBytes();
  while (pending_.size() < wantedBytes) {
    const bool hasRay = pending_.size() >= rowBytes();
    if (hasRay && !source_.isReady())
      break;
    if (source_.read(pending_, wantedBytes - pending_.size(), keepsGoing))
      continue;
    if (!keepsGoing())
      return false;
    refuseTruncated(readCount_ + pending_.size() / rowBytes());
  }
  const std::size_t count = pending_.size() / rowBytes();
  block.bytes = pending_.substr(0, count * rowBytes());
  block.columnCount = columnCount_;
  pending_.erase(0, block.bytes.size());
  readCount_ += count;
  return true;
}

void NpyRayReader::checkEnd(const KeepsGoing& keepsGoing) {
  std::string more;
  if (source_.read(more, 1, keepsGoing)) {
    refuseNpy(source_.name(),
              fmt::format("goes on after the {} rays that its header promises", rayCount_),
              "Save the rays again, in one array.");
  }
}

template <class T>
std::vector<Ray<T>> NpyRayReader::decode(const RayBlock& block) const {
  std::vector<Ray<T>> rays;
  rays.reserve(block.bytes.size() / rowBytes());
  const auto* number = reinterpret_cast<const std::byte*>(block.bytes.data());
  const std::byte* const end = number + block.bytes.size();
  while (number != end) {
    std::array<T, 8> columns{};
    for (std::size_t i = 0; i < columnCount_; ++i) {
      if (isDouble_) {
        columns[i] = static_cast<T>(detail::loadNumber<double>(number, order_));
        number += sizeof(double);
      } else {
        columns[i] = static_cast<T>(detail::loadNumber<float>(number, order_));
        number += sizeof(float);
      }
    }
    rays.push_back(rayOfColumns(columns.data(), columnCount_));
  }
  return rays;
}

std::vector<Rayf> NpyRayReader::decodeFloat(const RayBlock& block) const {
  return decode<float>(block);
}

std::vector<Rayd> NpyRayReader::decodeDouble(const RayBlock& block) const {
  return decode<double>(block);
}

}  // namespace planetree::tool

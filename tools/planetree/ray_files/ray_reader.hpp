#pragma once

#include "ray_files/byte_source.hpp"
#include "ray_files/table_format.hpp"

#include <planetree/geometry/ray.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Rays from files of any size. Reading and decoding are two steps: the blocks of a file are read
/// one after the other and decoded by many threads at once, and no more of the file is in memory
/// than the blocks at hand.
namespace planetree::tool {

/// How much of a file is read at once: enough work for a thread to be worth handing out, and little
/// enough that even short files are shared between threads.
inline constexpr std::size_t kBlockBytes = std::size_t{1} << 18;

/// Some whole rays, as they stand in their file.
struct RayBlock {
  std::string bytes;
  std::size_t columnCount = 0;  ///< numbers per ray: 6, or 8 with tMin and tMax
  std::uint64_t firstLine = 0;  ///< of a text, counted from 1
};

class RayReader {
 public:
  RayReader() = default;
  RayReader(const RayReader&) = delete;
  RayReader& operator=(const RayReader&) = delete;
  virtual ~RayReader() = default;

  [[nodiscard]] virtual TableFormat format() const noexcept = 0;
  /// Whether the file holds numbers that float does not.
  [[nodiscard]] virtual bool isDouble() const noexcept = 0;
  /// How many rays there are, where the file says it beforehand.
  [[nodiscard]] virtual std::optional<std::uint64_t> rayCount() const noexcept = 0;
  /// Which part of the file was read, from 0 to 1, where its end is known.
  [[nodiscard]] virtual std::optional<double> progress() const noexcept = 0;

  /// The next block, made of the rays that have arrived: it waits for no more than one. False at
  /// the end, or if `keepsGoing` said no. Throws `Error` with `MalformedFile` or `FileNotReadable`.
  [[nodiscard]] virtual bool next(RayBlock& block, const KeepsGoing& keepsGoing) = 0;

  /// The rays of a block. Any thread may call it, also while `next` reads on. Throws `Error` with
  /// `MalformedFile`.
  [[nodiscard]] virtual std::vector<Rayf> decodeFloat(const RayBlock& block) const = 0;
  [[nodiscard]] virtual std::vector<Rayd> decodeDouble(const RayBlock& block) const = 0;
};

/// Opens a file of rays, or standard input for `-`. The format is told by the first bytes. Throws
/// `Error` if it cannot be read, is empty, or has a header that cannot be.
[[nodiscard]] std::unique_ptr<RayReader> openRays(const std::filesystem::path& path);

/// The ray that a row of a table is: origin and direction, then tMin and tMax if it has 8 columns.
template <class T>
[[nodiscard]] Ray<T> rayOfColumns(const T* columns, std::size_t columnCount) noexcept {
  Ray<T> ray{.origin = {columns[0], columns[1], columns[2]},
             .direction = {columns[3], columns[4], columns[5]}};
  if (columnCount == 8) {
    ray.tMin = columns[6];
    ray.tMax = columns[7];
  }
  return ray;
}

}  // namespace planetree::tool

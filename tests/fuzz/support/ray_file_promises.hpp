#pragma once

#include "ray_files/ray_reader.hpp"

#include "support/expected_error.hpp"
#include "support/memory_file.hpp"
#include "support/promise.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// What holds of every table of rays, whatever the bytes were.
namespace planetree::fuzz {

struct RayTable {
  tool::TableFormat format = tool::TableFormat::Csv;
  std::vector<Rayf> inFloat;
  std::vector<Rayd> inDouble;
};

inline RayTable readRayTable(const std::filesystem::path& path) {
  const auto reader = tool::openRays(path);
  RayTable table;
  table.format = reader->format();
  tool::RayBlock block;
  while (reader->next(block, [] { return true; })) {
    require(block.columnCount == 6 || block.columnCount == 8, "a ray has six or eight numbers");
    for (const Rayf& ray : reader->decodeFloat(block))
      table.inFloat.push_back(ray);
    for (const Rayd& ray : reader->decodeDouble(block))
      table.inDouble.push_back(ray);
  }
  if (const auto promised = reader->rayCount())
    require(*promised == table.inFloat.size(), "there are as many rays as are promised");
  if (const auto progress = reader->progress())
    require(*progress >= 0.0 && *progress <= 1.0, "progress goes from 0 to 1");
  return table;
}

inline void checkRayReader(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(std::as_bytes(std::span(data, size)));
  const auto table =
      readOrRefuse(file.path().string(), [&file] { return readRayTable(file.path()); });
  if (!table)
    return;
  require(table->inFloat.size() == table->inDouble.size(),
          "there are as many rays in float as in double");
  require(table->inFloat.size() <= size, "a ray takes at least a byte");
}

}  // namespace planetree::fuzz

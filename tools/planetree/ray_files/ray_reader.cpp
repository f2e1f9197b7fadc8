#include "ray_files/ray_reader.hpp"

#include "ray_files/csv_ray_reader.hpp"
#include "ray_files/npy_header.hpp"
#include "ray_files/npy_ray_reader.hpp"

#include <planetree/error.hpp>

#include <utility>

namespace planetree::tool {

std::unique_ptr<RayReader> openRays(const std::filesystem::path& path) {
  ByteSource source(path);
  const std::string_view start = source.peek(kNpyMagic.size());
  if (start.empty()) {
    throw Error(ErrorCode::MalformedFile, "is empty",
                "Give rays as CSV or .npy; a CSV file without rays has at least a header.",
                {.file = source.name()});
  }
  if (start == kNpyMagic)
    return std::make_unique<NpyRayReader>(std::move(source));
  return std::make_unique<CsvRayReader>(std::move(source));
}

}  // namespace planetree::tool

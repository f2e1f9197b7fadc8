#include "ray_files/ray_reader.hpp"

#include "ray_files/csv_ray_reader.hpp"
#include "ray_files/npy_header.hpp"
#include "ray_files/npy_ray_reader.hpp"

#include <planetree/error.hpp>

#include "support/text_lines.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace planetree::tool {

namespace {

bool isText(std::string_view bytes) noexcept {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const bool isControl = static_cast<unsigned char>(c) < ' ';
    return isControl && !detail::isBlank(c) && c != '\n';
  });
}

}  // namespace

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
  if (!isText(start)) {
    throw Error(ErrorCode::UnknownFormat, "is neither CSV nor .npy",
                "Save the rays with numpy.save, or with numpy.savetxt and delimiter=','.",
                {.file = source.name()});
  }
  return std::make_unique<CsvRayReader>(std::move(source));
}

}  // namespace planetree::tool

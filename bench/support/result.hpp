#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::bench {

// The values of `Result::measure`.
inline constexpr std::string_view kBuildSeconds = "build_seconds";
inline constexpr std::string_view kBytesPerTriangle = "bytes_per_triangle";
inline constexpr std::string_view kPeakBytesPerTriangle = "peak_bytes_per_triangle";
inline constexpr std::string_view kMraysPerSecond = "mrays_per_second";
inline constexpr std::string_view kBatchMraysPerSecond = "batch_mrays_per_second";
inline constexpr std::string_view kNanosecondsOneByOne = "nanoseconds_one_by_one";
inline constexpr std::string_view kNanosecondsOfABatch = "nanoseconds_of_a_batch_of_";  ///< rays
inline constexpr std::string_view kNodeStepsPerRay = "node_steps_per_ray";
inline constexpr std::string_view kBlockStepsPerRay = "block_steps_per_ray";

// Of pictures: the parts of a run, and the rays of rendering. They say little on their own; see
// picture_tables.hpp.
inline constexpr std::string_view kPictureReadingSeconds = "picture_reading_seconds";
inline constexpr std::string_view kPictureBuildingSeconds = "picture_building_seconds";
inline constexpr std::string_view kPictureTracingSeconds = "picture_tracing_seconds";
inline constexpr std::string_view kPictureShadingSeconds = "picture_shading_seconds";
inline constexpr std::string_view kPictureEncodingSeconds = "picture_encoding_seconds";
inline constexpr std::string_view kPictureRays = "picture_rays";

/// One cell of the benchmark, as it stands in the JSON.
struct Result {
  std::string scene;    ///< name of the file without folder and extension
  std::string measure;  ///< one of those above; of small batches with a number behind
  std::string kind;     ///< of rays, or of picture; empty where there are none
  std::string engine;   ///< "planetree", "embree3", "cgal"
  std::string mode;     ///< "balanced-watertight", "high-robust"
  unsigned threadCount = 1;
  double value = 0.0;
  bool isDefault = false;  ///< what a user of the library gets without options
  std::string commit;      ///< of planetree
  std::string compiler;
  std::uint64_t objectCount = 0;  ///< triangles or shapes of the scene; 0 if that is not known

  friend bool operator==(const Result&, const Result&) = default;
};

/// The numbers of rays in the small batches that are measured.
inline constexpr std::array kSmallBatches = {std::size_t{1}, std::size_t{8}, std::size_t{64}};

/// "nanoseconds_of_a_batch_of_8"
[[nodiscard]] inline std::string smallBatchMeasure(std::size_t size) {
  return std::string(kNanosecondsOfABatch) + std::to_string(size);
}

/// Whether it is one of the measures of small batches, which say little on their own.
[[nodiscard]] inline bool isOfSmallBatches(std::string_view measure) {
  return measure == kNanosecondsOneByOne || measure.starts_with(kNanosecondsOfABatch);
}

/// Whether it is one of the measures of pictures, likewise.
[[nodiscard]] inline bool isOfPictures(std::string_view measure) {
  return measure.starts_with("picture_");
}

/// Whether more is better; otherwise less is.
[[nodiscard]] inline bool moreIsBetter(std::string_view measure) {
  return measure == kMraysPerSecond || measure == kBatchMraysPerSecond;
}

/// A JSON array of objects with the keys scene, measure, kind, engine, mode, threads, value,
/// default, commit, compiler and objects, one object to a line.
[[nodiscard]] std::string toJson(const std::vector<Result>& results);

/// Throws `Error` with `MalformedFile`, naming `file`, for anything that `toJson` would not write,
/// but for objects without the last key, which older files have not.
[[nodiscard]] std::vector<Result> resultsFromJson(const std::string& json, const std::string& file);

}  // namespace planetree::bench

#pragma once

#include "bench/support/result.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace planetree::bench {

struct PictureSettings {
  std::vector<unsigned> threadCounts = {1};
  unsigned rounds = 5;
  std::uint32_t width = 400;  ///< of the pictures; the height follows
  std::function<void(const std::string&)> say;
};

/// What `planetree render` takes for this scene or model, with the width alone as an option: the
/// parts of the best round, each part with its own best one, but tracing and shading with that of
/// rendering. Throws `WrongAnswers` unless the file of the picture has the same bytes with all
/// numbers of threads, and what reading the scene throws.
[[nodiscard]] std::vector<Result> measurePicture(const std::filesystem::path& file,
                                                 const PictureSettings& settings);

/// Reading and building for a `.ray` scene of one mesh of ten thousand faces, which is made in
/// memory. Throws `WrongAnswers` if it is not what was written.
[[nodiscard]] std::vector<Result> measureRayMesh(const PictureSettings& settings);

}  // namespace planetree::bench

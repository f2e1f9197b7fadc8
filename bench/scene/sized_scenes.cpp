#include "bench/scene/sized_scenes.hpp"

#include "bench/scene/generated_scenes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace planetree::bench {

namespace {

constexpr std::string_view kTerrain = "terrain";
constexpr std::string_view kScatter = "scatter";

/// What the letter behind a number stands for; 0 if for nothing.
std::uint64_t factorOf(std::string_view suffix) {
  if (suffix.empty())
    return 1;
  if (suffix == "k")
    return 1'000;
  return suffix == "m" ? 1'000'000 : 0;
}

}  // namespace

std::optional<SizedSceneName> sizedSceneName(std::string_view name) {
  const std::size_t dash = name.find('-');
  if (dash == std::string_view::npos)
    return std::nullopt;
  const std::string_view family = name.substr(0, dash);
  if (family != kTerrain && family != kScatter)
    return std::nullopt;
  const std::string_view size = name.substr(dash + 1);
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), number);
  if (error != std::errc{} || number > kMostSizedTriangles)
    return std::nullopt;
  const std::uint64_t triangles =
      number * factorOf(size.substr(static_cast<std::size_t>(end - size.data())));
  if (triangles < kFewestSizedTriangles || triangles > kMostSizedTriangles)
    return std::nullopt;
  return SizedSceneName{std::string(family), triangles};
}

TriangleMesh<float> makeSizedTerrain(std::uint64_t triangles) {
  return makeTerrain(
      static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 2.0))));
}

BenchScene makeSizedScene(const SizedSceneName& size, std::string name) {
  return makeScene(std::move(name), size.family == kTerrain ? makeSizedTerrain(size.triangles)
                                                            : makeScatter(size.triangles));
}

}  // namespace planetree::bench

#include "render/colour_map.hpp"

#include "render/image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace planetree::render {

namespace {

constexpr std::array<Rgb8, 9> kInferno = {{{0x00, 0x00, 0x04},
                                           {0x21, 0x0C, 0x4A},
                                           {0x56, 0x10, 0x6E},
                                           {0x89, 0x22, 0x6A},
                                           {0xBB, 0x37, 0x54},
                                           {0xE3, 0x59, 0x32},
                                           {0xF9, 0x8C, 0x0A},
                                           {0xF9, 0xC9, 0x32},
                                           {0xFC, 0xFF, 0xA4}}};

Vec3f asChannels(const Rgb8& colour) noexcept {
  return Vec3f{static_cast<float>(colour.red), static_cast<float>(colour.green),
               static_cast<float>(colour.blue)} /
         255.0f;
}

}  // namespace

Vec3f infernoColour(float value) noexcept {
  // fmax returns the number if the other argument is NaN.
  const float clamped = std::fmin(std::fmax(value, 0.0f), 1.0f);
  const float place = clamped * static_cast<float>(kInferno.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kInferno.size() - 2);
  const float weight = place - static_cast<float>(below);
  return asChannels(kInferno[below]) * (1.0f - weight) + asChannels(kInferno[below + 1]) * weight;
}

}  // namespace planetree::render

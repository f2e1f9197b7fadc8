#include "ray_file.hpp"

#include <random>

namespace planetree::test {
namespace {

/// Replaces, removes or repeats a few bytes.
std::string damaged(std::string bytes, std::mt19937_64& generator) {
  const auto below = [&](std::size_t count) { return generator() % count; };
  for (std::size_t wounds = 1 + below(4); wounds > 0 && !bytes.empty(); --wounds) {
    const std::size_t place = below(bytes.size());
    switch (below(4)) {
      case 0:
        bytes[place] = static_cast<char>(below(256));
        break;
      case 1:
        bytes.erase(place, 1 + below(8));
        break;
      case 2:
        bytes.insert(place, bytes.substr(below(bytes.size()), 1 + below(8)));
        break;
      default:
        bytes.resize(place);
    }
  }
  return bytes;
}

void expectRaysOrAnError(const std::string& whole, std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 generator(seed);
  for (int repetition = 0; repetition < 1500; ++repetition) {
    const std::string bytes = damaged(whole, generator);
    try {
      static_cast<void>(readRays<double>(bytes));
    } catch (const Error& error) {
      ASSERT_FALSE(error.advice().empty()) << error.what();
    }
  }
}

TEST(DamagedRayFiles, GiveRaysOrAnErrorAndNothingElse) {
  expectRaysOrAnError("ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\r\n# x\n-1e3,inf,nan,.5,6,7\n", 1);
  const std::vector<float> numbers(12, 1.5f);
  expectRaysOrAnError(npyFile(npyDictionary("<f4", "(2, 6)"), bytesOf(numbers)), 2);
}

}  // namespace
}  // namespace planetree::test

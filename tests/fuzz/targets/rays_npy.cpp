#include "support/ray_file_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  planetree::fuzz::checkRayReader(data, size);
  return 0;
}

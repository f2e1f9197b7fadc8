#include "support/mesh_promises.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  planetree::fuzz::checkMeshReader(data, size, "model.obj");
  return 0;
}

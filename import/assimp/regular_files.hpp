#pragma once

#include <assimp/DefaultIOSystem.h>

namespace planetree::importing {

/// Where assimp reads from: files only. A model names others, its materials and its numbers, and a
/// device may have no end, and opening a pipe may wait for ever.
class RegularFiles : public Assimp::DefaultIOSystem {
 public:
  bool Exists(const char* path) const override;
  Assimp::IOStream* Open(const char* path, const char* mode) override;
};

}  // namespace planetree::importing

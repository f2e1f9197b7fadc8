#pragma once

#include <planetree/planetree.hpp>

#include "support/batch_rays.hpp"
#include "support/batch_scenes.hpp"
#include "support/compare_batches.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace planetree::test {

template <class Word>
[[nodiscard]] bool hasSameBytes(std::span<const Word> a, std::span<const Word> b) noexcept {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// What a program does with the library from inside of its own threads, and what comes of it
/// anywhere else. The checks return whether both are the same, to be called from any thread, where
/// those of GoogleTest are not for everyone.
class LibraryWork {
 public:
  [[nodiscard]] bool buildsTheSame(std::uint32_t threadCount) const {
    const auto built = buildTree(mesh_.view(), {.threadCount = threadCount});
    return hasSameBytes(built.nodes(), tree_.nodes()) &&
           hasSameBytes(built.view().references, tree_.view().references);
  }

  [[nodiscard]] bool answersTheSame() const {
    for (std::size_t i = 0; i < rays_.size(); i += 16) {
      if (!hasSameBits(tree_.findIntersection(rays_[i]).value_or(Hitf{}), alone_.hits[i]) ||
          tree_.isOccluded(rays_[i]) != (alone_.flags[i] != 0))
        return false;
    }
    return true;
  }

  [[nodiscard]] bool tracesTheSame(std::uint32_t threadCount) const {
    std::vector<Hitf> hits(rays_.size());
    std::vector<std::uint8_t> flags(rays_.size());
    const BatchOptions options = {.threadCount = threadCount};
    if (tree_.findIntersections(rays_, hits, options) != alone_.hitCount ||
        tree_.areOccluded(rays_, flags, options) != alone_.hitCount)
      return false;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      if (!hasSameBits(hits[i], alone_.hits[i]))
        return false;
    }
    return flags == alone_.flags;
  }

  /// All of it, with any number of threads in turn.
  [[nodiscard]] bool doesTheSame(int turn) const {
    const auto threadCount = static_cast<std::uint32_t>(turn % 4);
    return buildsTheSame(threadCount) && answersTheSame() && tracesTheSame(threadCount);
  }

  [[nodiscard]] const TriangleMesh<float>& mesh() const noexcept { return mesh_; }
  [[nodiscard]] const KdTree<Face<float>>& tree() const noexcept { return tree_; }
  [[nodiscard]] std::span<const Rayf> rays() const noexcept { return rays_; }

 private:
  // Enough for cells that all threads divide together, and for many portions of a batch.
  TriangleMesh<float> mesh_ = detail::soup<float>(901, 20'000, 0.02);
  KdTree<Face<float>> tree_ = buildTree(mesh_.view(), {.threadCount = 1});
  std::vector<Rayf> rays_ = randomRays<float>(tree_.bounds(), 6000, 902);
  SingleAnswers<float> alone_{tree_.view(), rays_};
};

/// The same one for all tests: it takes a while to make.
inline const LibraryWork& libraryWork() {
  static const LibraryWork work;
  return work;
}

}  // namespace planetree::test

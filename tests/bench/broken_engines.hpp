#pragma once

#include "bench/rivals/engines.hpp"

#include <planetree/hit/hit.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace planetree::test {

/// What an engine does to the true answer to a ray before it passes it on.
struct Lie {
  std::function<void(std::size_t ray, Hitf& hit)> aboutHit = [](std::size_t, Hitf&) {};
  std::function<void(std::size_t ray, std::uint8_t& occluded)> aboutOcclusion =
      [](std::size_t, std::uint8_t&) {};
};

/// planetree's default engine, but for the lie. Counts what it is asked to do.
class BrokenEngine final : public bench::Engine {
 public:
  struct Counts {
    std::size_t builds = 0;
    std::size_t queries = 0;
  };

  BrokenEngine(Lie lie, bool isExact)
      : honest_(std::move(bench::planetreeEngines().front())),
        lie_(std::move(lie)),
        isExact_(isExact) {}

  [[nodiscard]] std::string name() const override { return "broken"; }
  [[nodiscard]] std::string mode() const override { return "liar"; }
  [[nodiscard]] bool isDefault() const override { return false; }
  [[nodiscard]] bool isExact() const override { return isExact_; }
  [[nodiscard]] std::unique_ptr<bench::Structure> build(const bench::SceneObjects& objects,
                                                        unsigned threadCount) const override {
    ++counts_.builds;
    return std::make_unique<BrokenStructure>(honest_->build(objects, threadCount), lie_, counts_);
  }

  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

 private:
  class BrokenStructure final : public bench::Structure {
   public:
    BrokenStructure(std::unique_ptr<bench::Structure> honest, const Lie& lie, Counts& counts)
        : honest_(std::move(honest)), lie_(lie), counts_(counts) {}

    void findIntersections(std::span<const Rayf> rays, std::span<Hitf> hits) const override {
      ++counts_.queries;
      honest_->findIntersections(rays, hits);
      for (std::size_t i = 0; i < hits.size(); ++i)
        lie_.aboutHit(i, hits[i]);
    }
    void findOcclusions(std::span<const Rayf> rays,
                        std::span<std::uint8_t> occluded) const override {
      ++counts_.queries;
      honest_->findOcclusions(rays, occluded);
      for (std::size_t i = 0; i < occluded.size(); ++i)
        lie_.aboutOcclusion(i, occluded[i]);
    }

   private:
    std::unique_ptr<bench::Structure> honest_;
    const Lie& lie_;
    Counts& counts_;
  };

  std::unique_ptr<bench::Engine> honest_;
  Lie lie_;
  bool isExact_;
  mutable Counts counts_;
};

/// planetree and a broken engine, side by side.
inline bench::EngineList besideBroken(Lie lie, bool isExact = false) {
  bench::EngineList engines = bench::planetreeEngines();
  engines.push_back(std::make_unique<BrokenEngine>(std::move(lie), isExact));
  return engines;
}

}  // namespace planetree::test

#pragma once

#include "bench/scene/scene_objects.hpp"
#include "bench/support/answers.hpp"
#include "bench/support/precision.hpp"
#include "bench/support/ray_kinds.hpp"

#include <planetree/geometry/ray.hpp>
#include <planetree/hit/hit.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

/// What is compared: libraries behind one interface, one file for each library.
///
/// The rules are the same for all. Each reads the same array of rays and writes the same array of
/// hits, with t, u, v, normal and ids; what turning a `Rayf` into its own ray costs a library is
/// part of using it, but for batches, which may be laid out beforehand. Each ray is answered by a
/// call into compiled code of the library, or, for a library of headers only, by a function that is
/// not inlined. Shapes are bounded and tested by planetree's own code for all of them.
namespace planetree::bench {

/// How far queries went through a structure.
struct Steps {
  std::uint64_t nodes = 0;   ///< nodes visited
  std::uint64_t blocks = 0;  ///< blocks of triangles tested
};

/// The rays of a set as a library takes them best, and room for its answers. What is done to make
/// it is not timed: rays may be put into packets, and hits may stay in them.
class Batch {
 public:
  Batch() = default;
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;
  virtual ~Batch() = default;

  /// Takes back what tracing has changed of the rays. Done before they are traced, and not timed.
  virtual void reset() {}

  /// Traces all rays on so many threads: what is timed.
  virtual void trace(unsigned threadCount) = 0;

  /// The answers of the last time, in the order of the rays. The answers have room for them.
  virtual void readAnswers(Answers& answers) const = 0;
};

/// What a library has made of a mesh or of shapes. Its queries may be called from several threads
/// at once.
class Structure {
 public:
  Structure() = default;
  Structure(const Structure&) = delete;
  Structure& operator=(const Structure&) = delete;
  virtual ~Structure() = default;

  /// The nearest hit of each ray; a miss is a default-made `Hitf`. The normal may have any length:
  /// no rival computes a unit normal, and none has to. Both spans have one size.
  virtual void findIntersections(std::span<const Rayf> rays, std::span<Hitf> hits) const = 0;

  /// For each ray 1 if it hits anything, else 0. Both spans have one size.
  virtual void findOcclusions(std::span<const Rayf> rays,
                              std::span<std::uint8_t> occluded) const = 0;

  /// The set as a batch, `callSize` rays to a call, or null: then it is traced ray by ray. Engines
  /// that do not take batches decide for themselves how many rays are in a call. The structure and
  /// the set outlive the batch.
  [[nodiscard]] virtual std::unique_ptr<Batch> makeBatch(const RaySet& /*set*/,
                                                         std::size_t /*callSize*/) const {
    return nullptr;
  }

  /// The work of looking for the nearest hit of each ray, or for any; nothing is counted if the
  /// engine says that it does not count.
  [[nodiscard]] virtual Steps countSteps(std::span<const Rayf> /*rays*/, bool /*forAnyHit*/) const {
    return {};
  }
};

/// A library in one of its modes: quality of the build, kind of test, single rays or packets.
class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;

  [[nodiscard]] virtual std::string name() const = 0;  ///< "planetree", "embree3", "cgal"
  [[nodiscard]] virtual std::string mode() const = 0;  ///< "balanced-watertight", "high-robust"
  /// Whether this mode is what a user of the library gets without options.
  [[nodiscard]] virtual bool isDefault() const = 0;
  /// Whether the answers must be those of brute force bit for bit. Others may differ at edges.
  [[nodiscard]] virtual bool isExact() const { return false; }
  /// In which precision rays are traced. Brute force does as the engine does; its hits, like those
  /// of the engine, are rounded to float at the end.
  [[nodiscard]] virtual Precision precision() const { return Precision::Float; }
  /// Whether queries read the arrays of a mesh that the structure was made from, so that these
  /// belong to the memory it takes.
  [[nodiscard]] virtual bool queriesReadMesh() const { return false; }
  /// Whether it can hold anything but triangles.
  [[nodiscard]] virtual bool takesShapes() const { return true; }
  /// Whether the library has a call for any number of rays.
  [[nodiscard]] virtual bool takesBatches() const { return false; }
  /// Whether its structures count the steps of their queries.
  [[nodiscard]] virtual bool countsSteps() const { return false; }

  /// Sets up what the library keeps for all builds with so many threads, so that none of them pays
  /// for it.
  virtual void prepare(unsigned /*threadCount*/) const {}

  /// Everything from the arrays to the first ray that can be traced. The arrays stay the caller's
  /// and outlive the structure; sixteen bytes can be read from the last position of a mesh on. Uses
  /// `threadCount` threads where the library has a choice.
  [[nodiscard]] virtual std::unique_ptr<Structure> build(const SceneObjects& objects,
                                                         unsigned threadCount) const = 0;
};

}  // namespace planetree::bench

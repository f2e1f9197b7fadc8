#pragma once

#include <planetree/split/cost_model.hpp>

#include <cstdint>
#include <optional>

namespace planetree {

/// Which side of a split plane gets the objects that lie in it.
enum class PlanarRule : std::uint8_t {
  CheaperSide,  ///< whichever side costs less
  NormalSign,   ///< left if the normal's component along the axis is negative, else right
};

/// How `buildTree` builds. The defaults give the fastest rays; `textbook()` the rules as taught.
struct BuildOptions {
  /// A cell with this many objects or fewer becomes a leaf. May be 0.
  std::uint32_t leafSize = 4;

  /// The number of levels after which every cell becomes a leaf; the root is level 1, so a limit of
  /// 1 makes the whole tree one leaf. From 1 to `kMaxTreeDepth`. Unset: 8 + 1.3 log2(objects), the
  /// field's default.
  std::optional<std::uint32_t> depthLimit = std::nullopt;

  CostModel cost = {};

  /// Make a leaf where no split is expected to be cheaper than the leaf. Without it only `leafSize`
  /// and `depthLimit` stop.
  bool stopsByCost = true;

  /// Let a split leave one side empty, to cut off empty space. Without it such a split makes a
  /// leaf.
  bool allowsEmptyCells = true;

  /// Count an object only in the cells that its surface touches, not in all that its box touches
  /// ("perfect splits"; Havran and Bittner, "On improving kd-trees for ray shooting", WSCG 2002).
  bool clipsReferences = true;

  PlanarRule planarRule = PlanarRule::CheaperSide;

  /// Find the cheapest of all planes through ends of boxes. Without it, look at the edges of some
  /// dozens of bins, and find the cheapest plane next to the best edge.
  bool exactPlanes = true;

  /// Take splits back that turn out not to pay, once all below them is built and it is known what
  /// it costs a query: "pruning"; Havran, "Heuristic ray shooting algorithms", dissertation, CTU
  /// Prague 2000. For faces only. Takes longer than all the rest.
  bool retractsSplits = false;

  /// How many references there may be for each object, on average; 0 sets no bound. Large faces
  /// that cross in one place would otherwise multiply with every split. Each side of a split gets a
  /// part of what its parent may have, by the share of references it holds, and a cell that has
  /// used up its part becomes a leaf: the bound costs speed where it is met, and nothing elsewhere.
  std::uint32_t referencesPerObject = 32;

  /// Threads to build with, at most as many as oneTBB may use; 0 means all of these. The tree is
  /// the same for any number. The work runs in an arena of its own and does not mix with the
  /// caller's oneTBB tasks.
  std::uint32_t threadCount = 0;

  /// Builds in a fraction of the time, for scenes that change or are hardly looked at: planes are
  /// found by bins, whole boxes are counted, and leaves are left large. docs/performance.md has
  /// what each preset costs and gives.
  [[nodiscard]] static constexpr BuildOptions fast() noexcept {
    BuildOptions options;
    options.exactPlanes = false;
    options.clipsReferences = false;
    options.cost.faceCost = 0.01;
    return options;
  }

  /// The default.
  [[nodiscard]] static constexpr BuildOptions balanced() noexcept { return {}; }

  /// Takes its time for the sake of the rays, for scenes that are built once and looked at for
  /// long.
  [[nodiscard]] static constexpr BuildOptions high() noexcept {
    BuildOptions options;
    options.retractsSplits = true;
    return options;
  }

  /// The rules of the textbook to the letter: the plane with the smallest (nL AL + nR AR) / A wins,
  /// whole boxes are counted, an empty side makes a leaf, and only `leafSize` and `depthLimit`
  /// stop, both as such ray tracers usually have them. For teaching and as a yardstick: a plane
  /// that cuts off empty space, or on a wall of the cell, is often cheapest, so that these rules
  /// end early with large leaves, up to a single leaf for everything.
  [[nodiscard]] static constexpr BuildOptions textbook() noexcept {
    BuildOptions options;
    options.leafSize = 10;
    options.depthLimit = 15;
    options.cost = {
        .traversalCost = 0.0, .intersectionCost = 1.0, .faceCost = 1.0, .emptyBonus = 0.0};
    options.stopsByCost = false;
    options.allowsEmptyCells = false;
    options.clipsReferences = false;
    options.planarRule = PlanarRule::NormalSign;
    options.referencesPerObject = 0;
    return options;
  }
};

}  // namespace planetree

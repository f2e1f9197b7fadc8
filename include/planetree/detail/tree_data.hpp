#pragma once

#include <planetree/detail/geometry_entry.hpp>
#include <planetree/geometry/box3.hpp>
#include <planetree/node/node.hpp>
#include <planetree/split/build_control.hpp>
#include <planetree/split/build_options.hpp>
#include <planetree/split/build_report.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace planetree::detail {

struct WideTree;

/// Everything a tree is made of, whatever its objects. Made by `buildTreeData`, never changed
/// after.
template <class T>
struct TreeData {
  std::vector<Node> nodes = {};                ///< at least one
  std::vector<std::uint32_t> references = {};  ///< object numbers; each leaf names a sorted run
  std::vector<GeometryEntry<T>> geometries = {};
  Box3 bounds = {};                           ///< of all objects in the tree; empty without any
  std::shared_ptr<const WideTree> wide = {};  ///< derived from the nodes; null if there is none
  BuildOptions options = {};
  BuildReport report = {};
};

/// What one object in a leaf of the tree costs a query.
template <class T>
[[nodiscard]] double intersectionCostOf(const TreeData<T>& tree) noexcept;
extern template double intersectionCostOf(const TreeData<float>&) noexcept;
extern template double intersectionCostOf(const TreeData<double>&) noexcept;

/// Builds the tree of all objects of the geometries, numbered in their order.
template <class T>
[[nodiscard]] TreeData<T> buildTreeData(std::vector<GeometryEntry<T>> geometries,
                                        const BuildOptions& options, const BuildControl& control);
extern template TreeData<float> buildTreeData<float>(std::vector<GeometryEntry<float>>,
                                                     const BuildOptions&, const BuildControl&);
extern template TreeData<double> buildTreeData<double>(std::vector<GeometryEntry<double>>,
                                                       const BuildOptions&, const BuildControl&);

}  // namespace planetree::detail

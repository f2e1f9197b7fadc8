#include <planetree/traversal/leaf_node_intersection.hpp>

#include "traversal/traverse.hpp"

namespace planetree {

template <class T>
bool findIntersection(const LeafNode& leaf, const TreeView<T>& tree, const Ray<T>& r, Hit<T>& i,
                      T tMin, T tMax) noexcept {
  const detail::Query<T> query(tree, r, tMin, tMax);
  if (query.partInsideTree().isEmpty())
    return false;
  detail::Unobserved unobserved;
  return detail::visitLeaf<detail::NearestHit>(leaf, query, i, unobserved);
}

template bool findIntersection(const LeafNode&, const TreeView<float>&, const Rayf&, Hitf&, float,
                               float) noexcept;
template bool findIntersection(const LeafNode&, const TreeView<double>&, const Rayd&, Hitd&, double,
                               double) noexcept;

}  // namespace planetree

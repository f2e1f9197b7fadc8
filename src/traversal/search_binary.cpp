#include "traversal/search_binary.hpp"

namespace planetree::detail {

template <class Goal, class T>
bool searchBinary(const Request<T>& request, Hit<T>& hit, StepCounts* steps) noexcept {
  const Query<T> query(request);
  const Node& root = query.tree.nodes.front();
  const Interval<T> part = query.partInsideTree();
  return steps ? traverse<Goal>(root, query, part, hit, Counting(*steps))
               : traverse<Goal>(root, query, part, hit, Unobserved{});
}

#define PLANETREE_INSTANTIATE(Goal, T) \
  template bool searchBinary<Goal>(const Request<T>&, Hit<T>&, StepCounts*) noexcept;
#define PLANETREE_INSTANTIATE_FOR(T)     \
  PLANETREE_INSTANTIATE(NearestHit, T)   \
  PLANETREE_INSTANTIATE(AnyHit, T)       \
  PLANETREE_INSTANTIATE(NearestOffer, T) \
  PLANETREE_INSTANTIATE(AnyOffer, T)     \
  PLANETREE_INSTANTIATE(EveryOffer, T)
PLANETREE_INSTANTIATE_FOR(float)
PLANETREE_INSTANTIATE_FOR(double)
#undef PLANETREE_INSTANTIATE_FOR
#undef PLANETREE_INSTANTIATE

}  // namespace planetree::detail

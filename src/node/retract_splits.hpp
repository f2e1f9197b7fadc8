#pragma once

#include "node/divide_leaf.hpp"
#include "node/leaf_packer.hpp"
#include "node/node_array.hpp"
#include "node/plan_slots.hpp"

namespace planetree::detail {

/// The same subtree without splits that do not pay: where all objects below a split, each of them
/// once, make a leaf that costs no more in the wide form than what has become of the split, it is
/// made a leaf. The heuristic of the search takes all objects below a plane to be tested; only the
/// finished tree knows how blocks fill, and what it costs to hold objects twice.
///
/// Havran, "Heuristic ray shooting algorithms", dissertation, CTU Prague 2000, section 4.5, prunes
/// by the cost of the kd-tree itself; here it is that of the plan for the wide form
/// (`SlotPlanner`). Cells with a great many references stay divided. Leaves that are not packed
/// stay as they are. Takes some three times as long as dividing the leaves.
[[nodiscard]] NodeArray retractSplits(const NodeArray& tree, LeafCuts cuts, LeafPacker& packer,
                                      const SlotPlanner& planner);

}  // namespace planetree::detail

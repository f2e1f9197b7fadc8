#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planetree::detail {

/// The name that was probably meant: the nearest of `names`, if it is near at all. The first of
/// equally near ones.
[[nodiscard]] std::optional<std::string> nearestName(std::string_view typed,
                                                     const std::vector<std::string>& names);

/// How many letters have to be added, left out, changed or swapped with their neighbour to turn one
/// word into the other; each place is changed once ("optimal string alignment").
[[nodiscard]] std::size_t editDistance(std::string_view a, std::string_view b);

}  // namespace planetree::detail

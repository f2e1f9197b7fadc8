#pragma once

#include "bench/support/result.hpp"

#include <string>
#include <vector>

namespace planetree::bench {

struct Plot {
  std::string name;  ///< of its file
  std::string title;
  std::string svg;
};

/// The part of docs/performance.md that comes from results, and the plots that it shows.
struct PerformanceFigures {
  std::string markdown;
  std::vector<Plot> plots;
};

/// `plotFolder` is where the plots are, as seen from the page. `machine` says what the results were
/// measured on, which the results themselves do not.
[[nodiscard]] PerformanceFigures performanceFigures(const std::vector<Result>& results,
                                                    const std::string& machine,
                                                    const std::string& plotFolder);

/// The page with its part between the two marks replaced; what is written by hand stays. Throws
/// `Error` with `MalformedFile`, naming `file`, if the marks are not there.
[[nodiscard]] std::string withFigures(const std::string& page, const std::string& figures,
                                      const std::string& file);

}  // namespace planetree::bench

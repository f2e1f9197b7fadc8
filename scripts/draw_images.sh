#!/usr/bin/env bash
# Installs what is missing, builds planetree, and draws the pictures of README.md and docs/pictures.md
# anew in docs/images.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages build demo
cmake --preset release
cmake --build build/release --target planetree_tool --parallel "$(nproc)"

bunny=/usr/share/glmark2/models/bunny.obj
draw() { build/release/bin/planetree render --quiet --samples 16 "${@:2}" -o "docs/images/$1.png"; }

draw bunny "$bunny" --size 640x480
draw still-life --size 640x480
# With the legend it is as high as the others.
draw bunny-heat "$bunny" --size 640x423 --mode heat
draw bunny-cells "$bunny" --size 640x480 --show-cells 9
# The same scale for two trees: one split until little is left in a cell, one that stops early.
draw still-life-heat --size 420x280 --mode heat --heat-max 120
draw still-life-heat-large-leaves --size 420x280 --mode heat --heat-max 120 --leaf-size 16
draw still-life-heat-cells --size 640x423 --mode heat --show-cells 8
draw still-life-normals --size 640x480 --mode normals
# The scenes of the repository.
scene() { build/release/bin/planetree render --quiet --size 480 "data/scenes/$2" -o "docs/images/$1.png"; }
scene glass-and-mirrors glass_and_mirrors.json
scene spheres spheres.ray
scene coloured-shadows coloured_shadows.ray
scene forest forest.json
scene textures textures.ray
scene sea sea.ray
# Its times and speeds are those of this machine.
build/release/bin/planetree compare --quiet data/scenes/spheres.ray --presets fast,high --size 320 \
  -o docs/images/spheres-presets.png
say "drew the pictures in docs/images"

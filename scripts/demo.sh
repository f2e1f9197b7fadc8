#!/usr/bin/env bash
# Installs what is missing, builds planetree, and draws the Stanford bunny: bunny.png with ambient
# occlusion, and bunny-heat.png with the work of each ray.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages build demo
say "building in build/release"
cmake --preset release
cmake --build build/release --target planetree_tool --parallel "$(nproc)"

model=/usr/share/glmark2/models/bunny.obj
build/release/bin/planetree render "$model" --mode ao -o bunny.png
build/release/bin/planetree render "$model" --mode heat -o bunny-heat.png
say "drew bunny.png and bunny-heat.png"

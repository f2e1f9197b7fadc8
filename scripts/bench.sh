#!/usr/bin/env bash
# Installs what is missing, the libraries to compare with among it, and builds the benchmark:
# build/release/bin/planetree-bench.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages build bench
say "building in build/release"
cmake --preset release -D PLANETREE_BUILD_BENCHMARKS=ON
cmake --build build/release --target planetree_bench --parallel "$(nproc)"
say "built. To measure: bash scripts/fetch_scenes.sh FOLDER, and then"
say "  build/release/bin/planetree-bench rivals FOLDER/bunny.obj"

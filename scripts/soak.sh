#!/usr/bin/env bash
# Streams rays at closed meshes and counts those that leak, with Embree's count beside: installs what
# is missing, builds build/release/bin/planetree-soak, and hands on --rays N, --threads N, --isa NAME
# and --seed N. Ends with 1 if planetree leaks.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages build judges
say "building in build/release"
cmake --preset release -D PLANETREE_BUILD_TESTS=ON >&2
cmake --build build/release --target planetree_soak --parallel "$(nproc)" >&2
exec build/release/bin/planetree-soak "$@"

#!/usr/bin/env bash
# Compares answers with those of CGAL's exact kernel and counts the wrong ones: installs what is
# missing, builds build/release/bin/planetree-judge, and hands on --rays N, --isa NAME and --seed N.
# Ends with 1 if an answer is wrong.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages build judges
say "building in build/release"
cmake --preset release -D PLANETREE_BUILD_TESTS=ON >&2
cmake --build build/release --target planetree_judge --parallel "$(nproc)" >&2
exec build/release/bin/planetree-judge "$@"

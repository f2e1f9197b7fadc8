#!/usr/bin/env bash
# Installs what is missing, builds planetree with all of its tests, and runs them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages build judges
say "building in build/release"
cmake --preset release
cmake --build build/release --parallel "$(nproc)"
say "testing"
ctest --test-dir build/release --output-on-failure --no-tests=error --parallel "$(nproc)"

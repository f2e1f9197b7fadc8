#!/usr/bin/env bash
# Tries faults: memory that runs out at every request, stops at every progress call, outputs that
# fail after any number of bytes, inputs that change, a reader that dies at any byte. Takes about half
# an hour; the tests try some of each. Prints `faults injected: N, lost: 0, leaked: 0`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

require_packages build
say "building in build/release"
cmake --preset release >&2
cmake --build build/release --parallel "$(nproc)" --target fault >&2
say "trying every fault"
PLANETREE_EVERY_FAULT=1 build/release/bin/fault --gtest_brief=1 "$@"

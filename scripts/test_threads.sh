#!/usr/bin/env bash
# Builds what runs on several threads with clang's thread sanitizer, in build/thread, and runs its
# tests. Needs a bare Debian 12 and installs what is missing.
#
#   bash scripts/test_threads.sh            all of them
#   bash scripts/test_threads.sh REGEX      those whose names match, as for ctest -R
#
# The sanitizer sees how threads are kept apart only in code that was compiled with it, and Debian's
# oneTBB was not: so oneTBB, too, is built with it, from Debian's own source package, in
# build/thread-tbb. Then nothing has to be suppressed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

tbb=$PWD/build/thread-tbb
# The exit status where the sources cannot be had, as on a machine without a network: EX_TEMPFAIL.
nothing_tested=75
targets=(threads unit_batch unit_render unit_split)
# Long comparisons, and tests that stay on one thread, are left to other builds.
tests='^(threads\.(Inside[TB]|BuildWith|Threads/InsideT|ThrowingShapes|Concurrency)'
tests+='|threads\.Batch\.(GivesTheSame|HonoursTheChoices)|unit_batch\.(BatchThreads|Threads/BatchControl)'
tests+='|unit_render\.RenderImage|unit_split\.(BuildProgress|StopOfABuild|BuildTree|RetractSplits\.IsTheSame)'
tests+='|unit_split\.Determinism\.HoldsFor)'

# apt with lists of its own, of the sources of what the machine's lists have in binary.
use_apt_of_sources() {
  local state=$1 file
  mkdir -p "$state"/{lists/partial,cache/archives/partial,sources.d}
  touch "$state/status"
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources}; do
    if [[ -e $file ]]; then
      sed -E 's/^deb([[:space:]])/deb-src\1/; s/^Types:.*/Types: deb-src/' "$file" \
        >"$state/sources.d/$(basename "$file")"
    fi
  done
  cat >"$state/apt.conf" <<END
APT::Sandbox::User "root";
Dir::State "$state";
Dir::State::status "$state/status";
Dir::Cache "$state/cache";
Dir::Etc::sourcelist "/dev/null";
Dir::Etc::sourceparts "$state/sources.d";
END
  export APT_CONFIG=$state/apt.conf
}

# fetch_tbb FOLDER: the sources of the oneTBB whose headers are installed.
fetch_tbb() (
  version=$(dpkg-query -W -f '${source:Version}' libtbb-dev)
  use_apt_of_sources "$1/apt"
  mkdir "$1/download" "$1/source"
  cd "$1/download" || exit 1
  apt-get -qq update >&2 || true # one of several lists may be out of reach
  apt-get -qq source --download-only "onetbb=$version" >&2 &&
    tar -xf onetbb_*.orig.tar.* --strip-components=1 -C "$1/source"
)

# make_tbb FOLDER: builds what was fetched; build/thread-tbb appears when it is complete.
make_tbb() {
  cmake -S "$1/source" -B "$1/build" -G Ninja -D CMAKE_BUILD_TYPE=RelWithDebInfo \
        -D CMAKE_C_COMPILER=clang -D CMAKE_CXX_COMPILER=clang++ \
        -D CMAKE_CXX_FLAGS="-fsanitize=thread" -D CMAKE_CXX_FLAGS_RELWITHDEBINFO="-O2 -g1" \
        -D TBB_TEST=OFF -D TBB_STRICT=OFF -D TBBMALLOC_BUILD=OFF \
        -D TBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON -D CMAKE_INSTALL_LIBDIR=lib \
        -D CMAKE_INSTALL_PREFIX="$1/installed" >&2 &&
    cmake --build "$1/build" --parallel "$(nproc)" >&2 &&
    cmake --install "$1/build" >&2 &&
    mkdir -p "$(dirname "$tbb")" &&
    mv "$1/installed" "$tbb"
}

# The sanitizer's own memory has fixed places, which some kernels give away at random.
with_fixed_addresses() {
  if setarch --addr-no-randomize true 2>/dev/null; then
    setarch --addr-no-randomize "$@"
  else
    "$@"
  fi
}

require_packages build threads
if [[ ! -d $tbb ]]; then
  say "building oneTBB with the thread sanitizer in build/thread-tbb"
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  if ! fetch_tbb "$work"; then
    say "apt has no sources of oneTBB to offer; what it said is above. Nothing was tested."
    exit "$nothing_tested"
  fi
  make_tbb "$work" || { say "that failed; what was said is above"; exit 1; }
fi
say "building in build/thread"
cmake --preset thread
# Without it CMake takes the one of the system, in silence.
if ! grep -q "^TBB_DIR:.*=$tbb/" build/thread/CMakeCache.txt; then
  say "build/thread does not use the oneTBB of build/thread-tbb: remove both and try again"
  exit 1
fi
with_fixed_addresses cmake --build build/thread --parallel "$(nproc)" --target "${targets[@]}"
say "testing with the thread sanitizer"
# oneTBB comes with a list of its own: one harmless race in what it tells profilers.
export TSAN_OPTIONS="second_deadlock_stack=1 suppressions=$PWD/tests/threads/suppressions.txt ${TSAN_OPTIONS:-}"
with_fixed_addresses ctest --test-dir build/thread --output-on-failure --no-tests=error \
  --parallel "$(nproc)" --tests-regex "${1:-$tests}"

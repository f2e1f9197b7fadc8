#!/usr/bin/env bash
# Builds the library and its tests for AArch64, and runs them under qemu-user: that is how the NEON
# code is tested on other machines. Needs a bare Debian 12 and installs what is missing; the
# libraries for AArch64 go into build/aarch64-sysroot, and the machine's own packages stay as they
# are.
#
#   bash scripts/test_aarch64.sh            all tests of the library
#   bash scripts/test_aarch64.sh REGEX      those whose names match, as for ctest -R
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

sysroot=$PWD/build/aarch64-sysroot
tests=(unit_geometry unit_hit unit_library unit_mesh unit_node unit_read_mesh unit_shape unit_split
       unit_traversal property)

# apt as it would be on an AArch64 machine without any package, with lists of its own: nothing has
# to be told to the machine's dpkg.
use_apt_of_aarch64() {
  local state=$1
  mkdir -p "$state/lists/partial" "$state/cache/archives/partial"
  touch "$state/status"
  cat >"$state/apt.conf" <<END
APT::Architecture "arm64";
APT::Architectures { "arm64"; };
APT::Sandbox::User "root";
Dir::State "$state";
Dir::State::status "$state/status";
Dir::Cache "$state/cache";
END
  export APT_CONFIG=$state/apt.conf
}

# Downloads the libraries and unpacks them; the folder gets its name when it is complete.
make_sysroot() (
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  use_apt_of_aarch64 "$work/apt"
  read -r -a packages <<<"$(packages_for sysroot)"
  mkdir "$work/packages" "$work/sysroot"
  cd "$work/packages"
  apt-get -qq update >&2
  apt-get -qq download "${packages[@]}" >&2
  for package in *.deb; do dpkg -x "$package" "$work/sysroot"; done
  mkdir -p "$(dirname "$sysroot")"
  mv "$work/sysroot" "$sysroot"
)

require_packages aarch64
if [[ ! -d $sysroot ]]; then
  say "fetching oneTBB, Highway and GoogleTest for AArch64"
  make_sysroot || { say "apt-get failed; what it said is above"; exit 1; }
fi
say "building in build/aarch64"
cmake --preset aarch64
cmake --build build/aarch64 --parallel "$(nproc)" --target "${tests[@]}"
say "testing under qemu-user"
ctest --test-dir build/aarch64 --output-on-failure --no-tests=error --parallel "$(nproc)" \
      --tests-regex "${1:-^(unit_|property)}"

# The Debian packages that planetree needs, and how they get onto the machine. To be sourced.
# docs/dependencies.md says what each of them is for.
# shellcheck shell=bash

# packages_for PURPOSE: the packages, in words of their own.
packages_for() {
  case $1 in
    # To configure and build everything, the tests included.
    build) echo g++ cmake ninja-build libtbb-dev libhwy-dev libcli11-dev libfmt-dev \
                libpng-dev libopenexr-dev libassimp-dev libstb-dev libgtest-dev \
                nlohmann-json3-dev ;;
    # To have a bunny to draw.
    demo) echo glmark2-data ;;
    # For scripts/bench.sh: the libraries that planetree is compared with.
    bench) echo libembree-dev libcgal-dev ;;
    # For scripts/fetch_scenes.sh: models to measure with.
    scenes) echo glmark2-data assimp-testmodels ;;
    # For .ci/run: a second compiler with its sanitizers, and what reads the sources.
    ci) echo clang libclang-rt-14-dev clang-format git shellcheck mandoc zsh fish ;;
    # For scripts/test_aarch64.sh: a compiler for AArch64, and what runs its programs.
    aarch64) echo cmake ninja-build g++-aarch64-linux-gnu qemu-user ;;
    # For the same, not installed but unpacked: libraries for AArch64.
    sysroot) echo libtbb-dev libtbb12 libtbbbind-2-5 libtbbmalloc2 libhwy-dev libhwy1 \
                  libgtest-dev ;;
    *) say "no packages are known for '$1'"; return 1 ;;
  esac
}

say() { printf 'planetree: %s\n' "$*" >&2; }

is_installed() { dpkg-query -W -f '${db:Status-Status}\n' "$1" 2>/dev/null | grep -qx installed; }

# Whether apt's lists name all of the packages.
apt_knows() {
  local package
  for package in "$@"; do
    apt-cache show "$package" >/dev/null 2>&1 || return 1
  done
}

# Runs apt-get without questions, as root or with sudo, and shows the end of its output if it fails.
apt_get() {
  local log status=0
  local command=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=120 "$@")
  if ((EUID != 0)); then command=(sudo "${command[@]}"); fi
  log=$(mktemp)
  "${command[@]}" </dev/null >"$log" 2>&1 || status=$?
  if ((status != 0)); then tail -n 20 "$log" >&2; fi
  rm -f "$log"
  return "$status"
}

# install_packages PACKAGE...: apt's lists are fetched only if they do not name the packages, or are
# too old to install from.
install_packages() {
  local install=(install --yes --no-install-recommends "$@")
  if apt_knows "$@" && apt_get "${install[@]}" 2>/dev/null; then return; fi
  say "fetching apt's lists of packages"
  apt_get update && apt_get "${install[@]}"
}

# require_packages PURPOSE...: installs what is missing and says so; where nothing is missing apt is
# not called at all. Ends the script, with advice, where it cannot install.
require_packages() {
  local purpose package names needed=() missing=()
  for purpose in "$@"; do
    names=$(packages_for "$purpose")
    read -r -a needed <<<"${needed[*]} $names"
  done

  if ! command -v dpkg-query >/dev/null; then
    say "this script installs Debian packages, and there is no dpkg here. Install the like of"
    say "  ${needed[*]}"
    say "and build with CMake: see docs/building.md."
    exit 1
  fi
  for package in "${needed[@]}"; do
    is_installed "$package" || missing+=("$package")
  done
  if ((${#missing[@]} == 0)); then return; fi

  if ((EUID != 0)) && ! command -v sudo >/dev/null; then
    say "packages are missing, and installing them takes root or sudo. As root, run"
    say "  apt-get install --no-install-recommends ${missing[*]}"
    say "and then this script again."
    exit 1
  fi
  say "installing ${missing[*]}"
  if ! install_packages "${missing[@]}"; then
    say "apt-get failed; what it said is above. Install these and run this script again:"
    say "  ${missing[*]}"
    exit 1
  fi
}

#!/usr/bin/env bash
# check_names.sh REPOSITORY: what README.md and docs/ name must exist, and what they promise to list
# must be listed: links, scripts, presets, options of the build, packages, and the tests of limits.
set -euo pipefail
cd "$1"
# shellcheck source=scripts/packages.sh
source scripts/packages.sh

failures=0
fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

check_links() {
  local file link
  for file in README.md docs/*.md; do
    while read -r link; do
      [[ -e $(dirname "$file")/$link ]] || fail "$file links to $link, which does not exist"
    done < <(grep -oP '\]\(\K(?!https?:)[^)#]+' "$file")
  done
}

check_scripts_and_presets() {
  local name
  while read -r name; do
    bash -n "$name" || fail "the docs name $name, which is no script"
  done < <(grep -hoE '(scripts/[a-z_]+\.sh|\.ci/run)' README.md docs/*.md | sort -u)
  while read -r name; do
    grep -q "\"name\": \"$name\"" CMakePresets.json || fail "there is no preset '$name'"
  done < <(grep -hoP -- '--(preset |(build|test-dir|install) build/)\K[a-z-]+' README.md docs/*.md |
             sort -u)
}

# Each option stands in docs/building.md, in the words of CMakeLists.txt and with its default.
check_build_options() {
  local row
  while read -r row; do
    grep -qF "$row" docs/building.md || fail "docs/building.md lacks the row $row"
  done < <(sed -nE -e 's/^option\((PLANETREE_\w+) "([^"]+)" (.+)\)$/| `\1` | \2 | \3 |/p' \
                   -e 's/^set\((PLANETREE_\w+) "" CACHE STRING "([^"]+)"\)$/| `\1` | \2 | none |/p' \
                   CMakeLists.txt |
             sed -e 's/| ON |$/| on |/; s/| OFF |$/| off |/' \
                 -e 's/| ${PROJECT_IS_TOP_LEVEL} |$/| on, off inside another project |/')
}

check_packages() {
  local purpose package
  while read -r purpose; do
    for package in $(packages_for "$purpose"); do
      grep -qF "\`$package\`" docs/dependencies.md ||
        fail "docs/dependencies.md does not say what $package is for"
    done
  done < <(sed -nE 's/^ +([a-z0-9]+)\) echo .*/\1/p' scripts/packages.sh)
}

# Each line of docs/limits.md ends with the names of its tests.
check_tests_of_limits() {
  local row tests suite test
  while IFS= read -r row; do
    row=${row% |}
    tests=$(grep -oP '`\K[A-Z]\w+\.[A-Z]\w+(?=`)' <<<"${row##* | }" || true)
    [[ -n $tests ]] || fail "docs/limits.md names no test behind $row"
    while IFS=. read -r suite test; do
      [[ -z $suite ]] ||
        grep -rqEz "TEST[A-Z_]*\($suite,[[:space:]]*$test\)" --include='*_test.cpp' tests ||
        fail "docs/limits.md names the test $suite.$test, which does not exist"
    done <<<"$tests"
  done < <(grep '^|' docs/limits.md | grep -vE '^\| (---|what|input) ')
}

check_links
check_scripts_and_presets
check_build_options
check_packages
check_tests_of_limits
exit $((failures > 0))

#!/usr/bin/env bash
# check_commands.sh REPOSITORY FOLDER: runs the README's commands of the tool, which is in the folder,
# as they stand there, in a folder with a small model under the name that the README uses, and with the
# scenes of the repository; and those of the captions that name such a scene.
set -euo pipefail
readme=$(realpath "$1")/README.md
PATH=$(realpath "$2"):$PATH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work"/data
cp -r "$(realpath "$1")"/data/scenes "$work"/data
cd "$work"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >bunny.obj

mapfile -t commands < <(awk '/^```/ { inside = /^```sh$/ } inside && /^planetree /' "$readme")
# Those of the captions are drawn small: that they run is what counts.
# shellcheck disable=SC2016  # a backquote begins them in the README
mapfile -t -O "${#commands[@]}" commands < <(grep -oP '`\Kplanetree render data/[^`]+' "$readme" |
                                               sed 's/$/ --size 64/')
((${#commands[@]} > 0)) || { echo "FAILED: README.md shows no command of the tool"; exit 1; }
for command in "${commands[@]}"; do
  echo "\$ $command"
  bash -euo pipefail -c "$command"
  # What the command says it writes must be there.
  output=$(grep -oP ' (-o|--output) \K\S+' <<<"$command" || true)
  [[ -z $output || -s $output ]] || { echo "FAILED: it wrote no $output"; exit 1; }
done

#!/usr/bin/env bash
# drawings_test.sh DRAW_ROBOTS PICTURES: the robots' drawings are as their files have them now. To renew
# them: DRAW_ROBOTS PICTURES.
set -uo pipefail

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1" "$scratch" || exit 1
failures=0
for drawing in "$scratch"/*.svg; do
  cmp "$drawing" "$2/${drawing##*/}" || failures=$((failures + 1))
done
[[ $failures -eq 0 && $(ls "$scratch" | wc -l) -eq $(ls "$2" | grep -c '^robot_') ]]

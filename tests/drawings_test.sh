#!/usr/bin/env bash
# drawings_test.sh PREFIX PICTURES PROGRAM [ARGUMENT…]: the drawings PREFIX_*.svg in the folder PICTURES are
# those that PROGRAM makes now. To renew them: PROGRAM PICTURES ARGUMENT….
set -uo pipefail

prefix=$1
pictures=$2
program=$3
shift 3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$program" "$scratch" "$@" || exit 1
failures=0
for drawing in "$scratch"/*.svg; do
  cmp "$drawing" "$pictures/${drawing##*/}" || failures=$((failures + 1))
done
[[ $failures -eq 0 && $(ls "$scratch" | wc -l) -eq $(ls "$pictures" | grep -c "^${prefix}_") ]]

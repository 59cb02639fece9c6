#!/usr/bin/env bash
# install_test.sh BUILD: installs a build into a folder of its own, and builds and runs the programs
# of tests/embedding against what was installed there, as a stranger's project would.
set -euo pipefail

build=$(readlink -f "$1")
programs=$(cd "$(dirname "${BASH_SOURCE[0]}")/embedding" && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
package=$scratch/package

fail() {
  echo "install: $*" >&2
  exit 1
}

cmake --install "$build" --prefix "$package" > "$scratch/install.log" || fail "cannot be installed"

for file in bin/rob lib/librob_lang.a lib/librob_motion.a lib/librob_drivers.a \
  lib/cmake/rob/robConfig.cmake include/rob/lang.h include/rob/motion.h \
  share/doc/rob/language.md share/rob/examples/01_triangle.rob; do
  [[ -f $package/$file ]] || fail "$file is missing"
done
"$package/bin/rob" run "$package/share/rob/examples/01_triangle.rob" --fast > "$scratch/triangle" ||
  fail "the installed rob cannot run an installed example"
grep -q '^done: planned' "$scratch/triangle" || fail "the triangle did not come to its end"

# Every include of the package begins with rob/, unless it is of another package or of C++.
if grep -rnE '#include "' "$package/include" | grep -v '#include "rob/'; then
  fail "these includes lead nowhere outside the tree"
fi

# The language needs neither Eigen nor JSON.
echo '#include <rob/lang.h>' | ${CXX:-c++} -std=c++20 -I"$package/include" -M -x c++ - > "$scratch/reached"
if grep -E 'Eigen|nlohmann|rob/(motion|drivers|runtime)' "$scratch/reached"; then
  fail "rob/lang.h reaches these headers"
fi

# build_program NAME: against the package alone.
build_program() {
  cmake -S "$programs/$1" -B "$scratch/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$package" > "$scratch/$1.log" &&
    cmake --build "$scratch/$1" >> "$scratch/$1.log" || {
    cat "$scratch/$1.log"
    fail "$1 cannot be built"
  }
}

build_program interpreter
status=0
"$scratch/interpreter/interpreter" "$programs/interpreter/square.rob" > "$scratch/printed" 2>&1 ||
  status=$?
[[ $status -eq 1 ]] || fail "the interpreter ended with $status, not 1"
diff "$programs/interpreter/printed.txt" "$scratch/printed" || fail "the interpreter prints something else"

build_program generator
"$scratch/generator/generator" > "$scratch/references" || fail "the generator failed"
diff "$programs/generator/printed.txt" "$scratch/references" || fail "the generator prints something else"

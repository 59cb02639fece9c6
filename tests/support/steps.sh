# shellcheck shell=bash
# The steps of ./test and their count; sourced by it after setup.sh. A step that fails ends the
# run: what is wrong stands above the last line.

: "${root:?is set by setup.sh}"
passed=0
failed=0

heading() { echo "== $*"; }

# report: the last line of ./test, whatever happened.
report() { echo "$passed passed, $failed failed"; }

# fail TEXT: a step that is no list of tests has failed, and counts as one.
fail() {
  failed=$((failed + 1))
  echo "$*" >&2
  exit 1
}

# prepare FOLDER TARGET OPTION…: configures a build folder and builds one target there.
prepare() {
  local folder=$1 target=$2
  shift 2
  alone configure "$folder" "$@" || fail "$(basename "$folder") could not be configured"
  alone build "$folder" "$target" || fail "$(basename "$folder") could not be built"
}

# run_ctest FOLDER OPTION…: runs and counts the tests of a build folder.
run_ctest() {
  local folder=$1 log=$1/ctest.log status=0 summary
  shift
  fixed_addresses ctest --test-dir "$folder" --parallel "$(nproc)" --output-on-failure \
    --no-tests=error "$@" | tee "$log" || status=$?
  summary=$(sed -n 's/^.*tests passed, \([0-9]*\) tests* failed out of \([0-9]*\)$/\1 \2/p' "$log")
  [[ -n $summary ]] || fail "ctest did not come to its end"
  failed=$((failed + ${summary% *}))
  passed=$((passed + ${summary#* } - ${summary% *}))
  [[ $status -eq 0 ]] || exit 1
}

# fixed_addresses COMMAND…: the thread sanitizer of g++ 12 stops where the kernel spreads its
# addresses widely, and the fuzzer's choices hang on addresses; so they are spared that where this
# is permitted.
fixed_addresses() {
  if setarch "$(uname -m)" -R true 2> /dev/null; then
    setarch "$(uname -m)" -R "$@"
  else
    "$@"
  fi
}

step_tests() {
  heading "tests"
  prepare "$root/build" all -DCMAKE_BUILD_TYPE=Release -DROB_TESTS=ON -DROB_BENCHMARKS=ON
  run_ctest "$root/build"
}

step_format() {
  heading "format"
  local unformatted
  unformatted=$(cd "$root" && git ls-files -z -- '*.h' '*.cpp' |
    xargs -0 --no-run-if-empty clang-format-14 --dry-run -Werror 2>&1) ||
    fail "$unformatted"$'\n'"run clang-format-14 -i on these files"
  passed=$((passed + 1))
}

# Warnings and asserts as in a debug build, but fast enough to run every test.
sanitizer_options=(-DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O1
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12)

step_address() {
  heading "tests under the address and undefined-behaviour sanitizers"
  prepare "$root/build-asan" all "${sanitizer_options[@]}" -DROB_SANITIZE=address,undefined
  run_ctest "$root/build-asan"
}

step_thread() {
  heading "tests with threads under the thread sanitizer"
  prepare "$root/build-tsan" threaded_tests "${sanitizer_options[@]}" -DROB_SANITIZE=thread
  run_ctest "$root/build-tsan" --label-regex '^threads$'
}

# The same inputs each time, found anew in a folder that is thrown away: the seeds stay as they are.
# What would change them is left out: the order in which a folder lists its files, and the clock.
step_fuzz() {
  heading "fuzzing the front end and the formatter"
  local folder=$root/build-fuzz corpus=$root/build-fuzz/corpus target
  for target in front_end_fuzz formatter_fuzz; do
    prepare "$folder" "$target" -DCMAKE_CXX_COMPILER=clang++-14 -DROB_FUZZ=ON
    rm -rf "$corpus"
    mkdir -p "$corpus"
    quietly fixed_addresses "$(find "$folder" -type f -name "$target" -print -quit)" \
      -seed=1 -runs=20000 -shuffle=0 -reload=0 -max_len=4096 -timeout=10 -rss_limit_mb=1024 \
      -dict="$root/tests/fuzz/rob.dict" -artifact_prefix="$folder/" "$corpus" \
      "$root/tests/fuzz/seeds" ||
      fail "$target failed on the input that is named above"
    passed=$((passed + 1))
  done
}

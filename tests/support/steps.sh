# shellcheck shell=bash
# The steps of ./test and their count; sourced by it after setup.sh. A step that fails ends the
# run: what is wrong stands above the last line.

: "${root:?is set by setup.sh}"
passed=0
failed=0
reruns=0
times=() # what the steps took, for the report

heading() { echo "== $*"; }

# report: prints the time of each step, the reruns of tests in real time, and the last line of ./test,
# even after a failure.
report() {
  local step
  for step in "${times[@]}"; do
    echo "$step"
  done
  echo "in all $SECONDS s, $reruns reruns"
  echo "$passed passed, $failed failed"
}

# fail TEXT: a step that is no list of tests has failed, and counts as one.
fail() {
  failed=$((failed + 1))
  echo "$*" >&2
  exit 1
}

# timed WHAT COMMAND…: notes how long it takes.
timed() {
  local what=$1 begin=$SECONDS
  shift
  "$@"
  times+=("$what: $((SECONDS - begin)) s")
  echo "-- ${times[-1]}"
}

# prepare FOLDER TARGET OPTION…: configures a build folder and builds one target there.
prepare() {
  local folder=$1 target=$2
  shift 2
  alone configure "$folder" "$@" || fail "$(basename "$folder") could not be configured"
  alone build "$folder" "$target" || fail "$(basename "$folder") could not be built"
}

# run_ctest FOLDER OPTION…: runs and counts the tests of a build folder. More of them at a time than
# there are processors: some wait for most of their time.
run_ctest() {
  local folder=$1 log=$1/ctest.log status=0 summary
  shift
  fixed_addresses ctest --test-dir "$folder" --parallel $(($(nproc) + 1)) --output-on-failure \
    --no-tests=error "$@" | tee "$log" || status=$?
  summary=$(sed -n 's/^.*tests passed, \([0-9]*\) tests* failed out of \([0-9]*\)$/\1 \2/p' "$log")
  [[ -n $summary ]] || fail "ctest did not come to its end"
  failed=$((failed + ${summary% *}))
  passed=$((passed + ${summary#* } - ${summary% *}))
  reruns=$((reruns + $(reruns_in "$folder/Testing/Temporary/LastTest.log")))
  [[ $status -eq 0 ]] || exit 1
}

# reruns_in LOG: the sum of the reruns that in_time reports in a log of ctest.
reruns_in() {
  sed -n 's/^in_time: .*; reruns: \([0-9]*\)$/\1/p' "$1" | awk '{ sum += $1 } END { print sum + 0 }'
}

# fixed_addresses COMMAND…: the thread sanitizer of this time stops where the kernel spreads its
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
  timed "tests, built" prepare "$root/build" all \
    -DCMAKE_BUILD_TYPE=Release -DROB_TESTS=ON -DROB_BENCHMARKS=ON "${unity[@]}"
  timed "tests, run" run_ctest "$root/build"
}

step_format() {
  heading "format"
  timed "format" check_format
  passed=$((passed + 1))
}

check_format() {
  local unformatted
  unformatted=$(cd "$root" &&
    find base lang motion drivers runtime tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 clang-format-14 --dry-run -Werror 2>&1) ||
    fail "$unformatted"$'\n'"run clang-format-14 -i on these files"
}

# clang-tidy reads the product as the unity build of clang does: each header once for many sources.
step_tidy() {
  heading "clang-tidy"
  alone configure "$root/build-tidy" -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_BUILD_TYPE=Debug \
    -DROB_TESTS=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON "${unity[@]}" ||
    fail "build-tidy could not be configured"
  timed "clang-tidy" check_tidy
  passed=$((passed + 1))
}

check_tidy() {
  local found
  found=$(find "$root/build-tidy" -path '*/Unity/*.cxx' -print0 |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 -p "$root/build-tidy" --quiet 2> /dev/null) || fail "$found"
}

# Warnings and asserts as in a debug build, but fast enough to run every test. Instrumented code of
# clang runs in two thirds of the time that g++'s takes, and a second compiler reads the sources.
sanitizer_options=(-DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O1 "${unity[@]}")

step_address() {
  heading "tests under the address and undefined-behaviour sanitizers"
  timed "address sanitizer, built" prepare "$root/build-asan" all \
    "${sanitizer_options[@]}" -DROB_SANITIZE=address,undefined
  timed "address sanitizer, run" run_ctest "$root/build-asan"
}

step_thread() {
  heading "tests with threads under the thread sanitizer"
  timed "thread sanitizer, built" prepare "$root/build-tsan" threaded_tests \
    "${sanitizer_options[@]}" -DROB_SANITIZE=thread
  timed "thread sanitizer, run" run_ctest "$root/build-tsan" --label-regex '^threads$'
}

step_fuzz() {
  heading "fuzzing the front end and the formatter"
  timed "fuzzers, built" prepare "$root/build-fuzz" fuzzers \
    -DCMAKE_CXX_COMPILER=clang++-14 -DROB_FUZZ=ON "${unity[@]}"
  timed "fuzzers, run" run_fuzzers front_end_fuzz formatter_fuzz
}

# run_fuzzers NAME…: at the same time.
run_fuzzers() {
  local name
  local -A running
  for name in "$@"; do
    quietly run_fuzzer "$name" &
    running[$name]=$!
  done
  for name in "$@"; do
    wait "${running[$name]}" || fail "$name failed on the input that is named above"
    passed=$((passed + 1))
  done
}

# run_fuzzer NAME: the same inputs each time, found anew in a folder that is thrown away: the seeds
# stay as they are. What would change them is left out: the order in which a folder lists its files,
# and the clock.
run_fuzzer() {
  local folder=$root/build-fuzz corpus=$root/build-fuzz/corpus/$1
  rm -rf "$corpus"
  mkdir -p "$corpus"
  fixed_addresses "$(find "$folder" -type f -name "$1" -print -quit)" \
    -seed=1 -runs=20000 -shuffle=0 -reload=0 -max_len=4096 -timeout=10 -rss_limit_mb=1024 \
    -dict="$root/tests/fuzz/rob.dict" -artifact_prefix="$folder/" "$corpus" \
    "$root/tests/fuzz/seeds"
}

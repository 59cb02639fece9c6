# shellcheck shell=bash
# What ./rob and ./test have in common; sourced by both. Sets `root`, the folder of the project.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)

say() { echo "rob: $*" >&2; }

die() {
  say "$*"
  exit 74
}

# as_root COMMAND…: runs it directly as root, else through sudo.
as_root() {
  if [[ $EUID -eq 0 ]]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    return 1
  fi
}

# quietly COMMAND…: shows the output only if the command fails.
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" > "$log" 2>&1 < /dev/null || status=$?
  [[ $status -eq 0 ]] || cat "$log" >&2
  rm -f "$log"
  return "$status"
}

# missing_packages FILE…: the packages named in these lists that are not installed.
missing_packages() {
  local package installed
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' 2> /dev/null |
    sed -n 's/ installed$//p')
  sed 's/#.*//' "$@" | while read -r package; do
    [[ -z $package ]] || grep -qxF -- "$package" <<< "$installed" || echo "$package"
  done
}

# ensure_packages FILE…: installs what is missing of these lists.
ensure_packages() {
  local missing
  command -v dpkg-query > /dev/null ||
    die "this set-up needs Debian or Ubuntu; elsewhere install the likes of $root/packages.txt and use CMake"
  mapfile -t missing < <(missing_packages "$@")
  [[ ${#missing[@]} -gt 0 ]] || return 0
  say "installing ${missing[*]}"
  apt_get update || apt_get update || true # an old list may still do for the installation
  apt_get install -y --no-install-recommends "${missing[@]}" ||
    die "cannot install: run 'apt-get install ${missing[*]}' as root, then try again"
}

apt_get() {
  quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get "$@"
}

# is_configured FOLDER: it has build files, and has not been moved or copied with its clone.
is_configured() {
  [[ -f $1/build.ninja ]] &&
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt"
}

# configure FOLDER OPTION…: writes or brings up to date the build files of a build folder.
configure() {
  local folder=$1
  shift
  is_configured "$folder" ||
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles" "$folder/build.ninja"
  quietly cmake -G Ninja -S "$root" -B "$folder" "$@"
}

# build FOLDER TARGET…
build() {
  local folder=$1
  shift
  quietly cmake --build "$folder" --parallel "$(nproc)" --target "$@"
}

# alone COMMAND…: no other build of this clone runs meanwhile; a second one waits.
alone() {
  local status=0 lock
  mkdir -p "$root/build"
  exec {lock}> "$root/build/.lock"
  flock "$lock"
  "$@" || status=$?
  exec {lock}>&-
  return "$status"
}

# Is the built program as new as everything that it is made of?
rob_is_current() {
  local stamp=$root/build/.built
  [[ -x $root/build/rob && -f $stamp ]] || return 1
  [[ -z $(cd "$root" &&
    find CMakeLists.txt packages.txt base lang motion drivers runtime -newer "$stamp" -print -quit) ]]
}

# ensure_rob: build/rob is there and current.
ensure_rob() {
  rob_is_current || alone build_rob
}

# Compiles the sources of a folder as one, which takes less than half of the time.
unity=(-DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=12)

build_rob() {
  local folder=$root/build
  ! rob_is_current || return 0 # another ./rob has built it while this one waited
  ensure_packages "$root/packages.txt"
  if [[ -x $folder/rob ]]; then
    say "building what has changed"
  else
    say "building the program; the first time this takes a few minutes"
  fi
  touch "$folder/.building" # what is saved from now on is newer than the program
  if ! is_configured "$folder"; then
    # Without the tests, which need more packages; ./test adds them.
    configure "$folder" -DCMAKE_BUILD_TYPE=Release -DROB_TESTS=OFF "${unity[@]}" ||
      die "the build could not be configured; what is wrong stands above"
  fi
  build "$folder" rob || die "the program could not be built; what is wrong stands above"
  mv "$folder/.building" "$folder/.built"
}

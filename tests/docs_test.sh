#!/usr/bin/env bash
# docs_test.sh ROB PAGE.md: holds a page of the manual to what Rob does.
#
#   ```rob [FILE]          a program that `rob check` has to accept
#   ```rob-error [FILE]    a program that `rob check` has to refuse
#   ```console             lines "$ COMMAND", each with exactly what it prints, messages included
#
# Commands run in a folder of their own, which holds ./rob, examples/, motion/ and the programs with
# a FILE name that stand above them on the page. Links to files have to lead somewhere; the lists of
# messages and of built-in functions have to be complete.
set -uo pipefail

rob=$(readlink -f "$1")
page=$(readlink -f "$2")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
ln -s "$rob" "$scratch/rob"
ln -s "$root/examples" "$root/motion" "$scratch"
cd "$scratch" || exit 1
export XDG_DATA_HOME=$scratch/.data XDG_STATE_HOME=$scratch/.state
failures=0

fail() { # LINE TEXT
  echo "$page:$1: $2"
  failures=$((failures + 1))
}

check_program() { # LINE KIND FILE TEXT
  local file=${3:-shown.rob} output status
  printf '%s' "$4" > "$file"
  output=$(./rob check "$file" 2>&1)
  status=$?
  [[ $2 != rob || $status -eq 0 ]] || fail "$1" "this program is refused"$'\n'"$output"
  [[ $2 != rob-error || $status -eq 65 ]] || fail "$1" "this program is not refused"
}

check_command() { # LINE COMMAND EXPECTED
  local actual
  actual=$(bash -c "$2" 2>&1 < /dev/null)
  [[ "$actual" == "${3%$'\n'}" ]] ||
    fail "$1" "'$2' prints"$'\n'"$(diff <(echo "${3%$'\n'}") <(echo "$actual"))"
}

check_console() { # LINE TEXT
  local number=$1 at=$1 command="" expected="" line
  while IFS= read -r line; do
    number=$((number + 1))
    if [[ $line != "$ "* ]]; then
      expected+=$line$'\n'
      continue
    fi
    [[ -z $command ]] || check_command "$at" "$command" "$expected"
    at=$number command=${line#\$ } expected=""
  done < <(printf '%s' "$2")
  [[ -z $command ]] || check_command "$at" "$command" "$expected"
}

check_blocks() {
  local number=0 begin=0 kind="" name="" text="" line
  while IFS= read -r line; do
    number=$((number + 1))
    if [[ -z $kind ]]; then
      [[ $line =~ ^\`\`\`([a-z-]*)( ([a-z0-9_.]+))?$ ]] || continue
      kind=${BASH_REMATCH[1]:-plain} name=${BASH_REMATCH[3]:-} begin=$number text=""
    elif [[ $line != '```' ]]; then
      text+=$line$'\n'
    else
      case $kind in
        rob | rob-error) check_program "$begin" "$kind" "$name" "$text" ;;
        console) check_console "$begin" "$text" ;;
        *) [[ -z $name ]] || printf '%s' "$text" > "$name" ;;
      esac
      kind=""
    fi
  done < "$page"
  [[ -z $kind ]] || fail "$begin" "this block is not closed"
}

check_links() {
  local link
  while IFS= read -r link; do
    [[ $link == http*:* || -e $(dirname "$page")/$link ]] || fail 1 "the link $link leads nowhere"
  done < <(grep -o '](\([^)#]\+\)' "$page" | cut -c 3-)
}

check_mentions() { # WHAT, and the words on standard input
  local word
  while IFS= read -r word; do
    grep -qwF -- "$word" "$page" || fail 1 "the $1 $word is not mentioned"
  done
}

# What a page lists in full.
check_lists() {
  local names='s/^ROB_[A-Z]*(\([A-Z0-9]*\),.*/\1/p'
  case ${page#"$root/"} in
    docs/errors.md)
      check_mentions code < <(sed -n "$names" "$root"/{lang/text,runtime/words}/codes.def)
      check_mentions code < <(grep -rhoE '"[ENW][0-9]{3}"' "$root/runtime" | tr -d '"')
      ;;
    docs/language.md) check_mentions function < <(sed -n "$names" "$root/lang/values/builtins.def") ;;
  esac
}

check_blocks
check_links
check_lists
[[ $failures -eq 0 ]]

#!/bin/sh
# Takes every recipe that has a header home, as ./cookbook take does. Each compiles alone, with nothing
# but Eigen, and gives the same bits as the house: check_take.sh ROOT COMPILER EIGEN WORK
set -eu
root=$1 compiler=$2 eigen=$3 work=$4
rm -rf "$work"
mkdir -p "$work"

# Worlds answer wrong scenes by exceptions.
needs_exceptions="direct_solver position_based sequential_impulses soft_steps world"
# What these declare is in libraries, so there is nothing to call: they only have to compile.
only_declare="box_pairs sphere_pairs"

# What a recipe may bring at most, in lines.
budget() {
  case $1 in
    sphere_sphere) echo 450 ;;
    friction) echo 500 ;;
    face_clipping) echo 1100 ;;
    box_box) echo 1700 ;;
    *) echo 9999 ;;
  esac
}

among() { # among WORD LIST
  case " $2 " in *" $1 "*) return 0 ;; *) return 1 ;; esac
}

one_by_one() { # each line is a function and its arguments
  while read -r call what more; do "$call" "$what" "$more"; done
}

two_at_a_time() { # every other line each
  cat >"$work/lines"
  awk 'NR % 2 == 0' "$work/lines" | one_by_one &
  other=$!
  awk 'NR % 2' "$work/lines" | one_by_one
  wait "$other"
}

compile() { # compile NAME WHAT OPTIONS...: one sentence, and the compiler's, where it fails
  log="$work/$1.log" what="$1: $2"
  shift 2
  "$compiler" -std=c++20 -isystem "$eigen" -x c++ "$@" >"$log" 2>&1 && return
  echo "$what does not compile"
  sed -n 1,15p "$log"
  return 1
}

# Which bits come out must not depend on where a compiler puts fused multiply-adds.
run() { # run NAME WHAT OPTIONS...: compiles calls, and leaves what they print in NAME.bits
  compile "$@" -O1 -ffp-contract=off -o "$work/$1.calls" || return 0
  "$work/$1.calls" >"$work/$1.bits" || echo "$1: the calls of $2 end with an error"
}

house() { # house CALLS: calls the house's own headers
  options="-I $root -I $root/recipes"
  names=$(sed -n 's/^#ifdef TAKE_//p' "$1")
  for name in $names; do
    options="$options -D TAKE_$name -include $(echo "$root"/recipes/*/"$name/$name.hpp")"
  done
  # shellcheck disable=SC2086 # the options are words
  run "house_$(basename "$1" .cpp)" "the house" $options "$1"
}

same_bits() { # same_bits NAME WHAT OPTIONS...
  : >"$work/$1.bits"
  run "$@"
  grep -qxF "$(cat "$work/$1.bits")" "$work"/house_*.bits || echo "$1: $2 gives other bits than the house"
}

taken() { # taken NAME [OPTION]: compiles a header for warnings, and compares its bits with the house's
  name=$1 option=$2 id=$1$2 plain="-fno-exceptions -fno-rtti"
  ! among "$name" "$needs_exceptions" || plain=
  set -- ${option:+"$option"} -include "$work/$name.hpp"
  warn="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror $plain"
  calls=$(grep -lx "#ifdef TAKE_$name" "$root"/tests/take/calls_*.cpp) || among "$name" "$only_declare" ||
    echo "$name: tests/take calls nothing of it"
  # shellcheck disable=SC2086 # the options are words
  if [ -z "$wasm" ] && [ -n "$calls" ]; then
    same_bits "$id" "the taken header" $warn "$@" -D "TAKE_$name" "$calls"
  elif [ -n "$wasm" ] && [ -n "$plain" ]; then
    compile "$id" "the taken header, for $wasm," -fsyntax-only --target="$wasm" $warn "$@" /dev/null || true
  else
    compile "$id" "the taken header" -fsyntax-only $warn "$@" /dev/null || true
  fi
}

# A compiler that knows the web compiles each header for it, and all of them together for this machine;
# another one, g++, compares bits. Either takes a minute.
wasm=wasm32-wasi
echo '#include <vector>' | "$compiler" --target="$wasm" -fsyntax-only -x c++ - 2>/dev/null || {
  echo "left out: $compiler has no C++ library for $wasm"
  wasm=
}

for home in "$root"/recipes/*/*/; do
  name=$(basename "$home")
  if [ -f "$home$name.hpp" ] && [ -f "$home$name.expected" ]; then
    "$root/cookbook" take "$name" --out "$work/$name.hpp" 2>/dev/null
    echo "$name $(wc -l <"$work/$name.hpp") $(budget "$name")"
  fi
done >"$work/sizes"

# Where a game compiles the world once, all of its other sources see no more than this.
compiled_once() {
  compile compiled_once "the taken world, compiled elsewhere," -fsyntax-only -Wall -Wextra -Wpedantic \
    -DCOOKBOOK_WORLD_COMPILED -include "$work/world.hpp" /dev/null || true
}

together() {
  # shellcheck disable=SC2046 # the options are words
  compile together "a game with all of them" -fsyntax-only -Wall -Wextra -Werror \
    $(cut -d ' ' -f 1 "$work/sizes" | sed "s|.*|-include $work/&.hpp|") /dev/null || true
}

# A header that does not speak of COOKBOOK_PLAIN is the same text with it. The largest come first.
{
  [ -z "$wasm" ] || echo together
  sort -k 2,2nr "$work/sizes" | while read -r name _; do
    echo "taken $name"
    ! grep -q COOKBOOK_PLAIN "$work/$name.hpp" || echo "taken $name -DCOOKBOOK_PLAIN"
  done
  echo compiled_once
} >"$work/taken"

complaints=$(
  awk '$2 > $3 { print $1 " brings " $2 " lines, its budget is " $3 }' "$work/sizes"
  [ -n "$wasm" ] || printf 'house %s\n' "$root"/tests/take/calls_*.cpp | two_at_a_time
  two_at_a_time <"$work/taken"
)
[ -z "$complaints" ] || { echo "$complaints"; exit 1; }

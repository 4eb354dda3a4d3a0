#!/bin/sh
# Exports every recipe that has a header, as ./cookbook take does. Each compiles alone, with nothing
# but Eigen, and gives the same bits as the house: check_take.sh ROOT COMPILER EIGEN WORK
set -eu
root=$1 compiler=$2 eigen=$3 work=$4
rm -rf "$work"
mkdir -p "$work"

# Worlds answer wrong scenes by exceptions.
needs_exceptions="direct_solver position_based sequential_impulses small_world plain_positions plain_direct soft_steps wide_solver ball_joint game_world game joints ball_limits breaking distance hinge mouse slider weld wheel springs rope cloth articulated taut avbd"
# What these declare is in libraries, so there is nothing to call: they only have to compile.
only_declare="box_pairs sphere_pairs"

# What a recipe may bring at most, in lines.
budget() {
  case $1 in
    plain_spheres) echo 400 ;; # a plain rung: this is a promise
    sphere_sphere) echo 450 ;;
    friction) echo 500 ;;
    plain_box_box) echo 450 ;; # a plain rung: this is a promise
    small_world) echo 1800 ;; # a plain rung: this is a promise
    plain_positions) echo 1600 ;;
    plain_direct) echo 1850 ;;
    face_clipping) echo 1120 ;;
    box_box) echo 1800 ;; # with the plain rungs, whose functions it shares
    game_world) echo 16500 ;; # the header, with all modules, any convex shape and joints
    *) echo 9999 ;;
  esac
}

# What the recipe's own header may have at most, in lines of code: plain rungs are read, and typed in.
own_budget() {
  case $1 in
    plain_box_box) echo 160 ;;
    plain_spheres) echo 70 ;;
    *) echo 9999 ;;
  esac
}

among() { # among WORD LIST
  case " $2 " in *" $1 "*) return 0 ;; *) return 1 ;; esac
}

one_by_one() { # each line is a function and its arguments, two at most
  while read -r call one two; do "$call" "$one" "$two"; done
}

two_at_a_time() { # every other line each
  cat >"$work/lines"
  awk 'NR % 2 == 0' "$work/lines" | one_by_one &
  other=$!
  awk 'NR % 2' "$work/lines" | one_by_one
  wait "$other"
}

# `near` and `far` are empty macros in windows.h, so no header may call anything so.
compile() { # compile NAME WHAT OPTIONS...: one sentence, and the compiler's, where it fails
  log="$work/$1.log" what="$1: $2"
  shift 2
  "$compiler" -std=c++20 -Dnear= -Dfar= -isystem "$eigen" -x c++ "$@" >"$log" 2>&1 && return
  echo "$what cannot be compiled"
  sed -n 1,15p "$log"
  return 1
}

# What the headers include, compiled once; with -Wpedantic, as all that reads it.
first() {
  sed -n '/mmintrin/d; s/^\(#include <[^>]*>\).*/\1/p' "$work"/*.hpp | sort -u >"$work/first"
  # shellcheck disable=SC2086 # the options are words
  "$compiler" --version | grep -q clang || compile first "what all read first" $bits -x c++-header -c "$work/first"
}

# Which bits come out must not depend on where a compiler puts fused multiply-adds, nor on packs: the
# house's are in plain C++.
bits="-Wpedantic -O1 -ffp-contract=off"
calls() { # calls WHOSE CALLS: calls the house's headers, or those taken; what comes out is in NAME.bits
  whose=$1 calls=$(basename "$2" .cpp) source=$2
  # shellcheck disable=SC2086 # the options are words
  set -- $bits -include "$work/first"
  [ "$whose" = taken ] || set -- "$@" -D COOKBOOK_PLAIN -I "$root" -I "$root/recipes"
  # shellcheck disable=SC2013 # the names are words
  for name in $(sed -n 's/^#ifdef TAKE_//p' "$source" | sort -u); do
    case $whose in
      house) set -- "$@" -include "$(echo "$root"/recipes/*/"$name/$name.hpp")" ;;
      *) set -- "$@" -Wall -Wextra -Wconversion -Wshadow -Werror -include "$work/$name.hpp" ;;
    esac
    set -- "$@" -D "TAKE_$name"
  done
  compile "$whose.$calls" "what calls $whose headers" "$@" "$source" -o "$work/$whose.$calls" || return 0
  "$work/$whose.$calls" >"$work/$whose.$calls.bits" || echo "$calls: the calls of $whose headers end with an error"
}

same_bits() { # same_bits CALLS: what was taken gives the house's bits
  calls=$(basename "$1" .cpp)
  diff "$work/house.$calls.bits" "$work/taken.$calls.bits" || echo "$calls: taken headers give other bits than the house"
}

# What all headers that read Eigen include first, compiled once for the web and once for this machine.
eigen_first() {
  printf '#include <%s>\n' Eigen/Core Eigen/Geometry >"$work/eigen.hpp"
  # shellcheck disable=SC2086 # the options are words
  compile eigen_web "Eigen, for the web," $web -x c++-header "$work/eigen.hpp" -o "$work/web.pch" &&
    compile eigen_here "Eigen" -x c++-header "$work/eigen.hpp" -o "$work/here.pch"
}

taken() { # taken NAME [OPTION]: compiles alone for the web, or for this machine where it needs exceptions
  name=$1 id=$1$2 for=here
  # shellcheck disable=SC2086 # the options are words, or nothing
  set -- $2 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
  # shellcheck disable=SC2086
  among "$name" "$needs_exceptions" || { for=web && set -- "$@" $web; }
  if [ -f "$work/$for.pch" ] && grep -q '^#include <Eigen/Core>' "$work/$name.hpp"; then
    set -- "$@" -include-pch "$work/$for.pch"
  fi
  compile "$id" "the taken header, alone," "$@" -include "$work/$name.hpp" /dev/null || true
}

# A compiler that knows the web compiles each header alone, for it, plainly, and all of them together for
# this machine; another one, g++, compares bits. Either takes a minute or two.
web="-fno-exceptions -fno-rtti" wasm=wasm32-wasi
if echo '#include <vector>' | "$compiler" --target="$wasm" -fsyntax-only -x c++ - 2>/dev/null; then
  web="$web --target=$wasm"
else
  echo "left out: $compiler has no C++ library for $wasm"
  wasm=
fi

for home in "$root"/recipes/*/*/; do
  name=$(basename "$home")
  if [ -f "$home$name.hpp" ] && { [ -f "$home$name.expected" ] || [ -f "$home${name}_example.expected" ]; }; then
    "$root/cookbook" take "${home#"$root/"}$name" --out "$work/$name.hpp" 2>/dev/null
    echo "$name $(wc -l <"$work/$name.hpp") $(budget "$name") $(grep -cvE '^ *(//.*)?$' "$home$name.hpp") $(own_budget "$name")"
  fi
done >"$work/sizes"

# Where a game compiles the world once, all of its other sources see no more than this.
compiled_once() {
  compile compiled_once "the taken world, compiled elsewhere," -fsyntax-only -Wall -Wextra -Wpedantic \
    -DCOOKBOOK_WORLD_COMPILED -include "$work/game_world.hpp" /dev/null || true
}

together() {
  # shellcheck disable=SC2046 # the options are words
  compile together "a game with all of them" -fsyntax-only -Wall -Wextra -Werror \
    $(cut -d ' ' -f 1 "$work/sizes" | sed "s|.*|-include $work/&.hpp|") /dev/null || true
}

plainly() { # a header that does not speak of COOKBOOK_PLAIN is the same text with it
  grep -l COOKBOOK_PLAIN "$work"/*.hpp | sed 's|.*/\(.*\)\.hpp|taken \1 -DCOOKBOOK_PLAIN|'
}

alone() { # the largest come first
  echo together
  plainly
  sort -k 2,2nr "$work/sizes" | sed 's/^\([^ ]*\).*/taken \1/'
  echo compiled_once
}

all_calls() { # all_calls WHAT...: a line with each of these for each file of calls
  for source in "$root"/tests/take/calls_*.cpp; do
    for what in "$@"; do
      echo "$what $source"
    done
  done
}

# Each header is called, or only declares, or its example is what calls it.
called() {
  while read -r name _; do
    grep -qx "#ifdef TAKE_$name" "$root"/tests/take/calls_*.cpp || among "$name" "$only_declare" ||
      ls "$root"/recipes/*/"$name/${name}_example.expected" >/dev/null 2>&1 ||
      echo "$name: tests/take calls nothing of it"
  done
}

# Taken by its name, as a reader does, a game's world brings its solvers, too.
with_solvers() {
  lines=$("$root/cookbook" take game_world | wc -l)
  [ "$lines" -le 21000 ] || echo "game_world brings $lines lines with its solvers, its budget is 21000"
}

complaints=$(
  called <"$work/sizes"
  with_solvers
  awk '$2 > $3 { print $1 " brings " $2 " lines, its budget is " $3 }
    $4 > $5 { print $1 ".hpp has " $4 " lines of code, its budget is " $5 }' "$work/sizes"
  if [ -n "$wasm" ]; then
    ! eigen_first || alone | two_at_a_time
  elif first; then
    # shellcheck disable=SC2086 # the names are words
    { all_calls "calls house" "calls taken"; printf 'taken %s\n' $only_declare; echo compiled_once; } |
      two_at_a_time
    all_calls same_bits | one_by_one
  fi
)
[ -z "$complaints" ] || { echo "$complaints"; exit 1; }

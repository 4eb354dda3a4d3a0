#!/bin/sh
# What a game reads of the book where it links the compiled world: as much as takes a few times as long to
# compile as Eigen alone. check_includes.sh ROOT COMPILER EIGEN: fails where the first program of chapter 6
# includes more lines of the book's than its budget, or what only the library is to see.
set -eu
root=$1 compiler=$2 eigen=$3
budget=1700 # 1,300 of them make 1.7 times Eigen's own time; 5,100, as it was once, six times

read=$("$compiler" -std=c++20 -DCOOKBOOK_WORLD_COMPILED -isystem "$eigen" -I "$root" -I "$root/recipes" \
  -MM "$root/tests/06_world/first_world.cpp" | tr ' \\' '\n\n' | grep '\.hpp$')
# shellcheck disable=SC2086 # the names are words
lines=$(cat $read | wc -l)
if [ "$lines" -gt "$budget" ]; then
  echo "a source that links the world reads $lines lines of the book, more than $budget:"
  wc -l $read | sort -n | tail -20
  exit 1
fi

#!/bin/sh
# The check of instances, on two made-up objects that share a function: it must complain of different
# flags, and of nothing else. check_instances_test.sh CHECK COMPILER FOLDER
set -eu
check=$1 compiler=$2
mkdir -p "$3"
cd "$3"
echo '[[gnu::noinline]] inline int twice(int x) { return x + x; }' >twice.hpp
for name in first second; do
  printf '#include "twice.hpp"\nint %s(int x) { return twice(x); }\n' $name >$name.cpp
done

# build FLAGS_OF_FIRST FLAGS_OF_SECOND
build() {
  : >commands.json
  for name in first second; do
    # shellcheck disable=SC2086 # flags are words
    "$compiler" $1 -o $name.o -c $name.cpp
    echo "  \"command\": \"$compiler $1 -o $name.o -c $name.cpp\"," >>commands.json
    shift
  done
}

build '-O3' '-O3 -DOTHER'
sh "$check" commands.json first.o second.o
for other in '-O3 -O1' '-O3 -DNDEBUG' '-O3 -fno-math-errno'; do
  build '-O3' "$other"
  if sh "$check" commands.json first.o second.o 2>said; then
    echo "not noticed: $other"
    exit 1
  fi
  grep -q '^_Z5twicei$' said
done
echo 'int second(int x) { return x; }' >second.cpp # nothing in common
build '-O3' '-O1'
sh "$check" commands.json first.o second.o

#!/bin/sh
# A kind of constraint that leaves a function out does not compile, and the compiler names the function:
# check_left_out.sh COMPILER SOURCE_DIR EIGEN
set -eu
compiler=$1 source=$2 eigen=$3
joint=$source/recipes/06_world/ball_joint/ball_joint.hpp
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
compiles() {
  printf '#include "left_out.hpp"\nint main() { cookbook::BallJoints joints; return int(joints.size()); }\n' >"$dir/main.cpp"
  "$compiler" -std=c++20 -fsyntax-only -isystem "$eigen" -I "$dir" -I "$source" -I "$source/recipes" "$dir/main.cpp" 2>"$dir/said"
}
cp "$joint" "$dir/left_out.hpp"
compiles || { cat "$dir/said"; exit 1; }
for name in each_pair rows; do
  # Under another name it overrides nothing.
  sed "s/void $name(/void another_$name(/; /another_$name(/,/{/s/ override//" "$joint" >"$dir/left_out.hpp"
  if compiles; then
    echo "a joint without $name compiles"
    exit 1
  fi
  grep -q "$name" "$dir/said" || { cat "$dir/said"; echo "the compiler does not name $name"; exit 1; }
done

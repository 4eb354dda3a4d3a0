#!/bin/sh
# A kind of joint that leaves a function out does not compile, nor does a set of constraints, and the compiler
# names the function: check_left_out.sh COMPILER SOURCE_DIR EIGEN
set -eu
compiler=$1 source=$2 eigen=$3
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
compiles() {
  printf '#include "left_out.hpp"\n%s\nint main() { cookbook::BallJoints joints; return int(joints.size()); }\n' "$1" >"$dir/main.cpp"
  "$compiler" -std=c++20 -fsyntax-only -isystem "$eigen" -I "$dir" -I "$source" -I "$source/recipes" "$dir/main.cpp" 2>"$dir/said"
}
refused() { # NAME LINE
  if compiles "$2"; then
    echo "without $1 it compiles"
    exit 1
  fi
  grep -q "$1" "$dir/said" || { cat "$dir/said"; echo "the compiler does not name $1"; exit 1; }
}
joint=$source/recipes/06_world/ball_joint/ball_joint.hpp
cp "$joint" "$dir/left_out.hpp"
compiles "" || { cat "$dir/said"; exit 1; }
for name in check_joint joint_rows; do
  sed "s/$name(/another_$name(/" "$joint" >"$dir/left_out.hpp"
  refused "$name" ""
done
for name in each_pair rows; do
  # Under another name it overrides nothing.
  sed "s/void $name(/void another_$name(/; /another_$name(/,/{/s/ override//" \
    "$source/recipes/06_world/constraints/joint_set.hpp" >"$dir/left_out.hpp"
  refused "$name" "#include \"06_world/ball_joint/ball_joint.hpp\""
done

#!/bin/sh
# Takes every recipe that has a header home, as ./cookbook take does, and compiles each alone, with
# nothing but Eigen: check_take.sh ROOT COMPILER EIGEN WORK
set -eu
root=$1 compiler=$2 eigen=$3 work=$4
rm -rf "$work"
mkdir -p "$work"

# Worlds answer wrong scenes by exceptions.
needs_exceptions="direct_solver position_based sequential_impulses soft_steps world"

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

compile() {
  name=$1
  plain="-fno-exceptions -fno-rtti"
  case " $needs_exceptions " in *" $name "*) plain= ;; esac
  # shellcheck disable=SC2086 # the options are words
  "$compiler" -std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror $plain \
    -isystem "$eigen" -fsyntax-only -x c++ "$work/$name.hpp.cpp" >"$work/$name.log" 2>&1 || {
    echo "$name: the taken header does not compile"
    sed -n 1,15p "$work/$name.log"
  }
}

for home in "$root"/recipes/*/*/; do
  name=$(basename "$home")
  if [ -f "$home$name.hpp" ] && [ -f "$home$name.expected" ]; then
    "$root/cookbook" take "$name" --out "$work/$name.hpp" 2>/dev/null
    printf '#include "%s.hpp"\nint main() {}\n' "$name" >"$work/$name.hpp.cpp"
    echo "$name $(wc -l <"$work/$name.hpp") $(budget "$name")"
  fi
done >"$work/sizes"

complaints=$(
  awk '$2 > $3 { print $1 " brings " $2 " lines, its budget is " $3 }' "$work/sizes"
  while read -r name _; do
    compile "$name" &
    other=$!
    read -r name _ && compile "$name"
    wait "$other"
  done <"$work/sizes"
)
[ -z "$complaints" ] || { echo "$complaints"; exit 1; }

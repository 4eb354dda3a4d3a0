#!/bin/sh
# ./cookbook new lays out a recipe that compiles, is formatted and keeps every rule of the house:
# check_new.sh ROOT COMPILER EIGEN HOUSE_TEST WORK
set -eu
root=$1 compiler=$2 eigen=$3 house=$4 work=$5
rm -rf "$work"
mkdir -p "$work"
cd "$root"
cp -r .clang-format CMakeLists.txt CMakePresets.json README.md chapters common cookbook docs recipes tests tools "$work"
cd "$work"
./cookbook new 3 sphere_cone >said
grep -q 'The next formula of this chapter is S[0-9][0-9]*' said || { cat said; exit 1; }
COOKBOOK_HOUSE="$work" "$house" >house.log || { cat house.log; exit 1; }
for file in recipes/*/sphere_cone/sphere_cone.cpp tests/*/sphere_cone_test.cpp; do
  "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Werror -isystem "$eigen" -I . -I recipes "$file"
done
format=$(command -v clang-format-14 || command -v clang-format || true)
case $("${format:-echo}" --version) in
  *"version 14."*) "$format" --dry-run --Werror recipes/*/sphere_cone/*.?pp tests/*/sphere_cone_test.cpp ;;
esac

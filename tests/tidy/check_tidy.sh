#!/bin/sh
# Reads all headers that are taken home with clang-tidy, a chapter at a time: check_tidy.sh ROOT EIGEN WORK
set -eu
root=$1 eigen=$2 work=$3
if ! command -v clang-tidy >/dev/null; then
  echo "clang-tidy is not installed: nothing is checked"
  exit 0
fi
mkdir -p "$work"
for folder in "$root"/common/math "$root"/common/simd "$root"/recipes/*/; do
  name=$(basename "$folder")
  find "$folder" -name '*.hpp' ! -path '*/trial/*' ! -name '*_kernel.hpp' ! -name rational.hpp |
    sort | sed 's/.*/#include "&"/' >"$work/$name.cpp"
done
printf '%s\n' "$work"/*.cpp |
  xargs -P 2 -I SOURCE clang-tidy --quiet --config-file="$root/.clang-tidy" SOURCE -- \
    -std=c++20 -I"$root" -I"$root/recipes" -isystem "$eigen" 2>/dev/null

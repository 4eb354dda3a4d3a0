#!/bin/sh
# Reads all headers that are exported with clang-tidy, in one go, since each would read Eigen anew:
# check_tidy.sh ROOT EIGEN WORK
set -eu
root=$1 eigen=$2 work=$3
if ! command -v clang-tidy >/dev/null; then
  echo "clang-tidy is not installed: nothing is checked"
  exit 0
fi
mkdir -p "$work"
find "$root/common/math" "$root/common/simd" "$root/recipes" -name '*.hpp' ! -path '*/trial/*' \
  ! -name '*_kernel.hpp' | sort | sed 's/.*/#include "&"/' >"$work/all.cpp"
clang-tidy --quiet --config-file="$root/.clang-tidy" "$work/all.cpp" -- \
  -std=c++20 -I"$root" -I"$root/recipes" -isystem "$eigen" 2>/dev/null

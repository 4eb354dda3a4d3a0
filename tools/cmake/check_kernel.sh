#!/bin/sh
# A kernel for newer processors shares no function with files for every processor: the linker keeps one
# copy of such a function, and it must not be the kernel's. check_kernel.sh SET OBJECT...
set -eu
set_name=$1
shift
shared=$(nm -C --defined-only "$@" | awk '$2 ~ /^[WVu]$/' | grep -v "cookbook::$set_name::" || true)
[ -z "$shared" ] && exit
echo "The linker may take these for $set_name where the processor has no such instructions:"
echo "$shared" | sed -n 1,10p
exit 1

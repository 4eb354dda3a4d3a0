#!/bin/sh
# Of a function that several objects define the linker keeps one. In a program that measures time all of
# them must be compiled alike, or a method is timed as its label does not say.
#
# check_instances.sh COMPILE_COMMANDS OBJECT…: fails, and names some, where objects define the same weak
# function and differ in optimisation, instruction set or what Eigen is told.
set -eu
commands=$1
shift
{
  awk '/"command":/ {
    object = level = flags = ""
    gsub(/\\\\\\"[^"]*"/, "") # texts that are defined
    for (i = 1; i <= NF; ++i) {
      if ($i == "-o") object = $(i + 1)
      else if ($i ~ /^-O/) level = $i # the last one counts
      else if ($i ~ /^-(m|f|D(NDEBUG|EIGEN_|COOKBOOK_PLAIN))/) flags = flags " " $i
    }
    print "compiled", object, level flags
  }' "$commands"
  nm -A --defined-only "$@"
} | awk '
  $1 == "compiled" { object = $2; $1 = $2 = ""; flags[object] = $0; next }
  { sub(/:[0-9a-f]*$/, "", $1) } # the object, without the address
  !($1 in flags) { unknown = $1; exit }
  { ++seen }
  $2 != "W" { next }
  !($3 in first) { first[$3] = $1; next }
  flags[first[$3]] != flags[$1] {
    if (++several <= 5)
      print $3 "\n  in " first[$3] ":" flags[first[$3]] "\n  in " $1 ":" flags[$1]
  }
  END {
    if (unknown) print unknown " is not among the compile commands"
    if (several) print several " functions are compiled in two ways; the linker keeps one of each"
    exit several > 0 || unknown != "" || !seen
  }
' >&2

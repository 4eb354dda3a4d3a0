#!/bin/sh
# What each step of the small world changes in the one before, for the book: differences.sh FOLDER OUT
# writes OUT/step_2.diff and so on, without heads and marks; a head @@ names the function before.
set -eu
for n in 2 3 4 5 6 7; do
  before=$((n - 1))
  sed -e '1,/\\brief/d' -e '/^\/\/ \[/d' -e '/^namespace/d' -e '/^}  *\/\//d' "$1/step_$before.hpp" >"$2/before"
  sed -e '1,/\\brief/d' -e '/^\/\/ \[/d' -e '/^namespace/d' -e '/^}  *\/\//d' "$1/step_$n.hpp" >"$2/after"
  diff -U2 --show-function-line='^inline\|^struct' "$2/before" "$2/after" |
    sed -E -e 1,2d -e '/^@@/{s/^@@ [^@]*@@ ?/@@ /;s/\(.*/()/;s/ : .*//;s/^@@ inline ([^ ]+ )?/@@ /;}' >"$2/step_$n.diff"
  [ -s "$2/step_$n.diff" ]
done
rm "$2/before" "$2/after"

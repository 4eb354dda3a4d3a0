#!/bin/sh
# Runs a recipe's program in an empty folder and compares what it prints and draws, byte for byte, with
# the files that the pages show; or takes the new ones instead:
# check_output.sh compare|accept PROGRAM NAME EXPECTED FIGURES DRAWN
set -eu
mode=$1 program=$2 name=$3 expected=$4 figures=$5 drawn=$6
status=0

rm -rf "$drawn"
mkdir -p "$drawn"
"$program" --out "$drawn" >"$drawn/$name.printed" 2>"$drawn/$name.complaint" || {
  printf '%s ended with %s: %s\n' "$name" $? "$(cat "$drawn/$name.complaint")"
  exit 1
}

# What was made, and where it is kept, a line each.
pairs() {
  printf '%s\t%s\n' "$drawn/$name.printed" "$expected"
  for made in "$drawn"/*.svg "$drawn"/*.html "$drawn"/*.csv; do
    [ ! -f "$made" ] || printf '%s\t%s\n' "$made" "$figures/${made##*/}"
  done
}

# shows MADE KEPT: says how they differ, and whether they do.
shows() {
  [ -f "$2" ] || { echo "new: $2"; return 0; }
  cmp -s "$1" "$2" && return 1
  case $2 in
    *.svg | *.html) echo "changed: $2 ($(diff "$2" "$1" | grep -c '^[<>]') lines)" ;;
    *) echo "changed: $2"; diff -u "$2" "$1" | sed -n '3,60p' ;;
  esac
}

differing=$(pairs | while IFS="$(printf '\t')" read -r made kept; do
  shows "$made" "$kept" || continue
  [ "$mode" != accept ] || { mkdir -p "${kept%/*}"; cp "$made" "$kept"; }
done)
for kept in "$figures/$name.svg" "$figures/$name.html"; do
  if [ -f "$kept" ] && [ ! -f "$drawn/${kept##*/}" ]; then
    differing="$differing
no longer drawn: $kept"
  fi
done

if [ "$mode" = accept ]; then
  echo "${differing:-nothing has changed}"
elif [ -n "$differing" ]; then
  printf '%s\nWhat was made is in %s.\nIf it is right: ./cookbook accept %s\n' "$differing" "$drawn" "$name"
  status=1
fi
exit $status

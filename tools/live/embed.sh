#!/bin/sh
# Writes a module as a script that a page from file:// may load: embed.sh NAME MODULE SCRIPT
set -eu
{
  printf 'liveModule("%s", "' "$1"
  base64 <"$2" | tr -d '\n'
  printf '");\n'
} >"$3.part"
mv "$3.part" "$3"

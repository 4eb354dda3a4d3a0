#!/bin/sh
# Puts the modules of the live figures beside the pages: live_modules.sh LIVE HTML
set -eu
mkdir -p "$2"
for module in "$1"/*.wasm.js; do
  [ ! -f "$module" ] || cp "$module" "$2"
done

#!/bin/sh
# Looks at the book in headless Chromium: run.sh HTML [PAGE…]. Needs node and npm, by which it fetches
# playwright-core into build/browser, once, and the system's chromium.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
root=$(dirname -- "$(dirname -- "$here")")
html=$(cd "$1" && pwd)
shift
version=1.60.0 # the newest that runs on node 18, which Debian 12 has

untried() { echo "The book was not looked at in a browser: $1"; [ "${CI:-}" != true ]; exit; }
for command in node npm; do
  command -v "$command" >/dev/null || untried "there is no $command (./cookbook install-packages)"
done
command -v chromium chromium-browser google-chrome >/dev/null || untried "there is no chromium (./cookbook install-packages)"

kept="$root/build/browser"
if ! grep -qs "\"version\": \"$version\"" "$kept/node_modules/playwright-core/package.json"; then
  mkdir -p "$kept"
  npm install "playwright-core@$version" --prefix "$kept" --no-save --no-package-lock --ignore-scripts \
    --no-audit --no-fund --loglevel=error || untried "npm could not install playwright-core"
fi

failed=0
[ $# -ne 0 ] || node "$here/broken.mjs" "$html" || failed=1
node "$here/pages.mjs" "$html" "$@" || failed=1
if [ $# -eq 0 ] && [ -f "$here/live.mjs" ]; then
  node "$here/live.mjs" "$html" || failed=1
  node "$here/game.mjs" "$html" || failed=1
fi
exit "$failed"

#!/bin/sh
# Asks the book's own search for each term of terms.txt, in a browser without a window, from file://, and
# fails where the first answer is on no page that the term may lead to: check_search.sh HTML [TERM…]
set -eu
html=$(cd "$1" && pwd)
shift
terms=$(dirname "$0")/terms.txt
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$browser" ] || { echo "The search was not tried: there is no chromium"; exit 0; }

profile=$(mktemp -d)
asked="$html/search_check.html"
trap 'rm -rf "$profile" "$asked"' EXIT

# page ADDRESS: the page as it is once its scripts have run.
page() {
  timeout 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$profile" \
    --virtual-time-budget=20000 --dump-dom "$1" 2>/dev/null
}

# One page asks for all terms; the answers are lines of "term: file#place (heading)".
{
  cat <<'PAGE'
<!DOCTYPE html><meta charset="utf-8">
<script src="search.js"></script><script src="search_index.js"></script><pre id="found"></pre>
<script>
const answered = (term) => {
  const [best] = searchBook(term);
  return "\n= " + term + ": " + (best ? best.place + " (" + best.heading + ")" : "nothing");
};
document.getElementById("found").textContent = [
PAGE
  if [ $# -gt 0 ]; then printf '"%s",\n' "$@"; else sed -n 's/^\([^#:]*\):.*/"\1",/p' "$terms"; fi
  printf '%s\n' '].map(answered).join("") + "\n";' '</script>'
} >"$asked"
found=$(page "file://$asked" | sed -n 's/^= //p')
[ $# -eq 0 ] || { echo "$found"; exit 0; }

wrong=$(printf '%s\n' "$found" | awk -F': ' -v terms="$terms" '
  BEGIN {
    while ((getline line < terms) > 0)
      if (line !~ /^#/ && split(line, parts, ": ") == 2) { expected[parts[1]] = parts[2]; ++left }
  }
  {
    file = $2
    sub(/\.html.*/, "", file)
    sub(/^index$/, "mainpage", file)
    if (index(" " expected[$1] " ", " " file " ") == 0)
      print "  " $1 ": " substr($0, length($1) + 3) ", not " expected[$1]
    --left
  }
  END { if (left != 0) print "  " left " terms had no answer" }')
[ -z "$wrong" ] || printf 'The search leads elsewhere:\n%s\n' "$wrong"

# The page of all answers, as a reader has it.
first=$(page "file://$html/search.html?q=separating%20axis" |
  sed -n 's/.*<div id="all-answers"><a href="[^"]*\/\([a-z0-9_]*\)\.html.*/\1/p')
case $first in
  ch4* | ch2_overlaps) ;;
  *) wrong=$wrong.; echo "search.html?q=separating%20axis shows ${first:-nothing} first" ;;
esac
[ -z "$wrong" ]
echo "The search finds $(grep -c '^[^#]*: ' "$terms") terms where they are told"

#!/bin/sh
# Prints a recipe as one header that needs nothing but Eigen: take_recipe.sh ROOT HEADER [FIRST], the
# header as a path from the root, and the names that come first in the list of what it offers; a dot after
# them where no other is listed.
# ./cookbook take calls it.
set -eu
root=$1 header=$2 first=${3:-}
version=$(sed -n 's/^project(cookbook VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")

library=
[ ! -f "$root/${header%.hpp}_dispatch.cpp" ] || library=$(basename "$header" .hpp)

awk -v root="$root" -v library="$library" -v header="$header" -v first="$first" -v version="$version" '
# The file that an include names; empty for one of another library.
function named(include,    name, path, line, i) {
  name = include
  gsub(/^#include "|".*$/, "", name)
  for (i = 1; i <= 2; ++i) {
    path = (i == 1 ? "" : "recipes/") name
    if ((getline line < (root "/" path)) >= 0) { close(root "/" path); return path }
  }
  return ""
}

# Adds a file to the bodies, after those that it includes; what it includes of others, to the top. What
# it includes where bodies are wanted is put off until all others are there.
function take(path,    line, depth, text, blank, bodies_only) {
  if (path in taken) return
  taken[path] = 1
  taken_as[++files] = path
  depth = 0
  while ((getline line < (root "/" path)) > 0) {
    if (line == wanted) { bodies_only = 1; continue }
    if (bodies_only && line ~ /^#include "/) { put_off[++waiting] = named(line); continue }
    if (bodies_only && line ~ /^#endif/) { bodies_only = 0; continue }
    if (line ~ /^#if/) ++depth
    if (line ~ /^#endif/) --depth
    if (line ~ /^#include "/) { take(named(line)); continue }
    if (line ~ /^#include </ && depth == 0) { above[line] = 1; continue }
    if (line ~ /^\/\/\/ \\file/) about_file = 1
    if (line !~ /^\/\/\//) about_file = 0
    if (line ~ /^#pragma once/ || line ~ /^\/\/ \[.*\]$/ || about_file) continue
    if (line == "" && blank) continue
    blank = line == ""
    text = text line "\n"
  }
  close(root "/" path)
  sub(/^\n+/, "", text)
  # One namespace goes on from file to file; guards let a game include several taken headers.
  within = index(text, opening) == 1 && sub(closing "$", "", text)
  if (within) text = substr(text, length(opening) + 1)
  glue = within == inside ? "" : within ? "\nnamespace cookbook\n{\n" : closing
  inside = within
  guard = toupper(path)
  gsub(/^.*\/|[^A-Z0-9\/]/, "_", guard)
  guard = "COOKBOOK" guard
  bodies[files_in_order++] = glue "\n// ---- " path " ----\n#ifndef " guard "\n#define " guard "\n" text "#endif\n"
}

# What a header offers, all that was not listed yet or `only` one name: the name of what each comment stands before, and the comment\047s first sentence.
# One that only includes others offers what they do.
function offers(path,    line, said, done, any, includes, i, bodies_only) {
  while ((getline line < (root "/" path)) > 0) {
    bodies_only = line == wanted || (bodies_only && line !~ /^#endif/)
    if (line ~ /^#include "/ && !bodies_only) includes[++i] = named(line)
    if (line ~ /^\/\/\/ \\/) continue
    if (line ~ /^\/\/\//) {
      if (!done) said = said (said == "" ? "" : " ") substr(line, 5)
      done = done || line == "///" || line ~ /[.:]$/ || sub(/[.:;] .*/, "", said)
      continue
    }
    if (line ~ /^(#|namespace|\{)/) { said = ""; done = 0; continue }
    if (line ~ /^(template|\[\[gnu|$)/ && line !~ /\(/) continue
    if (said != "" && line !~ /[({]|^(struct|class|using|enum) / && line !~ /;$/) continue
    if (said != "" && line !~ /^ /) {
      sub(/[.:;]$/, "", said)
      gsub(/alignas\([0-9]*\) /, "", line)
      gsub(/ = .*| : .*|\(.*|;.*/, "", line)
      while (sub(/<[^<>]*>/, "", line)) ;
      gsub(/ *$|.*[ >&*:]/, "", line)
      if (only == "" ? !(line in listed) : line == only) printf "//   %s: %s\n", line, said
      found = found || line == only
      any = 1
    }
    said = ""
    done = 0
  }
  close(root "/" path)
  if (!any && only == "") for (i = 1; i in includes; ++i) offers(includes[i])
}

# What comes first, from whichever file has it; then the rest of the header.
function list(    names, count, i, k) {
  count = split(first, names, " ")
  for (i = 1; i <= count; ++i) {
    only = names[i]
    if (only == ".") return
    found = 0
    for (k = 1; k <= files && !found; ++k) offers(taken_as[k])
    listed[only] = 1
  }
  only = ""
  offers(header)
}

function brief(path,    line, text) {
  while ((getline line < (root "/" path)) > 0) {
    if (sub(/^\/\/\/ \\brief /, "", line)) text = line
    else if (text != "" && sub(/^\/\/\/ /, "", line)) text = text " " line
    else if (text != "") break
  }
  close(root "/" path)
  return text
}

BEGIN {
  opening = "namespace cookbook\n{\n\n"
  inside = 0
  closing = "\n} // namespace cookbook\n"
  name = header
  gsub(/.*\/|\.hpp$/, "", name)
  wanted = "#if COOKBOOK_WORLD_BODIES"
  take(header)
  if (waiting) {
    bodies[files_in_order++] = (inside ? closing : "") "\n" wanted "\n"
    inside = 0
    for (i = 1; i <= waiting; ++i) take(put_off[i])
    bodies[files_in_order++] = (inside ? closing : "") "#endif // bodies\n"
    inside = 0
  }
  print "// " name ": " brief(header)
  print "//"
  print "// Taken from the Contact Cookbook " version ": " files " of its files in one. Needs C++20 and Eigen 3.4:"
  print "//   c++ -std=c++20 -O2 -ffp-contract=off -I/usr/include/eigen3 game.cpp"
  if (library != "") {
    print "// This header only declares: what it declares is compiled once for each instruction set. Link"
    print "// cookbook::" library ", as the README shows."
  }
  if (waiting) {
    print "// It takes long to compile. In a game of several sources, compile all with COOKBOOK_WORLD_COMPILED"
    print "// defined; and one more, which defines COOKBOOK_WORLD_SOURCE, includes this, and holds no more."
  }
  space = "cookbook"
  while ((getline line < (root "/" header)) > 0) if (line ~ /^namespace cookbook::/) space = substr(line, 11)
  close(root "/" header)
  print "// Everything is in namespace " space ". What is here to be called:"
  list()
  print "//"
  while ((getline line < (root "/LICENSE")) > 0) print line == "" ? "//" : "// " line
  print "\n#pragma once\n"
  sort = "sort"
  for (line in above) print line | sort
  close(sort)
  for (i = 0; i < files_in_order; ++i) printf "%s", bodies[i]
  if (inside) printf "%s", closing
}'

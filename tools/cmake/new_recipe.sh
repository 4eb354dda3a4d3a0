#!/bin/sh
# Lays out a new recipe, which passes every check of the house: new_recipe.sh ROOT CHAPTER NAME.
# ./cookbook new calls it.
set -eu
root=$1 chapter=$2 name=$3
number=$(echo "${chapter%%_*}" | sed 's/^0//')
recipe="recipes/$chapter/$name/$name"
test="tests/$chapter/${name}_test.cpp"
page="chapters/${chapter}_$name.md"
cd "$root"
mkdir -p "tests/$chapter" "recipes/$chapter/$name"

cat >"$recipe.hpp" <<END
#pragma once

/// \\file
/// \\brief One sentence that says what $name answers.

#include "common/math/vector.hpp"

namespace cookbook
{

// [$name]
/// One sentence; then formula id, units, errors, the degenerate answer, the source.
template <class Real>
Real $name(const Vector3<Real>& v)
{
  return v.squaredNorm();
}
// [$name]

} // namespace cookbook
END

cat >"$recipe.cpp" <<END
/// \\file
/// \\brief One sentence that says what the program prints and draws.

#include "$chapter/$name/$name.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_answers(const Arguments&)
{
  Table table({"x", "answer"});
  table.row({"2", number($name<double>({2, 0, 0}))});
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{.name = "$name", .summary = "One sentence for --help."};
  return run_program(argc, argv, arguments, print_answers);
}
END

printf 'x  answer\n2       4\n' >"$recipe.expected"

cat >"$test" <<END
/// \\file
/// What holds for $name.

#include "$chapter/$name/$name.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [square]
TEST_CASE("a vector of length 2 gives 4", "[$name]")
{
  CHECK($name<double>({2, 0, 0}) == 4);
}
// [square]
END

cat >"$page" <<END
# Chapter $number: $name {#ch${number}_page_$name}

A picture and a question.

## What it answers {#ch${number}_$name}

### The idea {#ch${number}_${name}_idea}

A paragraph, and the formula as it stands.

### Code {#ch${number}_${name}_code}

The formula in C++:

\\snippet $name.hpp $name

### Run it {#ch${number}_${name}_run}

\`\`\`sh
./cookbook run $name
\`\`\`

It prints:

\\include $name.expected

### Proof {#ch${number}_${name}_proof}

The test whose answer is known by hand:

\\snippet ${name}_test.cpp square

## Exercises {#ch${number}_${name}_exercises}

1. Return the length instead of its square. Which test of \`./cookbook test $name\` turns red?
END

printf 'cookbook_recipe(%s)\n' "$name" >>"recipes/$chapter/CMakeLists.txt"
# The chapter's first page opens the new one, for now above the others.
awk -v link="\\\\subpage ch${number}_page_$name is new here.\n" '
  { lines[NR] = $0 }
  $0 == "" { blank = NR }
  /\\subpage/ && !first { first = blank }
  END { for (i = 1; i <= NR; ++i) { print lines[i]; if (i == first) print link } }
' "chapters/$chapter.md" >"chapters/$chapter.md.part"
mv "chapters/$chapter.md.part" "chapters/$chapter.md"

# Formulas are numbered through the book by a letter for each chapter, R for 5 to 7: the first number
# that is free.
letter=$(printf 'M P S O R R R' | cut -d ' ' -f "$number")
last=$(cat chapters/*.md tests/*/*.cpp | grep -oE "(tag\{|\[)$letter[0-9]+[]}]" | tr -dc '0-9\n' | sort -n | tail -n 1)
echo "Made $recipe.hpp, .cpp and .expected, $test,"
echo "and its page, $page, with a link to it in chapters/$chapter.md."
id=$letter$((last + 1))
printf '%s\n' "The next formula of this chapter is $id: \\tag{$id} on the page, [$id] at its test."
echo "Next: ./cookbook test $name, then docs/making.md, \"A recipe\"."

#!/bin/sh
# Lays out a new recipe: new_recipe.sh ROOT CHAPTER NAME. ./cookbook new calls it.
set -eu
root=$1 chapter=$2 name=$3
recipe="$root/recipes/$chapter/$name/$name"
test="$root/tests/$chapter/${name}_test.cpp"
mkdir -p "$root/tests/$chapter" "$root/recipes/$chapter/$name"

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

int main(int argc, char** argv)
{
  using namespace cookbook;
  const Arguments arguments{.name = "$name", .summary = "One sentence for --help."};
  return run_program(
    argc, argv, arguments,
    [](const Arguments&)
    {
      Table table({"x", "answer"});
      table.row({"2", number($name<double>({2, 0, 0}))});
      std::cout << table.text();
    });
}
END

printf 'x  answer\n2       4\n' >"$recipe.expected"

cat >"$test" <<END
/// \\file
/// What holds for $name.

#include "$chapter/$name/$name.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

TEST_CASE("a vector of length 2 gives 4", "[$name]")
{
  CHECK($name<double>({2, 0, 0}) == 4);
}
END

printf 'cookbook_recipe(%s)\n' "$name" >>"$root/recipes/$chapter/CMakeLists.txt"
echo "Made $recipe.hpp, .cpp, .expected and $test."
echo "Next: write its section in chapters/$chapter.md, then ./cookbook test $name"

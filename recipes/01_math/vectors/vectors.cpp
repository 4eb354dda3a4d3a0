/// \file
/// \brief What is made of two vectors, as a table and as pictures; and answers to a reader's rows.

#include "01_math/vectors/vectors.hpp"
#include "01_math/angles/angles.hpp"
#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/vectors/trial/vectors_cases.hpp"
#include "01_math/vectors/trial/vectors_figures.hpp"
#include "tools/program/asking.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_vectors()
{
  const Vector3<double> a(1, 2, 3), b(2, 1, 2);
  Table table({"a = (1, 2, 3), b = (2, 1, 2)", "x", "y", "z"});
  const auto add = [&](const std::string& what, const Vector3<double>& v) {
    table.row({what, number(v.x()), number(v.y()), number(v.z())});
  };
  add("a + b", a + b);
  add("2 a", 2 * a);
  table.row({"a · b", number(a.dot(b)), "", ""});
  add("a × b", a.cross(b));
  add("b × a", b.cross(a));
  add("a along b", project(a, b));
  add("a across b", reject(a, b));
  add("a mirrored, normal b", reflect(a, b));
  add("a quarter of the way from a to b", lerp(a, b, 0.25));
  std::cout << table.text();
}

const std::string one_vector = "ax,ay,az";
const std::string two_vectors = "ax,ay,az,bx,by,bz";

template <class Real>
std::vector<Real> list(const Vector3<Real>& v)
{
  return {v.x(), v.y(), v.z()};
}

/// A question about two vectors that a vector answers.
template <class Real, class Formula>
Question<Real> of_two(const std::string& name, const Formula& formula)
{
  return {name, two_vectors, "x,y,z", [formula](const PairsRow& row) {
            return list<Real>(formula(row.vector<Real>(0), row.vector<Real>(3)));
          }};
}

/// What may be asked of each row.
template <class Real>
std::vector<Question<Real>> questions()
{
  using Three = Vector3<Real>;
  return {
      {"length", one_vector, "length",
       [](const PairsRow& row) { return std::vector<Real>{length<Real>(row.vector<Real>(0))}; }},
      {"normalize", one_vector, "x,y,z",
       [](const PairsRow& row) { return list<Real>(normalize<Real>(row.vector<Real>(0)).unit); }},
      {"angle", two_vectors, "angle",
       [](const PairsRow& row)
       { return std::vector<Real>{angle(row.vector<Real>(0), row.vector<Real>(3))}; }},
      of_two<Real>("cross", [](const Three& a, const Three& b) { return accurate_cross(a, b); }),
      of_two<Real>("project", [](const Three& a, const Three& b) { return project(a, b); }),
      of_two<Real>("reflect", [](const Three& a, const Three& b) { return reflect(a, b); })};
}

} // namespace

int main(int argc, char** argv)
{
  return run_asking_program(
      argc, argv,
      {.name = "vectors",
       .summary = "Sums, products, parts and mirror images of vectors; their lengths and angles."},
      [](auto zero) { return questions<decltype(zero)>(); },
      [](const Arguments& given)
      {
        print_vectors();
        save_figure(given, "vectors.svg", adding_figure().svg());
        save_figure(given, "vectors_dot.svg", dot_figure().svg());
        save_figure(given, "vectors_cross.svg", cross_figure().svg());
        save_figure(given, "vectors_reflect.svg", mirror_figure().svg());
        save_figure(
            given, "vectors_cases.html",
            verdict_table(
                "Formulas on vectors as they are usually written, and the recommended ones.",
                vectors_methods, vectors_verdicts(), "vectors"));
      });
}

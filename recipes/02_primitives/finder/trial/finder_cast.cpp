#include "02_primitives/casts/casts.hpp"
#include "02_primitives/finder/trial/finder_pairs.hpp"
#include "02_primitives/in_the_plane/plane_casts.hpp"

namespace cookbook
{

namespace
{

struct Cast
{
  template <class Real, class A, class B>
  static std::optional<Question<Real>> about()
  {
    if constexpr (requires(const A& a, const B& b) { cast(a, b)->normal; })
    {
      using Found = decltype(cast(A(), B()));
      constexpr int size = decltype(Found()->normal)::RowsAtCompileTime;
      return question_about<Real, A, B>(
          "cast", "hit,t," + point_columns(size, "") + "," + point_columns(size, "n"),
          [](const A& a, const B& b)
          {
            const Found found = cast(a, b);
            std::vector<Real> numbers{Real(found.has_value())};
            if (found)
            {
              numbers.push_back(found->t);
              append<Real, size>(numbers, found->point);
              append<Real, size>(numbers, found->normal);
            }
            return numbers;
          });
    }
    return std::nullopt;
  }
};

} // namespace

template <class Real>
std::optional<Question<Real>> cast_question(const std::string& a, const std::string& b)
{
  return question_named<Real, Cast>(a, b);
}

template std::optional<Question<float>>
cast_question<float>(const std::string& a, const std::string& b);
template std::optional<Question<double>>
cast_question<double>(const std::string& a, const std::string& b);

} // namespace cookbook

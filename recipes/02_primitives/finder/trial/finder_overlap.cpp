#include "02_primitives/finder/trial/finder_pairs.hpp"
#include "02_primitives/in_the_plane/in_the_plane.hpp"
#include "02_primitives/overlaps/overlaps.hpp"

namespace cookbook
{

namespace
{

// [find_overlap]
struct Overlap
{
  template <class Real, class A, class B>
  static std::optional<Question<Real>> about()
  {
    const auto ask = [](auto answer)
    { return question_about<Real, A, B>("overlap", "hit", answer); };
    if constexpr (requires(const A& a, const B& b) { overlaps(a, b); })
    {
      return ask([](const A& a, const B& b) { return std::vector<Real>{Real(overlaps(a, b))}; });
    }
    else if constexpr (requires(const A& a, const B& b) { overlaps(b, a); })
    {
      return ask([](const A& a, const B& b) { return std::vector<Real>{Real(overlaps(b, a))}; });
    }
    return std::nullopt;
  }
};
// [find_overlap]

} // namespace

template <class Real>
std::optional<Question<Real>> overlap_question(const std::string& a, const std::string& b)
{
  return question_named<Real, Overlap>(a, b);
}

template std::optional<Question<float>>
overlap_question<float>(const std::string& a, const std::string& b);
template std::optional<Question<double>>
overlap_question<double>(const std::string& a, const std::string& b);

} // namespace cookbook

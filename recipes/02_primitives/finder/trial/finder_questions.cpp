#include "02_primitives/finder/trial/finder.hpp"
#include "02_primitives/finder/trial/finder_pairs.hpp"

namespace cookbook
{

const std::vector<std::string>& finder_asks()
{
  static const std::vector<std::string> asks{"overlap", "closest", "cast"};
  return asks;
}

const std::vector<std::string>& finder_shapes()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> all;
    const auto add = [&all]<class A>(std::type_identity<A>)
    { all.emplace_back(ShapeColumns<A>::name); };
    for_each_shape(ShapesInSpace<double>(), add);
    for_each_shape(ShapesInPlane<double>(), add);
    return all;
  }();
  return names;
}

template <class Real>
std::optional<Question<Real>>
finder_question(const std::string& ask, const std::string& a, const std::string& b)
{
  return ask == "overlap"   ? overlap_question<Real>(a, b)
         : ask == "closest" ? closest_question<Real>(a, b)
                            : cast_question<Real>(a, b);
}

template std::optional<Question<float>>
finder_question<float>(const std::string& ask, const std::string& a, const std::string& b);
template std::optional<Question<double>>
finder_question<double>(const std::string& ask, const std::string& a, const std::string& b);

std::vector<std::string> finder_partners(const std::string& ask, const std::string& a)
{
  std::vector<std::string> partners;
  for (const std::string& b : finder_shapes())
  {
    if (finder_question<double>(ask, a, b))
    {
      partners.push_back(b);
    }
  }
  return partners;
}

} // namespace cookbook

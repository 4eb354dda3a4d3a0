#include "01_math/angles/angles.hpp"
#include "01_math/math_prices/trial/math_prices.hpp"
#include "01_math/matrices/matrices.hpp"
#include "01_math/numbers/wrap_angle.hpp"
#include "01_math/rotations/rotation_between.hpp"
#include "01_math/rotations/rotations.hpp"
#include "01_math/rotations/slerp.hpp"
#include "01_math/rotations/trial/eigen_between.hpp"

#ifdef COOKBOOK_HAS_GLM
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/gtx/quaternion.hpp>
#include <glm/gtx/vector_angle.hpp>
#endif

#include <cmath>
#include <numbers>
#include <random>

namespace cookbook
{

namespace
{

std::vector<Ordinary> ordinary_inputs()
{
  std::mt19937 random(1);
  const auto fraction = [&] { return static_cast<float>(random() % 2001) / 1000 - 1; };
  const auto direction = [&]
  {
    Vector3<float> v = Vector3<float>::Zero();
    while (v.norm() < 0.1f)
    {
      v = {fraction(), fraction(), fraction()};
    }
    return Vector3<float>(v.normalized());
  };
  std::vector<Ordinary> all;
  while (all.size() < priced_inputs)
  {
    Ordinary one{direction(), direction(), direction(), {}, {}, {}, {}, 20 * fraction()};
    one.p = Eigen::AngleAxis<float>(fraction(), direction());
    one.q = Eigen::AngleAxis<float>(fraction(), direction()) * one.p;
    const Vector3<float> sizes(
        1.25f + 0.7f * fraction(), 1.25f + 0.7f * fraction(), 1.25f + 0.7f * fraction());
    one.m = one.p.toRotationMatrix() * sizes.asDiagonal();
    one.pose = pose<float>(one.q.toRotationMatrix(), 10 * direction());
    all.push_back(one);
  }
  return all;
}

std::vector<double> numbers_of(float x)
{
  return {x};
}
std::vector<double> numbers_of(const Vector3<float>& v)
{
  return {v.x(), v.y(), v.z()};
}
std::vector<double> numbers_of(const Matrix3<float>& m)
{
  return {m.data(), m.data() + 9};
}
/// Either sign is the same rotation.
std::vector<double> numbers_of(const Quaternion<float>& q)
{
  return numbers_of(Matrix3<float>(q.toRotationMatrix()));
}

/// The calls so far, and the inputs that they are given.
class Calls
{
public:
  template <class Call>
  void add(const std::string& what, const std::string& whose, Call call)
  {
    const auto run = [call]
    {
      for (const Ordinary& one : inputs_)
      {
        measure::keep(call(one));
      }
    };
    calls_.push_back(
        {what,
         whose,
         {whose.empty() ? what : what + ", " + whose, run, double(priced_inputs)},
         [call](std::size_t i) { return numbers_of(call(inputs_[i])); }});
  }

  const std::vector<PricedCall>& all() const { return calls_; }

private:
  static inline const std::vector<Ordinary> inputs_ = ordinary_inputs();
  std::vector<PricedCall> calls_;
};

#ifdef COOKBOOK_HAS_GLM
glm::vec3 of_glm(const Vector3<float>& v)
{
  return {v.x(), v.y(), v.z()};
}
glm::mat3 of_glm(const Matrix3<float>& m)
{
  return glm::make_mat3(m.data());
}
Vector3<float> from_glm(const glm::vec3& v)
{
  return {v.x, v.y, v.z};
}
Quaternion<float> from_glm(const glm::quat& q)
{
  return {q.w, q.x, q.y, q.z};
}
#endif

void add_vectors(Calls& calls)
{
  calls.add(
      "signed_angle", "", [](const Ordinary& o) { return signed_angle<float>(o.a, o.b, o.axis); });
#ifdef COOKBOOK_HAS_GLM
  calls.add(
      "signed_angle", "GLM",
      [](const Ordinary& o)
      { return glm::orientedAngle(of_glm(o.a), of_glm(o.b), of_glm(o.axis)); });
#endif
  calls.add("wrap_radians", "", [](const Ordinary& o) { return wrap_radians<float>(o.angle); });
  calls.add(
      "wrap_radians", "std::remainder",
      [](const Ordinary& o) { return std::remainder(o.angle, 2 * std::numbers::pi_v<float>); });
}

void add_matrices(Calls& calls)
{
  calls.add("determinant", "", [](const Ordinary& o) { return determinant<float, 3>(o.m); });
  calls.add("determinant", "Eigen", [](const Ordinary& o) { return o.m.determinant(); });
#ifdef COOKBOOK_HAS_GLM
  calls.add("determinant", "GLM", [](const Ordinary& o) { return glm::determinant(of_glm(o.m)); });
#endif
  calls.add("to_local", "", [](const Ordinary& o) { return to_local<float>(o.pose, o.a); });
  calls.add(
      "to_local", "Eigen",
      [](const Ordinary& o) { return Vector3<float>(o.pose.inverse(Eigen::Isometry) * o.a); });
  calls.add(
      "transformed_normal", "",
      [](const Ordinary& o) { return transformed_normal<float>(o.m, o.a); });
  calls.add(
      "transformed_normal", "Eigen",
      [](const Ordinary& o)
      { return Vector3<float>((o.m.inverse().transpose() * o.a).normalized()); });
#ifdef COOKBOOK_HAS_GLM
  calls.add(
      "transformed_normal", "GLM",
      [](const Ordinary& o)
      { return from_glm(glm::normalize(glm::inverseTranspose(of_glm(o.m)) * of_glm(o.a))); });
#endif
}

void add_rotations(Calls& calls)
{
  calls.add("slerp", "", [](const Ordinary& o) { return slerp<float>(o.p, o.q, 0.3f); });
  calls.add("slerp", "Eigen", [](const Ordinary& o) { return o.p.slerp(0.3f, o.q); });
  calls.add("nlerp", "", [](const Ordinary& o) { return nlerp<float>(o.p, o.q, 0.3f); });
  calls.add(
      "rotation_matrix", "",
      [](const Ordinary& o) { return Matrix3<float>(rotation_matrix<float>(o.p)); });
  calls.add(
      "rotation_matrix", "Eigen",
      [](const Ordinary& o) { return Matrix3<float>(o.p.toRotationMatrix()); });
  calls.add(
      "rotation_between", "", [](const Ordinary& o) { return rotation_between<float>(o.a, o.b); });
  calls.add("rotation_between", "Eigen", [](const Ordinary& o) { return eigen_between(o.a, o.b); });
#ifdef COOKBOOK_HAS_GLM
  calls.add(
      "rotation_between", "GLM",
      [](const Ordinary& o) { return from_glm(glm::rotation(of_glm(o.a), of_glm(o.b))); });
#endif
}

} // namespace

std::vector<PricedCall> priced_calls()
{
  Calls calls;
  add_vectors(calls);
  add_matrices(calls);
  add_rotations(calls);
  return calls.all();
}

} // namespace cookbook

/// \file
/// \brief The same answers from rows in registers as from plain rows, to the last bit.

#include "04_obb_manifolds/box_box/box_box_in_registers.hpp"
#include "04_obb_manifolds/box_failures/trial/box_failures.hpp"
#include "04_obb_manifolds/box_oracles/trial/manifold_error.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"

#include "tests/04_obb_manifolds/same_bits.hpp"
#include "tests/catch.hpp"

using namespace cookbook;

// [same_bits]
TEMPLATE_TEST_CASE(
    "rows in registers answer bit for bit what plain rows do, at every size", "[O9][O12][O13]",
    float, double)
{
  using Real = TestType;
  const auto differs = [](const Obb<Real>& a, const Obb<Real>& b)
  { return same_bits(box_box_in_registers(a, b), box_box(a, b)) ? 0 : 1; };
  for (const std::string& name : box_workload_names())
  {
    CAPTURE(name);
    int different = 0;
    for (const BoxPair<float>& pair : box_workload(name, 1000).pairs)
    {
      const auto [a, b] = pair_in<Real>(pair);
      for (const int exponent : {-60, 0, 50}) // squares too small, ordinary, too large
      {
        different += differs(scaled(a, exponent), scaled(b, exponent));
      }
    }
    CHECK(different == 0);
  }
  for (const BoxCase& row : all_box_cases())
  {
    CAPTURE(row.id);
    CHECK(differs(box_in<Real>(row.a), box_in<Real>(row.b)) == 0);
  }
}
// [same_bits]

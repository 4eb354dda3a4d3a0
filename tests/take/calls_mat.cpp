// Calls what matrices and transforms of chapter 1 offer, those whose TAKE_… is defined.
// check_take.sh includes their headers: the house's, or one that was taken.

#include "calls.hpp"

using namespace cookbook;

/// A matrix of any size; every eighth has two equal columns.
inline Eigen::Matrix3d drawn_matrix(Draw& draw)
{
  Eigen::Matrix3d m;
  m << draw.vector(1), draw.vector(1), draw.vector(1);
  if (draw.one_in(8))
  {
    m.col(2) = m.col(0);
  }
  return m * draw.scale();
}

int main()
{
#ifdef TAKE_matrices
  print(
      "matrices",
      [](Draw& draw, Bits& bits)
      {
        const Eigen::Matrix3d m = drawn_matrix(draw);
        bits(inverse<double, 3>(m), determinant<double, 3>(m), cofactors<double>(m));
        bits(permanent<double>(m), condition<double, 3>(m), adjugate_inverse<double, 3>(m));
        Eigen::Matrix4d larger = Eigen::Matrix4d::Identity();
        larger.topLeftCorner<3, 3>() = m;
        larger.topRightCorner<3, 1>() = draw.vector(10);
        bits(inverse<double, 4>(larger), determinant<double, 4>(larger), cofactors<double>(larger));
      });
#endif
#ifdef TAKE_transforms
  print(
      "transforms",
      [](Draw& draw, Bits& bits)
      {
        const Eigen::Vector3d move = draw.vector(10), point = draw.vector(10), n = draw.unit();
        const Isometry3<double> there = pose<double>(draw.axes(), move);
        bits(rigid_inverse<double>(there).matrix(), to_local<double>(there, point));
        Affine3<double> t = Affine3<double>::Identity();
        t.linear() = drawn_matrix(draw);
        t.translation() = move;
        const Eigen::Matrix3d m = t.linear();
        bits(to_local<double>(t, point), transformed_normal<double>(m, n));
        bits(transformed_plane<double>(t, Hyperplane3<double>(n, 2)).coeffs());
        const Eigen::Matrix4d all = t.matrix();
        bits(hand_exchanged<double>(all), rows_and_columns_exchanged<double>(all));
        bits(y_up_from_z_up<double>());
      });
#endif
}

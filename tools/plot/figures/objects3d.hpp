#pragma once

#include "tools/plot/svg.hpp"

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

/// What a Figure3d is made of; all coordinates in the camera's frame: x right, y up, z towards
/// the viewer, in world units.
namespace cookbook::plot
{

/// One element of an object: a filled face, a stroke, or the shaded disc of a ball or capsule.
struct Part
{
  enum class Kind
  {
    face,
    stroke,
    disc
  };
  Kind kind;
  std::vector<Eigen::Vector3d> points;
  svg::Pen pen;
  double opacity = 0; ///< face
  double radius = 0;  ///< disc, world units
};

/// A face plane: outward unit normal and distance.
struct FacePlane
{
  Eigen::Vector3d normal;
  double distance;
};

/// Something that is drawn as a whole, in front of some objects and behind others.
struct Object
{
  std::vector<Eigen::Vector3d> hull; ///< its corners …
  double radius = 0;                 ///< … grown by this
  std::vector<FacePlane> planes;
  std::vector<Part> behind; ///< hidden edges: drawn before any face
  std::vector<Part> front;  ///< faces and visible edges, in this order
};

/// A mark that lies over every object.
struct Note
{
  enum class Kind
  {
    arrow,
    dimension,
    point,
    label
  };
  Kind kind;
  Eigen::Vector3d start;
  Eigen::Vector3d end;
  std::string text;
  Side side;
  Ink ink;
  double offset; ///< [pixels]
};

/// Makes a box; `axes` are its unit axes in the camera's frame.
Object box_object(
    const Eigen::Vector3d& center, const Eigen::Matrix3d& axes, const Eigen::Vector3d& half_extents,
    Ink ink);

/// Makes a sphere with the great circle about `pole`.
Object
sphere_object(const Eigen::Vector3d& center, double radius, const Eigen::Vector3d& pole, Ink ink);

Object
capsule_object(const Eigen::Vector3d& start, const Eigen::Vector3d& end, double radius, Ink ink);

/// Makes a square with grid lines; `u` and `v` are its half sides.
Object plane_object(
    const Eigen::Vector3d& center, const Eigen::Vector3d& u, const Eigen::Vector3d& v, int cells,
    Ink ink);

Object
polygon_object(const std::vector<Eigen::Vector3d>& corners, Ink ink, Fill fill, Stroke stroke);

Object stroke_object(const std::vector<Eigen::Vector3d>& points, const svg::Pen& pen);

/// Returns the indices of the objects from far to near.
///
/// Two objects are told apart by the face plane that separates them best; without one, by depth;
/// equal ones keep their order.
std::vector<std::size_t> far_to_near(const std::vector<Object>& objects);

} // namespace cookbook::plot

#pragma once

/// \file
/// \brief Where the joints of a world are seen.

#include "06_world/game_world/game_world.hpp"
#include "07_constraints/joints/joints.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace cookbook::play
{

/// Where a joint is seen: its anchors, whether these are to be at one point, and its axis where it
/// has one.
struct JointMark
{
  int a, b;                                ///< the two bodies by their places in the world
  Vector3<double> anchor_a, anchor_b;      ///< [m], in each body's frame
  bool together = true;                    ///< not those of sliders, wheels, ropes and springs
  std::optional<Vector3<double>> axis_a{}; ///< unit, in A's frame
};

/// That of a joint of any kind.
template <class Kind>
JointMark mark_of(const Kind& joint)
{
  if constexpr (requires { joint.frame_a; })
  {
    constexpr bool moves = std::is_same_v<Kind, SliderJoint> || std::is_same_v<Kind, WheelJoint>;
    JointMark mark{joint.a, joint.b, joint.frame_a.anchor, joint.frame_b.anchor, !moves};
    if constexpr (!std::is_same_v<Kind, WeldJoint>)
    {
      mark.axis_a = joint.frame_a.axes * Vector3<double>::UnitX();
    }
    return mark;
  }
  else if constexpr (std::is_same_v<Kind, MouseJoint>)
  {
    return {joint.a, joint.b, joint.target, joint.anchor_b, false};
  }
  else
  {
    constexpr bool together = std::is_same_v<Kind, BallJoint>;
    return {joint.a, joint.b, joint.anchor_a, joint.anchor_b, together};
  }
}

/// Adds the marks of a set, if it is of this kind, but of joints that are broken.
template <class Kind>
void add_marks(std::vector<JointMark>& marks, const ConstraintSet& set)
{
  if (std::string(set.name()) == Kind::name)
  {
    const auto& joints = static_cast<const JointSet<Kind>&>(set);
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
      if (!joints.is_broken(i))
      {
        marks.push_back(mark_of(joints[i]));
      }
    }
  }
}

/// The marks of all joints of a world, but of the set in one place.
inline std::vector<JointMark> joint_marks(GameWorld& world, std::size_t left_out)
{
  std::vector<JointMark> marks;
  for (std::size_t place = 0; place < world.constraint_sets(); ++place)
  {
    if (place != left_out)
    {
      const ConstraintSet& set = world.constraint_set(place);
      add_marks<BallJoint>(marks, set);
      add_marks<ConeTwistJoint>(marks, set);
      add_marks<HingeJoint>(marks, set);
      add_marks<SliderJoint>(marks, set);
      add_marks<WeldJoint>(marks, set);
      add_marks<DistanceJoint>(marks, set);
      add_marks<WheelJoint>(marks, set);
      add_marks<MouseJoint>(marks, set);
    }
  }
  return marks;
}

} // namespace cookbook::play

#pragma once

/// \file
/// \brief Jointed scenes as this book's trees of links, for comparison with Bullet's multibodies.

#include "06_world/contacts/start_body.hpp"
#include "07_constraints/articulated/articulated.hpp"
#include "07_constraints/joint_chart/trial/joint_peer.hpp"

#include <cstddef>
#include <vector>

namespace cookbook
{

/// The links of a chain whose first body is fixed, each joint a ball between a body and the one
/// after it.
inline std::vector<Link> links_of(const JointedScene& chain)
{
  std::vector<Link> links;
  for (const JointPlace& joint : chain.joints)
  {
    const SceneBody& parent = chain.scene.bodies[index_of(joint.a)];
    const SceneBody& body = chain.scene.bodies[index_of(joint.b)];
    links.push_back(
        {.parent = joint.a - 1,
         .joint = JointType::ball,
         .solid = mass_properties(body),
         .anchor_parent = parent.orientation.conjugate() * (joint.point - parent.position),
         .anchor_child = body.orientation.conjugate() * (joint.point - body.position)});
  }
  return links;
}

/// Such a chain under semi-implicit Euler.
class JointTree
{
public:
  static constexpr bool chains_only = true;

  JointTree(const JointedScene& of, int substeps)
      : start_(first_frame(of.scene)),
        substeps_(substeps),
        tree_(links_of(of), of.scene.gravity),
        state_(zero_state(tree_.links()))
  {
    for (std::size_t i = 0; i < of.joints.size(); ++i)
    {
      const SceneBody &parent = of.scene.bodies[i], &body = of.scene.bodies[i + 1];
      const Quaternion<double> turn = parent.orientation.conjugate() * body.orientation;
      state_.positions.segment<4>(static_cast<Eigen::Index>(4 * i)) << turn.w(), turn.x(), turn.y(),
          turn.z();
      // What moves at the start is pushed in the first step, so that its neighbours go along.
      tree_.loads[i].tail<3>() = 60.0 * substeps * body.mass * body.velocity;
    }
  }

  void go()
  {
    for (int i = 0; i < substeps_; ++i)
    {
      semi_implicit_step(tree_, state_, 1.0 / (60 * substeps_));
      tree_.loads.assign(tree_.loads.size(), SpatialVector::Zero());
    }
  }

  Frame state()
  {
    Frame frame = start_;
    std::size_t i = 0;
    for (const LinkBody& link : link_bodies(tree_, state_))
    {
      frame.bodies[++i] = {
          link.motion.center, link.orientation, link.motion.velocity, link.motion.angular_velocity};
    }
    return frame;
  }

private:
  Frame start_;
  int substeps_;
  ArticulatedBody tree_;
  TreeState state_;
};

} // namespace cookbook

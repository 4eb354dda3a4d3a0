/// \file
/// \brief Makes joints of JSON values, all kinds of this chapter, and checks each value where it is
/// read.

#include "06_world/scenes/trial/scene_joints.hpp"
#include "06_world/contacts/start_body.hpp"
#include "07_constraints/joints/joints.hpp"
#include "tools/files/json_object_file.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <tuple>

namespace cookbook
{
namespace
{

constexpr Limits places{-1e9, 1e9}; // and speeds and angles [m, m/s, rad, rad/s]
constexpr Limits lengths{0, 1e9};   // [m]
constexpr Limits cones{0, std::numbers::pi};
constexpr Limits forces{0, 1e30}; // and torques, stiffnesses [N, N m, N/m, N m/rad]
constexpr Limits frequencies{1e-6, 1e6};
constexpr Limits ratios{0, 1e6};

/// The bodies of a scene as they start, as joints ask for them in a world.
struct StartBodies
{
  std::vector<RigidBody> bodies;

  std::size_t index(BodyId id) const { return id; }
  const RigidBody& body(BodyId id) const { return bodies[id]; }
};

/// Joints of all kinds, a set each.
using AllJoints = std::tuple<
    BallJoints, ConeTwistJoints, HingeJoints, SliderJoints, WeldJoints, DistanceJoints, WheelJoints,
    MouseJoints>;

/// A joint of a file: its object, and between which bodies it is.
struct JointText
{
  JsonObject object;
  const std::string& file;
  std::string what; ///< `hinge "door"`, for errors
  const StartBodies& start;
  BodyId a = 0, b = 0;
};

/// Refuses a lower bound above the upper one, which is what their members say.
void check_order(
    const JsonObject& object, const char* lower, double least, const std::string& upper,
    double most)
{
  if (least > most)
  {
    object.wrong(
        lower, object.need(lower), "no more than " + upper + ", " + round_trip(most),
        round_trip(least));
  }
}

/// What acts along the coordinate of a joint, as a member of a name says; nothing without it.
JointDrive read_drive(const JointText& text, const std::string& member)
{
  JointDrive drive;
  const JsonValue* const value = text.object.find(member);
  if (!value)
  {
    return drive;
  }
  const JsonObject object(*value, text.file, member + " of " + text.what);
  object.allow_only(
      {"lower", "upper", "motor_speed", "motor_force", "stiffness", "damping", "rest"});
  const auto needs = [&](const char* one, const char* other)
  {
    if (object.find(one) && !object.find(other))
    {
      object.need(other);
    }
  };
  needs("motor_speed", "motor_force");
  needs("rest", "stiffness");
  drive.lower = object.number("lower", places, drive.lower);
  drive.upper = object.number("upper", places, drive.upper);
  check_order(object, "lower", drive.lower, "upper", drive.upper);
  drive.motor_speed = object.number("motor_speed", places, drive.motor_speed);
  drive.motor_force = object.number("motor_force", forces, drive.motor_force);
  drive.stiffness = object.number("stiffness", forces, drive.stiffness);
  drive.damping = object.number("damping", forces, drive.damping);
  drive.rest = object.number("rest", places, drive.rest);
  return drive;
}

Vector3<double> read_point(const JointText& text, const char* name = "point")
{
  return text.object.vector<3>(name, places, std::nullopt);
}

Vector3<double> read_axis(const JointText& text, const char* name = "axis")
{
  return text.object.unit<3>(name, std::nullopt);
}

/// A ball joint with limits: about an axis, which is where the limb points.
ConeTwistJoint read_cone_twist(const JointText& text)
{
  ConeTwistJoint joint =
      cone_twist_at(text.start, text.a, text.b, read_point(text), read_axis(text));
  joint.cone = text.object.number("cone", cones, joint.cone);
  joint.twist = read_drive(text, "twist");
  return joint;
}

HingeJoint read_hinge(const JointText& text)
{
  HingeJoint joint = hinge_at(text.start, text.a, text.b, read_point(text), read_axis(text));
  joint.drive = read_drive(text, "drive");
  return joint;
}

SliderJoint read_slider(const JointText& text)
{
  SliderJoint joint = slider_at(text.start, text.a, text.b, read_point(text), read_axis(text));
  joint.drive = read_drive(text, "drive");
  return joint;
}

WeldJoint read_weld(const JointText& text)
{
  return weld_at(text.start, text.a, text.b, read_point(text));
}

/// A rod as long as its ends are apart, or bounds of that length.
DistanceJoint read_distance(const JointText& text)
{
  const JsonObject& object = text.object;
  DistanceJoint joint = rod_between(
      text.start, text.a, text.b, read_point(text, "point_a"), read_point(text, "point_b"));
  if (object.find("least") || object.find("most"))
  {
    const DistanceJoint open{};
    joint.least = object.number("least", lengths, open.least);
    joint.most = object.number("most", lengths, open.most);
  }
  check_order(object, "least", joint.least, "most", joint.most);
  return joint;
}

WheelJoint read_wheel(const JointText& text)
{
  WheelJoint joint =
      wheel_at(text.start, text.a, text.b, read_axis(text, "axle"), read_axis(text, "up"));
  joint.suspension = read_drive(text, "suspension");
  joint.spin = read_drive(text, "spin");
  joint.steering = text.object.number("steering", places, joint.steering);
  return joint;
}

MouseJoint read_mouse(const JointText& text)
{
  const JsonObject& object = text.object;
  MouseJoint joint = mouse_at(text.start, text.a, text.b, read_point(text));
  joint.target = anchor_at(text.start.body(text.a), read_point(text, "target"));
  joint.max_force = object.number("max_force", forces, joint.max_force);
  joint.frequency = object.number("frequency", frequencies, joint.frequency);
  joint.damping_ratio = object.number("damping_ratio", ratios, joint.damping_ratio);
  return joint;
}

/// Adds a joint to those of its kind; a fixed body that stands for the world still collides.
template <class Kind>
void add(AllJoints& all, Kind joint, const JointText& text, bool on_world)
{
  joint.collides = on_world || text.object.flag("collides", joint.collides);
  auto& joints = std::get<JointSet<Kind>>(all);
  const std::size_t i = joints.add(joint);
  if (text.object.find("strength"))
  {
    joints.set_strength(i, text.object.number("strength", forces));
  }
}

/// A kind of joint as files call it: the members it has beside those of all, and how it is made.
struct FileKind
{
  const char* name;
  std::vector<std::string> members;
  void (*read)(AllJoints&, const JointText&, bool);
};

/// Reads a joint of a kind, and adds it.
template <auto read>
void read_and_add(AllJoints& all, const JointText& text, bool on_world)
{
  add(all, read(text), text, on_world);
}

/// A ball joint, with limits where any is named.
void read_ball(AllJoints& all, const JointText& text, bool on_world)
{
  const JsonObject& object = text.object;
  const bool limited = object.find("axis") || object.find("cone") || object.find("twist");
  limited ? add(all, read_cone_twist(text), text, on_world)
          : add(all, ball_joint_at(text.start, text.a, text.b, read_point(text)), text, on_world);
}

const std::vector<FileKind>& file_kinds()
{
  static const std::vector<FileKind> kinds{
      {"ball", {"point", "axis", "cone", "twist"}, read_ball},
      {"hinge", {"point", "axis", "drive"}, read_and_add<read_hinge>},
      {"slider", {"point", "axis", "drive"}, read_and_add<read_slider>},
      {"weld", {"point"}, read_and_add<read_weld>},
      {"distance", {"point_a", "point_b", "least", "most"}, read_and_add<read_distance>},
      {"wheel", {"axle", "up", "suspension", "spin", "steering"}, read_and_add<read_wheel>},
      {"mouse",
       {"point", "target", "max_force", "frequency", "damping_ratio"},
       read_and_add<read_mouse>}};
  return kinds;
}

/// The kind that a joint names.
const FileKind& read_kind(const JsonObject& object)
{
  const std::string kind = object.text("kind");
  std::vector<std::string> names;
  std::string all;
  for (const FileKind& one : file_kinds())
  {
    if (kind == one.name)
    {
      return one;
    }
    names.emplace_back(one.name);
    all.append(all.empty() ? "one of " : ", ").append(one.name);
  }
  object.wrong(
      "kind", object.need("kind"), all, "\"" + kind.substr(0, 64) + "\"" + meant(kind, names));
}

/// The place of the body that a member names; "world" is the first fixed one, unless a body is
/// called so.
BodyId read_body(const JsonObject& object, const char* member, const Scene& scene)
{
  const std::string name = object.text(member);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    if (scene.bodies[i].name == name)
    {
      return i;
    }
    names.push_back(scene.bodies[i].name);
  }
  if (name != "world")
  {
    object.wrong(
        member, object.need(member), "the name of a body, or \"world\"",
        "\"" + name.substr(0, 64) + "\"" + meant(name, names));
  }
  const auto fixed = std::find_if(
      scene.bodies.begin(), scene.bodies.end(),
      [](const SceneBody& body) { return motion_type(body) == MotionType::fixed; });
  if (fixed == scene.bodies.end())
  {
    object.fail(
        object.need(member),
        std::string("\"world\" needs a body that is fixed, such as a plane; the scene has none"));
  }
  return static_cast<BodyId>(fixed - scene.bodies.begin());
}

/// Refuses two bodies that cannot be joined.
void check_pair(const JointText& text, const Scene& scene)
{
  const JsonObject& object = text.object;
  if (text.a == text.b)
  {
    const std::string name = object.text("a") == object.text("b")
                                 ? "\"" + object.text("a") + "\" twice"
                                 : "the world twice";
    object.wrong("b", object.need("b"), "another body than a", name);
  }
  const auto moves = [&](BodyId id)
  { return motion_type(scene.bodies[id]) == MotionType::dynamic; };
  if (!moves(text.a) && !moves(text.b))
  {
    object.fail(object.need("b"), text.what + " needs a body that is dynamic, as a or b");
  }
}

void read_joint(
    const JsonValue& value, const std::string& file, const Scene& scene, const StartBodies& start,
    std::size_t number, AllJoints& all)
{
  JointText text{{value, file, "joint number " + std::to_string(number)}, file, "", start};
  JsonObject& object = text.object;
  const FileKind& kind = read_kind(object);
  text.what = std::string(kind.name) + " joint number " + std::to_string(number);
  if (object.find("name"))
  {
    text.what = std::string(kind.name).append(" \"").append(object.text("name")).append("\"");
  }
  object.rename(text.what);
  std::vector<std::string> members{"kind", "name", "a", "b", "collides", "strength"};
  members.insert(members.end(), kind.members.begin(), kind.members.end());
  object.allow_only(members);
  text.a = read_body(object, "a", scene);
  text.b = read_body(object, "b", scene);
  check_pair(text, scene);
  const auto is_world = [&](const char* member, BodyId id) // read_body() found none of that name
  { return object.text(member) != scene.bodies[id].name; };
  const bool on_world = is_world("a", text.a) || is_world("b", text.b);
  if (on_world && object.find("collides"))
  {
    object.fail(object.need("collides"), text.what + " is held by the world, which never collides");
  }
  try
  {
    kind.read(all, text, on_world);
  }
  catch (const std::invalid_argument& wrong) // check_joint() has the last word
  {
    object.fail(value, text.what + ": " + wrong.what());
  }
}

} // namespace

void read_joints(const JsonValue& list, const std::string& file, Scene& scene)
{
  if (list.kind != JsonValue::Kind::list)
  {
    throw SceneError(
        file, list.line, "joints of the scene must be a list of joints, got " + described(list));
  }
  StartBodies start;
  for (const SceneBody& body : scene.bodies)
  {
    start.bodies.push_back(rigid_body(body));
  }
  AllJoints all;
  std::size_t number = 0;
  for (const JsonValue& joint : list.items)
  {
    read_joint(joint, file, scene, start, ++number, all);
  }
  const auto keep = [&scene](const auto& joints)
  {
    if (joints.size() > 0)
    {
      scene.constraints.push_back(std::make_shared<std::remove_cvref_t<decltype(joints)>>(joints));
    }
  };
  std::apply([&keep](const auto&... joints) { (keep(joints), ...); }, all);
}

} // namespace cookbook

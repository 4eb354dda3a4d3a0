/// \file
/// \brief Makes scenes of JSON values, and checks each value where it is read.

#include "06_world/scenes/trial/scene_text.hpp"
#include "06_world/scenes/trial/scene_joints.hpp"
#include "tools/files/json_object_file.hpp"

#include <algorithm>
#include <map>

namespace cookbook
{
namespace
{

constexpr Limits places{-1e9, 1e9}; // and speeds [m, m/s, rad/s]
constexpr Limits sizes{1e-9, 1e9};  // [m]
constexpr Limits masses{1e-9, 1e30};
constexpr Limits frictions{0, 1000};
constexpr Limits restitutions{0, 1};
constexpr Limits dampings{0, 1e6};
constexpr Limits steps{1e-6, 1};   // [s]
constexpr double most_steps = 1e7; // of a whole scene

const Vector3<double> zero(0, 0, 0);

const std::vector<std::string> scene_members{"gravity",     "step",   "duration", "friction",
                                             "restitution", "bodies", "joints"};

/// The members that a body of a shape can have; of any shape where that is not known yet.
std::vector<std::string> body_members(const std::string& shape = "")
{
  std::vector<std::string> names{"name",        "shape",   "mass",           "friction",
                                 "restitution", "damping", "angular_damping"};
  const auto add = [&](bool applies, const std::vector<std::string>& more)
  {
    if (applies || shape.empty())
    {
      names.insert(names.end(), more.begin(), more.end());
    }
  };
  add(shape == "box", {"half_extents"});
  add(shape == "sphere", {"radius"});
  add(shape == "plane", {"normal", "offset"});
  add(shape != "plane", {"motion", "position", "orientation", "velocity", "angular_velocity"});
  return names;
}

std::string read_name(const JsonObject& object)
{
  const std::string name = object.text("name");
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
  if (name.empty() || name.size() > 100 || std::any_of(name.begin(), name.end(), is_control))
  {
    object.wrong("name", object.need("name"), "1 to 100 letters on a line", "another text");
  }
  return name;
}

std::string read_shape_name(const JsonObject& object)
{
  const std::string shape = object.text("shape");
  if (shape != "box" && shape != "sphere" && shape != "plane")
  {
    object.wrong(
        "shape", object.need("shape"), "\"box\", \"sphere\" or \"plane\"",
        "\"" + shape.substr(0, 64) + "\"" + meant(shape, {"box", "sphere", "plane"}));
  }
  return shape;
}

Shape read_shape(const JsonObject& object, const std::string& shape)
{
  if (shape == "box")
  {
    return BoxShape{object.vector<3>("half_extents", sizes, std::nullopt)};
  }
  if (shape == "sphere")
  {
    return SphereShape{object.number("radius", sizes)};
  }
  return PlaneShape{object.unit<3>("normal", std::nullopt), object.number("offset", places)};
}

/// What may change how a body moves; dynamic, if it does not say, and fixed then without a mass.
MotionType read_motion_type(const JsonObject& object)
{
  const std::string name = object.find("motion") ? object.text("motion") : "dynamic";
  const std::vector<std::string> names(motion_names.begin(), motion_names.end());
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    object.wrong(
        "motion", object.need("motion"), "\"fixed\", \"kinematic\" or \"dynamic\"",
        "\"" + name.substr(0, 64) + "\"" + meant(name, names));
  }
  return static_cast<MotionType>(found - names.begin());
}

/// The mass [kg], which only a dynamic body must have.
double read_mass(const JsonObject& object, const std::string& shape, MotionType motion)
{
  const Limits any{-1e300, 1e300};
  const bool needless = shape == "plane" || motion != MotionType::dynamic;
  const double mass = object.number("mass", any, needless ? std::optional(0.0) : std::nullopt);
  if (mass != 0 && shape == "plane")
  {
    object.wrong("mass", object.need("mass"), "0, for a plane is fixed", round_trip(mass));
  }
  if (mass != 0 && !(mass >= masses.least && mass <= masses.most))
  {
    object.wrong(
        "mass", object.need("mass"),
        "0 (fixed) or " + round_trip(masses.least) + " to " + round_trip(masses.most),
        round_trip(mass));
  }
  return mass;
}

/// How the body stands and moves at the start; a fixed one does not move.
void read_motion(const JsonObject& object, SceneBody& body)
{
  const Vector<double, 4> q = object.unit<4>("orientation", Vector<double, 4>(1, 0, 0, 0));
  body.orientation = {q[0], q[1], q[2], q[3]};
  body.position = object.vector<3>("position", places, zero);
  body.velocity = object.vector<3>("velocity", places, zero);
  body.angular_velocity = object.vector<3>("angular_velocity", places, zero);
  for (const char* const name : {"velocity", "angular_velocity"})
  {
    const bool fixed = motion_type(body) == MotionType::fixed;
    if (fixed && !object.vector<3>(name, places, zero).isZero(0))
    {
      const bool told = body.motion == MotionType::fixed;
      object.wrong(
          name, object.need(name),
          told ? "zero, for the body is fixed" : "zero, for mass 0 means fixed", "another one");
    }
  }
}

SceneBody read_body(JsonObject object, const SceneBody& defaults)
{
  object.allow_only(body_members());
  SceneBody body = defaults;
  body.name = read_name(object);
  object.rename("body \"" + body.name + "\"");
  const std::string shape = read_shape_name(object);
  object.rename(shape + " \"" + body.name + "\"");
  object.allow_only(body_members(shape));
  body.shape = read_shape(object, shape);
  body.motion = read_motion_type(object);
  body.mass = read_mass(object, shape, body.motion);
  read_motion(object, body);
  body.friction = object.number("friction", frictions, defaults.friction);
  body.restitution = object.number("restitution", restitutions, defaults.restitution);
  body.damping = object.number("damping", dampings, defaults.damping);
  body.angular_damping = object.number("angular_damping", dampings, defaults.angular_damping);
  return body;
}

std::vector<SceneBody>
read_bodies(const JsonObject& scene, const std::string& file, const SceneBody& defaults)
{
  const JsonValue& list = scene.need("bodies");
  if (list.kind != JsonValue::Kind::list || list.items.empty())
  {
    const bool empty = list.kind == JsonValue::Kind::list;
    scene.wrong("bodies", list, "a list of bodies", empty ? "an empty one" : described(list));
  }
  std::vector<SceneBody> bodies;
  std::map<std::string, std::size_t> lines;
  for (const JsonValue& item : list.items)
  {
    const JsonObject object(item, file, "body number " + std::to_string(bodies.size() + 1));
    bodies.push_back(read_body(object, defaults));
    const JsonValue& name = object.need("name");
    const auto [other, is_new] = lines.emplace(name.text, name.line);
    if (!is_new)
    {
      const std::string first = std::to_string(other->second);
      object.fail(name, "there is a body \"" + name.text + "\" already, on line " + first);
    }
  }
  return bodies;
}

} // namespace

Scene scene_in(const std::string& text, const std::string& file)
{
  const JsonValue value = parse_json(text, file);
  const JsonObject object(value, file, "the scene");
  object.allow_only(scene_members);
  Scene scene;
  const std::string name = file.substr(file.find_last_of('/') + 1);
  scene.name = name.substr(0, name.find_last_of('.') == 0 ? name.npos : name.find_last_of('.'));
  scene.gravity = object.vector<3>("gravity", places, scene.gravity);
  scene.step = object.number("step", steps, scene.step);
  scene.duration = object.number("duration", {scene.step, most_steps * scene.step}, scene.duration);
  SceneBody defaults{.name = "", .shape = SphereShape{1}};
  defaults.friction = object.number("friction", frictions, defaults.friction);
  defaults.restitution = object.number("restitution", restitutions, defaults.restitution);
  scene.bodies = read_bodies(object, file, defaults);
  if (const JsonValue* const joints = object.find("joints"))
  {
    read_joints(*joints, file, scene);
  }
  return scene;
}

} // namespace cookbook

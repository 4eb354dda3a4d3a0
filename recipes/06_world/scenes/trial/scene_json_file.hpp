#pragma once

/// \file
/// \brief A scene as JSON, to be changed by its reader.

#include "06_world/contacts/scene.hpp"
#include "tools/files/csv.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace cookbook
{

/// A text in quotation marks; names have no control characters.
inline std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' || c == '\\' ? "\\" : "";
    result += c;
  }
  return result + "\"";
}

/// Numbers as a JSON list, with all their digits.
template <class Numbers>
std::string json_list(const Numbers& numbers)
{
  std::string text;
  for (Eigen::Index i = 0; i < numbers.size(); ++i)
  {
    text.append(i == 0 ? "[" : ", ").append(round_trip(double(numbers[i])));
  }
  return text + "]";
}

/// The shape of a body: its name, and the members that go with it.
inline std::string shape_json(const SceneBody& body)
{
  if (const auto* const box = std::get_if<BoxShape>(&body.shape))
  {
    return "\"box\", \"half_extents\": " + json_list(box->half_extents);
  }
  if (const auto* const sphere = std::get_if<SphereShape>(&body.shape))
  {
    return "\"sphere\", \"radius\": " + round_trip(sphere->radius);
  }
  const PlaneShape& plane = std::get<PlaneShape>(body.shape);
  return "\"plane\", \"normal\": " + json_list(plane.normal) +
         ", \"offset\": " + round_trip(plane.offset);
}

/// A body as a JSON object, on one line.
inline std::string body_json(const SceneBody& body)
{
  std::string text = "    {\"name\": " + quoted(body.name) + ", \"shape\": " + shape_json(body);
  const auto add = [&text](const char* name, const std::string& value)
  { text.append(", \"").append(name).append("\": ").append(value); };
  add("mass", round_trip(body.mass));
  if (body.motion != MotionType::dynamic)
  {
    add("motion", quoted(motion_names[static_cast<std::size_t>(body.motion)]));
  }
  if (!std::holds_alternative<PlaneShape>(body.shape))
  {
    const Quaternion<double>& q = body.orientation;
    add("position", json_list(body.position));
    add("orientation", json_list(Vector<double, 4>(q.w(), q.x(), q.y(), q.z())));
    add("velocity", json_list(body.velocity));
    add("angular_velocity", json_list(body.angular_velocity));
  }
  add("friction", round_trip(body.friction));
  add("restitution", round_trip(body.restitution));
  if (body.damping > 0 || body.angular_damping > 0)
  {
    add("damping", round_trip(body.damping));
    add("angular_damping", round_trip(body.angular_damping));
  }
  return text + "}";
}

/// The scene as JSON, a line for each body; it reads back as the same scene. std::invalid_argument
/// where it has joints, which it cannot write.
inline std::string scene_json(const Scene& scene)
{
  if (!scene.constraints.empty())
  {
    throw std::invalid_argument("a scene with joints cannot be written as JSON");
  }
  std::string text = "{\n  \"gravity\": " + json_list(scene.gravity) +
                     ",\n  \"step\": " + round_trip(scene.step) +
                     ",\n  \"duration\": " + round_trip(scene.duration) + ",\n  \"bodies\": [\n";
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
  {
    text += body_json(scene.bodies[i]) + (i + 1 < scene.bodies.size() ? ",\n" : "\n");
  }
  return text + "  ]\n}\n";
}

} // namespace cookbook

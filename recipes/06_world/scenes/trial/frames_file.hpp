#pragma once

/// \file
/// \brief Frames as CSV: a row for each body and step.

#include "06_world/scenes/trial/frames.hpp"
#include "tools/files/csv.hpp"

#include <ostream>

namespace cookbook
{

// [frames_csv]
/// The columns: time [s], body, position [m], quaternion, velocity [m/s], angular velocity [rad/s].
inline constexpr const char* frames_header = "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz";

/// A text as a field of CSV: in quotation marks where it has a comma, a quotation mark or a line's
/// end.
inline std::string csv_field(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
  {
    return text;
  }
  std::string field = "\"";
  for (const char c : text)
  {
    field.append(c == '"' ? 2 : 1, c);
  }
  return field + "\"";
}

/// A row: numbers read back as the same numbers.
inline std::string
frame_row(const std::string& time, const std::string& body, const BodyState& state)
{
  const Quaternion<double>& q = state.orientation;
  const Vector<double, 4> turn(q.w(), q.x(), q.y(), q.z());
  std::string row = time + "," + body;
  const auto add = [&row](const auto& numbers)
  {
    for (Eigen::Index i = 0; i < numbers.size(); ++i)
    {
      row.append(",").append(round_trip(double(numbers[i])));
    }
  };
  add(state.position);
  add(turn);
  add(state.velocity);
  add(state.angular_velocity);
  return row + "\n";
}

/// Writes the header and all frames.
inline void write_frames(std::ostream& stream, const Scene& scene, const std::vector<Frame>& frames)
{
  stream << frames_header << "\n";
  for (const Frame& frame : frames)
  {
    const std::string time = round_trip(frame.time);
    for (std::size_t i = 0; i < frame.bodies.size(); ++i)
    {
      stream << frame_row(time, csv_field(scene.bodies.at(i).name), frame.bodies[i]);
    }
  }
}
// [frames_csv]

} // namespace cookbook

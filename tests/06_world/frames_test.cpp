/// \file
/// What holds for frames: found by time, written so that they read back as the same numbers.

#include "06_world/scenes/trial/frames_file.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <sstream>

using namespace cookbook;

namespace
{

std::string csv(const Scene& scene, const std::vector<Frame>& frames)
{
  std::ostringstream stream;
  write_frames(stream, scene, frames);
  return stream.str();
}

} // namespace

TEST_CASE("a scene's first frame has all its bodies as they start", "[frames]")
{
  const Scene scene = named_scene("domino_3");
  const Frame frame = first_frame(scene);
  CHECK(frame.time == 0);
  REQUIRE(frame.bodies.size() == 4);
  CHECK(frame.bodies[1].position == scene.bodies[1].position);
  CHECK(frame.bodies[1].angular_velocity == Vector3<double>(0, 0, -1.5));
}

TEST_CASE("frames are a row for each body and step, by name, with all digits", "[frames]")
{
  Scene scene = named_scene("heavy_on_light");
  Frame second = first_frame(scene);
  second.time = 1.0 / 60;
  second.bodies[2] = {{0.1, 1e-300, -0.0}, {0.6, 0, 0.8, 0}, {1, 2, 3}, {4, 5, 6}};
  CHECK(
      csv(scene, {first_frame(scene), second}) ==
      "time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n"
      "0,ground,0,0,0,1,0,0,0,0,0,0,0,0,0\n"
      "0,light,0,0.5,0,1,0,0,0,0,0,0,0,0,0\n"
      "0,heavy,0,1.5,0,1,0,0,0,0,0,0,0,0,0\n"
      "0.016666666666666666,ground,0,0,0,1,0,0,0,0,0,0,0,0,0\n"
      "0.016666666666666666,light,0,0.5,0,1,0,0,0,0,0,0,0,0,0\n"
      "0.016666666666666666,heavy,0.1,1e-300,0,0.6,0,0.8,0,1,2,3,4,5,6\n");
}

TEST_CASE("a name with a comma or a quotation mark is one field", "[frames]")
{
  CHECK(csv_field("box 7") == "box 7");
  CHECK(csv_field("a,b") == "\"a,b\"");
  CHECK(csv_field("the \"big\" one") == "\"the \"\"big\"\" one\"");
}

TEST_CASE("the frame at a time is the closest, of two alike the earlier", "[frames]")
{
  const std::vector<Frame> frames{{0, {}}, {1, {}}, {2, {}}};
  CHECK(frame_at(frames, -5).time == 0);
  CHECK(frame_at(frames, 0.5).time == 0);
  CHECK(frame_at(frames, 0.6).time == 1);
  CHECK(frame_at(frames, 99).time == 2);
  CHECK_THROWS_AS(frame_at({}, 0), std::invalid_argument);
}

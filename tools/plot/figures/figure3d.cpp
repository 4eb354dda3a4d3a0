#include "tools/plot/figures/figure3d.hpp"

#include "tools/plot/annotate.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace cookbook::plot
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

void require(const std::string& element, const Vector3d& value)
{
  for (const double component : {value.x(), value.y(), value.z()})
  {
    svg::require_finite(element, component);
  }
}

/// From the camera's frame to pixels.
struct Projection
{
  double scale;
  Vector2d origin; // pixel of the camera frame's origin
  double height;   // [pixels] of the picture: what is not needed is cut off

  Vector2d operator()(const Vector3d& p) const
  {
    return {origin.x() + scale * p.x(), origin.y() - scale * p.y()};
  }
};

/// The projection that fits everything into the picture.
Projection fitted(
    const std::vector<Object>& objects, const std::vector<Note>& notes, const Camera& camera,
    double top)
{
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::max());
  Vector3d high = -low;
  const auto include = [&](const Vector3d& point, double radius)
  {
    low = low.cwiseMin(point - Vector3d::Constant(radius));
    high = high.cwiseMax(point + Vector3d::Constant(radius));
  };
  for (const Object& object : objects)
  {
    for (const Vector3d& point : object.hull)
    {
      include(point, object.radius);
    }
  }
  for (const Note& note : notes)
  {
    include(note.start, 0);
    include(note.end, 0);
  }
  if (objects.empty() && notes.empty())
  {
    return {1, {camera.width / 2, top + camera.height / 2}, camera.height};
  }
  const Vector3d size = (high - low).cwiseMax(1e-12);
  const double around = 2 * camera.margin;
  const double scale =
      std::min((camera.width - around) / size.x(), (camera.height - around) / size.y());
  const Vector3d middle = (low + high) / 2;
  const double height = std::min(camera.height, scale * size.y() + around);
  return {
      scale,
      {camera.width / 2 - scale * middle.x(), top + height / 2 + scale * middle.y()},
      height};
}

/// The outline of a ball or capsule, with its shading.
std::string
disc(const Vector2d& p, const Vector2d& q, double r, const svg::Pen& pen, const std::string& id)
{
  const double length = (q - p).norm();
  const Vector2d along = length > 1e-9 ? Vector2d((q - p) / length) : Vector2d(1, 0);
  const Vector2d side(-r * along.y(), r * along.x());
  const std::string arc = "A" + svg::number(r) + " " + svg::number(r) + " 0 0 1 ";
  const std::string data = "M" + svg::pair(p - side) + "L" + svg::pair(q - side) + arc +
                           svg::pair(q + side) + "L" + svg::pair(p + side) + arc +
                           svg::pair(p - side) + "Z";
  const std::string shade = "url(#" + id + "-shade-" + std::string(css_name(pen.ink)) + ")";
  return svg::element("path", {{"fill", shade}, {"d", data}}) + svg::path(data, pen, Fill::none);
}

/// The gradient that shades balls of one ink.
std::string gradient(const std::string& id, Ink ink)
{
  const std::string ink_class = "cb-shade cb-" + std::string(css_name(ink));
  std::string stops;
  const char* const offsets[] = {"0", "0.6", "1"};
  const char* const opacities[] = {"0.08", "0.2", "0.44"};
  for (int k = 0; k < 3; ++k)
  {
    stops += svg::element(
        "stop", {{"class", ink_class}, {"offset", offsets[k]}, {"stop-opacity", opacities[k]}});
  }
  return svg::element(
      "radialGradient",
      {{"id", id + "-shade-" + std::string(css_name(ink))},
       {"cx", "0.36"},
       {"cy", "0.3"},
       {"r", "0.75"}},
      "\n" + stops);
}

void draw_part(Sketch& sketch, const Part& part, const Projection& project, const std::string& id)
{
  std::vector<Vector2d> pixels;
  for (const Vector3d& point : part.points)
  {
    pixels.push_back(project(point));
  }
  switch (part.kind)
  {
  case Part::Kind::face:
    sketch.body += svg::filled(svg::path_data(pixels, true), part.pen.ink, part.opacity);
    break;
  case Part::Kind::stroke:
    sketch.body += svg::polyline(pixels, part.pen);
    avoid_path(sketch, pixels, false);
    break;
  case Part::Kind::disc:
  {
    const double radius = project.scale * part.radius;
    sketch.body += disc(pixels[0], pixels[1], radius, part.pen, id);
    avoid_path(sketch, circle_points(pixels[0], radius), true);
    avoid_path(sketch, circle_points(pixels[1], radius), true);
    break;
  }
  }
}

void draw_note(Sketch& sketch, const Note& note, const Projection& project)
{
  const Vector2d start = project(note.start);
  const Vector2d end = project(note.end);
  switch (note.kind)
  {
  case Note::Kind::arrow:
    draw_arrow(sketch, start, end, note.ink, note.text, note.side);
    break;
  case Note::Kind::dimension:
    draw_dimension(sketch, start, end, note.text, note.offset, note.ink);
    break;
  case Note::Kind::point:
    draw_contact(sketch, start, note.ink, note.text, note.side);
    break;
  case Note::Kind::label:
    add_label(sketch, start, note.side == Side::centre ? 0 : 5, note.text, note.side, note.ink);
    break;
  }
}

/// The gradients of all balls among the objects.
std::string gradients(const std::vector<Object>& objects, const std::string& id)
{
  std::set<Ink> inks;
  for (const Object& object : objects)
  {
    for (const Part& part : object.front)
    {
      if (part.kind == Part::Kind::disc)
      {
        inks.insert(part.pen.ink);
      }
    }
  }
  std::string result;
  for (const Ink ink : inks)
  {
    result += gradient(id, ink);
  }
  return result;
}

} // namespace

Figure3d::Figure3d(std::string name, std::string title, Camera camera)
    : name_(std::move(name)), title_(std::move(title)), camera_(camera)
{
  svg::require_name(name_);
  for (const double value : {camera.yaw, camera.pitch, camera.width, camera.height})
  {
    svg::require_finite(name_ + " camera", value);
  }
  if (!(camera.width > 2 * camera.margin && camera.height > 2 * camera.margin))
  {
    throw std::invalid_argument("plot: " + name_ + " camera: the picture is too small");
  }
}

Vector3d Figure3d::to_camera(const Vector3d& world) const
{
  const double cy = std::cos(camera_.yaw);
  const double sy = std::sin(camera_.yaw);
  const double cp = std::cos(camera_.pitch);
  const double sp = std::sin(camera_.pitch);
  const Vector3d right(cy, 0, -sy);
  const Vector3d up(-sy * sp, cp, -cy * sp);
  const Vector3d viewer(sy * cp, sp, cy * cp);
  return {right.dot(world), up.dot(world), viewer.dot(world)};
}

Figure3d& Figure3d::add(Object object)
{
  objects_.push_back(std::move(object));
  return *this;
}

Figure3d& Figure3d::note(Note note)
{
  notes_.push_back(std::move(note));
  return *this;
}

std::vector<Vector3d> Figure3d::seen(const char* element, const std::vector<Vector3d>& points) const
{
  std::vector<Vector3d> result;
  for (const Vector3d& point : points)
  {
    require(name_ + " " + element, point);
    result.push_back(to_camera(point));
  }
  return result;
}

Figure3d& Figure3d::describe(std::string text)
{
  description_ = std::move(text);
  return *this;
}

Figure3d& Figure3d::frame(const Frame& frame)
{
  require(name_ + " frame", frame.center);
  svg::require_finite(name_ + " frame", frame.width);
  if (!(frame.width > 0))
  {
    throw std::invalid_argument("plot: " + name_ + " frame: width must be positive");
  }
  frame_ = frame;
  return *this;
}

Figure3d&
Figure3d::box(const Vector3d& center, const Matrix3d& axes, const Vector3d& half_extents, Ink ink)
{
  const std::string element = name_ + " box";
  require(element, center);
  require(element, half_extents);
  Matrix3d turned;
  for (int k = 0; k < 3; ++k)
  {
    require(element, axes.col(k));
    turned.col(k) = to_camera(axes.col(k));
  }
  return add(box_object(to_camera(center), turned, half_extents, ink));
}

Figure3d& Figure3d::sphere(const Vector3d& center, double radius, Ink ink)
{
  require(name_ + " sphere", center);
  svg::require_finite(name_ + " sphere", radius);
  return add(sphere_object(to_camera(center), radius, to_camera(Vector3d::UnitY()), ink));
}

Figure3d& Figure3d::capsule(const Vector3d& start, const Vector3d& end, double radius, Ink ink)
{
  svg::require_finite(name_ + " capsule", radius);
  const std::vector<Vector3d> ends = seen("capsule", {start, end});
  return add(capsule_object(ends[0], ends[1], radius, ink));
}

Figure3d& Figure3d::plane(
    const Vector3d& center, const Vector3d& normal, double half_extent, int cells, Ink ink)
{
  require(name_ + " plane", center);
  require(name_ + " plane", normal);
  svg::require_finite(name_ + " plane", half_extent);
  if (!(normal.norm() > 0))
  {
    throw std::invalid_argument("plot: " + name_ + " plane: normal has no length");
  }
  // Sides along the world's x where the plane allows it.
  const Vector3d n = normal.normalized();
  const Vector3d guide = std::abs(n.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitZ();
  const Vector3d u = (guide - guide.dot(n) * n).normalized();
  const Vector3d v = n.cross(u);
  return add(plane_object(
      to_camera(center), half_extent * to_camera(u), half_extent * to_camera(v), cells, ink));
}

Figure3d& Figure3d::polygon(const std::vector<Vector3d>& corners, Ink ink, Fill fill, Stroke stroke)
{
  return corners.empty() ? *this : add(polygon_object(seen("polygon", corners), ink, fill, stroke));
}

Figure3d&
Figure3d::segment(const Vector3d& start, const Vector3d& end, Ink ink, Stroke stroke, double pixels)
{
  return add(stroke_object(seen("segment", {start, end}), {ink, stroke, pixels}));
}

Figure3d&
Figure3d::polyline(const std::vector<Vector3d>& points, Ink ink, Stroke stroke, double pixels)
{
  return points.empty() ? *this
                        : add(stroke_object(seen("polyline", points), {ink, stroke, pixels}));
}

Figure3d& Figure3d::arrow(
    const Vector3d& start, const Vector3d& end, Ink ink, const std::string& label, Side side)
{
  const std::vector<Vector3d> ends = seen("arrow", {start, end});
  return note({Note::Kind::arrow, ends[0], ends[1], label, side, ink, 0});
}

Figure3d& Figure3d::dimension(
    const Vector3d& start, const Vector3d& end, const std::string& label, double offset, Ink ink)
{
  svg::require_finite(name_ + " dimension", offset);
  const std::vector<Vector3d> ends = seen("dimension", {start, end});
  return note({Note::Kind::dimension, ends[0], ends[1], label, Side::automatic, ink, offset});
}

Figure3d& Figure3d::point(const Vector3d& position, Ink ink, const std::string& label, Side side)
{
  const Vector3d at = seen("point", {position}).front();
  return note({Note::Kind::point, at, at, label, side, ink, 0});
}

Figure3d& Figure3d::label(const Vector3d& anchor, const std::string& text, Side side, Ink ink)
{
  const Vector3d at = seen("label", {anchor}).front();
  return note({Note::Kind::label, at, at, text, side, ink, 0});
}

Figure3d& Figure3d::axes(const Vector3d& origin, double length)
{
  svg::require_finite(name_ + " axes", length);
  arrow(origin, origin + length * Vector3d::UnitX(), Ink::muted, "x");
  arrow(origin, origin + length * Vector3d::UnitY(), Ink::muted, "y");
  return arrow(origin, origin + length * Vector3d::UnitZ(), Ink::muted, "z");
}

Vector2d Figure3d::to_pixels(const Vector3d& world) const
{
  if (!frame_)
  {
    throw std::logic_error("plot: " + name_ + ": to_pixels needs a frame");
  }
  const double top = title_height(title_, camera_.width);
  const Vector3d p = camera_.width / frame_->width * to_camera(world - frame_->center);
  return {camera_.width / 2 + p.x(), top + camera_.height / 2 - p.y()};
}

Panel Figure3d::panel(const std::string& id) const
{
  const double top = title_height(title_, camera_.width);
  Projection project = fitted(objects_, notes_, camera_, top);
  if (frame_)
  {
    project = {camera_.width / frame_->width, to_pixels({0, 0, 0}), camera_.height};
  }
  Sketch sketch;
  const std::vector<std::size_t> order = far_to_near(objects_);
  for (const std::size_t k : order)
  {
    for (const Part& part : objects_[k].behind)
    {
      draw_part(sketch, part, project, id);
    }
  }
  for (const std::size_t k : order)
  {
    for (const Part& part : objects_[k].front)
    {
      draw_part(sketch, part, project, id);
    }
  }
  for (const Note& note : notes_)
  {
    draw_note(sketch, note, project);
  }
  const Rect box{0, top, camera_.width, top + project.height};
  sketch.body = gradients(objects_, id) +
                svg::clipped(sketch.body, id, box.left, box.top, camera_.width, project.height);
  write_title(sketch, title_, camera_.width);
  const Rect bounds{2, top + 2, box.right - 2, box.bottom - 2};
  const std::vector<Rect> boxes = write_labels(sketch, bounds);
  return {camera_.width, box.bottom, title_, description_, sketch.body, boxes};
}

std::vector<Rect> Figure3d::label_boxes() const
{
  return panel(name_).label_boxes;
}

std::string Figure3d::svg() const
{
  return document(name_, panel(name_));
}

} // namespace cookbook::plot

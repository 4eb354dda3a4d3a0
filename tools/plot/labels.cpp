#include "tools/plot/labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace cookbook::plot
{
namespace
{

using Eigen::Vector2d;
using Segment = std::pair<Vector2d, Vector2d>;

constexpr std::array<double, 6> rings{0, 9, 20, 34, 52, 74}; // [pixels] beyond the clearance
constexpr int directions = 16;
constexpr double padding = 1.5;  // [pixels] kept free around a text
constexpr double word_space = 5; // [pixels] and beside it, where the next text begins

/// A possible place, and what it costs by itself.
struct Candidate
{
  PlacedLabel place;
  double cost;
};

double shared_area(const Rect& p, const Rect& q)
{
  const double width = std::min(p.right, q.right) - std::max(p.left, q.left);
  const double height = std::min(p.bottom, q.bottom) - std::max(p.top, q.top);
  return width > 0 && height > 0 ? width * height : 0;
}

/// Whether all of a segment lies to one side of a rectangle: as nearly all do.
bool is_beside(const Segment& segment, const Rect& rect)
{
  const auto& [p, q] = segment;
  return (p.x() < rect.left && q.x() < rect.left) || (p.x() > rect.right && q.x() > rect.right) ||
         (p.y() < rect.top && q.y() < rect.top) || (p.y() > rect.bottom && q.y() > rect.bottom);
}

/// The length of the part of a segment that lies within a rectangle, after Liang and Barsky.
double length_inside(const Segment& segment, const Rect& rect)
{
  if (is_beside(segment, rect))
  {
    return 0;
  }
  const Vector2d span = segment.second - segment.first;
  const std::array<double, 4> steps{-span.x(), span.x(), -span.y(), span.y()};
  const std::array<double, 4> rooms{
      segment.first.x() - rect.left, rect.right - segment.first.x(), segment.first.y() - rect.top,
      rect.bottom - segment.first.y()};
  double enter = 0;
  double leave = 1;
  for (std::size_t k = 0; k < 4; ++k)
  {
    if (steps[k] == 0)
    {
      leave = rooms[k] < 0 ? -1 : leave;
    }
    else if (steps[k] < 0)
    {
      enter = std::max(enter, rooms[k] / steps[k]);
    }
    else
    {
      leave = std::min(leave, rooms[k] / steps[k]);
    }
  }
  return leave > enter ? (leave - enter) * span.norm() : 0;
}

Rect padded(const Rect& rect, double by)
{
  return {rect.left - by, rect.top - by, rect.right + by, rect.bottom + by};
}

/// The direction of a side in sixteenths of a turn, from the right towards above; -1 where free.
int direction_of(Side side)
{
  switch (side)
  {
  case Side::right:
    return 0;
  case Side::above_right:
    return 2;
  case Side::above:
    return 4;
  case Side::above_left:
    return 6;
  case Side::left:
    return 8;
  case Side::below_left:
    return 10;
  case Side::below:
    return 12;
  case Side::below_right:
    return 14;
  case Side::automatic:
  case Side::centre:
    break;
  }
  return -1;
}

/// What a direction costs: little where it is asked for, or where texts are easiest to read.
double direction_cost(int direction, Side side)
{
  const int wanted = direction_of(side);
  if (wanted < 0)
  {
    constexpr std::array<double, directions> comfort{0, 5, 1, 6, 2, 6, 3, 6,
                                                     1, 6, 4, 6, 2, 6, 3, 5};
    return comfort[static_cast<std::size_t>(direction)];
  }
  const int turn = std::abs(direction - wanted);
  return 7.0 * std::min(turn, directions - turn);
}

/// The line from near the anchor to the nearest point of the text.
Segment leader_of(const PlacedLabel& place)
{
  const Vector2d& anchor = place.label.anchor;
  const Vector2d end(
      std::clamp(anchor.x(), place.box.left, place.box.right),
      std::clamp(anchor.y(), place.box.top, place.box.bottom));
  const double length = (end - anchor).norm();
  const double skipped = length > 0 ? std::min(1.0, 0.45 * place.label.clearance / length) : 0;
  return {anchor + skipped * (end - anchor), end};
}

/// The sixteen directions, from the right towards above, y down.
const std::array<Vector2d, directions>& unit_vectors()
{
  constexpr double pi = 3.141592653589793;
  static const std::array<Vector2d, directions> vectors = []
  {
    std::array<Vector2d, directions> all;
    for (int k = 0; k < directions; ++k)
    {
      all[static_cast<std::size_t>(k)] = {std::cos(k * pi / 8), -std::sin(k * pi / 8)};
    }
    return all;
  }();
  return vectors;
}

/// Stands a label, `width` pixels wide, beside its anchor, `distance` away in one of sixteen
/// directions. Its text is filled in once it has been chosen: there are about a hundred candidates.
PlacedLabel stand(const Label& label, double width, int direction, double distance)
{
  const double dx = unit_vectors()[static_cast<std::size_t>(direction)].x();
  const double dy = unit_vectors()[static_cast<std::size_t>(direction)].y();
  const double height = 1.1 * label.font_size;
  const double x = label.anchor.x() + dx * distance + std::clamp(1.42 * dx, -1., 1.) * width / 2;
  const double y = label.anchor.y() + dy * distance + std::clamp(1.42 * dy, -1., 1.) * height / 2;
  PlacedLabel place;
  place.label.anchor = label.anchor;
  place.label.clearance = label.clearance;
  place.box = {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
  place.text_anchor = dx > 0.3 ? "start" : dx < -0.3 ? "end" : "middle";
  const double start = dx > 0.3 ? place.box.left : dx < -0.3 ? place.box.right : x;
  place.baseline = {start, y + 0.36 * label.font_size};
  place.leader = false;
  place.leader_line = leader_of(place);
  return place;
}

/// The gap between two rectangles.
double gap(const Rect& p, const Rect& q)
{
  const double dx = std::max({0.0, p.left - q.right, q.left - p.right});
  const double dy = std::max({0.0, p.top - q.bottom, q.top - p.bottom});
  return std::hypot(dx, dy);
}

/// Whether a rectangle keeps the anchor's own point free.
bool is_own(const Rect& rect, const Vector2d& anchor)
{
  const Vector2d middle((rect.left + rect.right) / 2, (rect.top + rect.bottom) / 2);
  return (middle - anchor).norm() < 0.5;
}

/// Whether a text stands at least as near to another point as to its own.
bool is_ambiguous(const PlacedLabel& place, const Obstacles& obstacles)
{
  const Vector2d& at = place.label.anchor;
  const double own = gap(place.box, {at.x(), at.y(), at.x(), at.y()});
  return std::any_of(
      obstacles.rects.begin(), obstacles.rects.end(),
      [&](const Rect& rect) { return !is_own(rect, at) && gap(place.box, rect) <= own; });
}

double obstacle_cost(const Rect& box, const Obstacles& obstacles, const Rect& bounds)
{
  const double outside = (box.right - box.left) * (box.bottom - box.top) - shared_area(box, bounds);
  double cost = outside > 1e-6 ? 5000 + 10 * outside : 0;
  for (const Rect& rect : obstacles.rects)
  {
    const double area = shared_area(box, rect);
    cost += area > 0 ? 150 + 6 * area : 0;
  }
  double crossed = 0;
  for (const Segment& segment : obstacles.segments)
  {
    crossed += length_inside(segment, box);
  }
  return cost + (crossed > 0 ? 12 + 2 * crossed : 0);
}

void add_candidate(
    std::vector<Candidate>& candidates, PlacedLabel place, double cost, const Obstacles& obstacles,
    const Rect& bounds)
{
  const Rect room = padded(place.box, padding);
  const bool ambiguous = is_ambiguous(place, obstacles);
  place.leader = place.leader || ambiguous;
  cost += ambiguous ? 6 : 0;
  cost += obstacle_cost(room, obstacles, bounds);
  for (std::size_t k = 0; k < obstacles.rects.size() && place.leader; ++k)
  {
    const Rect& rect = obstacles.rects[k];
    const bool crosses =
        !is_own(rect, place.label.anchor) && length_inside(place.leader_line, rect) > 1;
    cost += crosses ? 25 : 0;
  }
  candidates.push_back({std::move(place), cost});
}

/// The obstacles without the strokes that no candidate of a label comes close to.
Obstacles within_reach(const Label& label, const Obstacles& obstacles)
{
  const double farthest = label.clearance + rings.back() + 2 * padding;
  const double width = 1.06 * text_width(label.text, label.font_size),
               height = 1.1 * label.font_size;
  const Vector2d& at = label.anchor;
  const Rect reach = {
      at.x() - farthest - width, at.y() - farthest - height, at.x() + farthest + width,
      at.y() + farthest + height};
  Obstacles close{obstacles.rects, {}};
  for (const Segment& segment : obstacles.segments)
  {
    if (!is_beside(segment, reach))
    {
      close.segments.push_back(segment);
    }
  }
  return close;
}

std::vector<Candidate>
candidates_of(const Label& label, const Obstacles& all_obstacles, const Rect& bounds)
{
  const Obstacles obstacles = within_reach(label, all_obstacles);
  const double width = text_width(label.text, label.font_size) * (label.strong ? 1.06 : 1);
  std::vector<Candidate> candidates;
  candidates.reserve(rings.size() * directions + 1);
  if (label.side == Side::centre)
  {
    PlacedLabel place = stand(label, width, 4, -0.55 * label.font_size);
    add_candidate(candidates, place, 0, {}, bounds);
  }
  for (const double ring : rings)
  {
    for (int direction = 0; direction < directions; ++direction)
    {
      PlacedLabel place = stand(label, width, direction, label.clearance + ring);
      place.leader = ring > 9;
      const double detour = (ring > 0 ? 8 : 0) + 1.3 * ring + (label.side == Side::centre ? 60 : 0);
      add_candidate(
          candidates, place, detour + direction_cost(direction, label.side), obstacles, bounds);
    }
  }
  return candidates;
}

/// What two places cost each other.
double conflict(const Candidate& p, const Candidate& q)
{
  const auto room = [](Rect box)
  {
    return Rect{
        box.left - word_space, box.top - padding, box.right + word_space, box.bottom + padding};
  };
  const double area = shared_area(room(p.place.box), room(q.place.box));
  double cost = area > 0 ? 3000 + 10 * area : 0;
  if (p.place.leader)
  {
    cost += length_inside(p.place.leader_line, q.place.box) > 0 ? 400 : 0;
  }
  if (q.place.leader)
  {
    cost += length_inside(q.place.leader_line, p.place.box) > 0 ? 400 : 0;
  }
  return cost;
}

using Choices = std::vector<std::vector<Candidate>>;
constexpr std::size_t unplaced = std::numeric_limits<std::size_t>::max();

/// The candidate of one label that costs least while the others stay.
std::size_t
best_candidate(const Choices& choices, const std::vector<std::size_t>& chosen, std::size_t label)
{
  std::size_t best = 0;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (std::size_t k = 0; k < choices[label].size(); ++k)
  {
    double cost = choices[label][k].cost;
    for (std::size_t other = 0; other < choices.size(); ++other)
    {
      if (other != label && chosen[other] != unplaced)
      {
        cost += conflict(choices[label][k], choices[other][chosen[other]]);
      }
    }
    // Compare in thousandths, so that the last bit of a sum decides nothing.
    const std::int64_t rounded = std::llround(1000 * cost);
    if (rounded < least)
    {
      least = rounded;
      best = k;
    }
  }
  return best;
}

} // namespace

bool overlap(const Rect& p, const Rect& q)
{
  return shared_area(p, q) > 0;
}

std::vector<PlacedLabel>
place_labels(const std::vector<Label>& labels, const Obstacles& obstacles, const Rect& bounds)
{
  Choices choices;
  for (const Label& label : labels)
  {
    choices.push_back(candidates_of(label, obstacles, bounds));
  }
  // Place one after the other, then let each move again while the others stay.
  constexpr int sweeps = 6;
  std::vector<std::size_t> chosen(labels.size(), unplaced);
  std::vector<std::size_t> before;
  for (int sweep = 0; sweep < sweeps && chosen != before; ++sweep)
  {
    before = chosen;
    for (std::size_t label = 0; label < labels.size(); ++label)
    {
      chosen[label] = best_candidate(choices, chosen, label);
    }
  }
  std::vector<PlacedLabel> placed;
  for (std::size_t label = 0; label < labels.size(); ++label)
  {
    placed.push_back(choices[label][chosen[label]].place);
    placed.back().label = labels[label];
  }
  return placed;
}

} // namespace cookbook::plot

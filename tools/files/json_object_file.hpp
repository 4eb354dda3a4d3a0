#pragma once

/// \file
/// \brief The members of a JSON object, each checked as it is asked for.

#include "common/math/vector.hpp"
#include "tools/files/closest_name.hpp"
#include "tools/files/json_file.hpp"
#include "tools/files/round_trip.hpp"

#include <cmath>
#include <optional>

namespace cookbook
{

/// The numbers that a member can have.
struct Limits
{
  double least; ///< itself allowed
  double most;  ///< itself allowed
};

/// An object of a file; throws SceneError where a member is not as it is asked for.
class JsonObject
{
public:
  /// `what` names the object in errors: `the scene`, `body "crate"`.
  JsonObject(const JsonValue& value, const std::string& file, const std::string& what)
      : value_(value), file_(file), what_(what)
  {
    if (value.kind != JsonValue::Kind::object)
    {
      fail(value, what + " must be an object in { }, got " + described(value));
    }
  }

  /// Gives it another name in errors.
  void rename(const std::string& what) { what_ = what; }

  /// Throws SceneError at the line of a value.
  [[noreturn]] void fail(const JsonValue& at, const std::string& sentence) const
  {
    throw SceneError(file_, at.line, sentence);
  }

  /// Throws SceneError at a value of the member `name`: it must be as expected.
  [[noreturn]] void wrong(
      const std::string& name, const JsonValue& at, const std::string& expected,
      const std::string& got) const
  {
    fail(at, name + " of " + what_ + " must be " + expected + ", got " + got);
  }

  /// Refuses members of other names.
  void allow_only(const std::vector<std::string>& names) const
  {
    for (const JsonValue& member : value_.items)
    {
      if (std::find(names.begin(), names.end(), member.name) == names.end())
      {
        const std::string name = member.name.substr(0, 64);
        fail(member, what_ + " has no member \"" + name + "\"" + meant(member.name, names));
      }
    }
  }

  /// The member of a name; nullptr where there is none.
  const JsonValue* find(const std::string& name) const
  {
    const auto is_it = [&name](const JsonValue& member) { return member.name == name; };
    const auto found = std::find_if(value_.items.begin(), value_.items.end(), is_it);
    return found == value_.items.end() ? nullptr : &*found;
  }

  /// The member of a name.
  const JsonValue& need(const std::string& name) const
  {
    const JsonValue* const found = find(name);
    if (!found)
    {
      fail(value_, what_ + " needs a member \"" + name + "\"");
    }
    return *found;
  }

  /// The text of a name.
  std::string text(const std::string& name) const
  {
    const JsonValue& member = need(name);
    if (member.kind != JsonValue::Kind::text)
    {
      wrong(name, member, "a text in quotation marks", described(member));
    }
    return member.text;
  }

  /// The number of a name, within limits; `otherwise` where there is none.
  double number(
      const std::string& name, Limits limits, std::optional<double> otherwise = std::nullopt) const
  {
    return otherwise && !find(name) ? *otherwise : checked(name, need(name), limits);
  }

  /// Whether a name is true; `otherwise` where there is none.
  bool flag(const std::string& name, bool otherwise) const
  {
    const JsonValue* const member = find(name);
    if (member && member->kind != JsonValue::Kind::boolean)
    {
      wrong(name, *member, "true or false", described(*member));
    }
    return member ? member->number != 0 : otherwise;
  }

  /// As many numbers as the vector has; `otherwise` where there are none.
  template <int Size>
  Vector<double, Size> vector(
      const std::string& name, Limits limits,
      const std::optional<Vector<double, Size>>& otherwise) const
  {
    if (otherwise && !find(name))
    {
      return *otherwise;
    }
    const JsonValue& list = need(name);
    const bool is_list = list.kind == JsonValue::Kind::list;
    if (!is_list || list.items.size() != Size)
    {
      const std::string length = "a list of " + std::to_string(list.items.size());
      wrong(
          name, list, "a list of " + std::to_string(Size) + " numbers",
          is_list ? length : described(list));
    }
    Vector<double, Size> result;
    for (int i = 0; i < Size; ++i)
    {
      result[i] = checked(name, list.items[static_cast<std::size_t>(i)], limits);
    }
    return result;
  }

  /// A vector of length one; one whose length is within a thousandth of it was rounded, and is set
  /// to one. What is off by the rounding of double only stays as it is.
  template <int Size>
  Vector<double, Size>
  unit(const std::string& name, const std::optional<Vector<double, Size>>& otherwise) const
  {
    const Vector<double, Size> v = vector<Size>(name, {-1e9, 1e9}, otherwise);
    const double length = v.norm();
    if (!(std::abs(length - 1) <= 1e-3))
    {
      wrong(name, need(name), "of length 1", "length " + round_trip(length));
    }
    return std::abs(length - 1) <= 1e-15 ? v : v / length;
  }

private:
  double checked(const std::string& name, const JsonValue& at, Limits limits) const
  {
    if (at.kind != JsonValue::Kind::number)
    {
      wrong(name, at, "a number", described(at));
    }
    if (!(at.number >= limits.least && at.number <= limits.most))
    {
      wrong(
          name, at, round_trip(limits.least) + " to " + round_trip(limits.most),
          round_trip(at.number));
    }
    return at.number;
  }

  const JsonValue& value_;
  const std::string& file_;
  std::string what_;
};

} // namespace cookbook

#pragma once

/// \file
/// \brief JSON whose values know their lines, so that errors can say where.

#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook
{

/// What a wrong scene file is answered with: `path:line: sentence`. Lines count from one.
class SceneError : public std::runtime_error
{
public:
  /// Says where and what.
  SceneError(const std::string& file, std::size_t line, const std::string& sentence)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + sentence), line_(line)
  {
  }

  /// Where, from one.
  std::size_t line() const { return line_; }

private:
  std::size_t line_;
};

/// A value of a JSON file.
struct JsonValue
{
  /// What it is.
  enum class Kind
  {
    null,
    boolean,
    number,
    text,
    list,
    object
  };
  Kind kind;                      ///< says which of the members below count
  std::size_t line;               ///< where it begins, or its name if it has one
  double number = 0;              ///< finite
  std::string text{};             ///< UTF-8
  std::string name{};             ///< as a member of an object
  std::vector<JsonValue> items{}; ///< of a list, or the members of an object, in order
};

/// The value that a text is, all of it; `file` is named where there is an error.
///
/// Throws SceneError for a text that is not JSON, a name twice in one object, a number beyond the
/// range of double, and values nested more than 32 deep.
JsonValue parse_json(const std::string& text, const std::string& file);

/// What a value is, in words: `the number -1`, `a list`.
std::string described(const JsonValue& value);

} // namespace cookbook

/// \file
/// Reads JSON by the events of a library, and notes on which line each of them happens.

#include "tools/files/json_file.hpp"
#include "tools/files/round_trip.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace cookbook
{
namespace
{

constexpr std::size_t deepest = 32;

/// Walks through a text and tells another how far anybody has read.
class WatchedChar
{
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  WatchedChar(const char* at, const char** read) : at_(at), read_(read) {}
  reference operator*() const { return *at_; }
  WatchedChar& operator++()
  {
    *read_ = ++at_;
    return *this;
  }
  bool operator==(const WatchedChar& other) const { return at_ == other.at_; }
  bool operator!=(const WatchedChar& other) const { return at_ != other.at_; }

private:
  const char* at_;
  const char** read_;
};

bool is_word(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' ||
         c == '-';
}

/// The word of which the last character that was read is a part, or only that character.
std::string word_at(const std::string& text, std::size_t last)
{
  if (text[last] < ' ' || text[last] > '~')
  {
    return "a character beyond ASCII";
  }
  std::size_t begin = last;
  std::size_t end = last + 1;
  while (is_word(text[last]) && begin > 0 && is_word(text[begin - 1]))
  {
    --begin;
  }
  while (is_word(text[last]) && end < text.size() && is_word(text[end]))
  {
    ++end;
  }
  return text.substr(begin, std::min<std::size_t>(end - begin, 40));
}

/// What is wrong, by the library's complaint, in a reader's words; `word` is what cannot stand
/// there.
std::string reason(const std::string& complaint, const std::string& word)
{
  const auto says = [&complaint](const char* part)
  { return complaint.find(part) != std::string::npos; };
  const bool closing = says("unexpected '}'") || says("unexpected ']'");
  if (says("; expected '}'") || says("; expected ']'"))
  {
    return (closing ? "a bracket of the wrong kind: " : "a comma is missing before ") + word;
  }
  if (says("expected end of input"))
  {
    return "nothing may follow the last bracket, but there is " + word;
  }
  if (closing || says("unexpected ','"))
  {
    return "a value is missing before " + word + ", or there is a comma too many";
  }
  const std::vector<std::pair<const char*, std::string>> others{
      {"; expected ':'", "a colon is missing before " + word},
      {"number overflow", word + " is beyond the range of double"},
      {"missing closing quote", "a text lacks its closing quotation mark"},
      {"must be escaped", "a text lacks its closing quotation mark on its line"},
      {"ill-formed UTF-8", "a text is not UTF-8"}};
  for (const auto& [part, sentence] : others)
  {
    if (says(part))
    {
      return sentence;
    }
  }
  return word + " is not JSON, which has numbers, \"texts\", true, false and null";
}

/// Builds the value from the library's events.
class Builder
{
public:
  Builder(const std::string& text, const std::string& file)
      : text_(text), file_(file), counted_(text.data()), read_(text.data())
  {
  }

  const char** read() { return &read_; }
  JsonValue take() { return std::move(root_); }

  bool null() { return add({JsonValue::Kind::null, line()}); }
  bool boolean(bool value) { return add({JsonValue::Kind::boolean, line(), value ? 1.0 : 0.0}); }
  bool number_integer(std::int64_t value) { return add_number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return add_number(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return add_number(value); }
  bool string(std::string& value) { return add({JsonValue::Kind::text, line(), 0, value}); }
  bool binary(std::vector<std::uint8_t>&) { return false; } // JSON has none
  bool start_object(std::size_t) { return open(JsonValue::Kind::object); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(JsonValue::Kind::list); }
  bool end_array() { return close(); }

  bool key(std::string& name)
  {
    const std::vector<JsonValue>& members = open_.back()->items;
    const auto same = [&name](const JsonValue& member) { return member.name == name; };
    const auto other = std::find_if(members.begin(), members.end(), same);
    if (other != members.end())
    {
      fail("\"" + name + "\" is given twice, first on line " + std::to_string(other->line));
    }
    name_ = name;
    name_line_ = line();
    return true;
  }

  bool
  parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& complaint)
  {
    const std::string what = complaint.what();
    if (what.find("unexpected end of input") != std::string::npos)
    {
      fail("the file ends too early");
    }
    fail(reason(what, *(read_ - 1) == '"' ? token.substr(0, 40) : word(what)));
  }

private:
  /// The word complained of; where it is a number or a literal, the character behind it was read
  /// too.
  std::string word(const std::string& what) const
  {
    std::size_t last = static_cast<std::size_t>(read_ - text_.data()) - 1;
    const bool one_more = what.find("number") != std::string::npos ||
                          what.find("invalid literal") != std::string::npos;
    if (one_more && last > 0 && !is_word(text_[last]) && is_word(text_[last - 1]))
    {
      --last;
    }
    return word_at(text_, last);
  }

  [[noreturn]] void fail(const std::string& sentence) { throw SceneError(file_, line(), sentence); }

  /// The line of the last character that was read; a line's end belongs to the line.
  std::size_t line()
  {
    for (; counted_ + 1 < read_; ++counted_)
    {
      line_ += *counted_ == '\n' ? 1 : 0;
    }
    return line_;
  }

  bool add_number(double value) { return add({JsonValue::Kind::number, line(), value}); }

  bool add(JsonValue value)
  {
    JsonValue* const parent = open_.empty() ? nullptr : open_.back();
    if (parent && parent->kind == JsonValue::Kind::object)
    {
      value.name = name_;
      value.line = name_line_;
    }
    (parent ? parent->items.emplace_back() : root_) = std::move(value);
    return true;
  }

  bool open(JsonValue::Kind kind)
  {
    if (open_.size() == deepest)
    {
      fail("values are nested more than " + std::to_string(deepest) + " deep");
    }
    add({kind, line()});
    open_.push_back(open_.empty() ? &root_ : &open_.back()->items.back());
    return true;
  }

  bool close()
  {
    open_.pop_back();
    return true;
  }

  const std::string& text_;
  const std::string& file_;
  const char* counted_;
  const char* read_;
  std::size_t line_ = 1;
  std::string name_;
  std::size_t name_line_ = 0;
  JsonValue root_{};
  std::vector<JsonValue*> open_;
};

} // namespace

JsonValue parse_json(const std::string& text, const std::string& file)
{
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
  {
    throw SceneError(file, 1, "the file is empty");
  }
  Builder builder(text, file);
  const char* const begin = text.data();
  nlohmann::json::sax_parse(
      WatchedChar(begin, builder.read()), WatchedChar(begin + text.size(), builder.read()),
      &builder);
  return builder.take();
}

std::string described(const JsonValue& value)
{
  switch (value.kind)
  {
  case JsonValue::Kind::null:
    return "null";
  case JsonValue::Kind::boolean:
    return value.number > 0 ? "true" : "false";
  case JsonValue::Kind::number:
    return "the number " + round_trip(value.number);
  case JsonValue::Kind::text:
    return "the text \"" + value.text + "\"";
  case JsonValue::Kind::list:
    return "a list";
  case JsonValue::Kind::object:
    return "an object";
  }
  return "";
}

} // namespace cookbook

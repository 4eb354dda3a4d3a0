#include "02_primitives/meshes/trial/mesh_file.hpp"
#include "02_primitives/meshes/checked_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace cookbook
{

namespace
{

/// The lines of a text, each as its words, and errors that name the line.
class Lines
{
public:
  Lines(const std::string& text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Reads the next line that is not empty and no comment; false after the last.
  bool next()
  {
    while (begin_ < text_.size())
    {
      const std::size_t end = std::min(text_.find('\n', begin_), text_.size());
      words_.clear();
      std::string_view line = std::string_view(text_).substr(begin_, end - begin_);
      line = line.substr(0, line.find('#'));
      for (std::size_t i = 0; (i = line.find_first_not_of(" \t\r", i)) != line.npos;)
      {
        const std::size_t stop = std::min(line.find_first_of(" \t\r", i), line.size());
        words_.push_back(line.substr(i, stop - i));
        i = stop;
      }
      begin_ = end + 1;
      ++number_;
      if (!words_.empty())
      {
        return true;
      }
    }
    return false;
  }

  const std::vector<std::string_view>& words() const { return words_; }

  [[noreturn]] void fail(const std::string& sentence) const
  {
    throw MeshFileError(name_ + ":" + std::to_string(number_) + ": " + sentence);
  }

  /// Fails unless the line begins with these words.
  void expect(std::initializer_list<std::string_view> words) const
  {
    std::size_t i = 0;
    for (const std::string_view word : words)
    {
      if (i >= words_.size() || words_[i] != word)
      {
        fail("expected " + std::string(word) + (i < words_.size() ? ", got " + quoted(i) : ""));
      }
      ++i;
    }
  }

  /// The three numbers from a word on.
  Vector3<double> point(std::size_t first) const
  {
    if (words_.size() < first + 3)
    {
      fail("a point has three numbers, got " + std::to_string(words_.size() - first));
    }
    return {number(first), number(first + 1), number(first + 2)};
  }

  std::string quoted(std::size_t word) const { return '"' + std::string(words_[word]) + '"'; }

private:
  double number(std::size_t word) const
  {
    std::string_view text = words_[word];
    text.remove_prefix(text.substr(0, 1) == "+" && text.substr(1, 1) != "-" ? 1 : 0);
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || stop != text.data() + text.size() || !std::isfinite(value))
    {
      fail("expected a finite number, got " + quoted(word));
    }
    return value;
  }

  const std::string& text_;
  std::string name_;
  std::size_t begin_ = 0, number_ = 0;
  std::vector<std::string_view> words_;
};

/// The corner that a word of an OBJ face names, such as `7`, `7/1/3` or `-1`.
int corner_of(const Lines& lines, std::size_t word, std::size_t corners)
{
  const std::string_view text = lines.words()[word];
  const std::string_view index = text.substr(0, text.find('/'));
  long long value = 0;
  const auto [stop, error] = std::from_chars(index.data(), index.data() + index.size(), value);
  const auto count = static_cast<long long>(corners);
  const long long place = value < 0 ? count + value : value - 1;
  if (error != std::errc{} || stop != index.data() + index.size() || value == 0)
  {
    lines.fail("expected the number of a corner, got " + lines.quoted(word));
  }
  if (place < 0 || place >= count)
  {
    lines.fail(
        "corner " + lines.quoted(word) + " does not exist, so far there are " +
        std::to_string(corners));
  }
  return static_cast<int>(place);
}

/// Puts triangles together whose corners are known by their places.
class Corners
{
public:
  void add(const std::array<Vector3<double>, 3>& corners)
  {
    std::array<int, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Vector3<double>& at = corners[i];
      const auto number = static_cast<int>(mesh.vertices.size());
      const auto [known, is_new] = numbers_.insert({{at.x(), at.y(), at.z()}, number});
      if (is_new)
      {
        mesh.vertices.push_back(at);
      }
      triangle[i] = known->second;
    }
    mesh.triangles.push_back(triangle);
  }

  TriangleMesh<double> mesh;

private:
  std::map<std::array<double, 3>, int> numbers_;
};

/// Four bytes, the least first, at a place of a binary file.
std::uint32_t word_at(const std::string& bytes, std::size_t place)
{
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;)
  {
    word = word << 8 | static_cast<unsigned char>(bytes[place + i]);
  }
  return word;
}

TriangleMesh<double> mesh_from_binary(const std::string& bytes, const std::string& name)
{
  Corners corners;
  for (std::size_t at = 84; at < bytes.size(); at += 50)
  {
    std::array<Vector3<double>, 3> triangle;
    for (std::size_t i = 0; i < 9; ++i)
    {
      const double x = std::bit_cast<float>(word_at(bytes, at + 12 + 4 * i));
      if (!std::isfinite(x))
      {
        throw MeshFileError(
            name + ": triangle " + std::to_string((at - 84) / 50) +
            " has a number that is not finite");
      }
      triangle[i / 3][static_cast<Eigen::Index>(i % 3)] = x;
    }
    corners.add(triangle);
  }
  return corners.mesh;
}

} // namespace

TriangleMesh<double> mesh_from_obj(const std::string& text, const std::string& name)
{
  static const std::set<std::string_view> passed_over{"vn", "vt",     "vp",     "o", "g",
                                                      "s",  "usemtl", "mtllib", "l", "p"};
  TriangleMesh<double> mesh;
  Lines lines(text, name);
  while (lines.next())
  {
    const std::vector<std::string_view>& words = lines.words();
    if (words[0] == "v")
    {
      mesh.vertices.push_back(lines.point(1));
    }
    else if (words[0] == "f")
    {
      if (words.size() < 4)
      {
        lines.fail("a face has three corners or more, got " + std::to_string(words.size() - 1));
      }
      const std::size_t corners = mesh.vertices.size();
      for (std::size_t i = 3; i < words.size(); ++i)
      {
        const int first = corner_of(lines, 1, corners), second = corner_of(lines, i - 1, corners);
        mesh.triangles.push_back({first, second, corner_of(lines, i, corners)});
      }
    }
    else if (passed_over.count(words[0]) == 0)
    {
      lines.fail("unknown word " + lines.quoted(0));
    }
  }
  return mesh;
}

TriangleMesh<double> mesh_from_stl(const std::string& bytes, const std::string& name)
{
  if (bytes.size() >= 84 && bytes.size() - 84 == std::uint64_t(word_at(bytes, 80)) * 50)
  {
    return mesh_from_binary(bytes, name);
  }
  if (bytes.substr(0, 5) != "solid")
  {
    throw MeshFileError(name + ": neither a text, nor as long as its number of triangles says");
  }
  Corners corners;
  Lines lines(bytes, name);
  lines.next();
  while (lines.next() && lines.words()[0] != "endsolid")
  {
    lines.expect({"facet", "normal"});
    const auto expect_next = [&](std::initializer_list<std::string_view> words)
    {
      if (!lines.next())
      {
        lines.fail("the file ends within a triangle");
      }
      lines.expect(words);
    };
    expect_next({"outer", "loop"});
    std::array<Vector3<double>, 3> triangle;
    for (Vector3<double>& corner : triangle)
    {
      expect_next({"vertex"});
      corner = lines.point(1);
    }
    expect_next({"endloop"});
    expect_next({"endfacet"});
    corners.add(triangle);
  }
  return corners.mesh;
}

TriangleMesh<double> read_mesh(const std::filesystem::path& path)
{
  const std::string name = path.string(), kind = path.extension().string();
  if (kind != ".obj" && kind != ".stl")
  {
    throw MeshFileError(name + ": a mesh is read from a file that ends in .obj or .stl");
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
  {
    throw MeshFileError(name + ": cannot be read");
  }
  return checked(kind == ".obj" ? mesh_from_obj(bytes, name) : mesh_from_stl(bytes, name));
}

} // namespace cookbook

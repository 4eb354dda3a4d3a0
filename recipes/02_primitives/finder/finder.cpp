/// \file
/// \brief Which questions about two shapes the chapter answers; and the answers to a reader's own.

#include "02_primitives/finder/trial/finder.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

namespace
{

using namespace cookbook;

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

/// A shape's name; WrongOption naming those there are, if it is none.
std::string shape_named(const std::string& name)
{
  const std::vector<std::string>& all = finder_shapes();
  if (std::find(all.begin(), all.end(), name) == all.end())
  {
    throw WrongOption("there is no shape \"" + name + "\"; there are: " + joined(all));
  }
  return name;
}

template <class Real>
void answer(const Arguments& given)
{
  const std::string ask = given.value("ask"), shapes = given.value("shapes");
  const std::size_t comma = shapes.find(',');
  if (shapes.find(';') != shapes.npos)
  {
    throw WrongOption("--shapes takes a comma between the two, as A,B");
  }
  if (ask.empty() || comma == shapes.npos)
  {
    throw WrongOption(
        "--pairs needs --ask " + joined(finder_asks()) + ", and --shapes A,B (try --help)");
  }
  const std::string a = shape_named(shapes.substr(0, comma));
  const std::string b = shape_named(shapes.substr(comma + 1));
  const auto question = finder_question<Real>(ask, a, b);
  if (!question)
  {
    const std::vector<std::string> partners = finder_partners(ask, a);
    throw WrongOption(
        "--ask " + ask + " has no answer for " + a + " and " + b + "; " +
        (partners.empty() ? ask == "cast" ? "what is cast is a ray or a segment, ray2 or segment2"
                                          : "a " + a + " is cast, with --ask cast"
                          : a + " can be asked with: " + joined(partners)));
  }
  std::cout << answers_csv(*question, given.pairs.string());
}

/// A row a shape and a column a shape that may be a target; in each cell a letter for each answer
/// about the two.
Cells table_of(const std::vector<std::string>& shapes)
{
  Cells rows{{""}};
  for (const std::string& a : shapes)
  {
    rows.push_back({a});
  }
  for (const std::string& b : shapes)
  {
    if (b == "ray" || b == "ray2") // only cast, never a target
    {
      continue;
    }
    rows[0].push_back(b);
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
      std::string cell;
      for (const std::string& ask : finder_asks())
      {
        if (finder_question<double>(ask, shapes[i], b))
        {
          cell += cell.empty() ? "" : " ";
          cell += ask == "cast" ? "r" : ask.substr(0, 1);
        }
      }
      rows[i + 1].push_back(cell);
    }
  }
  return rows;
}

void print(const Cells& rows)
{
  Table table(rows[0]);
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    table.row(rows[i]);
  }
  std::cout << table.text() << "\n";
}

/// The table for a page, with cells narrow enough for its width.
std::string narrow_table(const Cells& rows)
{
  std::string html = html_table(rows);
  for (const std::string& cell : {std::string("<th>"), std::string("<td>")})
  {
    const std::string narrow =
        cell.substr(0, 3) + " style=\"padding: 0.3em 0.4em; font-size: 0.82em\">";
    for (std::size_t at = html.find(cell); at != html.npos; at = html.find(cell, at + 1))
    {
      html.replace(at, cell.size(), narrow);
    }
  }
  return html;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "finder",
      .summary = "For two shapes: whether they overlap, where they are closest, where a ray hits.",
      .pairs_header = "the columns of shape A with the prefix a, those of B with b",
      .options = {
          {"ask", "what to ask of each row of --pairs", "", finder_asks(), {"pairs"}},
          {"shapes", "the two shapes, as A,B", "", {}, {"pairs"}},
          scalar_option()}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        if (!given.pairs.empty())
        {
          return given.value("scalar") == "float" ? answer<float>(given) : answer<double>(given);
        }
        const std::vector<std::string>& all = finder_shapes();
        const auto plane = std::find(all.begin(), all.end(), "point2");
        const Cells space = table_of({all.begin(), plane}), flat = table_of({plane, all.end()});
        std::cout << "o: overlap, c: closest, r: raycast of the row's shape at the column's\n\n";
        print(space);
        print(flat);
        save_figure(given, "finder_space.html", narrow_table(space));
        save_figure(given, "finder_plane.html", narrow_table(flat));
      });
}

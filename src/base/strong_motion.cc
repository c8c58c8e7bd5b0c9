#include "base/strong_motion.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/dialect.h"
#include "base/text.h"

namespace upbead {

namespace {

constexpr std::size_t head_lines = 4;

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return capitals;
}

/// The first `n` numbers of a line, whatever stands between them.
std::vector<double> numbers_in(const std::string& line, std::size_t n) {
  std::vector<double> list;
  for (std::size_t at = 0; list.size() < n && at < line.size();) {
    const std::size_t begin = line.find_first_of("0123456789.", at);
    if (begin == std::string::npos) break;
    const std::size_t end = std::min(line.find_first_not_of("0123456789.E+-", begin), line.size());
    double number = 0.;
    if (read_cell(std::string_view(line).substr(begin, end - begin), {}, number) == CellIs::number)
      list.push_back(number);
    at = end;
  }
  return list;
}

/// Motion and unit by the line "ACCELERATION IN UNITS OF G".
bool read_quantity(const std::string& head, CsvTable& table) {
  constexpr std::pair<const char*, const char*> motions[]{
      {"ACCELERATION", "acceleration"}, {"VELOCITY", "velocity"}, {"DISPLACEMENT", "displacement"}};
  constexpr std::pair<const char*, const char*> units[]{
      {"CM/SEC/SEC", "cm/s2"}, {"CM/S/S", "cm/s2"}, {"CM/S2", "cm/s2"},
      {"CM/SEC", "cm/s"},      {"CM/S", "cm/s"},    {"CM", "cm"},
      {"M/S/S", "m/s2"},       {"M/S2", "m/s2"},    {"G", "g"}};
  const std::size_t of = head.find("UNITS OF");
  if (of == std::string::npos) return false;
  std::string word = head.substr(of + std::string_view("UNITS OF").size());
  word = word.substr(std::min(word.find_first_not_of(" \t"), word.size()));
  word = word.substr(0, word.find_first_of(" \t\r\n"));
  for (const auto& [text, name] : motions)
    for (const auto& [written, unit] : units)
      if (head.rfind(text, of) != std::string::npos && word == written) {
        table.names = {"time", name};
        table.units = {"s", unit};
        return true;
      }
  return false;
}

}  // namespace

std::optional<CsvTable> read_strong_motion(std::string_view text, const std::string& path) {
  std::array<std::string, head_lines> head;
  for (std::string& line : head) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    line = in_capitals(text.substr(0, std::min<std::size_t>(end, longest_path)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (head[3].find("NPTS") == std::string::npos || head[3].find("DT") == std::string::npos) return {};
  CsvTable table;
  table.path = path;
  const std::vector<double> told = numbers_in(head[3], 2);
  if (told.size() < 2 || !(told[1] > 0.) || !(told[0] >= 1.))
    throw InputError({path, 4, 1}, "the line of NPTS and DT has no two numbers above zero",
                     "give the record whole, as PEER wrote it");
  if (!read_quantity(head[2] + "\n", table))
    throw InputError({path, 3, 1}, "this line of a record of strong motion does not tell its unit",
                     "write ACCELERATION IN UNITS OF G, or the time and the motion in two columns");
  table.columns.resize(2);
  Dialect blanks;
  blanks.separator = ' ';
  std::vector<Cell> cells;
  for (int line = head_lines + 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    split(text.substr(0, end), blanks, cells);
    text.remove_prefix(std::min(end + 1, text.size()));
    for (const Cell& cell : cells) {
      double number = 0.;
      if (const CellIs is = read_cell(cell.text, blanks, number); is != CellIs::number)
        throw InputError({path, line, cell.column}, objection(is, cell.text, blanks), cure_of(is));
      table.columns[0].push_back(static_cast<double>(table.lines.size()) * told[1]);
      table.columns[1].push_back(number);
      table.lines.push_back(line);
    }
  }
  if (static_cast<double>(table.lines.size()) != told[0])
    throw InputError(
        {path, 4, 1},
        "NPTS tells of " + significant(told[0], 9) + " samples, the record has " + std::to_string(table.lines.size()),
        "give the record whole");
  table.faults.resize(2);
  table.layout = "record of strong motion, " + table.names[1] + " in " + table.units[1] + " every " +
                 significant(told[1], 6) + " s";
  return table;
}

}  // namespace upbead

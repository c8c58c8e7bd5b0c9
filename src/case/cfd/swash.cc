// Tables of SWASH. The table itself has neither header nor times: the command `TABLE 'WG01' NOHEADER 'file' WATL DEP
// OUTPUT tbegin dt SEC` in the command file INPUT gives both. Source: SWASH user manual, commands TABLE and SET.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/text.h"
#include "case/cfd/flow_tables.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// A command with its continued lines (ended by & or _), and where it begins.
struct SwashCommand {
  std::string text;
  Place place;
};

std::vector<SwashCommand> commands_of(const std::string& path, const Place& place, FlowNotes& notes) {
  FlowLines lines(path, place);
  std::vector<SwashCommand> commands;
  bool goes_on = false;
  while (lines.next(notes)) {
    std::string text(lines.line().substr(0, lines.line().find('!')));
    text = text.substr(0, text.find('$'));
    const std::size_t last = text.find_last_not_of(" \t");
    if (last == std::string::npos) continue;
    const bool next_goes_on = text[last] == '&' || text[last] == '_';
    text.resize(next_goes_on ? last : last + 1);
    if (goes_on)
      commands.back().text += " " + text;
    else
      commands.push_back({text, lines.place()});
    goes_on = next_goes_on;
  }
  return commands;
}

/// What the command TABLE says of the table.
struct SwashTable {
  std::vector<std::string> names;
  double begin = 0., step = 0.;  ///< s
  Place place;
};

/// Reads hhmmss.sss, the third of SWASH's ways to write a time.
bool read_clock(const std::string& word, double& seconds) {
  double number = 0.;
  if (word.find_first_not_of("0123456789.") != std::string::npos || !read_number(word, number)) return false;
  const double whole = std::floor(number), h = std::floor(whole / 1e4), m = std::floor((whole - 1e4 * h) / 100.);
  const double s = whole - 1e4 * h - 100. * m;
  seconds = 3600. * h + 60. * m + s + (number - whole);
  return m < 60. && s < 60. && h < 1e6;
}

SwashTable read_table_command(const SwashCommand& command, const std::vector<std::string>& words) {
  const auto fail = [&](const std::string& what) -> InputError {
    return InputError(command.place, what + " in " + in_quotes(command.text),
                      "it is TABLE 'POINT' NOHEADER 'FILE' WATL DEP OUTPUT tbegin dt SEC");
  };
  SwashTable table;
  table.place = command.place;
  std::size_t w = 4;
  for (; w < words.size() && !starts_with(lower_case(words[w]), "out"); ++w)
    table.names.push_back(lower_case(words[w]));
  if (lower_case(words[2]).substr(0, 4) != "nohe" && lower_case(words[2]).substr(0, 4) != "head")
    throw fail("neither NOHEADER nor HEADER");
  if (table.names.empty() || words.size() != w + 4) throw fail("no OUTPUT with begin, step and unit of the times");
  static const std::map<std::string, double> units{{"sec", 1.}, {"min", 60.}, {"hr", 3600.}, {"day", 86400.}};
  const auto unit = units.find(lower_case(words[w + 3]));
  if (unit == units.end()) throw fail("the unit of the step is none of SEC, MIN, HR, DAY");
  if (!read_clock(words[w + 1], table.begin)) throw fail("the begin is no hhmmss.sss");
  if (!read_number(words[w + 2], table.step) || !(table.step > 0.)) throw fail("the step is no number above zero");
  table.step *= unit->second;
  return table;
}

std::string without_quotes(const std::string& word) {
  return word.size() > 1 && word.front() == '\'' && word.back() == '\'' ? word.substr(1, word.size() - 2) : word;
}

/// Finds the command of this table, and the still water level by SET LEVEL.
std::optional<SwashTable> find_table(const std::string& input, const std::string& file, const Place& place,
                                     FlowNotes& notes, double& still) {
  std::optional<SwashTable> found;
  for (const SwashCommand& command : commands_of(input, place, notes)) {
    const std::vector<std::string> words = words_of(command.text);
    if (words.empty()) continue;
    const std::string first = lower_case(words[0]);
    for (std::size_t w = 1; first == "set" && w + 1 < words.size(); ++w)
      if (starts_with(lower_case(words[w]), "lev") && !read_number(words[w + 1], still))
        throw InputError(command.place, "the level of SET LEVEL is no number", "give it in m");
    if (!starts_with(first, "tab") || words.size() < 5) continue;
    if (fs::path(without_quotes(words[3])).filename() != fs::path(file).filename()) continue;
    if (found) throw InputError(command.place, "a second TABLE writes the same file", "keep the one that is meant");
    found = read_table_command(command, words);
  }
  return found;
}

}  // namespace

bool read_swash(const std::string& path, const Place& place, FlowRecord& record) {
  const std::string input = (fs::path(path).parent_path() / "INPUT").string();
  std::error_code ignored;
  if (!fs::is_regular_file(input, ignored)) return false;
  FlowLevel level;
  const std::optional<SwashTable> table = find_table(input, path, place, record.notes, level.still);
  if (!table) return false;
  const auto column = [&](const std::string& name) {
    const auto at = std::find_if(table->names.begin(), table->names.end(),
                                 [&name](const std::string& n) { return starts_with(n, name); });
    if (at != table->names.end()) return static_cast<std::size_t>(at - table->names.begin());
    throw InputError(table->place, "the table has no " + name + " in its columns: " + join(table->names),
                     "write WATL and DEP into the table");
  };
  const std::size_t of_level = column("watl"), of_depth = column("dep");
  FlowLines lines(path, place);
  FlowLine line;
  while (lines.next(record.notes)) {
    if (lines.line().front() == '%') {
      if (level.time.empty()) continue;
      throw InputError(lines.place(), "a second head: the times by INPUT are of one run", "give the table of one run");
    }
    read_line(lines, line);
    require_quantities(lines, line);
    if (line.shape != std::string(table->names.size(), 'n'))
      throw InputError(lines.place(),
                       "this row has " + std::to_string(line.numbers.size()) + " numbers, INPUT tells of " +
                           std::to_string(table->names.size()) + ": " + join(table->names),
                       "is a column lost, or does a name stand for two of them?");
    level.time.push_back(table->begin + table->step * static_cast<double>(level.time.size()));
    level.level.push_back(line.numbers[of_level]);
    level.depth.push_back(line.numbers[of_depth]);
    const double bed = level.level.back() - level.depth.back(), first_bed = level.level[0] - level.depth[0];
    if (!(level.depth.back() >= 0.) || std::abs(bed - first_bed) > 1e-3 * std::max(1., level.depth[0]))
      throw InputError(lines.place(), "WATL - DEP, the height of the bed, is not that of the first row",
                       "is a column exchanged, or does the bed fall dry here (-9)?");
  }
  if (level.time.size() < 2) throw InputError({path}, "fewer than two rows", "give the table whole");
  record.notes.push_back("times by INPUT: from " + significant(table->begin) + " s every " +
                         significant(table->step, 6) + " s");
  record.files = {path, input};
  record.layout = "SWASH table";
  record.level = std::move(level);
  return true;
}

}  // namespace upbead

// The four layouts of the function object `forces`. Source: output of OpenFOAM 1912, and for other versions the code
// that writes it (src/functionObjects/forces/forces/forces.C).
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <tuple>

#include "base/text.h"
#include "case/cfd/flow_text.h"
#include "case/cfd/openfoam.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// What the header says of a row.
struct ForceHeader {
  bool both = false;                ///< forces and moments in one row
  bool brackets = false;            ///< around vectors
  std::vector<std::string> groups;  ///< vectors of each: "total", "pressure", "viscous", "porous"
  std::optional<Triple> centre;
  int line = 0;  ///< of '# Time ...'

  bool known() const { return !groups.empty(); }
  bool is_like(const ForceHeader& other) const {
    return std::tie(both, brackets, groups, centre) == std::tie(other.both, other.brackets, other.groups, other.centre);
  }
  std::string shape() const;
};

std::string ForceHeader::shape() const {
  const std::string vector = brackets ? "(nnn)" : "nnn";
  std::string vectors;
  for (std::size_t g = 0; g < groups.size(); ++g) vectors += vector;
  return both ? "n(" + vectors + ")(" + vectors + ")" : "n" + vectors;
}

bool is_part(const std::string& word) {
  return word == "pressure" || word == "viscous" || word == "porous" || word == "internal";
}

[[noreturn]] void unknown_header(const FlowLines& lines) {
  throw InputError(
      lines.place(), "this is no header of OpenFOAM's forces that is known: " + in_quotes(lines.line()),
      "it is '# Time forces(pressure viscous) moments(pressure viscous)', the same with porous, or '# Time "
      "(total_x total_y total_z) (pressure_x ...' with or without brackets; is the line whole?");
}

/// "forces(pressure viscous) moments(pressure viscous)".
void read_foundation_header(const FlowLines& lines, std::string_view text, ForceHeader& header) {
  const std::vector<std::string> words = words_of(text, " \t(),");
  const std::size_t half = words.size() / 2;
  bool sound = words.size() % 2 == 0 && half >= 3 && words[0] == "forces" && starts_with(words[half], "moment");
  for (std::size_t w = 1; sound && w < half; ++w) {
    sound = is_part(words[w]) && words[w] == words[half + w];
    header.groups.push_back(words[w]);
  }
  sound = sound && header.groups[0] == "pressure" && header.groups[1] == "viscous" && text.back() == ')';
  if (!sound) unknown_header(lines);
  header.both = header.brackets = true;
}

/// "(total_x total_y total_z) (pressure_x ...", or without brackets.
void read_esi_header(const FlowLines& lines, std::string_view text, ForceHeader& header) {
  const std::vector<std::string> words = words_of(text, " \t()");
  header.brackets = text.find('(') != std::string_view::npos;
  bool sound = !words.empty() && words.size() % 3 == 0 && (!header.brackets || text.back() == ')');
  for (std::size_t w = 0; sound && w < words.size(); ++w) {
    const std::size_t at = words[w].size() < 2 ? 0 : words[w].size() - 2;
    const std::string group = words[w].substr(0, at);
    sound = words[w].substr(at) == std::string("_") + "xyz"[w % 3] && (w % 3 == 0 || group == header.groups.back());
    if (w % 3 == 0) header.groups.push_back(group);
  }
  sound = sound && header.groups.size() >= 3 && header.groups[0] == "total" && header.groups[1] == "pressure" &&
          header.groups[2] == "viscous";
  for (std::size_t g = 1; sound && g < header.groups.size(); ++g) sound = is_part(header.groups[g]);
  if (!sound) unknown_header(lines);
}

Triple read_centre(const FlowLines& lines, std::string_view text) {
  const std::vector<std::string> words = words_of(text, " \t():");
  Triple centre{};
  bool sound = words.size() == 4 && text.back() == ')';
  for (std::size_t i = 0; sound && i < 3; ++i) sound = read_number(words[i + 1], centre[i]);
  if (!sound)
    throw InputError(lines.place(), "the centre of the moments cannot be read: " + in_quotes(lines.line()),
                     "it is '# CofR : (x y z)'");
  return centre;
}

/// Reads a line of a head; other comments are passed over. A line of a head below a whole head begins another one, as
/// where the files of two runs were put together.
void read_comment(const FlowLines& lines, ForceHeader& header, const std::string& quantity) {
  std::string_view text = lines.line();
  text.remove_prefix(std::min(text.find_first_not_of("# \t"), text.size()));
  const std::string lower = lower_case(text.substr(0, 6));
  const bool title = starts_with(lower, "force") || starts_with(lower, "moment");
  if (header.known() && (title || starts_with(text, "CofR") || starts_with(text, "Time"))) header = {};
  if (starts_with(text, "CofR")) {
    header.centre = read_centre(lines, text);
  } else if (starts_with(text, "Time")) {
    text.remove_prefix(4);
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    header.line = lines.place().line;
    if (starts_with(text, "forces"))
      read_foundation_header(lines, text, header);
    else
      read_esi_header(lines, text, header);
  } else if (title && !starts_with(lower, quantity)) {
    throw InputError(lines.place(), "the file is called by its " + quantity + "s, but begins with " + in_quotes(text),
                     "give the files the names that OpenFOAM gave them");
  }
}

/// Adds the sums of a row's vectors as its 3 or 6 numbers. Where the row has totals, those are taken and compared
/// with the sum of the parts.
void add_row(const FlowLines& lines, const ForceHeader& header, const FlowLine& line, FlowRows& rows) {
  const std::size_t n = header.groups.size(), first = header.groups[0] == "total" ? 1 : 0;
  rows.time.push_back(line.numbers[0]);
  for (std::size_t part = 0; part < (header.both ? 2U : 1U); ++part) {
    const auto number = [&](std::size_t group, std::size_t i) {
      return line.numbers.at(1 + 3 * (n * part + group) + i);
    };
    double size = 0.;
    for (std::size_t i = 0; i < 3 * n; ++i) size = std::max(size, std::abs(number(0, i)));
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = 0.;
      for (std::size_t g = first; g < n; ++g) sum += number(g, i);
      constexpr double rounding = 1e-3;  // numbers are written with four digits or more
      if (first == 1 && std::abs(sum - number(0, i)) > rounding * size)
        throw InputError(lines.place(),
                         "total_" + std::string(1, "xyz"[i]) + " = " + significant(number(0, i), 6) +
                             " is not the sum of its parts, " + significant(sum, 6),
                         "is a column lost, or has one been exchanged?");
      rows.value.push_back(first == 1 ? number(0, i) : sum);
    }
  }
}

struct ForceFile {
  FlowRows rows;
  ForceHeader header;
  std::string layout() const {
    return header.both ? (header.groups.size() > 2 ? "forces.dat with a porous part" : "forces.dat")
                       : (header.brackets ? "force.dat, vectors in brackets" : "force.dat, no brackets");
  }
};

/// Begins the rows below a head. Throws InputError where it is another head than the one above in the file.
void begin_run(const FlowLines& lines, const ForceHeader& header, std::vector<FlowPiece>& runs, ForceFile& file) {
  if (!header.known())
    throw InputError(lines.place(), "there is no header '# Time ...' above the numbers, which says what they are",
                     "give the file whole, as OpenFOAM wrote it");
  if (runs.empty()) file.header = header;
  if (!header.is_like(file.header))
    throw InputError({lines.path(), header.line, 1},
                     "a second head, which differs from that of line " + std::to_string(file.header.line) +
                         " in its columns or its CofR",
                     "give the runs of the file a folder each, named after the time of its start");
  begin_piece(lines, header.both ? 6 : 3, runs);
}

ForceFile read_force_file(const std::string& path, const std::string& quantity, const Place& place, FlowNotes& notes) {
  FlowLines lines(path, place);
  ForceHeader header;
  ForceFile file;
  FlowLine line;
  std::vector<FlowPiece> runs;
  std::string shape;
  for (int of_rows = -1; lines.next(notes);) {
    if (lines.line().front() == '#') {
      read_comment(lines, header, quantity);
      continue;
    }
    if (of_rows != header.line || !header.known()) {
      begin_run(lines, header, runs, file);
      shape = header.shape();
      of_rows = header.line;
    }
    read_line(lines, line);
    if (line.shape != shape)
      throw InputError(lines.place(),
                       "this row has " + std::to_string(line.numbers.size()) + " numbers as " + in_quotes(line.shape) +
                           ", its header asks for " + in_quotes(shape),
                       "is a column lost, or the row cut?");
    require_quantities(lines, line);
    add_row(lines, header, line, runs.back().rows);
  }
  file.rows = rows_of_file(std::move(runs), {path}, notes);
  return file;
}

/// Joins moments to forces, row by row; rows that only one file has, as where a run was interrupted, are left out.
void add_moments(const ForceFile& moments, const std::string& path, ForceFile& forces, FlowNotes& notes) {
  const std::size_t n = std::min(forces.rows.count(), moments.rows.count());
  for (std::size_t row = 0; row < n; ++row)
    if (forces.rows.time[row] != moments.rows.time[row])
      throw InputError({path},
                       "row " + std::to_string(row + 1) + " is of t = " + significant(moments.rows.time[row], 8) +
                           " s, the force beside it of t = " + significant(forces.rows.time[row], 8) + " s",
                       "give force.dat and moment.dat of one run");
  if (forces.header.centre != moments.header.centre)
    throw InputError({path}, "its CofR is not that of the forces", "give force.dat and moment.dat of one run");
  if (forces.rows.count() != moments.rows.count())
    notes.push_back("forces and moments have " + std::to_string(forces.rows.count()) + " and " +
                    std::to_string(moments.rows.count()) + " rows: " + std::to_string(n) + " are read");
  FlowRows both{6, {}, {}};
  for (std::size_t row = 0; row < n; ++row) {
    both.time.push_back(forces.rows.time[row]);
    for (const FlowRows* rows : std::array<const FlowRows*, 2>{&forces.rows, &moments.rows})
      for (std::size_t c = 0; c < 3; ++c) both.value.push_back(rows->at(row, c));
  }
  forces.rows = std::move(both);
}

/// Forces of one run with their moments, which may lie in a file beside them.
ForceFile read_run(const fs::path& path, const Place& place, FlowRecord& record) {
  ForceFile run = read_force_file(path.string(), "force", place, record.notes);
  record.files.push_back(path.string());
  const std::string name = path.filename().string();
  const fs::path moments = path.parent_path() / ("moment" + name.substr(std::string("force").size()));
  std::error_code ignored;
  if (run.header.both || !fs::is_regular_file(moments, ignored)) return run;
  const ForceFile beside = read_force_file(moments.string(), "moment", place, record.notes);
  record.files.push_back(moments.string());
  add_moments(beside, moments.string(), run, record.notes);
  return run;
}

void require_one_kind(const ForceFile& run, const ForceFile& first, const std::string& path) {
  if (run.rows.width != first.rows.width || run.header.centre != first.header.centre)
    throw InputError({path}, "the runs differ in their CofR, or not all have moments", "give runs of one kind");
}

/// The runs of one folder: force.dat, and force_0.8.dat where a run from 0.8 s found force.dat there.
ForceFile read_runs(const FlowFolder& folder, const std::string& file, const Place& place, FlowRecord& record) {
  std::optional<ForceFile> all;
  std::vector<FlowPiece> pieces;
  for (const std::string& name : runs_in(folder.path, file)) {
    const fs::path path = fs::path(folder.path) / name;
    ForceFile run = read_run(path, place, record);
    if (all) require_one_kind(run, *all, path.string());
    pieces.push_back({"the run in " + quoted_path(path.string()), run.rows, start_in(name)});
    if (!all) all = std::move(run);
  }
  all->rows = joined(without_repetitions(std::move(pieces), place, record.notes), record.notes);
  return std::move(*all);
}

}  // namespace

void read_openfoam_forces(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                          FlowRecord& record) {
  std::vector<FlowPiece> pieces;
  std::optional<ForceFile> first;
  for (const FlowFolder& folder : folders) {
    ForceFile read = read_runs(folder, file, place, record);
    if (first) require_one_kind(read, *first, (fs::path(folder.path) / file).string());
    pieces.push_back({"the run from " + folder.name + " s", read.rows});
    if (!first) first = std::move(read);
  }
  record.layout = "OpenFOAM forces (" + first->layout() + ")";
  const FlowRows rows = joined(std::move(pieces), record.notes);
  FlowForces& forces = record.forces.emplace();
  forces.time = rows.time;
  forces.centre = first->header.centre;
  for (std::size_t row = 0; row < rows.count(); ++row) {
    forces.force.push_back({rows.at(row, 0), rows.at(row, 1), rows.at(row, 2)});
    if (rows.width == 6) forces.moment.push_back({rows.at(row, 3), rows.at(row, 4), rows.at(row, 5)});
  }
}

}  // namespace upbead

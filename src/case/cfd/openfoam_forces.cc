// The four layouts of the function object `forces`. Source: output of OpenFOAM 1912, and for other versions the code
// that writes it (src/functionObjects/forces/forces/forces.C).
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

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

  bool known() const { return !groups.empty(); }
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

void read_comment(const FlowLines& lines, ForceHeader& header, const std::string& quantity) {
  std::string_view text = lines.line();
  text.remove_prefix(std::min(text.find_first_not_of("# \t"), text.size()));
  const std::string lower = lower_case(text.substr(0, 6));
  if (starts_with(text, "CofR")) {
    const std::vector<std::string> words = words_of(text, " \t():");
    Triple centre{};
    bool sound = words.size() == 4 && text.back() == ')';
    for (std::size_t i = 0; sound && i < 3; ++i) sound = read_number(words[i + 1], centre[i]);
    if (!sound)
      throw InputError(lines.place(), "the centre of the moments cannot be read: " + in_quotes(lines.line()),
                       "it is '# CofR : (x y z)'");
    header.centre = centre;
  } else if (starts_with(text, "Time")) {
    text.remove_prefix(4);
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    if (starts_with(text, "forces"))
      read_foundation_header(lines, text, header);
    else
      read_esi_header(lines, text, header);
  } else if ((starts_with(lower, "force") || starts_with(lower, "moment")) && !starts_with(lower, quantity)) {
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
    const double* vectors = line.numbers.data() + 1 + 3 * n * part;
    double size = 0.;
    for (std::size_t i = 0; i < 3 * n; ++i) size = std::max(size, std::abs(vectors[i]));
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = 0.;
      for (std::size_t g = first; g < n; ++g) sum += vectors[3 * g + i];
      constexpr double rounding = 1e-3;  // numbers are written with four digits or more
      if (first == 1 && std::abs(sum - vectors[i]) > rounding * size)
        throw InputError(lines.place(),
                         "total_" + std::string(1, "xyz"[i]) + " = " + significant(vectors[i], 6) +
                             " is not the sum of its parts, " + significant(sum, 6),
                         "is a column lost, or has one been exchanged?");
      rows.value.push_back(first == 1 ? vectors[i] : sum);
    }
  }
}

struct ForceFile {
  FlowRows rows;
  std::optional<Triple> centre;
  bool both = false;
  std::string layout;
};

ForceFile read_force_file(const std::string& path, const std::string& quantity, const Place& place, FlowNotes& notes) {
  FlowLines lines(path, place);
  ForceHeader header;
  ForceFile file;
  FlowLine line;
  std::string shape;
  while (lines.next(notes)) {
    if (lines.line().front() == '#') {
      read_comment(lines, header, quantity);
      continue;
    }
    if (!header.known())
      throw InputError(lines.place(), "there is no header '# Time ...' above the numbers, which says what they are",
                       "give the file whole, as OpenFOAM wrote it");
    if (shape.empty()) {
      shape = header.shape();
      file.rows.width = header.both ? 6 : 3;
      file.rows.time.reserve(lines.rows_left());
      file.rows.value.reserve(lines.rows_left() * file.rows.width);
    }
    read_line(lines, line);
    if (line.shape != shape)
      throw InputError(lines.place(),
                       "this row has " + std::to_string(line.numbers.size()) + " numbers as " + in_quotes(line.shape) +
                           ", its header asks for " + in_quotes(shape),
                       "is a column lost, or the row cut?");
    require_quantities(lines, line);
    add_row(lines, header, line, file.rows);
  }
  settle(file.rows, {path}, notes);
  file.centre = header.centre;
  file.both = header.both;
  file.layout = header.both ? (header.groups.size() > 2 ? "forces.dat with a porous part" : "forces.dat")
                            : (header.brackets ? "force.dat, vectors in brackets" : "force.dat, no brackets");
  return file;
}

/// Whether `all` holds every row of `some` unchanged.
bool holds(const FlowRows& all, const FlowRows& some) {
  for (std::size_t row = 0; row < some.count(); ++row) {
    const auto at = std::lower_bound(all.time.begin(), all.time.end(), some.time[row]);
    if (at == all.time.end() || *at != some.time[row]) return false;
    const auto same = static_cast<std::size_t>(at - all.time.begin());
    for (std::size_t c = 0; c < all.width; ++c)
      if (all.at(same, c) != some.at(row, c)) return false;
  }
  return true;
}

/// Where OpenFOAM starts again at the same time, it writes force_0.8.dat beside force.dat. A person must say which
/// run counts, unless one file holds all rows of the other.
ForceFile read_force_files(const FlowFolder& folder, const std::string& file, const std::string& quantity,
                           const Place& place, FlowRecord& record) {
  const std::string path = (fs::path(folder.path) / file).string();
  ForceFile read = read_force_file(path, quantity, place, record.notes);
  record.files.push_back(path);
  const fs::path second = fs::path(folder.path) / (fs::path(file).stem().string() + "_" + folder.name + ".dat");
  std::error_code ignored;
  if (!fs::is_regular_file(second, ignored)) return read;
  ForceFile other = read_force_file(second.string(), quantity, place, record.notes);
  record.files.push_back(second.string());
  const bool first_holds = read.rows.width == other.rows.width && holds(read.rows, other.rows);
  if (!first_holds && !(read.rows.width == other.rows.width && holds(other.rows, read.rows)))
    throw InputError(
        place,
        quoted_path(path) + " and " + quoted_path(second.string()) + " are of two runs with the same start, and differ",
        "remove the one that does not count, or name a file");
  record.notes.push_back("a second run from " + folder.name + " s, " + second.filename().string() +
                         ", says the same; the longer file is taken");
  return first_holds ? std::move(read) : std::move(other);
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
  if (forces.centre != moments.centre)
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

std::string moment_file(const std::string& file) {
  return "moment" + file.substr(std::string("force").size());
}

}  // namespace

void read_openfoam_forces(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                          FlowRecord& record) {
  std::vector<FlowPiece> pieces;
  std::optional<Triple> centre;
  for (const FlowFolder& folder : folders) {
    const std::string path = (fs::path(folder.path) / file).string();
    ForceFile read = read_force_files(folder, file, "force", place, record);
    const fs::path moments = fs::path(folder.path) / moment_file(file);
    std::error_code ignored;
    if (!read.both && fs::is_regular_file(moments, ignored))
      add_moments(read_force_files(folder, moment_file(file), "moment", place, record), moments.string(), read,
                  record.notes);
    if (!pieces.empty() && (read.rows.width != pieces.front().rows.width || read.centre != centre))
      throw InputError({path}, "the runs differ in their CofR, or not all have moments", "give runs of one kind");
    centre = read.centre;
    record.layout = "OpenFOAM forces (" + read.layout + ")";
    pieces.push_back({folder.name, std::move(read.rows)});
  }
  const FlowRows rows = joined(std::move(pieces), record.notes);
  FlowForces& forces = record.forces.emplace();
  forces.time = rows.time;
  forces.centre = centre;
  for (std::size_t row = 0; row < rows.count(); ++row) {
    forces.force.push_back({rows.at(row, 0), rows.at(row, 1), rows.at(row, 2)});
    if (rows.width == 6) forces.moment.push_back({rows.at(row, 3), rows.at(row, 4), rows.at(row, 5)});
  }
}

}  // namespace upbead

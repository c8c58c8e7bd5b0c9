// The function object `probes`: a file per field, its points in comments above the rows.
#include <cmath>
#include <filesystem>

#include "base/numbers.h"
#include "base/text.h"
#include "case/cfd/flow_text.h"
#include "case/cfd/openfoam.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

struct ProbeHead {
  std::vector<Triple> at;
  std::vector<bool> outside;  ///< of the mesh: by a line of the head, or by the values
  std::string coordinates;    ///< axes read so far, in the layout of older files: "xyz" when complete
};

struct ProbeFile {
  ProbeHead head;
  FlowRows rows;
};

[[noreturn]] void bad_head(const FlowLines& lines) {
  throw InputError(lines.place(), "this is no head line of OpenFOAM's probes that is known: " + in_quotes(lines.line()),
                   "it is '# Probe 0 (x y z)' of each probe, by ascending numbers");
}

/// "Probe 3 (x y z)  # Not Found".
void read_probe_line(const FlowLines& lines, std::string_view text, ProbeHead& file) {
  const bool not_found = text.find("Not Found") != std::string_view::npos;
  const std::size_t open = text.find('('), close = text.find(')');
  const std::vector<std::string> name = words_of(text.substr(0, open), " \t");
  const std::vector<std::string> place = words_of(text.substr(open + 1, close - open - 1), " \t");
  bool sound = close != std::string_view::npos && open < close && name.size() == 2 && place.size() == 3 &&
               name[1] == std::to_string(file.at.size());
  Triple at{};
  for (std::size_t i = 0; sound && i < 3; ++i) sound = read_number(place[i], at[i]) && std::abs(at[i]) < 1e50;
  if (!sound) bad_head(lines);
  file.at.push_back(at);
  file.outside.push_back(not_found);
}

/// "x 0 1 2": one coordinate of all probes, in older files.
void read_coordinate_line(const FlowLines& lines, const std::vector<std::string>& words, ProbeHead& file) {
  const std::size_t axis = std::string("xyz").find(words[0]), n = words.size() - 1;
  if (axis == 0) {
    file.at.assign(n, Triple{});
    file.outside.assign(n, false);
  }
  bool sound = n > 0 && n == file.at.size();
  for (std::size_t i = 0; sound && i < n; ++i)
    sound = read_number(words[i + 1], file.at[i][axis]) && std::abs(file.at[i][axis]) < 1e50;
  if (!sound) bad_head(lines);
}

void read_head(const FlowLines& lines, ProbeHead& head) {
  std::string_view text = lines.line();
  text.remove_prefix(std::min(text.find_first_not_of("# \t"), text.size()));
  const std::vector<std::string> words = words_of(text);
  if (words.empty()) return;
  if (words[0] == "x" || words[0] == "y" || words[0] == "z") {
    read_coordinate_line(lines, words, head);
    head.coordinates += words[0];
  } else if (words[0] == "Probe" && text.find('(') != std::string_view::npos) {
    read_probe_line(lines, text, head);
  } else if (words[0] != "Probe" && words[0] != "Time") {
    bad_head(lines);
  }
}

bool is_outside(double value) {
  return !(value > -largest_magnitude);  // OpenFOAM writes -1e300 or -1.8e307, depending on the version
}

void add_probe_row(const FlowLines& lines, const FlowLine& line, ProbeHead& head, FlowRows& rows) {
  if (line.shape.find('(') != std::string::npos)
    throw InputError(lines.place(), "the field is one of vectors", "name the file of a pressure, p or p_rgh");
  if (line.numbers.size() != rows.width + 1)
    throw InputError(lines.place(),
                     "this row has " + std::to_string(line.numbers.size()) + " numbers; a time and " +
                         std::to_string(rows.width) + " probes are asked for by the head",
                     "is a column or a line of the head lost, or the row cut?");
  rows.time.push_back(line.numbers[0]);
  for (std::size_t p = 0; p < rows.width; ++p) {
    const double value = line.numbers.at(p + 1);
    const bool outside = is_outside(value);
    if (rows.count() == 1 && outside) head.outside.at(p) = true;
    if (outside != head.outside.at(p))
      throw InputError(
          lines.place(),
          "probe " + std::to_string(p) + " lies outside the mesh at some times only: " + significant(value),
          "leave the probe out of the file, or place it where the mesh always is");
    if (!outside && (is_too_large(value) || !std::isfinite(value)))
      throw InputError(lines.place(),
                       "the value " + significant(value) + " of probe " + std::to_string(p) +
                           " is larger than any quantity in SI units",
                       "did the run fail there? cut the file before");
    rows.value.push_back(outside ? 0. : value);
  }
}

/// Begins the rows below a head; `heads`: those above in the file.
void begin_run(const FlowLines& lines, const ProbeHead& head, std::vector<ProbeHead>& heads,
               std::vector<FlowPiece>& runs) {
  if (head.at.empty() || (!head.coordinates.empty() && head.coordinates != "xyz"))
    throw InputError(lines.place(), "the head does not say where the probes are: no '# Probe 0 (x y z)'",
                     "give the file whole, as OpenFOAM wrote it");
  if (!heads.empty() && head.at != heads.front().at)
    throw InputError(lines.place(), "a second head above this row, with other probes than the first",
                     "give the runs of the file a folder each, named after the time of its start");
  heads.push_back(head);
  begin_piece(lines, head.at.size(), runs);
}

ProbeFile read_probe_file(const std::string& path, const Place& place, FlowNotes& notes) {
  FlowLines lines(path, place);
  std::vector<ProbeHead> heads;
  std::vector<FlowPiece> runs;
  ProbeHead head;
  FlowLine line;
  for (bool in_head = true; lines.next(notes);) {
    if (const std::size_t first = lines.line().find_first_not_of(" \t"); lines.line()[first] == '#') {
      if (lines.line().find_first_not_of("# \t") == std::string_view::npos) continue;
      if (!in_head) head = {};
      in_head = true;
      read_head(lines, head);
      continue;
    }
    if (in_head) begin_run(lines, head, heads, runs);
    in_head = false;
    read_line(lines, line);
    if (!line.numbers.empty() && !std::isfinite(line.numbers[0])) require_quantities(lines, line);
    add_probe_row(lines, line, heads.back(), runs.back().rows);
  }
  for (const ProbeHead& other : heads)
    if (other.outside != heads.front().outside)
      throw InputError({path}, "a second head: its probes outside the mesh are not those of the run above it",
                       "give the runs of the file a folder each, named after the time of its start");
  FlowRows rows = rows_of_file(std::move(runs), {path}, notes);
  return {heads.front(), std::move(rows)};
}

/// Keeps only the probes that lie in the mesh.
void keep_inside(const ProbeHead& file, const FlowRows& rows, FlowRecord& record) {
  FlowPoints& points = *record.points;
  std::vector<std::size_t> inside;
  for (std::size_t p = 0; p < file.at.size(); ++p) {
    const std::string name = "probe" + std::to_string(p);
    if (file.outside[p]) {
      record.notes.push_back("probe " + std::to_string(p) + " at (" + significant(file.at[p][0], 6) + " " +
                             significant(file.at[p][1], 6) + " " + significant(file.at[p][2], 6) +
                             ") lies outside the mesh (Not Found): left out");
      continue;
    }
    inside.push_back(p);
    points.name.push_back(name);
    points.at.push_back(file.at[p]);
  }
  points.rows = {inside.size(), rows.time, {}};
  points.rows.value.reserve(inside.size() * rows.count());
  for (std::size_t row = 0; row < rows.count(); ++row)
    for (const std::size_t p : inside) points.rows.value.push_back(rows.at(row, p));
}

}  // namespace

void read_openfoam_probes(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                          FlowRecord& record) {
  std::vector<FlowPiece> pieces;
  ProbeHead first;
  for (const FlowFolder& folder : folders) {
    const std::string path = (fs::path(folder.path) / file).string();
    ProbeFile read = read_probe_file(path, place, record.notes);
    record.files.push_back(path);
    if (pieces.empty()) first = read.head;
    if (read.head.at != first.at || read.head.outside != first.outside)
      throw InputError({path}, "its probes are not those of the run before", "give runs of the same probes");
    pieces.push_back({"the run from " + folder.name + " s", std::move(read.rows)});
  }
  record.layout = "OpenFOAM probes of " + file;
  const FlowRows rows = joined(std::move(pieces), record.notes);
  record.points.emplace();
  record.points->field = file;
  keep_inside(first, rows, record);
  if (record.points->at.empty())
    throw InputError(place, "no probe of " + quoted_path(record.path) + " lies in the mesh", "move the probes");
}

}  // namespace upbead

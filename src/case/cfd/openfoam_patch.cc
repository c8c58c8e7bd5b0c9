// Sampled patches in a folder per time: face centres or corners and values; FIELD_SURFACE.raw, or SURFACE.xy.
#include "case/cfd/openfoam_patch.h"

#include <cmath>
#include <filesystem>

#include "base/text.h"
#include "case/cfd/flow_text.h"
#include "case/cfd/openfoam.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

struct RawFile : PatchFile {
  std::optional<std::size_t> count;  ///< as the head gives it
  bool named = false;                ///< the head has named the columns
};

bool read_count(const std::string& word, RawFile& file) {
  double number = 0.;
  if (!read_number(word, number) || !(number >= 1.) || number > 1e9 || number != std::floor(number)) return false;
  file.count = static_cast<std::size_t>(number);
  return true;
}

/// "p  FACE_DATA 20", then "x  y  z  p"; older files have the number on a line of its own.
void read_patch_head(const FlowLines& lines, RawFile& file) {
  const std::vector<std::string> words = words_of(lines.line(), "# \t");
  if (words.empty()) return;
  bool sound = false;
  if (!file.at.empty())
    throw InputError(lines.place(), "a second head", "give a file for each time, as OpenFOAM wrote it");
  if (words.size() >= 2 && words.size() <= 3 && (words[1] == "FACE_DATA" || words[1] == "POINT_DATA")) {
    file.field = words[0];
    file.vertices = words[1] == "POINT_DATA";
    file.faces = !file.vertices;
    sound = words.size() == 2 || read_count(words[2], file);
  } else if (words.size() == 1) {
    sound = !file.field.empty() && !file.count && read_count(words[0], file);
  } else {
    sound = words.size() == 4 && words[0] == "x" && words[1] == "y" && words[2] == "z" && words[3] == file.field;
    file.named = sound;
  }
  if (!sound)
    throw InputError(lines.place(), "this is no head line of a sampled patch that is known: " + in_quotes(lines.line()),
                     "it is '# p  FACE_DATA 20' and '# x y z p' of a scalar field");
}

PatchFile read_raw_file(const std::string& path, const Place& place, FlowNotes& notes) {
  FlowLines lines(path, place);
  RawFile file;
  FlowLine line;
  while (lines.next(notes)) {
    if (lines.line().front() == '#') {
      read_patch_head(lines, file);
      continue;
    }
    read_line(lines, line);
    if (!file.count && !file.field.empty() && line.shape == "n" && read_count(words_of(lines.line())[0], file))
      continue;
    if (!file.count || !file.named)
      throw InputError(lines.place(), "there is no head '# FIELD FACE_DATA N' and '# x y z FIELD' above the numbers",
                       "give the file whole, as OpenFOAM wrote it");
    if (line.shape != "nnnn")
      throw InputError(
          lines.place(),
          "this row has " + std::to_string(line.numbers.size()) + " numbers in place of x, y, z and " + file.field,
          "is a column lost, or the row cut?");
    require_quantities(lines, line);
    file.at.push_back({line.numbers.at(0), line.numbers.at(1), line.numbers.at(2)});
    file.value.push_back(line.numbers.at(3));
  }
  if (!file.count || file.at.size() != *file.count)
    throw InputError({path},
                     std::to_string(file.at.size()) + " rows of values; the head tells of " +
                         (file.count ? std::to_string(*file.count) : "none"),
                     "give the file whole, as OpenFOAM wrote it");
  return file;
}

/// Whether points have moved by more than the rounding to six digits.
bool moved(const std::vector<Triple>& a, const std::vector<Triple>& b) {
  if (a.size() != b.size()) return true;
  double size = 0., most = 0.;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t d = 0; d < 3; ++d) {
      size = std::max(size, std::abs(a[i][d]));
      most = std::max(most, std::abs(a[i][d] - b[i][d]));
    }
  return most > 2e-5 * size;
}

}  // namespace

void read_openfoam_patch(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
                         FlowRecord& record) {
  FlowPoints& points = record.points.emplace();
  std::vector<std::string> without;
  const bool is_xy = fs::path(file).extension() == ".xy";
  for (const FlowFolder& folder : folders) {
    const std::string path = (fs::path(folder.path) / file).string();
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
      without.push_back(folder.name);
      continue;
    }
    const PatchFile read = is_xy ? read_xy_file(path, place, record.notes) : read_raw_file(path, place, record.notes);
    record.files.push_back(path);
    if (points.at.empty()) {
      points.field = read.field;
      points.are_faces = read.faces;
      points.are_vertices = read.vertices;
      points.at = read.at;
      points.rows.width = read.at.size();
    }
    if (read.field != points.field || read.vertices != points.are_vertices || read.faces != points.are_faces ||
        moved(points.at, read.at))
      throw InputError({path}, "its points or its field are not those of the first time",
                       "a patch that moves, or whose mesh changes, is not read: sample it on a fixed surface");
    points.rows.time.push_back(folder.start);
    points.rows.value.insert(points.rows.value.end(), read.value.begin(), read.value.end());
  }
  if (!without.empty())
    record.notes.push_back(std::to_string(without.size()) + " folders of times are without " + file + ", the first " +
                           without.front());
  const std::string kind = points.are_faces ? "face" : "point";
  for (std::size_t i = 0; i < points.at.size(); ++i) points.name.push_back((is_xy ? kind : "face") + std::to_string(i));
  settle(points.rows, {record.path}, record.notes);
  record.layout = "OpenFOAM sampled patch (" + std::string(is_xy ? "xy, " : "raw, ") + kind + "s) of " + points.field;
}

}  // namespace upbead

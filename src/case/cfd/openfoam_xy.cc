// Surfaces and sets in .xy: columns of places and fields, named above them. Source: output of OpenFOAM 9 to 11, and the
// code that writes it (src/sampling/sampledSet/writers: setWriter.C, raw/rawSetWriter.C). Older sets have no head.
#include <algorithm>
#include <filesystem>

#include "base/text.h"
#include "case/cfd/flow_text.h"
#include "case/cfd/openfoam_patch.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

struct XyColumns {
  std::vector<std::string> name;
  std::size_t place = 0, field = 0;  ///< of x, and of the field
};

[[noreturn]] void without_places(const FlowLines& lines, const std::string& what) {
  throw InputError(
      lines.place(), "a sampled set of OpenFOAM " + what + ": where its points are is not in it",
      "write it with axis xyz, so that its columns are x y z and the pressure, or sample the wall's patch: "
      "function object surfaces, surfaceFormat raw");
}

/// Columns by the head: x y z, of version 11 face_x face_y face_z or point_x ..., perhaps behind a distance; fields.
XyColumns columns_by_head(const FlowLines& lines, PatchFile& file, FlowNotes& notes) {
  XyColumns columns;
  columns.name = words_of(lines.line(), "# \t\"");
  const std::vector<std::string>& names = columns.name;
  const auto begins = [&](std::size_t at, const std::string& stem) {
    for (std::size_t d = 0; d < 3; ++d)
      if (at + d >= names.size() || names[at + d] != stem + "xyz"[d]) return false;
    columns.place = at;
    return true;
  };
  const auto stands = [&](const std::string& stem) { return begins(0, stem) || begins(1, stem); };
  file.faces = stands("face_");
  file.vertices = !file.faces && stands("point_");
  if (!file.faces && !file.vertices && !stands("")) without_places(lines, "with the columns " + join(names));
  const std::vector<std::string> fields(names.begin() + static_cast<std::ptrdiff_t>(columns.place) + 3, names.end());
  auto field = std::find(fields.begin(), fields.end(), "p");
  if (field == fields.end()) field = std::find(fields.begin(), fields.end(), "p_rgh");
  if (field == fields.end() && fields.size() == 1) field = fields.begin();
  if (field == fields.end())
    throw InputError(lines.place(), "none of the fields " + join(fields) + " is a pressure, p or p_rgh",
                     "sample p: fields (p);");
  file.field = *field;
  columns.field = columns.place + 3 + static_cast<std::size_t>(field - fields.begin());
  for (const std::string& other : fields)
    if (other != file.field)
      notes.push_back("of the fields of " + excerpt(lines.path()) + ", " + other + " is left out");
  return columns;
}

/// Columns of a set without a head: SET_p.xy with x, y, z and p.
XyColumns columns_by_name(const FlowLines& lines, const FlowLine& line, PatchFile& file) {
  const std::string stem = fs::path(lines.path()).stem().string();
  for (const char* field : {"p_rgh", "p"}) {
    const std::string ending = std::string("_") + field;
    if (stem.size() > ending.size() && stem.substr(stem.size() - ending.size()) == ending) {
      file.field = field;
      break;
    }
  }
  if (file.field.empty() || line.shape != "nnnn")
    without_places(lines, "with " + std::to_string(line.numbers.size()) + " columns and no head");
  return {{"x", "y", "z", file.field}, 0, 3};
}

}  // namespace

PatchFile read_xy_file(const std::string& path, const Place& place, FlowNotes& notes) {
  FlowLines lines(path, place);
  PatchFile file;
  XyColumns columns;
  FlowLine line;
  while (lines.next(notes)) {
    if (lines.line().front() == '#') {
      if (!columns.name.empty())
        throw InputError(lines.place(), "a second head", "give a file for each time, as OpenFOAM wrote it");
      columns = columns_by_head(lines, file, notes);
      continue;
    }
    read_line(lines, line);
    if (columns.name.empty()) columns = columns_by_name(lines, line, file);
    if (line.shape != std::string(columns.name.size(), 'n'))
      throw InputError(
          lines.place(),
          "this row has " + std::to_string(line.numbers.size()) + " numbers in place of " + join(columns.name),
          "is a column lost, or the row cut?");
    require_quantities(lines, line);
    const std::size_t at = columns.place;
    file.at.push_back({line.numbers.at(at), line.numbers.at(at + 1), line.numbers.at(at + 2)});
    file.value.push_back(line.numbers.at(columns.field));
  }
  if (file.at.empty()) throw InputError({path}, "no row of numbers", "give the file whole, as OpenFOAM wrote it");
  return file;
}

}  // namespace upbead

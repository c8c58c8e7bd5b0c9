// Outputs of OpenFOAM that are met often and are no load: what they are, and what to write instead. Source: output of
// OpenFOAM 1912, and the code that writes it (src/functionObjects/{field, forces}).
#include <algorithm>
#include <array>
#include <filesystem>

#include "base/text.h"
#include "case/cfd/flow_text.h"
#include "case/cfd/openfoam.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// `mark`: how the name of such a file or a line of its head begins.
struct OtherOutput {
  std::array<const char*, 4> mark;
  const char *what, *instead;
};

const char* const write_forces = "function object forces of the wall's patch";
const char* const write_patch = "function object surfaces of the wall's patch with surfaceFormat raw and fields (p)";

constexpr std::array<OtherOutput, 3> others{
    {{{"coefficient", "forceCoeffs", "Force coefficients", "Force and moment coefficients"},
      "coefficients of the forces, without unit (forceCoeffs)",
      "function object forces of the same patches"},
     {{"surfaceFieldValue", "volFieldValue", "Region type", "faceSource"},
      "one number for a whole region, without its moment (surfaceFieldValue or the like)",
      "function object forces of the patch, or surfaces with surfaceFormat raw and fields (p)"},
     {{"height.dat", "position.dat", "Location", "hB"},
      "heights of the water's surface at places, no pressure and no force (interfaceHeight)",
      "function object forces of the wall's patch, or probes of p along it"}}};

/// Endings of surfaces and sets in other formats.
bool is_other_format(const std::string& name) {
  static const std::array<const char*, 14> endings{".vtk", ".vtp", ".vtu", ".vtm", ".pvd", ".csv",   ".case",
                                                   ".obj", ".stl", ".ply", ".dx",  ".agr", ".jplot", ".gplt"};
  const std::string ending = fs::path(name).extension().string();
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

/// The comments above the first row, without their marks.
std::vector<std::string> head_of(const std::string& path, const Place& place) {
  FlowLines lines(path, place);
  FlowNotes ignored;
  std::vector<std::string> head;
  while (lines.next(ignored)) {
    const std::string_view line = lines.line();
    const std::size_t first = line.find_first_not_of(" \t");
    if (line[first] != '#') break;
    const std::size_t begin = line.find_first_not_of("# \t", first);
    if (begin != std::string_view::npos) head.emplace_back(line.substr(begin));
  }
  return head;
}

}  // namespace

void refuse_other_output(const std::string& path, const Place& place) {
  const std::string name = fs::path(path).filename().string();
  const auto refuse = [&](const std::string& what, const std::string& instead) {
    throw InputError(place, quoted_path(path) + " holds " + what, "write in the CFD run: " + instead);
  };
  if (is_other_format(name)) refuse("a sampled surface or set in a format that is not read", write_patch);
  const bool is_force = starts_with(name, "force") && !starts_with(name, "forceCoeff");
  if (fs::path(name).extension() != ".dat" || is_force) return;
  const std::vector<std::string> head = head_of(path, place);
  const auto begins = [&head](const char* mark) {
    return std::find_if(head.begin(), head.end(), [mark](const std::string& line) { return starts_with(line, mark); });
  };
  for (const OtherOutput& other : others)
    for (const char* mark : other.mark)
      if (starts_with(name, mark) || begins(mark) != head.end()) refuse(other.what, other.instead);
  if (const auto columns = begins("Time"); columns != head.end() && begins("Probe") == head.end())
    refuse("a table of OpenFOAM that is neither of forces nor of probes: " + in_quotes(*columns),
           std::string(write_forces) + ", probes of p, or " + write_patch);
}

}  // namespace upbead

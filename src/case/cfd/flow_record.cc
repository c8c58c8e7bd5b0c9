#include "case/cfd/flow_record.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/text.h"
#include "case/cfd/flow_tables.h"
#include "case/cfd/flow_text.h"
#include "case/cfd/openfoam.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

constexpr std::size_t most_folders = 100'000;

bool is_time(const std::string& name, double& start) {
  return read_number(name, start) && std::isfinite(start);
}

bool is_patch(const std::string& name) {
  return fs::path(name).extension() == ".raw" || fs::path(name).extension() == ".xy";
}

bool is_force(const std::string& name) {
  return name == "forces.dat" ||
         (starts_with(name, "force") && !starts_with(name, "forceCoeff") && fs::path(name).extension() == ".dat");
}

/// "force.dat" of force_0.8.dat.
std::string without_start(const std::string& name) {
  return start_in(name) ? name.substr(0, name.rfind('_')) + ".dat" : name;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// Names of those files in the folders that may be the record. Moments are read with their forces, and force_0.8.dat
/// with force.dat.
std::set<std::string> candidates(const std::vector<FlowFolder>& folders) {
  std::set<std::string> names;
  for (const FlowFolder& folder : folders) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path, error))
      if (const std::string name = entry.path().filename().string();
          entry.is_regular_file(error) && name[0] != '.' && !starts_with(name, "moment"))
        names.insert(without_start(name));
  }
  return names;
}

/// Leaves out files that hold neither forces nor pressures at points. Throws InputError about the first where no other
/// is left.
std::set<std::string> without_others(const std::set<std::string>& names, const std::vector<FlowFolder>& folders,
                                     const Place& place) {
  std::set<std::string> rest;
  std::optional<InputError> first;
  for (const std::string& name : names) {
    const auto has = [&](const FlowFolder& folder) { return is_file(fs::path(folder.path) / name); };
    const auto folder = std::find_if(folders.begin(), folders.end(), has);
    try {
      if (folder != folders.end()) refuse_other_output((fs::path(folder->path) / name).string(), place);
      rest.insert(name);
    } catch (const InputError& error) {
      if (!first) first = error;
    }
  }
  if (rest.empty() && first) throw *first;
  return rest;
}

std::vector<std::string> subfolders(const std::string& path) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error))
    if (entry.is_directory(error)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  if (names.size() > 10) names.resize(10);
  return names;
}

/// Tells of later runs beside a folder of one run, which was named in place of the folder above.
void note_other_starts(const fs::path& folder, const std::string& file, FlowNotes& notes) {
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error).lexically_normal();
  const fs::path named = whole.filename().empty() ? whole.parent_path() : whole;
  double start = 0.;
  if (!is_time(named.filename().string(), start)) return;
  std::vector<std::string> others;
  for (const FlowFolder& other : time_folders(named.parent_path().string()))
    if (other.start > start && !runs_in(other.path, file).empty()) others.push_back(other.name);
  if (!others.empty())
    notes.push_back("of the runs beside it, from " + join(others) + " s, nothing is read: name the folder above, " +
                    quoted_path(named.parent_path().filename().string()) + ", to join them");
}

void read_kind(const std::vector<FlowFolder>& folders, const std::string& file, const Place& place,
               FlowRecord& record) {
  if (is_patch(file))
    read_openfoam_patch(folders, file, place, record);
  else if (is_force(file))
    read_openfoam_forces(folders, file, place, record);
  else
    read_openfoam_probes(folders, file, place, record);
}

void read_folder(const std::string& path, const std::string& file, const Place& place, FlowRecord& record) {
  std::vector<FlowFolder> folders = time_folders(path);
  if (folders.size() > most_folders)
    throw InputError(place, std::to_string(folders.size()) + " folders of times, more than any record has",
                     "name the folder of one function object, thinned");
  if (folders.empty()) folders.push_back({fs::path(path).filename().string(), path, 0.});
  const std::set<std::string> found = candidates(folders);
  if (found.empty())
    throw InputError(place, quoted_path(path) + " is a folder without folders of times or files of OpenFOAM",
                     subfolders(path).empty() ? "name the folder of a function object, such as postProcessing/forces"
                                              : "name one of its folders: " + join(subfolders(path)));
  const auto has_file = [&file](const FlowFolder& folder) { return is_file(fs::path(folder.path) / file); };
  const bool is_named = !file.empty() && std::any_of(folders.begin(), folders.end(), has_file);
  const std::set<std::string> names = without_others(is_named ? std::set<std::string>{file} : found, folders, place);
  if (!file.empty() && !is_named && names.count(file) == 0)
    throw InputError(place, "no folder of times in " + quoted_path(path) + " has a file " + in_quotes(file),
                     suggestion(file, {names.begin(), names.end()}, "files"));
  if (file.empty() && names.size() > 1)
    throw InputError(place, quoted_path(path) + " holds more than one record",
                     "add file = one of: " + join({names.begin(), names.end()}));
  const std::string meant = file.empty() ? *names.begin() : file;
  if (is_patch(meant) && time_folders(path).empty())
    throw InputError(place, quoted_path(path) + " holds a patch at one time only", "name the folder above it");
  std::vector<FlowFolder> with;  // folders with rows: a run that ended before its first row has left none
  for (const FlowFolder& folder : folders)
    if (is_patch(meant) || !runs_in(folder.path, meant).empty())
      with.push_back(folder);
    else
      record.notes.push_back("the folder " + folder.name + " has no " + meant);
  read_kind(with, meant, place, record);
  note_other_starts(path, meant, record.notes);
}

/// The first line that is not blank.
std::string first_line(const std::string& path, const Place& place) {
  FlowLines lines(path, place);
  FlowNotes ignored;
  if (!lines.next(ignored)) throw InputError({path}, "no whole line of text", "is it the right file?");
  return std::string(lines.line());
}

void read_file_of_flow(const std::string& path, const Place& place, FlowRecord& record) {
  const fs::path file(path);
  const std::string line = first_line(path, place), name = file.filename().string();
  const std::string folder = file.parent_path().empty() ? "." : file.parent_path().string();
  const std::vector<FlowFolder> alone{{file.parent_path().filename().string(), folder, 0.}};
  const bool is_comment = line[line.find_first_not_of(" \t")] == '#';
  if (is_comment) refuse_other_output(path, place);
  if (is_dualsphysics(line))
    read_dualsphysics(path, place, record);
  else if (is_proteus(line))
    read_proteus(path, place, record);
  else if (is_patch(name))
    throw InputError(place, quoted_path(path) + " is a patch at one time only",
                     "name the folder above the folders of the times, and file = \"" + name + "\"");
  else if (is_comment) {
    read_kind(alone, name, place, record);
    note_other_starts(folder, name, record.notes);
  } else if (!read_swash(path, place, record))
    throw InputError(place,
                     quoted_path(path) + " is none of the layouts that are known; it begins with " + in_quotes(line),
                     "they are those of OpenFOAM (forces, probes, raw patches), DualSPHysics, Proteus, and SWASH with "
                     "its file INPUT beside the table; a plain table is read by history or gauges");
}

}  // namespace

std::vector<FlowFolder> time_folders(const std::string& path) {
  std::vector<FlowFolder> folders;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
    FlowFolder folder{entry.path().filename().string(), entry.path().string(), 0.};
    if (entry.is_directory(error) && is_time(folder.name, folder.start)) folders.push_back(folder);
  }
  std::sort(folders.begin(), folders.end(), [](const FlowFolder& a, const FlowFolder& b) {
    return std::pair(a.start, a.name) < std::pair(b.start, b.name);
  });
  return folders;
}

std::optional<double> start_in(const std::string& name) {
  const std::string stem = fs::path(name).stem().string();
  const std::size_t at = stem.rfind('_');
  double start = 0.;
  const bool may = at != std::string::npos && (is_force(name) || starts_with(name, "moment"));
  return may && is_time(stem.substr(at + 1), start) ? std::optional(start) : std::nullopt;
}

std::vector<std::string> runs_in(const std::string& folder, const std::string& file) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (const std::string name = entry.path().filename().string();
        entry.is_regular_file(error) && (name == file || (start_in(name) && without_start(name) == file)))
      names.push_back(name);
  const auto before = [](const std::string& a, const std::string& b) {
    return std::pair(start_in(a), a) < std::pair(start_in(b), b);
  };
  std::sort(names.begin(), names.end(), before);
  return names;
}

const std::vector<double>& FlowRecord::time() const {
  return forces ? forces->time : points ? points->rows.time : level->time;
}

FlowRecord read_flow(const std::string& path, const std::string& file, const Place& place) {
  FlowRecord record;
  record.path = path;
  std::error_code error;
  if (fs::is_directory(path, error)) {
    read_folder(path, file, place, record);
    return record;
  }
  if (!file.empty())
    throw InputError(place, "'file' belongs to a folder, and " + quoted_path(path) + " is none", "remove it");
  read_file_of_flow(path, place, record);
  return record;
}

std::vector<FlowColumn> columns_of(const FlowRecord& record) {
  std::vector<FlowColumn> columns{{"time", "s", record.time()}};
  const auto add_vectors = [&columns](const std::string& name, const std::string& unit,
                                      const std::vector<Triple>& list) {
    for (std::size_t d = 0; d < 3; ++d) {
      columns.push_back({name + "_" + "xyz" [d], unit, {}});
      for (const Triple& vector : list) columns.back().value.push_back(vector[d]);
    }
  };
  if (record.forces) {
    add_vectors("force", "N", record.forces->force);
    if (!record.forces->moment.empty()) add_vectors("moment", "N m", record.forces->moment);
  }
  for (std::size_t p = 0; record.points && p < record.points->at.size(); ++p)
    columns.push_back({record.points->name[p], record.points->unit, record.points->rows.column(p)});
  if (record.level) {
    columns.push_back({"water_level", "m", record.level->level});
    columns.push_back({"depth", "m", record.level->depth});
  }
  return columns;
}

std::string text_of(const FlowRecord& record) {
  const std::vector<double>& time = record.time();
  std::string text = "layout      " + record.layout + "\nread        " + std::to_string(record.files.size()) +
                     (record.files.size() == 1 ? " file" : " files") + ", " + std::to_string(time.size()) +
                     " rows from t = " + significant(time.front(), 6) + " to " + significant(time.back(), 6) + " s\n";
  if (record.forces) {
    text += "forces      in N of the thickness that was computed, along x, y, z";
    if (const auto& c = record.forces->centre; c && !record.forces->moment.empty())
      text += "; moments about (" + significant((*c)[0], 6) + " " + significant((*c)[1], 6) + " " +
              significant((*c)[2], 6) + ")";
    text += record.forces->moment.empty() ? "; no moments\n" : "\n";
  }
  if (record.points)
    text += "points      " + std::to_string(record.points->at.size()) + " of " + record.points->field + "\n";
  if (record.level)
    text += "level       of the water, with still water at " + significant(record.level->still) + " m and the bed at " +
            significant(record.level->level[0] - record.level->depth[0], 6) + " m\n";
  for (const std::string& note : record.notes) text += "note        " + note + "\n";
  return text;
}

}  // namespace upbead

#include "study/soil_families.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "base/progress.h"
#include "base/text.h"
#include "case/case_run.h"
#include "case/script_trust.h"
#include "soils/soil_model.h"
#include "study/results.h"
#include "study/shared_files.h"
#include "upbead/base/error.h"

namespace fs = std::filesystem;

namespace upbead {

namespace {

/// Soils that may become points of the basis: enough to see the corners of a box of a dozen keys.
constexpr std::size_t most_candidates = 24;

/// Share of the tolerance that the estimates of candidates may reach. Estimates are several times the errors, which
/// must meet share_of_tolerance before a soil becomes a point: two points more cost what four soils cost that are
/// solved by themselves, as their own estimates exceed the tolerance.
constexpr double share_of_estimates = 0.8;

bool is_of_soil(const std::string& key) {
  return is_of_region(key) || key == "fluid.bulk_modulus";
}

/// Settings that change no System, but the course of loads and what is said of the answer.
bool is_of_waves(const std::string& key) {
  return starts_with(key, "loads.") || starts_with(key, "sliding.") || starts_with(key, "limits.") || key == "title";
}

/// The settings with one kind of key, as a text.
template <class Kind>
std::string settings_of(const StudyRun& run, const Kind& is_of_kind) {
  std::string text;
  for (const auto& [key, value] : run.settings)
    if (is_of_kind(key)) text += key + "=" + value + "\n";
  return text;
}

std::string soil_of(const StudyRun& run) {
  return settings_of(run, is_of_soil);
}

/// At most `most` of a list, evenly spaced.
std::vector<int> thinned(const std::vector<int>& list, std::size_t most) {
  if (list.size() <= most) return list;
  std::vector<int> few;
  for (std::size_t i = 0; i < most; ++i) few.push_back(list[i * list.size() / most]);
  return few;
}

Case case_of(const Study& study, int run) {
  const StudyRun& of = study.runs[static_cast<std::size_t>(run)];
  return read_case(study.cases[static_cast<std::size_t>(of.case_index)], overrides_of(of));
}

/// What a file of families was made for.
std::string made_for(const Study& study, std::size_t group) {
  return std::to_string(study.fingerprint) + " group " + std::to_string(group);
}

std::string path_of(const std::string& folder, std::size_t group, const char* ending) {
  return (journal_folder(folder) / ("soils-" + std::to_string(group) + ending)).string();
}

bool has_run_of(const std::vector<std::vector<int>>& pieces, const std::vector<int>& group) {
  return std::any_of(pieces.begin(), pieces.end(), [&group](const std::vector<int>& piece) {
    return std::find_first_of(piece.begin(), piece.end(), group.begin(), group.end()) != piece.end();
  });
}

/// Numbers, or beginnings of their paths, that follow from what a family holds: held_readings().
bool follows_from_held(const std::string& path) {
  static const std::vector<std::string> beginnings{"sliding.",
                                                   "base.",
                                                   "response.peak_shear",
                                                   "response.peak_force",
                                                   "response.peak_displacement",
                                                   "response.shear_to_force_ratio"};
  if (starts_with(path, "base.peak_computed_pressure")) return false;  // of single nodes
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&path](const std::string& beginning) { return starts_with(path, beginning); });
}

/// The first number that is read of which a family's estimate says nothing; "": none.
std::string read_beside_held(const Study& study) {
  const auto other = std::find_if_not(study.reads.begin(), study.reads.end(), follows_from_held);
  return other == study.reads.end() ? "" : *other;
}

/// The family of a group; or why it has none.
SoilFamilyRead family_of(const Study& study, const std::vector<int>& group, bool trusts_scripts,
                         const std::function<void(double)>& progress) {
  if (const std::string other = read_beside_held(study); !other.empty())
    return {{},
            "'" + other +
                "' is read, and one model of all soils holds F_T, S, the caisson's displacement and what "
                "presses on its base to the tolerance, and no more"};
  try {
    const Case problem = case_of(study, group.front());
    require_trust(problem, trusts_scripts);
    require_loads(problem);
    if (!problem.scene.mesh.refine) return {{}, "its mesh is made for it by its tolerance"};
    const Simulation first = first_of_soils(study, group, nullptr);
    for (const Diagnostic& reason : why_no_soils(first)) return {{}, reason.place.key + ": " + reason.what};
    std::vector<Scene> soils;
    for (const int i : thinned(group, most_candidates)) soils.push_back(scene_on(case_of(study, i), *first.mesh()));
    SoilModelOptions options;
    options.tolerance = share_of_tolerance * problem.scene.tolerance;
    options.of_estimates = share_of_estimates * problem.scene.tolerance;
    options.progress = progress;
    return {make_soils(first, soils, options).family, ""};
  } catch (const InputError& error) {
    return {{}, error.diagnostics().list().front().what};
  } catch (const NumericsError& error) {
    return {{}, error.what()};
  }
}

}  // namespace

bool is_of_region(const std::string& key) {
  return starts_with(key, "regions.");
}

std::vector<std::vector<int>> soil_groups(const Study& study) {
  if (study.share != StudyShare::soils) return {};
  std::map<std::string, std::vector<int>> of_rest;
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const StudyRun& run = study.runs[i];
    const std::string rest =
        settings_of(run, [](const std::string& key) { return !is_of_soil(key) && !is_of_waves(key); });
    of_rest[std::to_string(run.case_index) + "\n" + rest].push_back(static_cast<int>(i));
  }
  std::vector<std::vector<int>> groups;
  for (auto& entry : of_rest) {
    std::set<std::string> soils;
    for (const int i : entry.second) soils.insert(soil_of(study.runs[static_cast<std::size_t>(i)]));
    if (soils.size() >= least_soils) groups.push_back(std::move(entry.second));
  }
  return groups;
}

Simulation first_of_soils(const Study& study, const std::vector<int>& group, const std::shared_ptr<const Mesh>& mesh) {
  return simulation_with_all_cells(case_of(study, group.front()), mesh);
}

SoilFamilyRead read_soil_family(const Study& study, std::size_t group, const std::string& folder) {
  if (std::ifstream text(path_of(folder, group, ".txt")); text) {
    std::string first;
    std::getline(text, first);
    if (first == made_for(study, group)) return {{}, {std::istreambuf_iterator<char>(text), {}}};
  }
  try {
    if (auto family = read_soil_family_file(path_of(folder, group, ".h5"), made_for(study, group)))
      return {std::move(family), ""};
  } catch (const InputError& error) {
    return {{}, error.diagnostics().list().front().what, false};
  }
  return {{}, "the model of all soils is of another study", false};
}

void make_soil_families(const Study& study, const std::vector<std::vector<int>>& pieces, const std::string& folder,
                        bool trusts_scripts, const std::function<void(double)>& progress) {
  const std::vector<std::vector<int>> groups = soil_groups(study);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!has_run_of(pieces, groups[g]) || read_soil_family(study, g, folder).was_tried) continue;
    const double n = static_cast<double>(groups.size());
    const auto shown = part_of(progress, static_cast<double>(g) / n, static_cast<double>(g + 1) / n);
    const SoilFamilyRead made = family_of(study, groups[g], trusts_scripts, shown);
    if (read_soil_family(study, g, folder).was_tried) continue;  // of another part, which was first
    std::error_code code;
    fs::create_directories(journal_folder(folder), code);
    fs::remove(path_of(folder, g, made.family ? ".txt" : ".h5"), code);
    if (made.family)
      write_together({{path_of(folder, g, ".h5"), soil_family_file(*made.family, made_for(study, g))}});
    else
      write_together({{path_of(folder, g, ".txt"), made_for(study, g) + "\n" + made.why_not}});
  }
}

}  // namespace upbead

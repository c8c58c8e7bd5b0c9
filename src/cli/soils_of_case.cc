#include "cli/soils_of_case.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "case/case_run.h"
#include "cli/reduced_case.h"
#include "run/derived.h"
#include "soils/soil_answers.h"
#include "soils/soil_model.h"
#include "study/soil_box.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

constexpr int n_candidates = 23;  ///< beside the case's own soil
constexpr int n_unseen = 16;
/// Coefficients by the file's text and by the case are the same numbers, but for round-off.
constexpr double round_off = 1e-12;

/// Soils of a case, on one mesh and up to one end.
class SoilsOnMesh {
 public:
  SoilsOnMesh(const Case& input, const CaseOptions& options, std::shared_ptr<const Mesh> mesh)
      : options_(options), end_(to_toml(input.scene.time.end)), mesh_(std::move(mesh)) {}

  Scene scene(const std::vector<Setting>& soil) const {
    std::vector<std::string> overrides = options_.overrides;
    overrides.push_back("time.end=" + end_);
    for (const auto& [key, value] : soil) overrides.push_back(key + "=" + value);
    return scene_on(read_case(options_.file, overrides), *mesh_);
  }
  std::vector<Scene> scenes(const std::vector<SoilAxis>& box, int from, int to) const {
    std::vector<Scene> list;
    for (int i = from; i < to; ++i) list.push_back(scene(settings_of(drawn_soil(box, i))));
    return list;
  }

 private:
  const CaseOptions& options_;
  std::string end_;
  std::shared_ptr<const Mesh> mesh_;
};

Simulation first_of(const Case& input, const std::shared_ptr<const Mesh>& mesh) {
  const Simulation first = simulation_with_all_cells(input, mesh);
  Diagnostics reasons;
  for (const Diagnostic& reason : why_no_soils(first))
    reasons.add(input.place(reason.place.key), reason.what, "use 'upbead reduce' without --soils for each soil");
  reasons.throw_if_any();
  return first;
}

/// Numbers may decide about flow, deformation and compressibility at the ends of a region's own numbers.
void check_corners(const Simulation& first, const SoilsOnMesh& soils, const std::vector<SoilAxis>& box) {
  for (const std::vector<Setting>& corner : corners_by_region(box)) {
    const Scene other = resolved_on(with_all_cells(soils.scene(corner)), first.mesh()).scene;
    const std::string why = why_not_of_family(first.scene(), other);
    if (why.empty()) continue;
    std::vector<std::string> words;
    for (const auto& [key, value] : corner) words.push_back(key + " = " + value);
    throw InputError(Place(), "the box holds soils of more than one kind: with " + join(words, ", ") + ", " + why,
                     "make the box smaller, make a model for each part of it, or write the choice into the case");
  }
}

/// The model's text must tell the same coefficients as the case: a key may act on more than its own region.
void check_text(const SoilModelFile& file, const Simulation& first, const SoilsOnMesh& soils) {
  const SoilText text(file.regions_text, "the model");
  for (int draw = 0; draw < 2; ++draw) {
    const Soil soil = drawn_soil(file.box, draw);
    const auto by_text = text.coefficients(soil);
    const auto by_case =
        coefficients_of(resolved_on(with_all_cells(soils.scene(settings_of(soil))), first.mesh()).scene);
    for (const AffineTerm& term : file.family.terms) {
      const auto q = static_cast<std::size_t>(term.coefficient);
      const double a = by_text.at(term.region)[q], b = by_case.at(term.region)[q];
      if (!(std::abs(a - b) <= round_off * std::max(std::abs(a), std::abs(b))))
        throw InputError(Place(), "constants of '" + term.region + "' follow from more than the keys of the box",
                         "leave keys that act on the water in the pores out of the box");
    }
  }
}

Eigen::MatrixXd points_of(const SoilModelFile& file, const std::vector<int>& points) {
  const SoilText text(file.regions_text, "the model");
  Eigen::MatrixXd out(points.size(), file.box.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Soil soil = points[p] == 0 ? Soil() : drawn_soil(file.box, points[p] - 1);
    for (std::size_t a = 0; a < file.box.size(); ++a)
      out(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(a)) =
          soil.empty() ? text.number(file.box[a].key).value_or(0.) : soil.at(file.box[a].key);
  }
  return out;
}

/// Every key of the box needs a value in the case, from which the model takes it where a soil does not give it.
void check_own_soil(const SoilModelFile& file, const Case& input) {
  const SoilText text(file.regions_text, "the model");
  Diagnostics mistakes;
  for (const SoilAxis& axis : file.box) {
    const std::optional<double> own = text.number(axis.key);
    if (!own)
      mistakes.add(input.place(axis.key), "the case has no number at " + in_quotes(axis.key) + ", which varies",
                   "give it one within the box");
    else if (*own < axis.low || *own > axis.high)
      mistakes.add(input.place(axis.key), number_text(*own) + " lies outside the box of soils", "widen the box");
  }
  mistakes.throw_if_any();
}

void estimate_unseen(SoilsOfCase& made, const Simulation& first, const std::vector<Scene>& unseen, double tolerance) {
  const SoilModel model(first, made.file.family);
  std::vector<double> estimates(unseen.size());
  in_parallel(unseen.size(), "estimating unseen soils",
              [&](std::size_t i) { estimates[i] = error_of_soils(model.member(unseen[i])); });
  made.unseen = static_cast<int>(unseen.size());
  made.largest_estimate = *std::max_element(estimates.begin(), estimates.end());
  made.over = static_cast<int>(
      std::count_if(estimates.begin(), estimates.end(), [tolerance](double estimate) { return estimate > tolerance; }));
}

}  // namespace

SoilsOfCase soils_of_case(Case& input, const CaseOptions& options, const std::vector<SoilAxis>& box,
                          const std::string& folder) {
  const Stopwatch watch;
  std::shared_ptr<const Mesh> mesh = settle_end(input);
  const Simulation first = first_of(input, mesh);
  const SoilsOnMesh soils(input, options, first.mesh());
  SoilsOfCase made;
  SoilModelFile& file = made.file;
  file.box = box;
  file.regions_text = soil_text(first.scene());
  check_own_soil(file, input);
  in_places_of(input, [&] { check_corners(first, soils, box); });
  Reduced frame = reduced_case(input, first, {false, false, true}, folder);
  made.warnings = frame.warnings();
  file.frame = std::move(frame.file);
  SoilModelOptions making;
  making.tolerance = share_of_tolerance * input.scene.tolerance;
  making.progress = shown_progress("one model for many soils");
  SoilsMade family = make_soils(first, soils.scenes(box, 0, n_candidates), making);
  file.family = std::move(family.family);
  file.points = points_of(file, family.points);
  check_text(file, first, soils);
  estimate_unseen(made, first, soils.scenes(box, n_candidates, n_candidates + n_unseen), input.scene.tolerance);
  file.family.phi = {};  // for pressures everywhere, which need the mesh
  made.seconds = watch.seconds();
  return made;
}

std::string describe(const SoilsOfCase& made, const std::string& path) {
  const SoilModelFile& file = made.file;
  std::string text = file.frame.title + "\nsoils      ";
  for (const SoilAxis& axis : file.box)
    text += " " + axis.key + " from " + number_text(axis.low) + " to " + number_text(axis.high) +
            (axis.logarithmic ? " (by its logarithm)\n           " : "\n           ");
  text += " one model of " + std::to_string(file.family.reduced.fixed.size()) + " coordinates, by " +
          std::to_string(file.points.rows()) + " soils that were solved\n";
  text += "error       estimated, of F_T, displacement and forces on the base over their peaks: at most " +
          significant(100. * made.largest_estimate, 2) + " % for " + std::to_string(made.unseen) + " unseen soils, " +
          std::to_string(made.over) + " of them beyond the tolerance of " +
          significant(100. * file.frame.tolerance, 2) + " %; each answer tells its own\n";
  return text + "time        " + significant(made.seconds, 3) + " s\nwritten     " + path + "\n";
}

std::string to_json(const SoilsOfCase& made, const std::string& path) {
  using Json = nlohmann::ordered_json;
  const SoilModelFile& file = made.file;
  Json json = {{"title", file.frame.title}, {"model", path}, {"box", Json::array()}};
  for (const SoilAxis& axis : file.box)
    json["box"].push_back(
        {{"key", axis.key}, {"low", axis.low}, {"high", axis.high}, {"logarithmic", axis.logarithmic}});
  json["coordinates"] = file.family.reduced.fixed.size();
  json["points"] = file.points.rows();
  json["tolerance"] = file.frame.tolerance;
  json["unseen"] = {
      {"soils", made.unseen}, {"beyond_tolerance", made.over}, {"largest_estimate", made.largest_estimate}};
  json["warnings"] = warnings_json(made.warnings);
  json["timing"] = {{"total", made.seconds}};
  return json.dump(2) + "\n";
}

}  // namespace upbead

#include "study/soil_runs.h"

#include <algorithm>

#include "case/case_run.h"
#include "upbead/base/error.h"

namespace upbead {

void SoilRuns::read(std::size_t group, const std::shared_ptr<const Mesh>& mesh) {
  read_ = group;
  model_.reset();
  SoilFamilyRead found = read_soil_family(study_, group, folder_);
  why_no_model_ = found.why_not;
  if (!found.family) return;
  try {
    model_ = std::make_unique<SoilModel>(first_of_soils(study_, groups_[group], mesh), *std::move(found.family));
  } catch (const InputError& error) {
    why_no_model_ = error.diagnostics().list().front().what;
  }
}

std::optional<Simulation> SoilRuns::member(int run, const Case& problem, const std::shared_ptr<const Mesh>& mesh) {
  why_not_.clear();
  const auto found = std::find_if(groups_.begin(), groups_.end(), [run](const std::vector<int>& group) {
    return std::find(group.begin(), group.end(), run) != group.end();
  });
  if (found == groups_.end()) return std::nullopt;
  if (const auto group = static_cast<std::size_t>(found - groups_.begin()); group != read_) read(group, mesh);
  why_not_ = why_no_model_;
  if (!model_) return std::nullopt;
  try {
    Simulation simulation = simulation_by(
        problem, mesh, [this](Scene scene, const std::shared_ptr<const Mesh>&) { return model_->member(scene); });
    if (error_of_soils(simulation) <= problem.scene.tolerance) return simulation;
    why_not_ = "the estimate of its error by one model of all soils exceeds the tolerance";
  } catch (const InputError& error) {
    why_not_ = error.diagnostics().list().front().what;
  }
  return std::nullopt;
}

}  // namespace upbead

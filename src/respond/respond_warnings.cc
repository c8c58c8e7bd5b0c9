#include "respond/respond_warnings.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "model/quantities.h"
#include "respond/answered_wave.h"

namespace upbead {

namespace {

/// A warning where the coupled S of some waves could not be computed.
NumberedWarnings slip_warnings(const std::vector<WaveResponses>& files) {
  const std::vector<AnsweredWave> waves = all_waves(files);
  const auto untold = [](const AnsweredWave& row) { return !row.wave->why_not_coupled.empty(); };
  const auto first = std::find_if(waves.begin(), waves.end(), untold);
  if (first == waves.end()) return {};
  const auto n = std::count_if(waves.begin(), waves.end(), untold);
  return {{"no_coupled_slip", static_cast<double>(n), 0., "1",
           "the distance that the caisson slips as a whole could not be computed for " + std::to_string(n) + " of " +
               std::to_string(waves.size()) + " waves, such as " + first->name + ": " + first->wave->why_not_coupled,
           "take S of the bonded caisson, or solve such a wave by 'upbead run' with contact node by node (kind = "
           "\"friction\")"}};
}

/// Warning no_contact: slip and uplift node by node of some waves could not be computed.
NumberedWarnings contact_warnings(const std::vector<WaveResponses>& files) {
  const std::vector<AnsweredWave> waves = all_waves(files);
  const auto untold = [](const AnsweredWave& row) { return !row.wave->why_not_contact.empty(); };
  const auto n = std::count_if(waves.begin(), waves.end(), untold);
  if (n == 0) return {};
  const AnsweredWave& first = *std::find_if(waves.begin(), waves.end(), untold);
  return {{"no_contact", static_cast<double>(n), 0., "1",
           "slip and uplift node by node of " + std::to_string(n) + " of " + std::to_string(waves.size()) +
               " waves could not be computed, such as of " + first.name + ": " + first.wave->why_not_contact,
           "solve such a wave by 'upbead run', which marches the whole ground"}};
}

/// Warning slides_on: S is that of loads that stop where the wave ends.
NumberedWarnings endless_warnings(const std::vector<WaveResponses>& files) {
  const std::vector<AnsweredWave> waves = all_waves(files);
  const auto goes_on = [](const AnsweredWave& row) { return row.wave->slides_on; };
  const auto n = std::count_if(waves.begin(), waves.end(), goes_on);
  if (n == 0) return {};
  const AnsweredWave& first = *std::find_if(waves.begin(), waves.end(), goes_on);
  const double S = *first.wave->sliding;
  return {{"slides_on", S, 0., "m",
           "the loads at the end of " + std::to_string(n) + " of " + std::to_string(waves.size()) + " waves, such as " +
               first.name + " with S " + with_unit(S, "m") +
               ", exceed the friction: S is that of loads which stop there, and has no bound where they stay",
           "let the wave last until its loads are over"}};
}

/// A warning where more of a wave's response than the model's tolerance lies above the model's highest frequency.
NumberedWarnings band_warnings(const ReducedModelFile& model, const std::vector<WaveResponses>& files) {
  const std::vector<AnsweredWave> waves = all_waves(files);
  const auto n = std::count_if(waves.begin(), waves.end(),
                               [&model](const AnsweredWave& row) { return row.wave->beyond_band > model.tolerance; });
  if (n == 0) return {};
  const AnsweredWave& worst = *std::max_element(
      waves.begin(), waves.end(),
      [](const AnsweredWave& a, const AnsweredWave& b) { return a.wave->beyond_band < b.wave->beyond_band; });
  return {{"beyond_band", worst.wave->beyond_band, model.tolerance, "1",
           std::to_string(n) + " of " + std::to_string(waves.size()) +
               " waves reach beyond the frequencies that the model has been checked for, " +
               significant(model.highest_frequency) + " Hz: worst " + worst.name + ", where " +
               significant(100. * worst.wave->beyond_band) + " % of F_T lies beyond (tolerance " +
               significant(100. * model.tolerance) + " %)",
           "reduce again with a shorter pulse or a smaller tolerance, or march the wave with 'upbead run'"}};
}

/// Warnings of waves whose error estimate exceeds the model's tolerance, and of models that cannot estimate errors:
/// docs/warnings.md.
NumberedWarnings error_warnings(const ReducedModelFile& model, const std::vector<WaveResponses>& files) {
  if (!model.nested)
    return {{"no_error_estimate", 0., model.tolerance, "1",
             "the model holds nothing from which the error of its answer to a wave follows, so error_estimate is null",
             "make the model again with 'upbead reduce'"}};
  const std::vector<AnsweredWave> waves = all_waves(files);
  const auto estimate = [](const AnsweredWave& row) { return row.wave->error_estimate.value_or(0.); };
  const auto n = std::count_if(waves.begin(), waves.end(),
                               [&](const AnsweredWave& row) { return estimate(row) > model.tolerance; });
  if (n == 0) return {};
  const AnsweredWave& worst =
      *std::max_element(waves.begin(), waves.end(),
                        [&](const AnsweredWave& a, const AnsweredWave& b) { return estimate(a) < estimate(b); });
  return {{"reduced_model_error", estimate(worst), model.tolerance, "1",
           "F_T of " + std::to_string(n) + " of " + std::to_string(waves.size()) +
               " waves may be wrong by more than the model's tolerance: worst " + worst.name + ", by up to " +
               significant(100. * estimate(worst), 2) + " % of its largest F_T (tolerance " +
               significant(100. * model.tolerance) + " %)",
           "reduce again with an 'end' as long as the wave, a load as short as its pulse or a smaller [accuracy] "
           "tolerance, or march the wave with 'upbead run'"}};
}

/// Warning slip_circle: circles have less than what they need to stand.
NumberedWarnings circle_warnings_of(const std::vector<WaveResponses>& files) {
  const std::vector<AnsweredWave> waves = all_waves(files);
  const auto factor = [](const AnsweredWave& row) { return row.wave->circle ? row.wave->circle->factor : HUGE_VAL; };
  const auto n = std::count_if(waves.begin(), waves.end(), [&](const AnsweredWave& row) { return factor(row) < 1.; });
  if (n == 0) return {};
  const AnsweredWave& worst = *std::min_element(
      waves.begin(), waves.end(), [&](const AnsweredWave& a, const AnsweredWave& b) { return factor(a) < factor(b); });
  return {{"slip_circle", factor(worst), 1., "1",
           "in " + std::to_string(n) + " of " + std::to_string(waves.size()) +
               " waves the ground under the caisson would slip on a circle, worst in " + worst.name +
               ": F = " + circle_text(worst.wave->circle) + " by Bishop's simplified method",
           "widen the caisson or its berm, or give the mound more height; a factor below 1 of a moment is a permanent "
           "displacement and not yet a collapse"}};
}

/// Warning would_lift: an edge of the base, which a reduced model has bonded, is in tension.
NumberedWarnings lift_warnings_of(const std::vector<WaveResponses>& files) {
  const std::vector<AnsweredWave> waves = all_waves(files);
  const auto stress = [](const AnsweredWave& row) {
    return row.wave->tension && !row.wave->response ? row.wave->tension->stress : 0.;  // contact tells more
  };
  const auto n = std::count_if(waves.begin(), waves.end(), [&](const AnsweredWave& row) { return stress(row) < 0.; });
  if (n == 0) return {};
  const AnsweredWave& worst = *std::min_element(
      waves.begin(), waves.end(), [&](const AnsweredWave& a, const AnsweredWave& b) { return stress(a) < stress(b); });
  return {{"would_lift", stress(worst), 0., "Pa",
           "in " + std::to_string(n) + " of " + std::to_string(waves.size()) + " waves, worst in " + worst.name + ", " +
               lifts_text(*worst.wave->tension),
           "solve such a wave by 'upbead run' with [regions.caisson.interface] kind = \"friction\""}};
}

/// Whether every load is a power of ten in its largest wave, or zero throughout.
bool are_unit_loads(const std::vector<WaveFile>& files) {
  for (const WaveFile& file : files)
    for (int k = 0; k < file.n_loads; ++k) {
      double largest = 0.;
      for (int w = 0; w < file.n_waves(); ++w)
        largest = std::max(largest, static_cast<double>(file.wave(w).row(k).cwiseAbs().maxCoeff()));
      if (largest > 0. && !is_unit_load(largest)) return false;
    }
  return true;
}

}  // namespace

NumberedWarnings warnings_of_files(const std::vector<WaveFile>& files) {
  NumberedWarnings list;
  for (const WaveFile& file : files) {
    append(list, file.notes.warnings);
    int zero = 0;
    for (int w = 0; w < file.n_waves(); ++w)
      if (file.wave(w).isZero(0.)) ++zero;
    if (zero > 0)
      list.push_back({"load_zero", static_cast<double>(zero), 0., "1",
                      std::to_string(zero) + " of " + std::to_string(file.n_waves()) + " waves of " +
                          in_quotes(file.name) + " are zero throughout",
                      "look whether a wrong column is read as the load"});
  }
  return list;
}

std::string circle_text(const std::optional<CircleInWave>& circle) {
  if (!circle) return "none";
  const std::string when = " at " + significant(circle->time) + " s";
  if (circle->slips.empty()) return "0: the resultant leaves the base" + when;
  return significant(circle->factor, 4) + " " + circle->slips + when;
}

NumberedWarnings force_warnings(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                                const std::vector<WaveResponses>& responses) {
  double largest = 0.;
  for (const WaveResponses& response : responses)
    if (response.force.size() > 0)
      largest = std::max(largest, static_cast<double>(response.force.cwiseAbs().maxCoeff()));
  constexpr double g = 9.81;
  const double weight = model.base ? model.base->weight : model.caisson_mass * g;
  NumberedWarnings list;
  if (!(weight > 0.) || are_unit_loads(files)) return list;
  judge("the largest force of the waves", largest,
        of(quantities::load_on_weight, weight, "N/m", "beside the caisson's weight"), list);
  return list;
}

NumberedWarnings uplift_warnings(const ReducedModelFile& model) {
  if (!model.sliding || model.sliding->uplift != "history") return {};
  return {{"uplift_left_out", 0., 0., "",
           "[sliding.uplift] of the model's case is a record that belongs to its own wave: no answer of the model has "
           "an uplift, S has no value without --friction and --buoyant-weight, and with them S, pressures and factors "
           "are those of a base without uplift",
           "give the uplift by its peak or as computed before the case is reduced, or solve the wave by 'upbead run'"}};
}

NumberedWarnings warnings_of_answers(const ReducedModelFile& model, const std::vector<WaveResponses>& files) {
  NumberedWarnings list = model.warnings;
  append(list, uplift_warnings(model));
  for (const NumberedWarnings& more :
       {band_warnings(model, files), error_warnings(model, files), slip_warnings(files), contact_warnings(files),
        endless_warnings(files), lift_warnings_of(files), circle_warnings_of(files)})
    append(list, more);
  return list;
}

}  // namespace upbead

#include "respond/respond_warnings.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "case/strain_model.h"
#include "case/time_end.h"
#include "model/quantities.h"
#include "respond/answered_wave.h"
#include "respond/respond_waves.h"
#include "sliding/rest_velocity.h"

namespace upbead {

namespace {

/// What is told of some of the waves, and of which it is worst; of equal ones the first.
struct ToldOfWaves {
  std::size_t n = 0, all = 0;
  double amount = -HUGE_VAL;
  std::string worst{};
  const WaveResponse* wave = nullptr;  ///< the worst
  std::string count() const { return std::to_string(n) + " of " + std::to_string(all) + " waves"; }
};

/// Of the waves whose `amount` is above `limit`; none where there are none.
template <class Amount>
std::optional<ToldOfWaves> told_of(const std::vector<AnsweredWave>& waves, Amount amount, double limit = 0.) {
  ToldOfWaves told;
  told.all = waves.size();
  for (const AnsweredWave& row : waves) {
    const double of_row = amount(*row.wave);
    if (of_row > limit) ++told.n;
    if (of_row > told.amount) told = {told.n, told.all, of_row, row.name, row.wave};
  }
  return told.n > 0 ? std::optional(told) : std::nullopt;
}

/// A warning where the coupled S of some waves could not be computed.
NumberedWarnings slip_warnings(const std::vector<AnsweredWave>& waves) {
  const auto told = told_of(waves, [](const WaveResponse& w) { return w.why_not_coupled.empty() ? 0. : 1.; });
  if (!told) return {};
  return {{"no_coupled_slip", static_cast<double>(told->n), 0., "1",
           "the distance that the caisson slips as a whole could not be computed for " + told->count() + ", such as " +
               told->worst + ": " + told->wave->why_not_coupled,
           "take S of the bonded caisson, or solve such a wave by 'upbead run' with contact node by node (kind = "
           "\"friction\")"}};
}

/// Warning no_contact: slip and uplift node by node of some waves could not be computed.
NumberedWarnings contact_warnings(const std::vector<AnsweredWave>& waves) {
  const auto told = told_of(waves, [](const WaveResponse& w) { return w.why_not_contact.empty() ? 0. : 1.; });
  if (!told) return {};
  return {{"no_contact", static_cast<double>(told->n), 0., "1",
           "slip and uplift node by node of " + told->count() + " could not be computed, such as of " + told->worst +
               ": " + told->wave->why_not_contact,
           "solve such a wave by 'upbead run', which marches the whole ground"}};
}

/// What a run says of a base that is followed node by node. `amount`: by how far; 0: not at all.
struct Doubt {
  const char *name, *unit, *what, *cure;
  double (*amount)(const ContactSummary& contact);
  bool voids = false;
};

constexpr double earth = 9.81;  ///< gravity (m/s2)

const Doubt doubts[] = {
    {"still_slides", "m/s",
     "the caisson still slides when the answer ends, node by node: S is no more than its way till then",
     "let the wave last until its loads are over, or give a later --end",
     [](const ContactSummary& contact) {
       const double v = std::abs(contact.solved->end_velocity);
       return v > tolerable_velocity(contact.friction, earth, contact.solved->slip) ? v : 0.;
     },
     true},
    {"rocks_on_edge", "m",
     "the whole bottom lifts from the ground: what presses when it comes down is not known, and neither is S",
     "make the caisson heavier, or let less uplift act",
     [](const ContactSummary& contact) {
       const NodeContact& solved = *contact.solved;
       return solved.least_contact == 0. ? std::max(solved.opening_seaward, solved.opening_landward) : 0.;
     },
     true},
    {"no_settlement", "m",
     "an edge of the base lifts: ground that is elastic keeps no settlement and no tilt of that, and stones do",
     "solve the wave by 'upbead run' with a mound whose law yields, or take settlement and tilt from tests",
     [](const ContactSummary& contact) {
       const NodeContact& solved = *contact.solved;
       return solved.first_open ? std::max(solved.opening_seaward, solved.opening_landward) : 0.;
     }}};

/// Warnings still_slides, rocks_on_edge and no_settlement, as of a run with contact node by node.
NumberedWarnings solved_warnings(const std::vector<AnsweredWave>& waves) {
  NumberedWarnings list;
  for (const Doubt& doubt : doubts) {
    const auto told = told_of(waves, [&doubt](const WaveResponse& w) {
      return w.contact && w.contact->solved ? doubt.amount(*w.contact) : 0.;
    });
    if (!told) continue;
    list.push_back({doubt.name, told->amount, 0., doubt.unit,
                    "in " + told->count() + ", worst in " + told->worst + " by " + with_unit(told->amount, doubt.unit) +
                        ", " + doubt.what,
                    doubt.cure, doubt.voids});
  }
  return list;
}

/// Warning uplift_left_out: the pores lift the caisson, and its S counts no uplift.
NumberedWarnings pore_warnings(const std::vector<AnsweredWave>& waves) {
  const auto told = told_of(waves, [](const WaveResponse& w) { return w.left_out_uplift; });
  if (!told) return {};
  return {{"uplift_left_out", told->amount, 0., "N/m",
           "in " + told->count() + ", worst in " + told->worst +
               ", the pore pressure under the base lifts the caisson with up to " + with_unit(told->amount, "N/m") +
               ", and S leaves it out, as [sliding] of the model's case has no uplift",
           "write sliding.uplift = { kind = \"computed\" } in the case and reduce it again",
           std::any_of(waves.begin(), waves.end(),
                       [](const AnsweredWave& row) { return row.wave->slides_by_left_out_uplift; })}};
}

/// Warning soil_of_other_wave: soil that follows its strain has the stiffness that the case's own loads have left it.
NumberedWarnings soil_warnings(const ReducedModelFile& model, const std::vector<WaveResponses>& files) {
  constexpr double other = 1.5;  // F_T of a wave twice as large was a quarter off
  if (!follows_strain(model)) return {};
  const auto [least, most] = forces_of_case(model);
  double worst = 1., force = 0.;
  for (const WaveResponses& file : files)
    for (Eigen::Index row = 0; row < file.force.rows(); ++row) {
      const double P = file.force.row(row).cwiseAbs().maxCoeff();
      const double apart = P > 0. ? std::max(P / most, least / P) : 1.;
      if (apart > worst) force = P;
      worst = std::max(worst, apart);
    }
  if (!(worst > other)) return {};
  return {{"soil_of_other_wave", worst, other, "1",
           "the soil follows its strain, and the model has the stiffness that P = " + with_unit(most, "N/m") +
               " has left; a wave with P = " + with_unit(force, "N/m") +
               " leaves another, so that F_T and S of it are wrong by far more than the error that is told",
           "reduce the case with a load of about that size", true}};
}

/// Warning slides_on: S is that of loads that stop where the wave ends.
NumberedWarnings endless_warnings(const std::vector<AnsweredWave>& waves) {
  const auto told = told_of(waves, [](const WaveResponse& w) { return w.slides_on ? 1. : 0.; });
  if (!told) return {};
  const double S = *told->wave->sliding;
  return {{"slides_on", S, 0., "m",
           "the loads at the end of " + told->count() + ", such as " + told->worst + " with S " + with_unit(S, "m") +
               ", exceed the friction: S is that of loads which stop there, and has no bound where they stay",
           "let the wave last until its loads are over"}};
}

/// A warning where more of a wave's response than the model's tolerance lies above the model's highest frequency.
NumberedWarnings band_warnings(const ReducedModelFile& model, const std::vector<AnsweredWave>& waves) {
  const auto told = told_of(
      waves, [](const WaveResponse& w) { return w.beyond_band; }, model.tolerance);
  if (!told) return {};
  return {{"beyond_band", told->amount, model.tolerance, "1",
           told->count() + " reach beyond the frequencies that the model has been checked for, " +
               significant(model.highest_frequency) + " Hz: worst " + told->worst + ", where " +
               significant(100. * told->amount) + " % of F_T lies beyond (tolerance " +
               significant(100. * model.tolerance) + " %)",
           "reduce again with a shorter pulse or a smaller tolerance, or march the wave with 'upbead run'"}};
}

/// Warnings of waves whose error estimate exceeds the model's tolerance, and of models that cannot estimate errors:
/// docs/warnings.md.
NumberedWarnings error_warnings(const ReducedModelFile& model, const std::vector<AnsweredWave>& waves) {
  if (!model.nested)
    return {{"no_error_estimate", 0., model.tolerance, "1",
             "the model holds nothing from which the error of its answer to a wave follows, so error_estimate is null",
             "make the model again with 'upbead reduce'"}};
  const auto told = told_of(
      waves, [](const WaveResponse& w) { return w.error_estimate.value_or(0.); }, model.tolerance);
  if (!told) return {};
  return {{"reduced_model_error", told->amount, model.tolerance, "1",
           "F_T of " + told->count() + " may be wrong by more than the model's tolerance: worst " + told->worst +
               ", by up to " + significant(100. * told->amount, 2) + " % of its largest F_T (tolerance " +
               significant(100. * model.tolerance) + " %)",
           "reduce again with an 'end' as long as the wave, a load as short as its pulse or a smaller [accuracy] "
           "tolerance, or march the wave with 'upbead run'"}};
}

/// Warning slip_circle: circles have less than what they need to stand.
NumberedWarnings circle_warnings_of(const std::vector<AnsweredWave>& waves) {
  const auto told = told_of(
      waves, [](const WaveResponse& w) { return w.circle ? -w.circle->factor : -HUGE_VAL; }, -1.);
  if (!told) return {};
  return {{"slip_circle", told->wave->circle->factor, 1., "1",
           "in " + told->count() + " the ground under the caisson would slip on a circle, worst in " + told->worst +
               ": F = " + circle_text(told->wave->circle) + " by Bishop's simplified method",
           "widen the caisson or its berm, or give the mound more height; a factor below 1 of a moment is a permanent "
           "displacement and not yet a collapse"}};
}

/// Warning would_lift: an edge of the base, which a reduced model has bonded, is in tension; contact tells more.
NumberedWarnings lift_warnings_of(const std::vector<AnsweredWave>& waves) {
  const auto told =
      told_of(waves, [](const WaveResponse& w) { return w.tension && !w.response ? -w.tension->stress : 0.; });
  if (!told) return {};
  return {{"would_lift", told->wave->tension->stress, 0., "Pa",
           "in " + told->count() + ", worst in " + told->worst + ", " + lifts_text(*told->wave->tension),
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
                      "look whether a wrong column is read as the load", true});
  }
  return list;
}

std::string circle_text(const std::optional<CircleInWave>& circle) {
  if (!circle) return "none";
  const std::string when = " at " + significant(circle->time) + " s";
  if (circle->slips.empty()) return "0: the resultant leaves the base" + when;
  return significant(circle->factor, 4) + " " + circle->slips + when;
}

namespace {

/// Warning load_left_out: no wave has a load that acts in the model's case, as where its column is missing.
NumberedWarnings left_out_warnings(const ReducedModelFile& model, const std::vector<WaveFile>& files) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < model.loads.size(); ++k) {
    const auto has = [k](const WaveFile& file) {
      for (int w = 0; w < file.n_waves(); ++w)
        if (!file.wave(w).row(static_cast<Eigen::Index>(k)).isZero(0.)) return true;
      return false;
    };
    if (model.loads[k].peak > 0. && std::none_of(files.begin(), files.end(), has))
      names.push_back(model.modes.load_name[k]);
  }
  if (names.empty()) return {};
  return {{"load_left_out", static_cast<double>(names.size()), 0., "1",
           "no wave has " + join(names) + ", which acts in the model's case: it is zero in all answers",
           "give the files a column for it, or 'upbead respond' the case itself"}};
}

}  // namespace

NumberedWarnings force_warnings(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                                const std::vector<WaveResponses>& responses) {
  double largest = 0.;
  for (const WaveResponses& response : responses)
    if (response.force.size() > 0)
      largest = std::max(largest, static_cast<double>(response.force.cwiseAbs().maxCoeff()));
  const double weight = model.base ? model.base->weight : model.caisson_mass * earth;
  NumberedWarnings list = left_out_warnings(model, files);
  if (!(weight > 0.) || are_unit_loads(files)) return list;
  judge("the largest force of the waves", largest,
        of(quantities::load_on_weight, weight, "N/m", "beside the caisson's weight"), list);
  return list;
}

NumberedWarnings cut_warnings(const ReducedModelFile& model, const std::vector<WaveFile>& files,
                              const std::vector<WaveResponses>& responses) {
  NumberedWarnings all;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const WaveFile& file = files[i];
    const double end = responses[i].time.back();
    if (end >= whole_answer(model, file) * (1. - 1e-9)) continue;
    std::vector<Action> actions;
    for (Eigen::Index row = 0; row < file.value.rows(); ++row) {
      if (file.value.row(row).isZero(0.)) continue;
      const Eigen::RowVectorXd value = file.value.row(row);
      actions.push_back(action_of(file.name, "a later time", file.time, {{value.begin(), value.end()}}));
    }
    append(all, end_warnings(actions, end, "--end"));
    append(all, answer_warnings(actions, end, of_rebound / rebound * swing_period_of(model.modes), "--end"));
  }
  return first_of_each(all, "more of the waves and loads, too");
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
  NumberedWarnings list = model.warnings, of_uplift = uplift_warnings(model);
  const std::vector<AnsweredWave> waves = all_waves(files);
  const bool judged =
      std::any_of(waves.begin(), waves.end(), [](const AnsweredWave& row) { return !!row.wave->sliding; });
  for (NumberedWarning& warning : of_uplift) warning.voids = judged;  // F_T alone needs no uplift
  append(list, of_uplift);
  for (const NumberedWarnings& more :
       {band_warnings(model, waves), error_warnings(model, waves), slip_warnings(waves), contact_warnings(waves),
        solved_warnings(waves), pore_warnings(waves), soil_warnings(model, files), endless_warnings(waves),
        lift_warnings_of(waves), circle_warnings_of(waves)})
    append(list, more);
  return list;
}

}  // namespace upbead

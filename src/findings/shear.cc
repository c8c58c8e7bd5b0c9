// F_T, P and the motion of the caisson; energy; how both differ from what they should be.
#include "base/text.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "findings/errors.h"
#include "findings/load_places.h"
#include "findings/topics.h"
#include "response/shear_response.h"

namespace upbead {

namespace {

OutputSchema<ShearResponse> forces_on_caisson_outputs() {
  using R = ShearResponse;
  return OutputSchema<R>()
      .key("peak_force", &R::peak_force, "N/m", "largest horizontal wave force on the caisson, landward: peak P")
      .key("peak_force_time", &R::peak_force_time, "s", "when")
      .key("peak_force_seaward", &R::peak_force_seaward, "N/m", "least P")
      .key("peak_force_seaward_time", &R::peak_force_seaward_time, "s", "when")
      .key("impulse", &R::impulse, "N s/m", "integral of P over the run")
      .key("peak_shear", &R::peak_shear, "N/m",
           "largest shear force at the bottom, landward, found inside the steps: peak F_T")
      .key("peak_shear_time", &R::peak_shear_time, "s", "when")
      .key("peak_shear_seaward", &R::peak_shear_seaward, "N/m",
           "largest shear force seaward: least F_T; in an undamped scene it may be the larger swing")
      .key("peak_shear_seaward_time", &R::peak_shear_seaward_time, "s", "when")
      .key("shear_to_force_ratio", &R::shear_to_force_ratio, "",
           "ratio of the peaks: peak F_T / peak P, landward, or seaward where the largest abs(P) is seaward; null "
           "where there is no P")
      .key("largest_displacement", &R::largest_displacement, "m",
           "displacement x_G of largest magnitude, with its sign: landward positive, of the centre of gravity")
      .key("largest_displacement_time", &R::largest_displacement_time, "s", "when")
      .key("peak_displacement", &R::peak_displacement, "m",
           "largest displacement x_G landward; `largest_displacement` may be a larger one seaward")
      .key("peak_rotation", &R::peak_rotation, "rad",
           "largest rotation landward; `largest_rotation` may be a larger one seaward")
      .key("largest_rotation", &R::largest_rotation, "rad", "rotation of largest magnitude, with its sign")
      .key("peak_shear_paper", &R::peak_shear_paper, "N/m",
           "largest P - m x_G'' of the caisson, the paper's reading; differs from `peak_shear` only where water is "
           "modelled")
      .key("peak_shear_experiment", &R::peak_shear_experiment, "N/m",
           "largest P + P_water,front - m x_G'', what the paper's experiment evaluates")
      .key("shear_to_impulse", &R::shear_to_impulse, "1/s",
           "the same peak F_T as in `shear_to_force_ratio` / impulse; null where there is none")
      .key(
          "arm", &R::arm, "m",
          "height of the force above the bottom when P is largest: of its line of action; null without horizontal load")
      .key("peak_base_moment", &R::peak_base_moment, "N m/m",
           "largest moment at the bottom, about its middle, landward")
      .key("largest_base_moment", &R::largest_base_moment, "N m/m", "the one of largest magnitude, with its sign")
      .key("reaction_mismatch", &R::reaction_mismatch, "",
           "largest difference of both routes to F_T over the largest abs(F_T), or, where that is less, over a "
           "millionth of the largest of abs(P), change of the normal force, uplift, and base moment over the bottom's "
           "width; round-off; above 1e-7 the next [way](reduced.md#the-ladder) is tried");
}

OutputSchema<ErrorEstimate> error_outputs() {
  using E = ErrorEstimate;
  return OutputSchema<E>()
      .key("mesh", &E::mesh, "", "part from the size of the cells")
      .key("time", &E::time, "", "part from the time steps of the march; 0 where a reduced model answers")
      .key("reduced_model", &E::reduced_model, "",
           "part from the limited number of vectors of the reduced model; 0 where it was marched")
      .key("far_boundary", &E::far_boundary, "", "part from waves that the far sides reflect");
}

std::string word_of_base(const Summary& s) {
  return s.contact && s.contact->solved ? "friction" : "bonded";
}

OutputSchema<Summary> response_outputs() {
  using S = Summary;
  const auto total = [](const std::optional<ErrorEstimate>& error) {
    return error ? std::optional(error->total()) : std::nullopt;
  };
  const auto mismatch = [](const S& s) { return s.energy ? std::optional(s.energy->mismatch()) : std::nullopt; };
  return OutputSchema<S>()
      .key(
          "caisson", [](const S& s) { return word_of_base(s); }, "",
          "`bonded`, or `friction` where it was followed node by node: that of all numbers here, of `base` and of the "
          "histories; those of `sliding` are of the bonded one")
      .keys_of(&S::response, forces_on_caisson_outputs())
      .key("energy_mismatch", mismatch, "",
           "work of the loads minus the sum of all energies stored and taken (the entries of `energy`), over the "
           "largest "
           "work; round-off; above 1e-6 the next way is tried; null where a reduced model answered")
      .key(
          "error_estimate", [total](const S& s) { return total(s.error); }, "",
          "relative error of `peak_shear`: the sum of `error_sources`, meant as an upper bound; null unless "
          "`mesh.refine = \"auto\"` or `accuracy.estimate = true` ([how it is found, how good it is](accuracy.md))")
      .object("error_sources", &S::error, error_outputs(), "where it comes from; null with it")
      .key(
          "history_error_estimate", [total](const S& s) { return total(s.history_error); }, "",
          "the same of F_T at any time, over its largest magnitude; the far sides are taken as given (`far_boundary` "
          "is 0; [`walls_too_near`](warnings.md#far-sides) warns of them); null with `error_estimate`")
      .object("history_error_sources", &S::history_error, error_outputs(), "where it comes from; null with it");
}

OutputSchema<EnergyAccount> energy_outputs() {
  using E = EnergyAccount;
  return OutputSchema<E>()
      .key("work", &E::work, "J/m",
           "done by the loads, and by the reaction of a moving base on its velocity: the sum of the next ten")
      .key("kinetic", &E::kinetic, "J/m", "stored")
      .key("strain", &E::strain, "J/m", "stored")
      .key("fluid", &E::fluid, "J/m", "stored in compressed fluid and raised surfaces")
      .key("lifted", &E::lifted, "J/m",
           "stored where the caisson has parted from its ground: forces at rest times openings")
      .key("drag", &E::drag, "J/m", "taken by flow through the pores")
      .key("damping", &E::damping, "J/m", "taken by material damping, of motion relative to a base that is shaken")
      .key("radiated", &E::radiated, "J/m",
           "gone through absorbing sides, by motion relative to an outcrop that is shaken")
      .key("friction", &E::friction, "J/m", "taken at the bottom, by friction and where nodes close")
      .key("plastic", &E::plastic, "J/m", "taken by soil that yields")
      .key("scheme", &E::scheme, "J/m", "taken by the time scheme; may be negative")
      .key("mismatch", &E::mismatch, "", "`response.energy_mismatch`");
}

double farther_of(double a, double b) {
  return std::abs(a) < std::abs(b) ? b : a;
}

/// With the rotation and the moment of the rows of /history, which lie inside the steps, too.
std::optional<ShearResponse> find_response(const Evidence& e) {
  std::optional<ShearResponse> r = e.of(find_shear);
  const Series& series = e.of(find_history).series;
  if (!r || series.time.empty()) return r;
  const auto row = [&](const char* name) { return series.reading.row(e.simulation.system().reading(name)); };
  const auto take = [](const auto& values, double& peak, double& farthest) {
    peak = std::max(peak, values.maxCoeff());
    farthest = farther_of(farthest, farther_of(values.maxCoeff(), values.minCoeff()));
  };
  take(row(reading::rotation), r->peak_rotation, r->largest_rotation);
  take(row(reading::base_moment), r->peak_base_moment, r->largest_base_moment);
  return r;
}

std::vector<LoadOnCaisson> find_loads(const Evidence& e) {
  return e.simulation.compiled()->loads_on_caisson;
}

std::optional<EnergyAccount> find_energy(const Evidence& e) {
  const std::vector<EnergyAccount>& energy = e.solution.response.energy;
  return energy.empty() ? std::nullopt : std::optional(energy.back());
}

std::optional<ErrorEstimate> find_peak_error(const Evidence& e) {
  return e.of(find_errors).peak;
}

std::optional<ErrorEstimate> find_history_error(const Evidence& e) {
  return e.of(find_errors).history;
}

SkippedList skipped_shear(const Simulation& simulation, bool) {
  if (simulation.compiled()->caisson) return {};
  return {{"shear force", "the mesh has no surface 'caisson'"}};
}

/// Warning answer_cut: the run stops early with more than a tenth of its energy, which is a third of its motion.
NumberedWarnings stop_warnings(const Evidence& e) {
  constexpr double rests = 0.1;
  const double share = e.scene.time.stop_at_energy.value_or(0.);
  if (!e.solution.discretisation.stopped_early || share <= rests) return {};
  return {{"answer_cut", share, rests, "1",
           "the run stops where " + percent(share) +
               " of its largest energy is left: forces, pressures, margins and S may be larger after that, and are not "
               "judged",
           "give time.stop_at_energy = 0.01, or leave it out", true}};
}

/// Warning still_grows: the loads go on after the run, and so does the growth of F_T.
NumberedWarnings growth_warnings(const Evidence& e, const Summary& summary) {
  constexpr double before_last_part = 0.8, steady = 1.01;
  if (!summary.response) return {};
  if (!loads_go_on(e.simulation)) return stop_warnings(e);
  const Series& series = e.of(find_history).series;
  const auto F = series.reading.row(e.simulation.system().reading(reading::shear_force));
  double before = 0., last = 0.;
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    double& largest = series.time[i] < before_last_part * e.scene.time.end ? before : last;
    largest = std::max(largest, std::abs(F[static_cast<Eigen::Index>(i)]));
  }
  if (!(last > steady * before) || before == 0.) return {};
  return {{"still_grows", last / before, steady, "1",
           "the loads go on after the run, and F_T still grows: in the last fifth it comes to " +
               significant(last / before, 4) + " times what it was before, so that no peak here is the largest",
           "let the run end later (time.end)", true}};
}

}  // namespace

std::optional<ShearResponse> find_shear(const Solution& solution) {
  const CompiledScene& compiled = *solution.simulation->compiled();
  if (!compiled.caisson) return std::nullopt;
  return read_shear_response(compiled, solution.response, solution.simulation->scene().time.inertia);
}

OutputSchema<LoadOnCaisson> load_outputs() {
  using L = LoadOnCaisson;
  return OutputSchema<L>()
      .key("force_x", &L::force_x, "N/m", "landward")
      .key("force_y", &L::force_y, "N/m", "upward")
      .key("moment", &L::moment, "N m/m", "about the bottom's middle")
      .key("arm", &L::arm, "m", "height above the bottom; null without horizontal force");
}

Finding shear_finding() {
  Finding f;
  const auto of_caisson = [](const Summary& summary) { return summary.response ? &summary : nullptr; };
  f.keys.object("response", of_caisson, response_outputs(), "null where the mesh has no surface `caisson`")
      .named("loads.NAME", &Summary::loads, &LoadOnCaisson::name, load_outputs(),
             "resultant on the caisson per unit of the history");
  f.skipped_of_scene = skipped_shear;
  f.warnings = growth_warnings;
  return f.part(&Summary::response, find_response)
      .part(&Summary::loads, find_loads)
      .part(&Summary::error, find_peak_error)
      .part(&Summary::history_error, find_history_error);
}

Finding energy_finding() {
  Finding f;
  f.keys.object("energy", &Summary::energy, energy_outputs(), "at the end; null where a reduced model answered");
  return f.part(&Summary::energy, find_energy);
}

}  // namespace upbead

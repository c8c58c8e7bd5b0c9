#include "run/sliding/case_sliding.h"

#include <algorithm>
#include <cmath>

#include "base/run_end.h"
#include "base/text.h"
#include "fem/caisson/readings.h"
#include "model/words.h"
#include "response/shear_response.h"
#include "run/sliding/uplift.h"
#include "sliding/still_water_push.h"
#include "upbead/base/error.h"
#include "upbead/waves/goda.h"

namespace upbead {

namespace {

/// W of the caisson (N/m).
double weight_of(const Scene& scene, const CompiledScene& compiled) {
  return scene.sliding->weight.value_or(compiled.caisson->body.mass * scene.gravity);
}

/// U(t) of a prescribed uplift, at these times and at its own kinks and samples.
History prescribed(const UpliftChoice& uplift, const CompiledScene& compiled, const std::vector<double>& time) {
  const TimeFunction of_time = prescribed_uplift(uplift, force_on_caisson(compiled), time.back());
  History U{time, {}};
  for (const auto* more : {&of_time.kinks(), &of_time.samples()})
    for (const double t : *more)
      if (t < time.back()) U.time.push_back(t);
  std::sort(U.time.begin(), U.time.end());
  for (const double t : U.time) U.value.push_back(until_end(of_time, t, time.back()));
  return U;
}

BottomForces bottom_forces(const SlidingChoice& sliding, const CompiledScene& compiled, const BaseHistory& base,
                           double push) {
  BottomForces forces{base.shear_force, {}, base.normal_force};
  for (double& shear : forces.shear_force.value) shear += push;
  if (const auto& uplift = sliding.uplift)
    forces.uplift =
        uplift->kind == UpliftKind::computed ? base.uplift : prescribed(*uplift, compiled, base.shear_force.time);
  return forces;
}

/// S by eq. (4) with either course of U, held and in phase; none where the course is known.
std::optional<UpliftCourses> by_course(SlidingChoice sliding, const CompiledScene& compiled, const BaseHistory& base,
                                       const BottomResistance& bottom, double push) {
  if (!sliding.uplift || !sliding.uplift->peak) return std::nullopt;
  const auto S = [&](UpliftCourse course) {
    sliding.uplift->course = course;
    return slide_on_history(bottom_forces(sliding, compiled, base, push), bottom).residual;
  };
  return UpliftCourses{S(UpliftCourse::held), S(UpliftCourse::in_phase)};
}

std::optional<EqualImpulse> equal_impulse(double mass, const HistorySliding& history) {
  if (!history.own || !history.own->by_impulse) return std::nullopt;
  const TriangularPulse pulse{history.peak_force, *history.own->by_impulse};
  return EqualImpulse{pulse.duration, sliding_distance_paper(mass, history.resistance, pulse),
                      sliding_distance_exact(mass, history.resistance, pulse)};
}

/// `push`: of still water at two levels, which is no part of the pulse, and leaves it less of the resistance.
PulseSliding pulse_sliding(const SlidingWave& wave, double mass, const HistorySliding& history, double push) {
  PulseSliding s;
  s.standing_duration = standing_duration(wave.height, wave.depth, wave.period);
  s.factor = wave.factor.value_or(DurationFactor()(wave.alpha_star));
  s.duration = s.factor * s.standing_duration;
  const TriangularPulse pulse{history.peak_force - push, s.duration};
  const double resistance = history.resistance - push;
  s.paper = sliding_distance_paper(mass, resistance, pulse);
  s.paper_parts = sliding_distance_paper_parts(mass, resistance, pulse);
  s.exact = sliding_distance_exact(mass, resistance, pulse);
  return s;
}

bool has_pore_pressure(const CompiledScene& compiled) {
  return !compiled.system.readings[static_cast<std::size_t>(compiled.system.reading(reading::uplift))].velocity.empty();
}

}  // namespace

void check_sliding(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const CompiledScene& compiled = *simulation.compiled();
  if (!scene.sliding || !compiled.caisson) return;
  const SlidingChoice& sliding = *scene.sliding;
  Diagnostics mistakes;
  const double by_mass = compiled.caisson->body.mass * scene.gravity;
  if (sliding.weight && std::abs(*sliding.weight - by_mass) > 0.01 * by_mass)
    mistakes.add(at_key("sliding.weight"),
                 "weight = " + significant(*sliding.weight, 5) + " N/m is not mass x g of the caisson, " +
                     significant(by_mass, 5) + " N/m",
                 "remove weight, or mend density or mass in [regions.caisson]");
  constexpr double rounded = 1.001;  // of a dry block, whose W' is W
  if (sliding.submerged_weight > rounded * weight_of(scene, compiled))
    mistakes.add(
        at_key("sliding.submerged_weight"),
        "submerged_weight = " + significant(sliding.submerged_weight, 5) + " N/m is above the weight in air, " +
            significant(weight_of(scene, compiled), 5) + " N/m",
        "give W' in still water, W less the weight of the water that the caisson displaces; of a dry block both "
        "are equal");
  if (sliding.uplift && sliding.uplift->kind == UpliftKind::computed && !has_pore_pressure(compiled))
    mistakes.add(at_key("sliding.uplift.kind"),
                 "the uplift cannot be computed: no pore pressure acts on the caisson's bottom",
                 "give a porous region under it a flow other than drained, or prescribe the uplift");
  const std::string moved =
      scene.initial && scene.initial->harbour_level
          ? moved_by_still_water(still_water(scene, *compiled.caisson), sliding.friction, sliding.submerged_weight)
          : "";
  if (!moved.empty())
    mistakes.add(at_key("initial.harbour_level"), moved,
                 "give the harbour a level nearer to the sea's, or check friction and submerged_weight");
  mistakes.throw_if_any();
}

TimeFunction sampled_uplift(const Scene& scene, const CompiledScene& compiled, const std::vector<double>& time) {
  const History U = prescribed(*scene.sliding->uplift, compiled, time);
  return piecewise_linear(U.time, U.value);
}

std::optional<SlidingSummary> sliding_of(const Scene& scene, const CompiledScene& compiled, const Response& response) {
  if (!scene.sliding || !compiled.caisson) return std::nullopt;
  const SlidingChoice& choice = *scene.sliding;
  SlidingSummary s;
  s.weight = weight_of(scene, compiled);
  const StillWater still = still_water(scene, *compiled.caisson);
  s.submerged_weight = choice.submerged_weight + still.weight;
  s.friction = choice.friction;
  s.drag = choice.drag;
  s.uplift = choice.uplift ? word_of(choice.uplift->kind, uplift_kind_words) : "none";
  const double mass = s.weight / scene.gravity;
  const BaseHistory base = read_base_history(compiled, response, scene.time.inertia);
  const BottomResistance bottom{mass, s.friction, s.submerged_weight, s.drag};
  s.history = slide_history(bottom_forces(choice, compiled, base, still.push), bottom);
  s.courses = by_course(choice, compiled, base, bottom, still.push);
  s.equal_impulse = equal_impulse(mass, s.history);
  if (choice.wave) s.pulse = pulse_sliding(*choice.wave, mass, s.history, still.push);
  return s;
}

}  // namespace upbead

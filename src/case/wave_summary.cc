// What a load by a wave is, in words and numbers, and what formulas say of the section under it.

#include "base/text.h"
#include "case/wave_load.h"
#include "output/section_outputs.h"
#include "upbead/sliding/combined.h"

namespace upbead {

namespace {

std::string impact_words(const WaveLoad& w) {
  const ImpactAssumptions& a = w.table.impact;
  return "the larger of a triangle, rise " + significant(a.rise_coefficient) + " sqrt(d/g) rho g " +
         (w.breaking && w.breaking->breaks ? "H_b" : "H") + "^2 / P, duration rise (" + significant(a.duration_least) +
         " + " + significant(a.duration_gain) + " exp(-" + significant(a.duration_decay) +
         " rise/T)), and gamma P_1 sin(2 pi t/T) with gamma = " + significant(w.impact->reduction) +
         ": half a period keeps the impulse P_1 T/pi, where the triangle alone has no more; assumptions of ours";
}

std::string course_words(const WaveLoad& w) {
  switch (w.table.course) {
    case WaveCourse::church_roof:
      return impact_words(w);
    case WaveCourse::triangle:
      return "a triangle of tau_0 = k(alpha*) tau_0F, eqs. (8)-(11) of Shimosako and Takahashi (1994)";
    case WaveCourse::sine:
      return "half a sine of T/2, as of a wave that does not break; an assumption of ours";
    case WaveCourse::combined:
      return "the larger of a triangle of tau_0 = k(alpha*) tau_0F and gamma_P P_1 sin(2 pi t/T), Shimosako and "
             "Takahashi (1998)";
    case WaveCourse::standing:
      return "a trough that grows within T/2, a whole period, and T/2 in which the wave dies away";
  }
  return "";
}

/// The peak_gain of an impact with that peak.
double gain_of(const WaveLoad& w, double peak) {
  return (peak / w.impact->standing_force - 1.) / w.pressure.alpha_star;
}

/// The peak of an impact, and how far it is known: it scatters from wave to wave.
std::string impact_peak_words(const WaveLoad& w) {
  const ImpactWave& impact = *w.impact;
  std::string text = "peak P_I = P_1 (1 + e alpha*), P_1 by alpha_1 alone, e = peak_gain ";
  const auto& given = w.table.impact.peak_gain;
  if (given)
    text += "= " + significant(*given) + ": " + significant(impact.peak / w.pressure.force) + " of Goda's P";
  else
    text += "not given: P_I is Goda's P, the least that may be assumed";
  if (w.pressure.alpha_star > 0.)
    text += "; measured impulsive peaks scatter from about that P to several times it (twice: peak_gain = " +
            significant(gain_of(w, 2. * w.pressure.force)) +
            ", four times: " + significant(gain_of(w, 4. * w.pressure.force)) + ")";
  return text + "; an assumption";
}

std::string peak_words(const WaveLoad& w) {
  if (w.standing)
    return "P of the standing wave that a smooth wall on a flat bed, without its mound, makes of H: 2H at the wall, "
           "potential flow by the full equations, " +
           std::to_string(w.standing->wave.harmonics()) + " harmonics, residual " +
           significant(w.standing->wave.residual(), 2);
  if (w.table.force == ImpactForce::impulse) return impact_peak_words(w);
  if (w.breaking)
    return "peak by " + text_of(*with_force(w.table.impact, w.table.force).proverbs, *w.breaking) + ": " +
           significant(w.impact->peak / w.pressure.force) + " of Goda's P" +
           (w.pressure.alpha_star > 0. ? ", as peak_gain = " + significant(gain_of(w, w.impact->peak)) : "");
  return std::string("peak P by Goda's formulas with alpha* = ") +
         (w.pressure.alpha_I > w.pressure.alpha_2 ? "alpha_I, an effective sliding force" : "alpha_2");
}

std::vector<std::string> assumptions_of(const WaveLoad& w) {
  std::vector<std::string> list{peak_words(w), "course: " + course_words(w),
                                w.standing ? "profile over the height: its own at every time; what rises above the "
                                             "crest is spilt"
                                           : "profile over the height: Goda's, the same at every time",
                                w.standing ? "uplift: a triangle with the pressure at the seaward edge at every time; "
                                             "suction would help and is left out"
                                           : "uplift: U = p_u B/2 by Goda's formulas, with alpha_1 alone"};
  if (w.table.deep_water_height) list.push_back("H and H_1/3 by random breaking of the deep-water height");
  if (!w.table.deep_water_height && !w.table.significant_height) list.push_back("H_1/3 = H/1.8");
  if (!w.table.mound.empty())
    list.push_back("on " + join(w.table.mound) +
                   ": the pressure at the wall's foot times cos(2 pi x/L) of the distance x from the wall, as of a "
                   "standing wave, at once and the same at every depth");
  if (w.table.number > 1)
    list.push_back(std::to_string(w.table.number) + " equal waves in a row, one in " + significant(w.wave.period) +
                   " s; an uplift that is held stays at its peak from the first on, on the safe side");
  if (const std::string direction = direction_text(w.table, w.section); !direction.empty())
    list.push_back("direction: " + direction);
  return list;
}

WaveLoadSummary summary_of(const WaveLoad& w) {
  const double factor = w.load.factor;
  WaveLoadSummary s;
  s.name = w.name;
  s.course = word_of(w.table.course, wave_course_words);
  s.height = w.wave.height;
  s.significant_height = w.wave.significant_height;
  s.period = w.wave.period;
  s.angle = turned_angle(w.table, w.section);
  s.direction = w.table.direction;
  s.impact = w.breaking;
  s.wavelength = w.wavelength;
  s.pressure = w.pressure;
  s.peak = factor * w.peak();
  s.peak_uplift = factor * (w.standing ? w.standing->peak_uplift : w.pressure.uplift);
  if (w.standing) s.trough_force = factor * w.standing->extremes.seaward.force;
  const double whole = 0.5 * w.wave.period;
  s.rise = w.impact ? w.impact->rise : 0.5 * (w.pulse ? w.pulse->duration : whole);
  s.duration = w.impact ? w.impact->duration : (w.pulse ? w.pulse->duration : whole);
  s.standing_force = factor * w.standing_force;
  s.end = w.end;
  s.impulse = factor * integral(w.history, 0., w.end);
  s.assumptions = assumptions_of(w);
  return s;
}

/// What formulas say of the section under the load, with its factor.
void add_formulas(const WaveLoad& w, const Water& water, WaveLoadSummary& s) {
  const double factor = w.load.factor;
  WavePressure p = w.pressure;
  p.force *= factor;
  p.force_moment *= factor;
  p.uplift *= factor;
  p.uplift_moment *= factor;
  if (p.force != 0.) s.peak_over_goda = s.peak / p.force;
  s.stability = stability(w.section, p, still_water(w.section, water));
  s.standing = standing_answer(w.section, water, w.wave, factor, w.standing ? &w.standing->wave : nullptr);
  const SlidingLoad load = sliding_load(w.section, water, p, w.wave.height, w.wave.period, w.k);
  s.sliding = sliding_distance_exact(load.mass, load.resistance, load.pulse);
  const double standing = Goda(w.section, water, w.wave).at(w.wave.height, PressureFormula::standing).force;
  const CombinedWave both{w.wave.period, factor * standing, {p.force, load.pulse.duration}, p.uplift};
  s.sliding_combined =
      sliding_distance_combined(load.mass + added_mass(water.density, w.section.foundation_depth, w.combined),
                                load.resistance, w.section.friction, both, w.combined);
}

}  // namespace

std::vector<WaveLoadSummary> wave_summaries(const Case& input) {
  std::vector<WaveLoadSummary> list;
  const Water water{input.scene.fluid.density, input.scene.gravity};
  for (const WaveLoad* wave : acting_waves(input)) {
    list.push_back(summary_of(*wave));
    add_formulas(*wave, water, list.back());
  }
  return list;
}

Checks formula_checks(const std::vector<WaveLoadSummary>& waves, const Limits& limits) {
  Checks list;
  for (const WaveLoadSummary& w : waves)
    if (w.stability)
      append(list, formula_checks({w.name, "", *w.stability, w.standing,
                                   larger_sliding(*w.sliding, *w.sliding_combined), "wave_loads." + w.name + "."},
                                  limits));
  return list;
}

OutputSchema<WaveLoadSummary> wave_load_outputs() {
  using W = WaveLoadSummary;
  return OutputSchema<W>()
      .key("course", &W::course, "", "`church_roof`, `triangle`, `sine`, `combined` or `standing`")
      .key("height", &W::height, "m", "H")
      .key("significant_height", &W::significant_height, "m", "H_1/3")
      .key("period", &W::period, "s", "T")
      .key("angle", &W::angle, "degrees", "beta")
      .key("wavelength", &W::wavelength, "m", "L")
      .key("alpha_1", inner(&W::pressure, &WavePressure::alpha_1), "", "of Goda's formula")
      .key("alpha_2", inner(&W::pressure, &WavePressure::alpha_2), "", "of Goda's formula")
      .key("alpha_I", inner(&W::pressure, &WavePressure::alpha_I), "", "as its formula says, negative or not")
      .key("alpha_star", inner(&W::pressure, &WavePressure::alpha_star), "", "alpha*")
      .key("eta_star", inner(&W::pressure, &WavePressure::eta_star), "m", "eta*")
      .key("p1", inner(&W::pressure, &WavePressure::p1), "Pa", "p_1, with alpha*")
      .key("p3", inner(&W::pressure, &WavePressure::p3), "Pa", "p_3, with alpha*")
      .key("p4", inner(&W::pressure, &WavePressure::p4), "Pa", "p_4, with alpha*")
      .key("pu", inner(&W::pressure, &WavePressure::pu), "Pa", "p_u")
      .key("force", inner(&W::pressure, &WavePressure::force), "N/m", "P, with alpha*, as `waves` gives it")
      .key("force_moment", inner(&W::pressure, &WavePressure::force_moment), "N m/m", "of P about the bottom's level")
      .key("uplift", inner(&W::pressure, &WavePressure::uplift), "N/m", "U, as `waves` gives it")
      .key("peak", &W::peak, "N/m", "largest P of the load, with its factor")
      .key("trough_force", &W::trough_force, "N/m", "least P of a standing wave, seaward; null of other courses")
      .key("peak_uplift", &W::peak_uplift, "N/m",
           "largest U of `[sliding.uplift]` of kind wave, with the load's factor")
      .key("rise", &W::rise, "s", "of the impulsive part; of a sine that of the whole")
      .key("duration", &W::duration, "s", "of the impulsive part; of a sine that of the whole")
      .key("standing_force", &W::standing_force, "N/m", "peak of the slow part, gamma P_1; 0 where there is none")
      .key("impulse", &W::impulse, "N s/m", "integral of P over the course")
      .key("end", &W::end, "s", "when the course is over")
      .key("peak_over_goda", &W::peak_over_goda, "",
           "`peak` over P by Goda's formulas with alpha*; a load below 1 is milder than what `waves` has; null where "
           "that "
           "P is 0")
      .keys_of(&W::stability, stability_outputs())
      .key("sliding_exact", &W::sliding, "m",
           "S of Goda's P with alpha* by eqs. (4), (6), tau_0 = k(alpha*) tau_0F: by formulas, without the ground")
      .key("sliding_combined", &W::sliding_combined, "m",
           "the same with the standing wave besides the pulse, by `[combined]`, as `waves` has it")
      .keys_of(&W::standing, standing_outputs())
      .object("impact", &W::impact, impact_outputs(),
              "by PROVERBS, without the load's factor; null unless `force = \"proverbs\"`")
      .key("direction", &W::direction, "degrees", "from which it comes, from north; null where `angle` is given")
      .key("assumptions[]", &W::assumptions, "", "what the load rests on, in words");
}

}  // namespace upbead

#include "case/wave_load.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "case/case_checks.h"
#include "case/case_schema.h"
#include "case/records/gauge_load.h"
#include "model/words.h"
#include "upbead/case/case.h"
#include "upbead/sliding/combined.h"

namespace upbead {

const Words<WaveCourse> wave_course_words{{"church_roof", WaveCourse::church_roof},
                                          {"triangle", WaveCourse::triangle},
                                          {"sine", WaveCourse::sine},
                                          {"combined", WaveCourse::combined},
                                          {"standing", WaveCourse::standing}};

namespace {

constexpr int most_waves = 1000;
constexpr double same_peak = 1e-9;  ///< round-off of a peak

bool has_impact(const WaveLoadTable& table) {
  return table.course == WaveCourse::church_roof;
}

TableSchema<ImpactAssumptions> wave_impact_schema() {
  TableSchema<ImpactAssumptions> table;
  declare_impact(table);
  return table;
}

}  // namespace

TableSchema<WaveLoadTable> wave_load_schema() {
  TableSchema<WaveLoadTable> table;
  declare_wave(table);
  table
      .choice(
          "course", &WaveLoadTable::course, wave_course_words,
          "how P runs in time; church_roof: an impulsive triangle beside half a standing wave, by [.impact]; triangle: "
          "tau_0 = k(alpha*) tau_0F; sine: half a sine of T/2; combined: that triangle beside half a standing wave; "
          "standing: crest and trough of a standing wave of finite height, for waves that do not break")
      .required();
  table
      .choice("force", &WaveLoadTable::force, impact_force_words,
              "peak of P; goda_with_alpha_I: as `waves` gives it, an effective sliding force; impulse: P_I of "
              "[.impact], as `expected` has it; proverbs: F* rho g H_b^2 of a wave that breaks on the wall, by "
              "[.impact.proverbs], at least Goda's P")
      .when("course", has_impact, "where course = \"church_roof\"");
  table.key("number", &WaveLoadTable::number, "",
            "of equal waves in a row, one a period: ground and slip remember those before", from_to(1, most_waves));
  table
      .key("mound", &WaveLoadTable::mound, "",
           "curves of mound and bed, without a sea upon them, on which the wave presses in front of the wall as at its "
           "foot, by cos(2 pi x/L): the mound's pore water then carries it under the base, for uplift of kind computed")
      .fallback("none");
  table.table("impact", &WaveLoadTable::impact, wave_impact_schema())
      .doc("The impulsive part of a church roof, as in a design: assumptions of ours")
      .when("course", has_impact, "where course = \"church_roof\"");
  return table;
}

double WaveLoad::peak() const {
  if (standing) return standing->extremes.landward.force;
  return impact ? impact->peak : pressure.force;
}

namespace {

ImpactWave impact_of(const WaveLoad& w, const WavePressure& standing, const Water& water) {
  const ImpactAssumptions assumptions = with_force(w.table.impact, w.table.force);
  return impact_wave(assumptions,
                     wave_on_wall(w.wave.height, w.wave.period, standing, w.pressure,
                                  breaker_of(assumptions, w.section, w.wavelength)),
                     water, w.section.berm_depth);
}

/// Where the triangle crosses the standing wave closer than this share of the rise to the peak or to an end, no kink
/// is set.
constexpr double least_gap = 1e-3;

TimeFunction history_of(const ImpactWave& wave) {
  const auto [from, to] = where_triangle_leads(wave);
  const double gap = least_gap * wave.rise, end = 0.5 * wave.period;
  std::vector<double> kinks{0., wave.rise, end};
  for (const double t : {from, to})
    if (std::min({t, std::abs(t - wave.rise), end - t}) > gap) kinks.push_back(t);
  std::sort(kinks.begin(), kinks.end());
  const auto zero = [](double) { return 0.; };
  std::vector<TimeFunction::Piece> pieces(kinks.size() + 1, [wave](double t) { return force_at(wave, t); });
  pieces.front() = pieces.back() = zero;
  return TimeFunction(std::move(kinks), std::move(pieces));
}

void add_church_roof(const WavePressure& standing, const Water& water, WaveLoad& w) {
  w.impact = impact_of(w, standing, water);
  if (const auto& scatter = with_force(w.table.impact, w.table.force).proverbs)
    w.breaking = breaking_impact(*scatter, w.section, water, w.wave, w.wavelength);
  w.standing_force = w.impact->reduction * w.impact->standing_force;
  w.history = history_of(*w.impact);
  w.duration = 2. * std::min(w.impact->rise, w.impact->duration - w.impact->rise);
}

void add_triangle(WaveLoad& w) {
  const double standing = standing_duration(w.wave.height, w.section.water_depth, w.wave.period);
  w.pulse = {w.pressure.force, w.k(w.pressure.alpha_star) * standing};
}

void add_pulse(const Pulse& pulse, WaveLoad& w) {
  w.history = time_function(pulse);
  w.duration = duration(pulse);
  w.end = *pulse.duration;
}

void add_combined(const WavePressure& standing, WaveLoad& w) {
  add_triangle(w);
  const CombinedWave combined{w.wave.period, standing.force, *w.pulse, w.pressure.uplift};
  const History force = combined_force(combined);
  w.standing_force = standing_reduction(combined) * standing.force;
  w.history = piecewise_linear(force.time, force.value);
  w.duration = w.pulse->duration;
}

void add_standing(const Water& water, WaveLoad& w) {
  w.standing = std::make_shared<const StandingLoad>(standing_load(w.wave, w.section, water));
  w.wavelength = w.standing->wave.wavelength();
  w.history = w.standing->force;
  w.end = w.standing->end;
}

Pulse pulse_of(PulseShape shape, double peak, double duration) {
  Pulse pulse;
  pulse.shape = shape;
  pulse.peak = peak;
  pulse.duration = duration;
  return pulse;
}

}  // namespace

std::shared_ptr<WaveLoad> wave_load(const WaveLoadTable& table, const Section& section, const Water& water,
                                    const DurationFactor& k) {
  const auto wave = std::make_shared<WaveLoad>();
  WaveLoad& w = *wave;
  w.table = table;
  w.section = section;
  w.k = k;
  w.wave = design_wave(table, section, water);
  const Goda goda(section, water, w.wave);
  w.wavelength = goda.wavelength();
  w.pressure = goda.at(w.wave.height);
  w.end = 0.5 * w.wave.period;
  w.outside = warnings(section, water, w.wave, w.pressure);
  const WavePressure standing = goda.at(w.wave.height, PressureFormula::standing);
  switch (table.course) {
    case WaveCourse::church_roof:
      add_church_roof(standing, water, w);
      break;
    case WaveCourse::triangle:
      add_triangle(w);
      add_pulse(pulse_of(PulseShape::triangle, w.pulse->peak, w.pulse->duration), w);
      break;
    case WaveCourse::sine:
      add_pulse(pulse_of(PulseShape::half_sine, w.pressure.force, w.end), w);
      break;
    case WaveCourse::combined:
      add_combined(standing, w);
      break;
    case WaveCourse::standing:
      add_standing(water, w);
      break;
  }
  if (table.number > 1) {
    w.history = repeated(w.history, table.number, w.wave.period);
    w.end += (table.number - 1) * w.wave.period;
  }
  return wave;
}

Gauges row_on_wall(const StandingLoad& standing, double still) {
  Gauges row = standing.gauges;
  for (double& place : row.place) place += still;
  return row;
}

std::vector<const WaveLoad*> acting_waves(const Case& input) {
  std::vector<const WaveLoad*> list = sources_of_type<WaveLoad>(input);
  list.erase(std::remove_if(list.begin(), list.end(), [](const WaveLoad* wave) { return !wave->acts(); }), list.end());
  return list;
}

std::vector<Pair> pressure_profile(const WaveLoad& wave, double bottom) {
  const WavePressure& p = wave.pressure;
  const double still = bottom + wave.section.foundation_depth;
  std::vector<Pair> profile{{bottom, p.p3 / p.p1}, {still, 1.}};
  if (const double top = std::min(p.eta_star, wave.section.crest); top > 0.)
    profile.push_back({still + top, p.p4 / p.p1});
  return profile;
}

namespace {

NumberedWarning effective_force(const std::string& title, const WavePressure& p) {
  return {
      "effective_force",
      p.alpha_I,
      p.alpha_2,
      "1",
      title + ": P of Goda's formulas with alpha_I = " + significant(p.alpha_I) +
          " already is an effective sliding force, which the caisson's dynamics make another one of: where F_T/P is "
          "below 1 the reduction counts twice: the checks by formulas, which stand beside the others, are those of "
          "this P itself, and the worse governs",
      "give the peak of an impact for the caisson's own dynamics: force = \"impulse\" with peak_gain"};
}

/// An impact that is milder than Goda's P by its peak_gain.
NumberedWarning below_goda(const std::string& title, const WaveLoad& w) {
  return {"impact_below_goda",
          w.peak(),
          w.pressure.force,
          "N/m",
          title + ": the peak of the impact, " + with_unit(w.peak(), "N/m") + ", is below P of Goda's formulas, " +
              with_unit(w.pressure.force, "N/m") +
              ", which already is an effective sliding force: checks by dynamics are on the unsafe side of those by "
              "formulas",
          "leave peak_gain out, or give a larger one"};
}

NumberedWarning outside_formulas(const std::string& title, const NumberedWarnings& found) {
  std::vector<std::string> what, cures;
  for (const NumberedWarning& one : found) {
    what.push_back(one.what);
    if (std::find(cures.begin(), cures.end(), one.cure) == cures.end()) cures.push_back(one.cure);
  }
  return {"wave_outside_formulas",
          static_cast<double>(found.size()),
          0.,
          "1",
          title + ": " + join(what, "; ") + " (docs/waves.md)",
          join(cures, "; "),
          std::any_of(found.begin(), found.end(), [](const NumberedWarning& one) { return one.voids; })};
}

/// Warnings wave_outside_formulas, effective_force and impact_below_goda: docs/warnings.md.
NumberedWarnings warnings_of(const WaveLoad& w) {
  NumberedWarnings list;
  const WavePressure& p = w.pressure;
  if (!w.standing && w.table.force == ImpactForce::goda_with_alpha_I && p.alpha_I > p.alpha_2)
    list.push_back(effective_force(w.title, p));
  if (w.impact && w.peak() < (1. - same_peak) * p.force) list.push_back(below_goda(w.title, w));
  if (!w.outside.empty()) list.push_back(outside_formulas(w.title, w.outside));
  return list;
}

bool is_wave(const LoadTable& table) {
  return table.kind == LoadKind::wave;
}

void check_wave_table(const LoadCheck& check) {
  const WaveLoadTable& wave = *check.load.wave;
  const std::optional<Section>& section = check.tables.section;
  check.wrong.add(diagnose(static_cast<const WaveGiven&>(wave), section ? &*section : nullptr), "wave.");
  if (has_impact(wave)) check.wrong.add(diagnose(wave.impact, wave.force), "wave.impact.");
  if (wave.course != WaveCourse::standing) return;
  if (wave.number > 1)
    check.wrong.add("wave.number", "a standing wave has a course of its own, of one whole wave between two halves",
                    "remove number, or write another course");
  if (section && turned_angle(wave, *section) != 0.)
    check.wrong.add(wave.direction ? "wave.direction" : "wave.angle",
                    "a standing wave of finite height is one that comes straight at the wall",
                    "give angle = 0, which is the safe side, or another course");
  if (section && section->dissipating_blocks)
    check.wrong.add("wave.course", "wave-dissipating blocks leave no standing wave before the wall",
                    "give another course, which Goda's factors for blocks belong to");
}

void check_wave(const LoadCheck& check) {
  constexpr double least_lambda_1 = 1e-3;  // a wave whose lambda_1 is smaller has a P of nearly zero
  check.refuse({"pulse", "history", "shape", "region"}, "a load by a wave", "write kind = \"force\"");
  if (check.load.factor < 0.)
    check.wrong.add("factor",
                    "factor = " + number_text(check.load.factor) +
                        ": a wave pushes landward, with the uplift of that, and no formula knows one that pulls",
                    "give a factor of at least 0; the pull of a trough is that of course = \"standing\"");
  if (check.load.wave)
    check_wave_table(check);
  else
    check.wrong.add("wave", "'wave' is missing, which kind = \"wave\" needs",
                    "add wave = { height = ..., period = ..., course = \"church_roof\" }");
  const std::optional<Section>& section = check.tables.section;
  if (!section)
    check.wrong.add("kind",
                    "a load by a wave needs the cross-section that Goda's formulas take, and there is no [section]",
                    "add [section], as in a design");
  else if (section->lambda_1 && *section->lambda_1 < least_lambda_1)
    check.report.add(check.document.place("section.lambda_1"),
                     "[section]: lambda_1 = " + number_text(*section->lambda_1) +
                         " leaves nothing of the standing wave, which is a part of the load [" + check.path + "]",
                     "give at least " + number_text(least_lambda_1));
}

/// The course of the pressure at the wall's foot (Pa): that of P with p_3 of Goda's profile, or the standing wave's
/// own.
TimeFunction pressure_at_foot(const WaveLoad& w, const std::map<std::string, Load>& made) {
  if (!w.standing) return scaled(w.history, w.load.factor * w.pressure.p3 / w.pressure.force);
  const auto lowest = made.find(w.name + "." + w.standing->gauges.name.front());
  return lowest == made.end() ? TimeFunction() : lowest->second.history;
}

/// Adds pressures on mound and bed; their courses along x are set once the mesh is known.
void add_mound(const Load& load, WaveLoad& w) {
  const TimeFunction at_foot = pressure_at_foot(w, w.made);
  for (const std::string& curve : w.table.mound) {
    Load& one = w.made[w.name + "." + curve] = load;
    one.boundary = one.transducer = curve;
    one.kind = LoadKind::pressure;
    one.over_x = true;
    one.history = at_foot;
  }
}

/// A landward force; its shape over the wall is set once the mesh is known.
std::shared_ptr<LoadSource> read_wave(const GivenLoad& given) {
  const Scene& scene = given.problem.scene;
  const auto source = [&] {
    try {
      const CaseTables& tables = *given.problem.tables;
      const auto wave = wave_load(*given.table.wave, *tables.section, {scene.fluid.density, scene.gravity},
                                  tables.duration.value_or(DurationFactor()));
      wave->combined = tables.combined.value_or(CombinedModel());
      return wave;
    } catch (const NumericsError& error) {
      throw InputError(given.place("wave.height"), error.what(),
                       "give a lower wave, or course = \"church_roof\", which is of waves that break");
    }
  }();
  begin(given, *source);
  Load load = given.table;
  load.kind = LoadKind::force;
  load.history = source->history;
  load.duration = source->duration;
  load = with_factor(std::move(load));
  if (source->standing)
    source->made = gauge_loads(given.name, load, source->standing->gauges, given.end());
  else
    source->made[given.name] = load;
  if (!source->acts()) return source;
  add_mound(load, *source);
  source->action = action_of(source->title, "wave_cut", "its period", source->history);
  source->warnings = warnings_of(*source);
  return source;
}
}  // namespace

std::vector<Pair> profile_on_mound(const WaveLoad& wave, double wall, double seaward) {
  constexpr double per_length = 128.;  // straight between them: within (2 pi/128)^2/8 = 3e-4
  const double reach = wall - seaward, number = two_pi / wave.wavelength;
  const int n = 1 + static_cast<int>(std::max(reach, 0.) * per_length / wave.wavelength);
  std::vector<Pair> profile;
  for (int i = n; i >= 0; --i) {
    const double x = reach * i / n;
    profile.push_back({wall - x, std::cos(number * x)});
  }
  return profile;
}

LoadWay by_wave() {
  return {[](const LoadTable& table) { return is_wave(table) && table.from.empty(); },
          [](TableSchema<LoadTable>& table) {
            table.table("wave", &LoadTable::wave, wave_load_schema())
                .doc(
                    "A wave, with exactly one of height and deep_water_height; its pressure over the height of the "
                    "wall is Goda's.")
                .when("kind", is_wave, "where kind = \"wave\"");
          },
          check_wave,
          read_wave,
          {},
          "section"};
}

}  // namespace upbead

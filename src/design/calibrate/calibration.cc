#include "design/calibrate/calibration_report.h"

#include <algorithm>
#include <cmath>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "design/calibrate/calibration_waves.h"
#include "design/expected_laws.h"
#include "soils/soil_answers.h"
#include "upbead/sliding/history_sliding.h"

namespace upbead {

namespace {

CalibrationFit fit(const CalibratedModel& model, DurationMeasure measure, std::optional<double> ratio,
                   const DurationFactor& given) {
  CalibrationFit out;
  out.measure = measure;
  out.ratio = ratio;
  for (const CalibratedWave& wave : model.waves)
    for (const WaveDuration& duration : wave.durations) {
      const auto tau_0 = duration.tau_0.find(measure);
      if (tau_0 != duration.tau_0.end() && (!ratio || duration.ratio == *ratio))
        out.points.push_back({wave.alpha_star, tau_0->second / wave.tau_0F});
    }
  out.fit = fit_duration_factor(out.points);
  if (!out.points.empty()) out.given = quality(out.points, given);
  out.given_in_ellipse = out.fit && in_ellipse(*out.fit, given);
  return out;
}

/// What all waves of one model have in common, at the model's size.
struct Setting {
  Section section;
  Water water;
  ImpactAssumptions impact;
  std::vector<double> ratios;
  std::vector<CalibrationWave> waves;
};

Setting setting_at(const DesignTables& tables, const CalibrationWaves& waves, double scale) {
  Setting setting{scaled(tables.section, scale), tables.water, tables.impact, tables.calibration->ratios.values, {}};
  for (const CalibrationWave& wave : waves.waves) setting.waves.push_back(scaled(wave, scale));
  return setting;
}

Breakwater breakwater_of(const Setting& setting, const CalibrationWave& wave) {
  return {with_mound(setting.section, wave), setting.water, {}, {}};
}

double shortest_rise(const Setting& setting) {
  double shortest = HUGE_VAL;
  for (const CalibrationWave& wave : setting.waves) {
    const WaveForces forces(breakwater_of(setting, wave), sea_state(wave));
    const ImpactWave impact =
        impact_wave(setting.impact,
                    wave_on_wall(wave.height, wave.period, forces.at(wave.height, {}, PressureFormula::standing),
                                 forces.at(wave.height, {})),
                    setting.water, wave.berm_depth);
    shortest = std::min(shortest, impact.rise);
  }
  return shortest;
}

WaveDuration duration_at(double ratio, double mass, const History& force) {
  const HistoryDuration found = history_duration(mass, force, ratio);
  WaveDuration duration{ratio, found.sliding, {}};
  const auto take = [&duration](DurationMeasure measure, const std::optional<double>& tau_0) {
    if (tau_0) duration.tau_0[measure] = *tau_0;
  };
  take(DurationMeasure::paper, found.by_paper);
  take(DurationMeasure::exact, found.by_exact);
  take(DurationMeasure::excess, found.by_excess);
  take(DurationMeasure::impulse, found.by_impulse);
  return duration;
}

CalibratedWave calibrate_wave(const Setting& setting, std::size_t number,
                              const std::shared_ptr<const ShearAnswer>& answer) {
  const CalibrationWave& wave = setting.waves[number];
  CalibratedWave out;
  static_cast<CalibrationWave&>(out) = wave;
  out.wave = number;
  out.tau_0F = standing_duration(wave.height, setting.section.water_depth, wave.period);
  const DynamicWave answered =
      DynamicLaw(breakwater_of(setting, wave), sea_state(wave), setting.impact, answer).wave(wave.height);
  out.impact = answered.wave;
  out.peak_shear = *std::max_element(answered.shear.begin(), answered.shear.end());
  const History force{answered.time, answered.sliding_force};
  out.peak_sliding_force = force.value[peak_index(force)];
  if (out.peak_sliding_force <= 0.) return out;  // nothing pushes the caisson landward
  for (const double ratio : setting.ratios)
    out.durations.push_back(duration_at(ratio, setting.section.weight / setting.water.gravity, force));
  return out;
}

/// Fits by every measure: for each r, and for all r together; tau_0 by impulse is the same at every r and fitted
/// once.
std::vector<CalibrationFit> fits(const CalibratedModel& model, const std::vector<double>& ratios,
                                 const DurationFactor& given) {
  std::vector<CalibrationFit> list;
  for (const DurationMeasure measure : {DurationMeasure::paper, DurationMeasure::exact, DurationMeasure::excess}) {
    for (const double ratio : ratios) list.push_back(fit(model, measure, ratio, given));
    list.push_back(fit(model, measure, std::nullopt, given));
  }
  list.push_back(fit(model, DurationMeasure::impulse, ratios.front(), given));
  list.back().ratio.reset();
  return list;
}

/// One model and the place of its table.
struct Calibrator {
  Calibrator(const Design& design, const CalibrationWaves& waves, const std::string& of)
      : name(of),
        given(design.tables.duration),
        table(design.tables.calibration->models.at(of)),
        path(design.resolve(table.model)),
        place(design.document.place(dotted("calibration.models", of))),
        setting(setting_at(design.tables, waves, table.scale)) {}

  CalibratedModel of(const WaveModel& model) const {
    CalibratedModel out;
    out.name = name;
    out.title = model.title;
    out.load = model.load;
    out.warnings = model.warnings;
    out.scale = table.scale;
    out.shortest_rise = shortest_rise(setting);
    out.step = table.step.value_or(out.shortest_rise / steps_of_a_rise);
    const auto answer = std::make_shared<const ShearAnswer>(model.shear, out.step, 0.);
    out.waves.resize(setting.waves.size());
    in_parallel(out.waves.size(), "calibrating " + name,
                [&](std::size_t i) { out.waves[i] = calibrate_wave(setting, i, answer); });
    out.fits = fits(out, setting.ratios, given);
    return out;
  }

  CalibratedModel of_soils(const SoilAnswers& soils) const {
    CalibratedModel all;
    for (int i = 0; i < *table.soils; ++i) {
      const Soil soil = drawn_soil(soils.file().box, i);
      const ReducedModelFile model = of_soil(soils, soil, place);
      CalibratedModel one = of(wave_model(model, table, setting.section, setting.water, place));
      const CalibrationFit* taken = recommended(one);
      std::vector<CalibratedSoil> before = std::move(all.soils);
      before.push_back({soil, model.error, taken ? taken->fit : std::nullopt});
      if (i > 0) one.waves.insert(one.waves.begin(), all.waves.begin(), all.waves.end());
      all = std::move(one);
      all.soils = std::move(before);
    }
    all.fits = fits(all, setting.ratios, given);
    return all;
  }

  std::string name;
  DurationFactor given;
  const ScaledModel& table;
  std::string path;
  Place place;
  Setting setting;
};

CalibratedModel calibrate_model(const Design& design, const CalibrationWaves& waves, const std::string& name) {
  const Calibrator calibrator(design, waves, name);
  const ScaledModel& table = calibrator.table;
  if (!table.soils)
    return calibrator.of(read_wave_model(calibrator.path, table, calibrator.setting.section, calibrator.setting.water,
                                         calibrator.place));
  return calibrator.of_soils({read_soil_model_file(calibrator.path), calibrator.path});
}

constexpr double most_waves = 1e6;  // waves of the grid: minutes

double n_grid(const CalibrationTable& grid) {
  double n = 1.;
  for (const NumberList* list :
       {&grid.relative_height, &grid.period, &grid.relative_berm_depth, &grid.relative_berm_width})
    n *= static_cast<double>(list->values.size());
  return n;
}

void check_models(const DesignTables& tables, const Document& document, Diagnostics& report) {
  const auto& models = tables.calibration->models;
  if (models.empty() && report.sound("calibration.models"))
    report.add(
        document.place("calibration"), "[calibration] has no reduced model",
        "add a table [calibration.models.NAME] with model = the path of a reduced model, made by 'upbead reduce'");
  if (!report.sound("section") || !report.sound("gravity") || !report.sound("fluid")) return;
  for (const auto& [name, model] : models) {
    const std::string path = dotted("calibration.models", name);
    if (model.soils && !model.soil.empty())
      report.add(document.place(path), "[" + path + "] has 'soil' and 'soils'", "keep one of them");
    if (report.sound(path))
      check_model(path, model, scaled(tables.section, model.scale), tables.water, document, report);
  }
}

void check_grid(const DesignTables& tables, const Document& document, Diagnostics& report) {
  const CalibrationTable& grid = *tables.calibration;
  if (grid.steepness[0] >= grid.steepness[1])
    report.add(document.place("calibration.steepness"), "no steepness lies between the two limits",
               "give the least steepness H/L first, then a larger one");
  else if (n_grid(grid) > most_waves)
    report.add(document.place("calibration"),
               "the grid has " + significant(n_grid(grid)) + " waves, more than " + significant(most_waves),
               "give fewer heights, periods or berms");
  else if (report.sound("section") && report.sound("gravity") && report.sound("fluid") &&
           calibration_waves(tables).waves.empty())
    report.add(document.place("calibration"), "every wave of the grid is beyond the limits of the formulas",
               "give H/h up to 0.8, periods with H below 0.142 L tanh(kh) and H/L within steepness, and d up to h'");
}

/// k is that of waves on a resistance without still water's push.
void refuse_harbour(const DesignTables& tables, const Document& document, Diagnostics& report) {
  if (report.sound("section") && tables.section.harbour_level != 0.)
    report.add(document.place("section.harbour_level"),
               "[section]: a calibration has sea and harbour at one level, as k belongs to the wave alone",
               "remove it, or write --set section.harbour_level=0");
}

}  // namespace

void check_calibration(const DesignTables& tables, const Document& document, Diagnostics& report) {
  check_impact(tables, document, report);
  refuse_harbour(tables, document, report);
  if (report.sound("impact") && tables.impact.force == ImpactForce::proverbs)
    report.add(document.place("impact.force"),
               "a calibration is for every wave with every mound, and has no wave that breaks on one wall",
               "write force = \"impulse\" with a peak_gain");
  if (!tables.calibration) {
    if (report.sound("calibration"))
      report.add(document.place("calibration"), "the table [calibration] is missing, which 'calibrate' needs",
                 "add [calibration] with period = [T, ...] (s), and [calibration.models.NAME]");
    return;
  }
  const bool sound = report.sound("calibration");
  check_models(tables, document, report);
  if (sound) check_grid(tables, document, report);
}

const CalibrationFit* recommended(const CalibratedModel& model) {
  const CalibrationFit* best = nullptr;
  for (const CalibrationFit& found : model.fits) {
    if (found.measure != DurationMeasure::exact || !found.fit || found.fit->doubt != FitDoubt::none) continue;
    if (!found.ratio) return &found;
    if (!best || found.fit->residual_deviation < best->fit->residual_deviation) best = &found;
  }
  return best;
}

const char* word(DurationMeasure measure) {
  switch (measure) {
    case DurationMeasure::paper:
      return "paper";
    case DurationMeasure::exact:
      return "exact";
    case DurationMeasure::excess:
      return "excess";
    case DurationMeasure::impulse:
      break;
  }
  return "impulse";
}

Calibration calibrate(const Design& design) {
  const Stopwatch watch;
  const CalibrationWaves waves = calibration_waves(design.tables);
  Calibration out;
  out.n_grid = waves.n_grid;
  out.n_waves = waves.waves.size();
  out.left = waves.left;
  out.given = design.tables.duration;
  for (const auto& [name, model] : design.tables.calibration->models)
    out.models.push_back(calibrate_model(design, waves, name));
  out.seconds = watch.seconds();
  return out;
}

}  // namespace upbead

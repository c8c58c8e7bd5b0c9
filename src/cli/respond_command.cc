#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>

#include "base/files.h"
#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "cli/respond_cases.h"
#include "output/wave_response.h"
#include "respond/respond_waves.h"
#include "sliding/still_water_push.h"

namespace upbead {

namespace {

constexpr std::size_t longest_table = 20;  // rows that people read

/// A wave with its name.
struct Named {
  std::string name;
  const WaveResponse* wave;
};

std::vector<Named> all_waves(const std::vector<WaveResponses>& files) {
  std::vector<Named> list;
  for (const WaveResponses& file : files)
    for (std::size_t w = 0; w < file.waves.size(); ++w) list.push_back({file.wave_name(w), &file.waves[w]});
  return list;
}

/// Whether the coupled slip of the wave was asked for.
bool is_asked(const Named& row) {
  return row.wave->coupled || !row.wave->why_not_coupled.empty();
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

std::string ratio_text(const WaveResponse& wave) {
  return wave.ratio ? significant(*wave.ratio, 4) : "none";
}

std::string error_text(const WaveResponse& wave) {
  return wave.error_estimate ? "< " + significant(100. * *wave.error_estimate, 2) + " %" : "unknown";
}

std::string table(const std::vector<Named>& waves) {
  const bool sliding = waves.front().wave->sliding.has_value();
  const bool coupled = std::any_of(waves.begin(), waves.end(), is_asked);
  std::size_t width = 12;
  for (const Named& row : waves) width = std::max(width, row.name.size() + 2);
  std::string text = padded("wave", width) + "peak P         peak F_T       F_T / P   error of F_T";
  if (sliding) text += coupled ? "   S              S, coupled" : "   S";
  text += "\n";
  for (const Named& row : waves) {
    const WaveResponse& w = *row.wave;
    const std::string error = error_text(w);
    text += padded(row.name, width) + padded(with_unit(w.peak_force, "N/m"), 15) +
            padded(with_unit(w.peak_shear, "N/m", w.peak_force), 15) + padded(ratio_text(w), 10);
    text += sliding ? padded(error, 15) : error;
    if (sliding) text += coupled ? padded(with_unit(*w.sliding, "m"), 15) : with_unit(*w.sliding, "m");
    if (coupled) text += w.coupled ? with_unit(w.coupled->sliding, "m") : "no value";
    text += "\n";
  }
  return text;
}

std::string factor_text(const std::optional<double>& factor) {
  return factor ? significant(*factor, 4) : "none";
}

std::string circle_text(const std::optional<CircleInWave>& circle) {
  if (!circle) return "none";
  const std::string when = " at " + significant(circle->time) + " s";
  if (circle->slips.empty()) return "0: the resultant leaves the base" + when;
  return significant(circle->factor, 4) + " " + circle->slips + when;
}

/// The least factor of each way to fail, where the ground has circles.
std::string factors(const std::vector<Named>& waves) {
  if (std::none_of(waves.begin(), waves.end(), [](const Named& row) { return row.wave->circle; })) return "";
  std::size_t width = 12;
  for (const Named& row : waves) width = std::max(width, row.name.size() + 2);
  std::string text = padded("least", width) + "sliding   seaward   overturning  slip circles\n";
  for (const Named& row : waves) {
    const WaveResponse& w = *row.wave;
    text += padded(row.name, width) + padded(factor_text(w.least_sliding_factor), 10) +
            padded(factor_text(w.least_sliding_factor_seaward), 10) +
            padded(factor_text(w.least_overturning_margin), 13) + circle_text(w.circle) + "\n";
  }
  return text;
}

/// The least factors of many waves.
std::string factors_overview(const std::vector<Named>& waves) {
  const Named* worst = nullptr;
  int below = 0;
  for (const Named& row : waves) {
    if (!row.wave->circle) continue;
    if (row.wave->circle->factor < 1.) ++below;
    if (!worst || row.wave->circle->factor < worst->wave->circle->factor) worst = &row;
  }
  if (!worst) return "";
  return "circles     F below 1 in " + std::to_string(below) + " of them, least " + circle_text(worst->wave->circle) +
         " in " + worst->name + "\n";
}

/// How many waves slide the caisson, and how far.
std::string sliding_overview(const std::vector<Named>& waves, const std::string& title,
                             const std::function<double(const WaveResponse&)>& S) {
  const auto farthest = std::max_element(waves.begin(), waves.end(),
                                         [&S](const Named& a, const Named& b) { return S(*a.wave) < S(*b.wave); });
  const auto n = std::count_if(waves.begin(), waves.end(), [&S](const Named& a) { return S(*a.wave) != 0.; });
  return title + std::to_string(n) + " of them slide the caisson, farthest " + with_unit(S(*farthest->wave), "m") +
         " in " + farthest->name + "\n";
}

std::string overview(const std::vector<Named>& waves) {
  const auto [least, most] = std::minmax_element(waves.begin(), waves.end(), [](const Named& a, const Named& b) {
    return a.wave->peak_shear < b.wave->peak_shear;
  });
  const double top = most->wave->peak_shear;
  std::string text = "waves       " + std::to_string(waves.size()) + "\n";
  text += "peak F_T    " + with_unit(least->wave->peak_shear, "N/m", top) + " to " + with_unit(top, "N/m") +
          ", largest in " + most->name + " (peak P " + with_unit(most->wave->peak_force, "N/m") + ", F_T / P " +
          ratio_text(*most->wave) + ")\n";
  if (waves.front().wave->error_estimate) {
    const Named& worst = *std::max_element(waves.begin(), waves.end(), [](const Named& a, const Named& b) {
      return a.wave->error_estimate < b.wave->error_estimate;
    });
    text += "error of F_T " + error_text(*worst.wave) + " of its largest value, largest in " + worst.name + "\n";
  }
  if (!waves.front().wave->sliding) return text;
  text += sliding_overview(waves, "sliding     ", [](const WaveResponse& w) { return *w.sliding; });
  if (std::none_of(waves.begin(), waves.end(), is_asked)) return text;
  std::vector<Named> told;
  std::copy_if(waves.begin(), waves.end(), std::back_inserter(told), [](const Named& a) { return a.wave->coupled; });
  if (told.empty()) return text + "S, coupled  could be computed for none of them\n";
  text += sliding_overview(told, "S, coupled  ", [](const WaveResponse& w) { return w.coupled->sliding; });
  const auto n =
      std::count_if(told.begin(), told.end(), [](const Named& a) { return a.wave->coupled->lifted_time > 0.; });
  if (n > 0) text += "            " + std::to_string(n) + " of them would lift it\n";
  return text;
}

/// A warning where the coupled S of some waves could not be computed.
NumberedWarnings slip_warnings(const std::vector<WaveResponses>& files) {
  const std::vector<Named> waves = all_waves(files);
  const auto untold = [](const Named& row) { return !row.wave->why_not_coupled.empty(); };
  const auto first = std::find_if(waves.begin(), waves.end(), untold);
  if (first == waves.end()) return {};
  const auto n = std::count_if(waves.begin(), waves.end(), untold);
  return {{"no_coupled_slip", static_cast<double>(n), 0., "1",
           "the distance that the caisson slips as a whole could not be computed for " + std::to_string(n) + " of " +
               std::to_string(waves.size()) + " waves, such as " + first->name + ": " + first->wave->why_not_coupled,
           "take S of the bonded caisson, or solve such a wave by 'upbead run' with contact node by node (kind = "
           "\"friction\")"}};
}

/// A table of a few waves; of many, their number, ranges and the worst.
std::string describe(const ReducedModelFile& model, const std::vector<WaveResponses>& files,
                     const RespondTiming& timing) {
  const std::vector<Named> waves = all_waves(files);
  std::string text = model.title + ", reduced to " + std::to_string(model.modes.n_modes()) + " modes: F_T within " +
                     significant(100. * model.error) + " % up to " + significant(model.highest_frequency) + " Hz\n";
  text += waves.size() <= longest_table ? table(waves) + factors(waves) : overview(waves) + factors_overview(waves);
  text += "time        read " + significant(timing.read) + " s, respond " + significant(timing.respond) + " s";
  if (timing.respond > 0.)
    text += " (" + significant(static_cast<double>(waves.size()) / timing.respond) + " waves a second)";
  return text + ", write " + significant(timing.write) + " s\n";
}

/// A warning where more of a wave's response than the model's tolerance lies above the model's highest frequency.
NumberedWarnings band_warnings(const ReducedModelFile& model, const std::vector<WaveResponses>& files) {
  const std::vector<Named> waves = all_waves(files);
  const auto n = std::count_if(waves.begin(), waves.end(),
                               [&model](const Named& row) { return row.wave->beyond_band > model.tolerance; });
  if (n == 0) return {};
  const Named& worst = *std::max_element(waves.begin(), waves.end(), [](const Named& a, const Named& b) {
    return a.wave->beyond_band < b.wave->beyond_band;
  });
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
  const std::vector<Named> waves = all_waves(files);
  const auto estimate = [](const Named& row) { return row.wave->error_estimate.value_or(0.); };
  const auto n =
      std::count_if(waves.begin(), waves.end(), [&](const Named& row) { return estimate(row) > model.tolerance; });
  if (n == 0) return {};
  const Named& worst = *std::max_element(waves.begin(), waves.end(),
                                         [&](const Named& a, const Named& b) { return estimate(a) < estimate(b); });
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
  const std::vector<Named> waves = all_waves(files);
  const auto factor = [](const Named& row) { return row.wave->circle ? row.wave->circle->factor : HUGE_VAL; };
  const auto n = std::count_if(waves.begin(), waves.end(), [&](const Named& row) { return factor(row) < 1.; });
  if (n == 0) return {};
  const Named& worst = *std::min_element(waves.begin(), waves.end(),
                                         [&](const Named& a, const Named& b) { return factor(a) < factor(b); });
  return {{"slip_circle", factor(worst), 1., "1",
           "in " + std::to_string(n) + " of " + std::to_string(waves.size()) +
               " waves the ground under the caisson would slip on a circle, worst in " + worst.name +
               ": F = " + circle_text(worst.wave->circle) + " by Bishop's simplified method",
           "widen the caisson or its berm, or give the mound more height; a factor below 1 of a moment is a permanent "
           "displacement and not yet a collapse"}};
}

struct Arguments {
  std::string model;
  std::vector<std::string> forces;
  bool json = false;
  std::string out;
  std::optional<double> end, friction, submerged_weight;
};

void require_positive(const std::optional<double>& value, const std::string& option, const std::string& example,
                      Diagnostics& mistakes) {
  if (value && !(*value > 0. && std::isfinite(*value)))
    mistakes.add(Place(), option + " " + significant(*value) + " is not above 0",
                 "give a positive number such as " + example);
}

void check(const Arguments& arguments) {
  Diagnostics mistakes;
  require_positive(arguments.end, "--end", "2 (s)", mistakes);
  require_positive(arguments.friction, "--friction", "0.6", mistakes);
  require_positive(arguments.submerged_weight, "--buoyant-weight", "3.4e6 (N/m)", mistakes);
  if (arguments.forces.empty() && !is_case(arguments.model))
    mistakes.add(Place(), "there is no wave to answer", "give files of waves after the model, such as storm.csv");
  mistakes.throw_if_any();
}

/// The name of the file, or of its folder where the file has the name that 'upbead reduce' gives to every model.
std::string model_name(const std::string& path) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  return (file.stem() == "reduced" && file.has_parent_path() ? file.parent_path().filename() : file.stem()).string();
}

/// The sliding to compute: what the model knows of its case's [sliding], changed by the options.
std::optional<ModelSliding> sliding_of(const Arguments& arguments, const ReducedModelFile& model) {
  const bool asked = arguments.friction || arguments.submerged_weight;
  if (!asked && !model.sliding) return std::nullopt;
  ModelSliding sliding = model.sliding.value_or(ModelSliding());
  if (sliding.uplift == "history") {
    if (!asked) return std::nullopt;  // that record belongs to one wave only
    sliding.uplift = "none";
  }
  sliding.friction = arguments.friction.value_or(sliding.friction);
  const StillWater still = model.still.value_or(StillWater());
  if (arguments.submerged_weight) sliding.submerged_weight = *arguments.submerged_weight + still.weight;
  sliding.push = still.push;
  Diagnostics mistakes;
  const std::string moved = moved_by_still_water({still.push, 0., 0.}, sliding.friction, sliding.submerged_weight);
  if (model.still && sliding.friction > 0. && sliding.submerged_weight > 0. && !moved.empty())
    mistakes.add(Place(), moved, "give a larger --friction or --buoyant-weight");
  if (sliding.friction == 0.)
    mistakes.add(Place(), "--buoyant-weight alone gives no resistance mu W', and the model's case has no [sliding]",
                 "give --friction too, such as 0.6");
  if (sliding.submerged_weight == 0.)
    mistakes.add(Place(), "--friction alone gives no resistance mu W', and the model's case has no [sliding]",
                 "give --buoyant-weight too (N/m)");
  if (model.caisson_mass == 0.)
    mistakes.add({arguments.model}, "the model has no mass of a caisson, so nothing can slide",
                 "leave out --friction and --buoyant-weight, or reduce a case with a caisson");
  mistakes.throw_if_any();
  return sliding;
}

/// SI units of the loads, in the model's order; "" where the file gives none for a load.
std::vector<std::string> units_of_loads(const ReducedModelFile& model) {
  std::vector<std::string> units;
  for (const std::string& name : model.modes.load_name) {
    const auto load = std::find_if(model.loads.begin(), model.loads.end(),
                                   [&name](const ModelLoad& one) { return one.name == name; });
    units.push_back(load == model.loads.end() ? "" : load->unit);
  }
  return units;
}

std::vector<InputFile> input_files(const Arguments& arguments) {
  std::vector<InputFile> files{{arguments.model, {arguments.model}}};
  for (const std::string& path : arguments.forces) files.push_back({path, {path}});
  return files;
}

/// Notes on how the waves were read.
std::string notes_of(const std::vector<WaveFile>& files) {
  std::string text;
  for (const WaveFile& file : files) text += note_lines(file.notes);
  return text;
}

/// Warnings of how they were read, and of waves that are zero throughout.
NumberedWarnings file_warnings(const std::vector<WaveFile>& files) {
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

/// Waves of files, then those that are the loads of cases; of a case alone its own.
std::vector<WaveFile> waves_of(const Arguments& arguments, const RespondCases& cases, const ReducedModelFile& model) {
  std::vector<std::string> files, of_cases;
  for (const std::string& path : arguments.forces) (is_case(path) ? of_cases : files).push_back(path);
  if (arguments.forces.empty()) of_cases.push_back(arguments.model);
  std::vector<WaveFile> waves;
  if (!files.empty()) waves = read_wave_files(files, model.modes.load_name, units_of_loads(model));
  for (const std::string& path : of_cases) {
    WaveFile wave = cases.wave(path, model);
    const auto has_name = [&wave](const WaveFile& other) { return other.name == wave.name; };
    while (std::any_of(waves.begin(), waves.end(), has_name)) wave.name += "-case";
    waves.push_back(std::move(wave));
  }
  return waves;
}

int respond(const Arguments& arguments, const RespondCases& cases, const Stopwatch& since_start) {
  check(arguments);
  RespondTiming timing;
  const std::string out = arguments.out.empty() ? "results/" + model_name(arguments.model) + "-respond" : arguments.out;
  const bool makes_model = is_case(arguments.model);
  std::vector<std::string> written{"responses.h5", "summary.json"};
  if (makes_model) written.push_back("reduced.h5");
  std::optional<OutputFolder> place;
  const auto open_folder = [&] {
    note_interrupts();
    require_inputs_kept(out, written, input_files(arguments));
    place.emplace(out);
  };
  if (makes_model) open_folder();
  const ReducedModelFile model = makes_model ? cases.model(arguments.model, *place) : read_model_file(arguments.model);
  const RespondOptions options{arguments.end, sliding_of(arguments, model)};
  const std::vector<WaveFile> waves = waves_of(arguments, cases, model);
  timing.read = since_start.seconds();
  if (!makes_model) open_folder();
  OutputFolder& folder = *place;

  const Stopwatch respond_watch;
  const std::vector<WaveResponses> responses = respond_to_waves(model, waves, options);
  timing.respond = respond_watch.seconds();
  const Stopwatch write_watch;
  folder.write("responses.h5", response_file({model, arguments.model}, responses));
  timing.write = write_watch.seconds();
  timing.total = since_start.seconds();
  NumberedWarnings warnings = file_warnings(waves);
  for (const NumberedWarnings& more : {band_warnings(model, responses), error_warnings(model, responses),
                                       slip_warnings(responses), circle_warnings_of(responses)})
    append(warnings, more);
  const std::string json = to_json({model, arguments.model}, responses, timing, warnings);
  folder.write("summary.json", json);
  check_interrupt();
  folder.commit();
  std::cerr << notes_of(waves) << describe(warnings);
  std::cout << (arguments.json ? json
                               : describe(model, responses, timing) + "written     " + folder.name() +
                                     "/{responses.h5, summary.json" + (makes_model ? ", reduced.h5}\n" : "}\n"));
  return 0;
}

const char* const respond_footer =
    R"(A wave is linear between its times, and zero before and after them; times need not be equally spaced.
  waves.csv   time (s), then columns named like the loads of the case (any name where there is one load)
  case.toml   its loads, at the times at which a run reads them
  waves.h5    /time (N) and /LOAD of shape N, or waves x N for thousands of waves at once

Writes into results/NAME-respond (or --out DIR), all or nothing:
  responses.h5   per file of waves: time, force, shear_force, peaks, ratio, sliding,
                 sliding_coupled; SI units
  summary.json   peaks, ratio and least factors of every wave, times
  reduced.h5     where MODEL is a case

Examples:
  upbead respond results/fig2b-prototype/reduced.h5 cases/fig2b-prototype-impulse.csv
  upbead respond cases/designer/section.toml         # one file: reduced, then its own wave, with all ways to fail
  upbead respond prototype.h5 storm.h5 --friction 0.6 --buoyant-weight 3.4e6
  upbead respond prototype.h5 waves/*.csv --json | jq '.waves[] | [.name, .peak_shear]')";

}  // namespace

bool is_case(const std::string& path) {
  return std::filesystem::path(path).extension() == ".toml";
}

Command respond_command(const RespondCases& cases) {
  const auto arguments = std::make_shared<Arguments>();
  Command command{"respond", "answer any number of waves with a reduced model"};
  command.options = {
      {"MODEL", &arguments->model,
       "the model, made by 'upbead reduce' (.h5), or a case (.toml), which is reduced first", "", true},
      {"FORCES", &arguments->forces,
       "waves (.csv, .h5), or cases whose loads are a wave (.toml); of a case as MODEL its "
       "own loads, where none are given"},
      {"--json", &arguments->json, "print the summary as JSON on stdout and nothing else"},
      {"--out", &arguments->out,
       "folder for the results (default: results/NAME-respond, NAME as the model's file, or as its folder if the file "
       "is "
       "reduced.h5)",
       "DIR"},
      {"--end", &arguments->end, "how long to answer (default: as long as the waves or the case)", "S"},
      {"--friction", &arguments->friction,
       "friction coefficient of the caisson's bottom, for S (default: [sliding] of the model's case)", "MU"},
      {"--buoyant-weight", &arguments->submerged_weight,
       "W' of the caisson in still water, for S (default: [sliding] of the model's case)", "N/m"}};
  command.footer = respond_footer;
  command.work = [arguments, cases, since_start = Stopwatch()] { return respond(*arguments, cases, since_start); };
  return command;
}

}  // namespace upbead

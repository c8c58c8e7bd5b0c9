#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "base/files.h"
#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/warning_lines.h"
#include "respond/respond_waves.h"
#include "respond_report.h"

namespace upbead {

namespace {

struct Arguments {
  std::string model;
  std::vector<std::string> forces;
  bool json = false;
  std::string out;
  std::optional<double> end, friction, buoyant_weight;
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
  require_positive(arguments.buoyant_weight, "--buoyant-weight", "3.4e6 (N/m)", mistakes);
  mistakes.throw_if_any();
}

/// That of the file; of its folder where the file is called as 'upbead reduce' calls all of them.
std::string model_name(const std::string& path) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  return (file.stem() == "reduced" && file.has_parent_path() ? file.parent_path().filename() : file.stem()).string();
}

/// What is asked for beside what the model knows of its case's [sliding].
std::optional<ModelSliding> sliding_of(const Arguments& arguments, const ReducedModelFile& model) {
  const bool asked = arguments.friction || arguments.buoyant_weight;
  if (!asked && !model.sliding) return std::nullopt;
  ModelSliding sliding = model.sliding.value_or(ModelSliding());
  if (sliding.uplift == "history") {
    if (!asked) return std::nullopt;  // that record is of one wave
    sliding.uplift = "none";
  }
  sliding.friction = arguments.friction.value_or(sliding.friction);
  sliding.buoyant_weight = arguments.buoyant_weight.value_or(sliding.buoyant_weight);
  Diagnostics mistakes;
  if (sliding.friction == 0.)
    mistakes.add(Place(), "--buoyant-weight alone tells no resistance mu W', and the model's case has no [sliding]",
                 "give --friction too, such as 0.6");
  if (sliding.buoyant_weight == 0.)
    mistakes.add(Place(), "--friction alone tells no resistance mu W', and the model's case has no [sliding]",
                 "give --buoyant-weight too (N/m)");
  if (model.caisson_mass == 0.)
    mistakes.add({arguments.model}, "the model has no mass of a caisson, so nothing can slide",
                 "leave out --friction and --buoyant-weight, or reduce a case with a caisson");
  mistakes.throw_if_any();
  return sliding;
}

/// SI units of the loads, in the model's order; "" where it has none.
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

/// How the waves were read, and which of them are no load at all.
std::string notes_of(const std::vector<WaveFile>& files) {
  std::string text;
  for (const WaveFile& file : files) {
    for (const LeftOut& part : file.notes.left_out) text += "note: " + part.what + ": " + part.why + "\n";
    text += describe(file.notes.warnings);
    int zero = 0;
    for (int w = 0; w < file.n_waves(); ++w)
      if (file.wave(w).isZero(0.)) ++zero;
    if (zero > 0)
      text += "warning: load_zero: " + std::to_string(zero) + " of " + std::to_string(file.n_waves()) + " waves of " +
              in_quotes(file.name) + " are zero throughout: is a wrong column read as the load?\n";
  }
  return text;
}

void respond(const Arguments& arguments, const Stopwatch& since_start) {
  check(arguments);
  RespondTiming timing;
  const ReducedModelFile model = read_model_file(arguments.model);
  const RespondOptions options{arguments.end, sliding_of(arguments, model)};
  const std::vector<WaveFile> waves = read_wave_files(arguments.forces, model.modes.load_name, units_of_loads(model));
  timing.read = since_start.seconds();
  note_interrupts();
  const std::string out = arguments.out.empty() ? "results/" + model_name(arguments.model) + "-respond" : arguments.out;
  require_inputs_kept(out, {"responses.h5", "summary.json"}, input_files(arguments));
  OutputFolder folder(out);

  const Stopwatch respond_watch;
  const std::vector<WaveResponses> responses = respond_to_waves(model, waves, options);
  timing.respond = respond_watch.seconds();
  const Stopwatch write_watch;
  folder.write("responses.h5", response_file(model.title, responses));
  timing.write = write_watch.seconds();
  timing.total = since_start.seconds();
  const NumberedWarnings warnings = error_warnings(model, responses);
  const std::string json = to_json(model, arguments.model, responses, timing, warnings);
  folder.write("summary.json", json);
  check_interrupt();
  folder.commit();
  std::cerr << notes_of(waves) << band_warning(model, responses) << describe(warnings) << slip_warning(responses);
  std::cout << (arguments.json ? json
                               : describe(model, responses, timing) + "written     " + folder.name() +
                                     "/{responses.h5, summary.json}\n");
}

}  // namespace

void add_respond(CLI::App& program) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("respond", "answer any number of waves with a reduced model");
  command->add_option("MODEL", arguments->model, "the model, made by 'upbead reduce' (.h5)")->required();
  command->add_option("FORCES", arguments->forces, "waves (.csv, .h5)")->required();
  command->add_flag("--json", arguments->json, "print the summary as JSON on stdout and nothing else");
  command
      ->add_option("--out", arguments->out,
                   "folder for the results (default: results/NAME-respond, NAME as the model's file, or as "
                   "its folder if the file is reduced.h5)")
      ->type_name("DIR");
  command->add_option("--end", arguments->end, "how long to answer (default: as long as the waves or the case)")
      ->type_name("S");
  command
      ->add_option("--friction", arguments->friction,
                   "friction coefficient of the caisson's bottom, for S (default: [sliding] of the model's case)")
      ->type_name("MU");
  command
      ->add_option("--buoyant-weight", arguments->buoyant_weight,
                   "W' of the caisson in still water, for S (default: [sliding] of the model's case)")
      ->type_name("N/m");
  command->footer(
      "A wave is straight between its times, and zero before and after them; times need not be equally spaced.\n"
      "  waves.csv   time (s), then columns named like the loads of the case (any name where there is one load)\n"
      "  waves.h5    /time (N) and /LOAD of shape N, or waves x N for thousands of waves at once\n\n"
      "Writes into results/NAME-respond (or --out DIR), all or nothing:\n"
      "  responses.h5   per file of waves: time, force, shear_force, peaks, ratio, sliding,\n"
      "                 sliding_coupled; SI units\n"
      "  summary.json   peaks and ratio of every wave, times\n\n"
      "Examples:\n"
      "  upbead respond results/fig2b-prototype/reduced.h5 cases/fig2b-prototype-impulse.csv\n"
      "  upbead respond prototype.h5 storm.h5 --friction 0.6 --buoyant-weight 3.4e6\n"
      "  upbead respond prototype.h5 waves/*.csv --json | jq '.waves[] | [.name, .peak_shear]'");
  command->callback([arguments, since_start = Stopwatch()] { respond(*arguments, since_start); });
}

}  // namespace upbead

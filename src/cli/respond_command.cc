#include <filesystem>
#include <iostream>
#include <sstream>
#include <variant>

#include "base/files.h"
#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "cli/respond_cases.h"
#include "cli/respond_input.h"
#include "cli/respond_text.h"
#include "output/wave_response.h"
#include "respond/respond_warnings.h"
#include "respond/respond_waves.h"
#include "respond/soil_server.h"

namespace upbead {

namespace {

/// The name of the file, or of its folder where the file has the name that 'upbead reduce' gives to every model.
std::string model_name(const std::string& path) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  return (file.stem() == "reduced" && file.has_parent_path() ? file.parent_path().filename() : file.stem()).string();
}

std::vector<InputFile> input_files(const RespondArguments& arguments) {
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

/// A model, and its soil where it has many.
struct ModelOfSoil {
  ReducedModelFile model;
  Soil soil;
  std::string why_no_slip;
};

InputError at_option(const InputError& error, const std::string& option) {
  Diagnostics mistakes;
  for (Diagnostic mistake : error.diagnostics()) {
    if (mistake.place.file.empty()) mistake.place.file = option;
    mistakes.add(std::move(mistake));
  }
  return InputError(mistakes);
}

ModelOfSoil model_of_soil(const SoilAnswers& answers, const std::vector<std::string>& options) {
  try {
    const Soil soil = answers.whole(soil_of_options(options));
    return {answers.at(soil), soil, why_no_slip(answers.file())};
  } catch (const InputError& error) {
    throw at_option(error, "--soil");
  }
}

InputError one_soil_only(const RespondArguments& arguments) {
  return InputError({"--soil"}, quoted_path(arguments.model) + " is the model of one soil",
                    "leave out --soil, or give a model of soils, made by 'upbead reduce --soils'");
}

ModelOfSoil read_model(const RespondArguments& arguments) {
  std::variant<ReducedModelFile, SoilModelFile> file = read_any_model_file(arguments.model);
  if (auto* soils = std::get_if<SoilModelFile>(&file))
    return model_of_soil({std::move(*soils), arguments.model}, arguments.soil);
  if (!arguments.soil.empty()) throw one_soil_only(arguments);
  return {std::move(std::get<ReducedModelFile>(file)), {}, ""};
}

/// "a,b" as a list.
std::vector<std::string> names_in(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream stream(list);
  for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
  return names;
}

/// Answers soils from standard input until it ends. Interrupts end the program at once, as nothing is written.
int serve(const RespondArguments& arguments, const RespondCases& cases) {
  std::variant<ReducedModelFile, SoilModelFile> file = read_any_model_file(arguments.model);
  auto* soils = std::get_if<SoilModelFile>(&file);
  if (soils == nullptr) throw one_soil_only(arguments);
  RespondOptions options{arguments.end, sliding_of(arguments, soils->frame), {}, {}};
  options.histories.names = names_in(arguments.histories);
  std::vector<WaveFile> waves = waves_of(arguments, cases, soils->frame);
  std::cerr << notes_of(waves) << describe(warnings_of_options(arguments, soils->frame))
            << describe(warnings_of_files(waves));
  const auto server = [&] {
    SoilAnswers answers(std::move(*soils), arguments.model);
    try {
      return SoilServer(std::move(answers), std::move(waves), options);
    } catch (const InputError& error) {
      throw at_option(error, "--histories");
    }
  }();
  for (std::string line; std::cout && std::getline(std::cin, line);) std::cout << server.answer(line) << std::flush;
  return 0;
}

int respond(const RespondArguments& arguments, const RespondCases& cases, const Stopwatch& since_start) {
  check(arguments);
  if (arguments.serves()) return serve(arguments, cases);
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
  const ModelOfSoil loaded =
      makes_model ? ModelOfSoil{cases.model(arguments.model, *place), {}, ""} : read_model(arguments);
  const AnsweredModel answered{loaded.model, arguments.model, loaded.soil};
  const RespondOptions options{arguments.end, sliding_of(arguments, loaded.model), loaded.why_no_slip, {}};
  const std::vector<WaveFile> waves = waves_of(arguments, cases, loaded.model);
  timing.read = since_start.seconds();
  if (!makes_model) open_folder();
  OutputFolder& folder = *place;

  const Stopwatch respond_watch;
  const std::vector<WaveResponses> responses = respond_to_waves(loaded.model, waves, options);
  timing.respond = respond_watch.seconds();
  const Stopwatch write_watch;
  folder.write("responses.h5", response_file(answered, responses));
  timing.write = write_watch.seconds();
  timing.total = since_start.seconds();
  NumberedWarnings warnings = warnings_of_options(arguments, loaded.model);
  append(warnings, warnings_of_files(waves));
  append(warnings, force_warnings(loaded.model, waves, responses));
  append(warnings, cut_warnings(loaded.model, waves, responses));
  append(warnings, warnings_of_answers(loaded.model, responses));
  const Json summary = to_json(answered, responses, timing, warnings);
  const std::string json = json_text(summary);
  folder.write("summary.json", json);
  check_interrupt();
  folder.commit();
  std::cerr << notes_of(waves) << describe(warnings);
  std::cout << (arguments.json ? json
                               : answers_text(answered, summary, timing) + "written     " + folder.name() +
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

A model of soils answers the soil of its case, or that of --soil. With --soil - it writes no file, reads a soil a line from
standard input, as {"KEY": VALUE, ...} or KEY=VALUE KEY=VALUE, and answers each at once with a line of JSON:
  {"soil": {...}, "error": ..., "waves": [{...}], "warnings": [...]}   waves as in summary.json
  {"soil": {...}, "why": "..."}                                       where it cannot be answered

Examples:
  upbead respond results/fig2b-prototype/reduced.h5 cases/fig2b-prototype-impulse.csv
  upbead respond cases/designer/section.toml         # one file: reduced, then its own wave, with all ways to fail
  upbead respond prototype.h5 storm.h5 --friction 0.6 --buoyant-weight 3.4e6
  upbead respond prototype.h5 waves/*.csv --json | jq '.waves[] | [.name, .peak_shear]'
  upbead respond soils.h5 storm.csv --soil regions.seabed.shear_modulus=25e6
  echo '{"regions.seabed.shear_modulus": 25e6}' | upbead respond soils.h5 storm.csv --soil - --histories shear_force)";

}  // namespace

bool is_case(const std::string& path) {
  return std::filesystem::path(path).extension() == ".toml";
}

Command respond_command(const RespondCases& cases) {
  const auto arguments = std::make_shared<RespondArguments>();
  Command command{"respond", "answer any number of waves with a reduced model"};
  command.options = {
      {"MODEL", &arguments->model,
       "the model of a soil or of soils, made by 'upbead reduce' (.h5), or a case (.toml), which is reduced first", "",
       true},
      {"FORCES", &arguments->forces,
       "waves (.csv, .h5), or cases whose loads are a wave (.toml); of a case as MODEL its "
       "own loads, where none are given"},
      {"--json", &arguments->json, "print the summary as JSON on stdout and nothing else"},
      {"--out", &arguments->out,
       "folder for the results (default: results/NAME-respond, NAME as the model's file, or as its folder if the file "
       "is "
       "reduced.h5)",
       "DIR"},
      {"--soil", &arguments->soil,
       "of a model of soils: a key's value, others as in the case; may be given many times; - answers a soil for each "
       "line of standard input",
       "KEY=VALUE"},
      {"--histories", &arguments->histories,
       "with --soil -: readings of the model whose histories are printed, such as shear_force,caisson/displacement_x",
       "NAMES"},
      {"--end", &arguments->end, "how long to answer (default: as long as the waves or the case)", "S"},
      {"--friction", &arguments->friction,
       "friction coefficient of the caisson's bottom, for S and factors (default: [sliding] of the model's case)",
       "MU"},
      {"--buoyant-weight", &arguments->submerged_weight,
       "W' of the caisson in still water, for S, pressures and factors (default: [sliding] of the model's case)",
       "N/m"}};
  command.footer = respond_footer;
  command.work = [arguments, cases, since_start = Stopwatch()] { return respond(*arguments, cases, since_start); };
  return command;
}

}  // namespace upbead

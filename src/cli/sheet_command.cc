// The command sheet: all that one file allows, in one table.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>

#include "base/child_program.h"
#include "base/files.h"
#include "base/interrupt.h"
#include "base/progress.h"
#include "base/text.h"
#include "case/case_findings.h"
#include "case/case_run.h"
#include "case/input_files.h"
#include "case/scene_text.h"
#include "case/script_trust.h"
#include "case/wave_load.h"
#include "cli/command.h"
#include "cli/reduced_case.h"
#include "design/expected_report.h"
#include "design/sheet.h"
#include "design/waves_report.h"
#include "findings/histories.h"
#include "output/result_file.h"
#include "output/soil_model_file.h"
#include "reliability/answer.h"
#include "reliability/ground.h"
#include "respond/node_slips.h"
#include "run/derived.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// What the tables of a file ask for.
struct Asked {
  explicit Asked(const Document& file)
      : waves(file.find("waves")),
        run(file.find("loads")),
        life(file.find("sea") || file.find("storms")),
        chances(file.find("reliability")) {}
  bool waves, run, life, chances;
};

/// The file as a case and as a design, as far as it is one.
struct SheetInput {
  std::string title, stem;
  std::optional<Case> scene;
  std::optional<Design> design;
  Asked asked;
};

/// Calls read(), and keeps the mistakes that were not found before: both readers check the tables that they share.
template <class Read>
void keep_mistakes(Diagnostics& report, std::set<std::string>& seen, const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    for (const Diagnostic& one : error.diagnostics())
      if (seen.insert(to_string(one)).second) report.add(one);
  }
}

SheetInput read_input(const CaseOptions& options) {
  const Document file(options.file, options.overrides);
  SheetInput input{{}, {}, {}, {}, Asked(file)};
  if (!input.asked.waves && !input.asked.run && !input.asked.life)
    throw InputError(
        file.place(""), "the file asks for nothing that a sheet could hold",
        "add [waves.NAME] and [section] for formulas, [loads.NAME], [mesh] and [regions] for a run, [sea] or "
        "[storms] for a life");
  Diagnostics report;
  std::set<std::string> seen;
  if (input.asked.run) keep_mistakes(report, seen, [&] { input.scene = read_case(options.file, options.overrides); });
  if (input.asked.waves || input.asked.life)
    keep_mistakes(report, seen, [&] {
      std::vector<DesignCheck> checks;
      if (input.asked.life) checks.push_back(check_expected);
      if (input.asked.chances && input.asked.waves) checks.push_back(check_random);
      input.design = read_design(options.file, options.overrides, checks);
    });
  report.throw_if_any(options.file);
  input.title = input.scene ? input.scene->scene.title : input.design->tables.title;
  input.stem = input.scene ? input.scene->stem : input.design->stem;
  return input;
}

/// A part of the sheet, with the whole summary of its command.
struct Done {
  SheetPart part;
  Json summary;
};

Done no_part(const std::string& name, const std::string& why) {
  return {{name, {}, {}, why}, Json()};
}

/// The run of the sheet, and what of it serves the life. Empty where the file asks for none.
struct SolvedScene {
  Done done;
  std::optional<Case> problem;  ///< with its end
  /// With its soil converged; where the caisson may slip, as it was before, as its System then has loads of its own.
  std::shared_ptr<const Simulation> simulation;
};

/// Warning wave_not_of_design: the run bears a wave, and none as the design has it.
NumberedWarnings run_wave_warnings(const SheetInput& input) {
  if (!input.scene || input.design->tables.waves.empty()) return {};
  const std::vector<const WaveLoad*> loads = acting_waves(*input.scene);
  const DesignTables& t = input.design->tables;
  constexpr double written = 1e-6;
  const auto is_same = [](double a, double b) { return std::abs(a - b) <= written * std::abs(b); };
  double highest = 0.;
  for (const auto& [name, given] : t.waves) {
    const DesignWave wave = design_wave(given, t.section, t.water);
    highest = std::max(highest, wave.height);
    for (const WaveLoad* load : loads)
      if (load->load.factor == 1. && is_same(load->wave.height, wave.height) && is_same(load->wave.period, wave.period))
        return {};
  }
  if (loads.empty()) return {};
  const WaveLoad& load = *loads.front();
  return {{"wave_not_of_design", load.wave.height, highest, "m",
           load.title + " is a wave of " + with_unit(load.wave.height, "m") + " and " +
               with_unit(load.wave.period, "s") + ", by the factor " + significant(load.load.factor, 3) +
               ": what is told of motion is of none of the waves of [waves], whose highest has " +
               with_unit(highest, "m"),
           "give the run a wave of [waves], with factor = 1"}};
}

Done waves_part(const SheetInput& input) {
  if (!input.asked.waves) return no_part("waves", "no [waves.NAME]: no wave is checked by formulas at all levels");
  const std::vector<WaveAnswer> answers = answer_waves(input.design->tables);
  NumberedWarnings warnings = warnings_of(*input.design, answers);
  append(warnings, run_wave_warnings(input));
  return {{"waves", checks_of(input.design->tables, answers), warnings, ""}, to_json(*input.design, answers)};
}

/// The design with the reduced model of the same file's scene, by which every wave of a life has its own dynamics; or
/// why it has none.
struct DesignWithModel {
  Design design;
  std::string why_none;
};

DesignWithModel with_model(const Design& design, const SolvedScene& solved, const OutputFolder& folder) {
  if (design.tables.dynamics) return {design, ""};
  if (!solved.problem) return {design, "no [mesh] and [loads.NAME]: waves have no dynamics of their own"};
  const auto refused = [&](const std::exception& error) {
    std::filesystem::remove(folder.path("reduced.h5"));  // nothing was computed by it
    return DesignWithModel{design, error.what()};
  };
  try {
    folder.write("reduced.h5", model_file(reduced_case(*solved.problem, *solved.simulation, {}, folder.name()).file));
    DesignWithModel out{design, ""};
    out.design.tables.dynamics.emplace().model = folder.path("reduced.h5");
    Diagnostics mistakes;
    check_expected(out.design.tables, out.design.document, mistakes);
    mistakes.throw_if_any();
    return out;
  } catch (const InputError& error) {
    return refused(error);
  } catch (const NumericsError& error) {
    return refused(error);
  }
}

/// Warning model_of_other_scene: a part takes its dynamics from a model that is not of the file's scene.
NumberedWarnings model_warnings(const std::string& part, const SheetInput& input, const OutputFolder& folder) {
  const auto& dynamics = input.design->tables.dynamics;
  if (!dynamics || !input.scene) return {};
  const auto file = read_any_model_file(input.design->resolve(dynamics->model));
  const auto* const soils = std::get_if<SoilModelFile>(&file);
  const std::string& model = (soils ? soils->frame : std::get<ReducedModelFile>(file)).case_text;
  const std::vector<std::string> names = tables_that_differ(model, effective_case(*input.scene, folder.name()));
  if (names.empty()) return {};
  return {{"model_of_other_scene", static_cast<double>(names.size()), 0., "1",
           part + " the dynamics of '" + dynamics->model +
               "', which is of another scene than this file: they "
               "differ in " +
               join(names, ", "),
           "leave [dynamics] model out, so that the sheet reduces its own scene"}};
}

Done expected_part(const SheetInput& input, const SolvedScene& solved, const OutputFolder& folder) {
  if (!input.asked.life)
    return no_part("expected", "no [sea] or [storms]: nothing is known of the sliding distance of a life");
  const DesignWithModel with = with_model(*input.design, solved, folder);
  const ExpectedAnswer answer = find_expected(with.design, nullptr, node_slips);
  NumberedWarnings warnings = warnings_of(with.design, answer);
  append(warnings, model_warnings("the life has", input, folder));
  if (!with.why_none.empty())
    warnings.push_back({"no_own_dynamics", 0., 0., "", "the life is by formulas alone: " + with.why_none,
                        "read S and pressures of the life as those of formulas"});
  return {{"expected", checks_of(with.design, answer), warnings, ""}, to_json(with.design, answer, {})};
}

SolvedScene run_part(const SheetInput& input, const OutputFolder& folder) {
  if (!input.asked.run)
    return {no_part("run", "no [loads.NAME]: nothing is known of F_T, its dynamics and the ground"), {}, nullptr};
  Case problem = *input.scene;
  std::shared_ptr<const Mesh> mesh = settle_end(problem);
  const Simulation simulation = with_room(simulation_of(problem, std::move(mesh)));
  const std::vector<MeasuredRecord> records = read_records(problem, simulation);
  Progress line("solving");
  RunOptions options;
  options.progress = [&line](double done) {
    check_interrupt();
    line.update(done);
  };
  const Run run = solve(problem, simulation, records, options);
  folder.write("results.h5", dataset_file(problem.scene.title, tables(run)));
  return {{{"run", run.summary.checks, run.summary.warnings, ""}, summary_outputs().to_json(run.summary)},
          std::move(problem),
          simulation.system().interface ? std::make_shared<const Simulation>(simulation) : run.simulation};
}

const std::string chances_folder = "reliability";

/// A probability that is asked for and was not found: it stays on the sheet.
Done no_chances(const SheetInput& input, const std::string& why) {
  Check check = check_of(FailureMode::failure_of_life, "reliability index of the life", "", {}, "modes", "");
  check.by = "formulas";
  if (input.design && input.design->tables.reliability)
    check = at_least_as(check, input.design->tables.reliability->target);
  return {{"reliability", {not_checked(check, why)}, {}, ""}, Json()};
}

std::string in_one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// What `upbead reliability` says of the file. It is a program of its own, as it alone loads OpenTURNS; its files go
/// into a folder below the sheet's.
Done chances_part(const CaseOptions& options, const SheetInput& input, const OutputFolder& folder) {
  if (!input.asked.waves)
    return no_chances(input, "no [waves.NAME]: [reliability] asks how often one of them fails the section by formulas");
  // below a folder that no process has locked: that of the sheet is, and the child waits for its turn in the one above
  const std::string made = folder.path(chances_folder + "/made/summary.json");
  const std::filesystem::path out = std::filesystem::path(made).parent_path();
  std::vector<std::string> words{"reliability", options.file, "--out", out.string()};
  for (const std::string& one : options.overrides) append(words, {"--set", one});
  const ChildEnd end = run_child("upbead-reliability", words, "probability of failure");
  if (end.code != 0) {
    std::filesystem::remove_all(out.parent_path());
    return no_chances(
        input, "'upbead reliability' ended with code " + std::to_string(end.code) + ": " + in_one_line(end.told));
  }
  std::ifstream file(made);
  const Json summary = Json::parse(file);
  std::filesystem::remove_all(out);
  folder.write(chances_folder + "/summary.json", json_text(summary));
  folder.write(chances_folder + "/case.toml", effective_design(*input.design, folder.name() + "/" + chances_folder));
  NumberedWarnings warnings = warnings_in(summary);
  if (!input.asked.life && asks_for_ground(input.design->tables))
    append(warnings, model_warnings("the chances have", input, folder));
  return {{"reliability", checks_in(summary), warnings, ""}, summary};
}

int work(const CaseOptions& options) {
  const SheetInput input = read_input(options);
  if (input.scene) {
    require_trust(*input.scene, options.trusted);
    std::cerr << notes_on(*input.scene);
  }
  note_interrupts();
  const std::string out = options.out.empty() ? "results/" + input.stem + "-sheet" : options.out;
  std::vector<InputFile> files = input.scene ? input_files(*input.scene) : std::vector<InputFile>();
  if (input.design) append(files, input_files(*input.design));
  require_inputs_kept(out,
                      {"summary.json", "sheet.md", "case.toml", "results.h5", "reduced.h5",
                       chances_folder + "/summary.json", chances_folder + "/case.toml"},
                      files);
  OutputFolder folder(out);
  const Done waves = waves_part(input);
  const SolvedScene solved = run_part(input, folder);
  std::vector<Done> parts{waves, solved.done, expected_part(input, solved, folder)};
  if (input.asked.chances) parts.push_back(chances_part(options, input, folder));
  const Limits& limits = input.scene ? input.scene->scene.limits : input.design->tables.limits;
  std::vector<SheetPart> told;
  for (const Done& done : parts) told.push_back(done.part);
  const Sheet sheet = sheet_of(input.title, std::move(told), limits);
  Json json = to_json(sheet);
  for (const Done& done : parts) json[done.part.name] = done.summary;
  const std::string text = json_text(json);
  folder.write("summary.json", text);
  folder.write("sheet.md", markdown(sheet));
  folder.write("case.toml", !input.design  ? effective_case(*input.scene, folder.name())
                            : !input.scene ? effective_design(*input.design, folder.name())
                                           : effective_file(*input.scene, *input.design, folder.name()));
  check_interrupt();
  const bool has_chances = input.asked.chances && !parts.back().summary.is_null();
  folder.commit({"results.h5", "reduced.h5", chances_folder + "/summary.json", chances_folder + "/case.toml"});
  std::cerr << describe(sheet.warnings);
  std::cout << (options.json ? text
                             : text_of(sheet) + "written     " + folder.name() + "/{summary.json, sheet.md, case.toml" +
                                   (input.asked.run ? ", results.h5" : "") +
                                   (std::filesystem::exists(folder.name() + "/reduced.h5") ? ", reduced.h5" : "") +
                                   (has_chances ? ", " + chances_folder + "/}\n" : "}\n"));
  return 0;
}

}  // namespace

Command sheet_command() {
  const auto options = std::make_shared<CaseOptions>();
  Command command = case_command("sheet", *options);
  command.work = [options] { return work(*options); };
  return command;
}

}  // namespace upbead

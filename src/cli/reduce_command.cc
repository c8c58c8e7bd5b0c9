#include <iostream>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "case/case_run.h"
#include "case/input_files.h"
#include "case/script_trust.h"
#include "cli/command.h"
#include "cli/reduced_case.h"
#include "cli/soils_of_case.h"
#include "study/soil_box.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

nlohmann::ordered_json to_object(const ReducedSlip& slip) {
  if (!slip.model) return nullptr;
  return {{"vectors", slip.model->vectors},
          {"solves", slip.model->solves},
          {"error", slip.model->error},
          {"glued_error", slip.model->glued_error},
          {"time", slip.seconds}};
}

nlohmann::ordered_json to_object(const Nested& nested) {
  if (!nested.models) return nullptr;
  const NestedModels& m = *nested.models;
  return {{"modes", {m.middle.n_modes(), m.reference.n_modes()}},
          {"solves", m.solves},
          {"factorisations", m.factorisations},
          {"time", nested.seconds}};
}

nlohmann::ordered_json to_object(const CircleModelMade& made) {
  if (!made.model) return nullptr;
  return {{"circles", made.model->family.circles.size()},
          {"readings", made.model->family.n_readings()},
          {"gap", made.model->gap},
          {"time", made.seconds}};
}

nlohmann::ordered_json to_object(const ContactModelMade& made) {
  if (!made.model) return nullptr;
  nlohmann::ordered_json coordinates = nlohmann::ordered_json::array();
  for (const GroundLevel& level : made.model->levels) coordinates.push_back(level.n_free());
  return {{"nodes", made.model->interface.n_nodes()},
          {"coordinates", coordinates},
          {"solves", made.model->levels.back().solves},
          {"time", made.seconds}};
}

std::string describe(const ContactModelMade& made) {
  if (!made.model) return "";
  std::string text;
  for (const GroundLevel& level : made.model->levels)
    text += (text.empty() ? "" : ", ") + std::to_string(level.n_free());
  return "contact     of " + std::to_string(made.model->interface.n_nodes()) + " nodes on grounds of " + text +
         " coordinates, " + significant(made.seconds, 2) + " s\n";
}

std::string describe(const CircleModelMade& made) {
  if (!made.model) return "";
  return "circles     " + std::to_string(made.model->family.circles.size()) + " under the caisson, " +
         significant(made.seconds, 2) + " s; their least factor was up to " + significant(100. * made.model->gap, 2) +
         " % above that of a full search\n";
}

std::string describe(const Nested& nested) {
  if (!nested.models) return "";
  const NestedModels& m = *nested.models;
  return "waves       their errors by larger models of " + std::to_string(m.middle.n_modes()) + " and " +
         std::to_string(m.reference.n_modes()) + " modes, " + std::to_string(m.solves) + " solves, " +
         significant(nested.seconds, 2) + " s\n";
}

std::string to_json(const Reduced& made) {
  const ReducedModelFile& m = made.file;
  const Reduction& r = made.reduction;
  const Timing& t = made.timing;
  nlohmann::ordered_json json = {{"title", m.title}, {"model", made.path}};
  json["discretisation"] = {{"unknowns", m.unknowns}, {"solves", m.solves}, {"factorisations", m.factorisations}};
  json["reduction"] = {{"vectors", r.n_vectors},
                       {"modes", m.modes.n_modes()},
                       {"independent_loads", r.n_independent_loads},
                       {"error", m.error},
                       {"error_peak", m.error_peak},
                       {"error_of_others", r.error.others},
                       {"highest_frequency", m.highest_frequency}};
  json["reduction"]["error_march"] = m.error_march ? nlohmann::ordered_json(*m.error_march) : nullptr;
  json["nested"] = to_object(made.nested);
  json["slip"] = to_object(made.slip);
  if (made.circles.model) json["circles"] = to_object(made.circles);
  if (made.contact.model) json["contact"] = to_object(made.contact);
  json["warnings"] = warnings_json(made.warnings());
  json["skipped"] = nlohmann::ordered_json::array();
  for (const Skipped& part : made.skipped) json["skipped"].push_back({{"what", part.what}, {"why", part.why}});
  json["timing"] = {
      {"mesh", t.mesh}, {"compile", t.compile}, {"factorise", t.factorise}, {"reduce", t.march}, {"total", t.total}};
  return json.dump(2) + "\n";
}

std::string describe(const ReducedSlip& slip) {
  if (!slip.model) return "";
  return "slip        of the caisson with its ground, " + std::to_string(slip.model->solves) + " solves, " +
         significant(slip.seconds, 2) + " s; error of its forces " + significant(slip.model->error, 2) +
         " of their peaks, of F_T while it sticks " + significant(slip.model->glued_error, 2) +
         " (against the model without slip)\n";
}

std::string describe(const Reduced& made) {
  const ReducedModelFile& m = made.file;
  const Reduction& r = made.reduction;
  const Timing& t = made.timing;
  std::string text = m.title + "\n";
  text += "reduced     " + std::to_string(m.unknowns) + " unknowns to " + std::to_string(m.modes.n_modes()) +
          " modes, by 1 factorisation and " + std::to_string(m.solves) + " solves\n";
  text += "loads      ";
  for (const ModelLoad& load : m.loads) text += " " + load.name + " (" + load.unit + ")";
  text += "\nerror       history of F_T " + significant(m.error, 2) + " of its peak, its peak " +
          significant(m.error_peak, 2) + told_of_others(r) + "\n";
  if (m.error_march) text += "            history of F_T " + significant(*m.error_march, 2) + " against a march\n";
  text += describe(made.nested);
  text += "checked     up to " + significant(m.highest_frequency) + " Hz\n" + describe(made.slip) +
          describe(made.circles) + describe(made.contact);
  for (const Skipped& part : made.skipped) text += "skipped     " + part.what + ": " + part.why + "\n";
  text += "time        factorise " + significant(t.factorise, 2) + " s, reduce " + significant(t.march, 2) +
          " s, total " + significant(t.total, 2) + " s\n";
  return text + "written     " + made.path + "\n";
}

int reduce_soils(Case& input, const CaseOptions& options, const std::string& out) {
  if (options.check || options.all_readings)
    throw InputError(Place(), std::string(options.check ? "--check" : "--all-readings") + " does not go with --soils",
                     "reduce the case without --soils for that");
  const std::vector<SoilAxis> box = read_soil_box(options.soils);
  std::vector<InputFile> inputs = input_files(input);
  inputs.push_back({options.soils, {options.soils}});
  require_inputs_kept(out, {"soils.h5"}, inputs);
  OutputFolder folder(out);
  const SoilsOfCase made = soils_of_case(input, options, box, folder.name());
  folder.write("soils.h5", soil_model_file(made.file));
  check_interrupt();
  folder.commit();
  const std::string path = folder.name() + "/soils.h5";
  std::cerr << describe(made.warnings);
  std::cout << (options.json ? to_json(made, path) : describe(made, path));
  return 0;
}

int reduce(const CaseOptions& options, const Stopwatch& since_start) {
  Case input = read_case(options.file, options.overrides);
  require_trust(input, options.trusted);
  require_loads(input);
  std::cerr << notes_on(input);
  note_interrupts();
  const std::string out = options.out.empty() ? "results/" + input.stem : options.out;
  if (!options.soils.empty()) return reduce_soils(input, options, out);
  require_inputs_kept(out, {"reduced.h5"}, input_files(input));
  OutputFolder folder(out);
  Reduced made = reduced_case(input, {options.all_readings, options.check}, folder.name());
  folder.write("reduced.h5", model_file(made.file));
  check_interrupt();
  folder.commit();
  made.timing.total = since_start.seconds();
  made.path = folder.name() + "/reduced.h5";
  std::cerr << describe(made.warnings());
  std::cout << (options.json ? to_json(made) : describe(made));
  return 0;
}

}  // namespace

Command reduce_command() {
  const auto options = std::make_shared<CaseOptions>();
  Command command = case_command("reduce", *options);
  command.work = [options, since_start = Stopwatch()] { return reduce(*options, since_start); };
  return command;
}

}  // namespace upbead

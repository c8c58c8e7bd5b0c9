#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/text.h"
#include "case/case_schema.h"
#include "case/input_files.h"
#include "case/scale.h"
#include "cli/command.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

struct ScaleOptionsOfCommand : CommonOptions {
  double factor = 1.;
  std::vector<std::string> ratios;
  std::string soil = "froude";
};

/// Quantities whose factors are printed, with their units.
const std::vector<std::pair<std::string, std::string>> quantities{
    {"length", "m"},  {"time", "s"},      {"frequency", "Hz"}, {"velocity", "m/s"},
    {"force", "N/m"}, {"pressure", "Pa"}, {"mass", "kg/m"},    {"density", "kg/m3"}};

double factor_of(const ScaleOptions& options, const std::string& unit) {
  return std::pow(options.factor, froude_exponent(unit));
}

std::string scaling_json(const Case& problem, const ScaledCase& scaled, const ScaleOptions& options) {
  Json json{{"title", problem.scene.title}, {"from", problem.document.path()}, {"factor", options.factor}};
  json["soil"] = options.soil == SoilScaling::same ? "same" : "froude";
  for (const auto& [name, unit] : quantities) json["factors"][name] = factor_of(options, unit);
  json["kept"] = scaled.kept;
  return json.dump(2) + "\n";
}

std::string text_of(const ScaledCase& scaled, const ScaleOptions& options) {
  std::string text = "scaled      by Froude's law";
  for (const auto& [name, unit] : quantities)
    text += (name == "length" ? ": " : ", ") + name + " x " + significant(factor_of(options, unit), 6);
  text += "\nsoil        ";
  if (options.soil == SoilScaling::froude) return text + "similar: moduli as pressures, conductivity as a velocity\n";
  return text + "the same, kept: " + join(scaled.kept) + "\n";
}

/// Warning design_not_scaled: tables of a design, which the scaled case lacks.
NumberedWarnings warnings_of(const Case& problem) {
  std::vector<std::string> names;
  for (const std::string& name : tables_of_designs())
    if (problem.document.find(name)) names.push_back("[" + name + "]");
  if (names.empty()) return {};
  return {{"design_not_scaled", static_cast<double>(names.size()), 0., "1",
           "the scaled case lacks " + join(names, ", ") + ", which the file holds for waves, expected and sheet",
           "scale those tables by hand"}};
}

int scale(const ScaleOptionsOfCommand& options) {
  const Case problem = read_case(options.file, options.overrides);
  std::cerr << notes_on(problem) << describe(warnings_of(problem));
  const std::string name = options.out.empty() ? "results/" + problem.stem + "-scaled" : options.out;
  const ScaleOptions wanted{options.factor, options.soil == "same" ? SoilScaling::same : SoilScaling::froude,
                            options.ratios};
  const ScaledCase scaled = scale_case(problem, wanted, name);
  std::vector<std::string> written{"case.toml"};
  for (const NamedText& history : scaled.histories) written.push_back(history.path);
  require_inputs_kept(name, written, input_files(problem));
  OutputFolder folder(name);
  folder.write("case.toml", scaled.text);
  for (const NamedText& history : scaled.histories) folder.write(history.path, history.text);
  folder.commit();
  std::cout << (options.json ? scaling_json(problem, scaled, wanted)
                             : text_of(scaled, wanted) + "written     " + name + "/case.toml\n");
  return 0;
}

const char* const scale_footer =
    R"(Writes into results/NAME-scaled (or --out DIR), all or nothing:
  case.toml      the similar case with all defaults; runs as it is
  LOAD.csv       its force histories, where the case has any

Lengths of a .geo are scaled by the units in its comments: // m: height of the mound

Examples:
  upbead scale cases/fig2b-model.toml --factor 20                  the prototype, its soil 20 times as stiff
  upbead scale cases/fig2b-model.toml --factor 20 --soil same      the prototype on the model's soil
  upbead scale cases/fig2b-model.toml --factor 20 --soil same \
      --ratio regions.seabed.shear_modulus=4.47 --ratio regions.mound.shear_modulus=4.47)";

}  // namespace

Command scale_command() {
  const auto options = std::make_shared<ScaleOptionsOfCommand>();
  Command command{"scale", "write the similar case at another size, by Froude's law"};
  command.options = common_options(*options, "case", "the case (default: results/NAME-scaled, NAME as the file's)") +
                    std::vector<Option>{
                        {"--factor", &options->factor, "new length over old length", "", true},
                        {"--soil",
                         &options->soil,
                         "froude: moduli and conductivity similar too (default); same: the soil's constants stay",
                         "",
                         false,
                         false,
                         {},
                         {"froude", "same"}},
                        {"--ratio", &options->ratios, "multiply one number of the case by that instead", "KEY=VALUE"}};
  command.footer = scale_footer;
  command.work = [options] { return scale(*options); };
  return command;
}

}  // namespace upbead

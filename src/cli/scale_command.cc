#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/text.h"
#include "case/input_files.h"
#include "case/scale.h"
#include "cli/commands.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

struct ScaleOptionsOfCommand : CommonOptions {
  ScaleOptions scale;
  std::string soil = "froude";
};

/// What a person wants to know of the similarity, by unit.
const std::vector<std::pair<std::string, std::string>> quantities{
    {"length", "m"},  {"time", "s"},      {"frequency", "Hz"}, {"velocity", "m/s"},
    {"force", "N/m"}, {"pressure", "Pa"}, {"mass", "kg/m"},    {"density", "kg/m3"}};

double factor_of(const ScaleOptions& options, const std::string& unit) {
  return std::pow(options.factor, froude_exponent(unit));
}

std::string to_json(const Case& problem, const ScaledCase& scaled, const ScaleOptions& options) {
  Json json{{"title", problem.scene.title}, {"from", problem.document.path()}, {"factor", options.factor}};
  json["soil"] = options.soil == SoilScaling::same ? "same" : "froude";
  for (const auto& [name, unit] : quantities) json["factors"][name] = factor_of(options, unit);
  json["kept"] = scaled.kept;
  return json.dump(2) + "\n";
}

std::string describe(const ScaledCase& scaled, const ScaleOptions& options) {
  std::string text = "scaled      by Froude's law";
  for (const auto& [name, unit] : quantities)
    text += (name == "length" ? ": " : ", ") + name + " x " + significant(factor_of(options, unit), 6);
  text += "\nsoil        ";
  if (options.soil == SoilScaling::froude) return text + "similar: moduli as pressures, conductivity as a velocity\n";
  return text + "the same, kept: " + join(scaled.kept) + "\n";
}

void scale(const ScaleOptionsOfCommand& options) {
  const Case problem = read_case(options.file, options.overrides);
  const std::string name = options.out.empty() ? "results/" + problem.stem + "-scaled" : options.out;
  const ScaledCase scaled = scale_case(problem, options.scale, name);
  std::vector<std::string> written{"case.toml"};
  for (const NamedText& history : scaled.histories) written.push_back(history.path);
  require_inputs_kept(name, written, input_files(problem));
  OutputFolder folder(name);
  folder.write("case.toml", scaled.text);
  for (const NamedText& history : scaled.histories) folder.write(history.path, history.text);
  folder.commit();
  std::cout << (options.json ? to_json(problem, scaled, options.scale)
                             : describe(scaled, options.scale) + "written     " + name + "/case.toml\n");
}

const char* const scale_footer =
    "Writes into results/NAME-scaled (or --out DIR), all or nothing:\n"
    "  case.toml      the similar case with all defaults; runs as it is\n"
    "  LOAD.csv       its force histories, where the case has any\n\n"
    "Lengths of a .geo are scaled by the units in its comments: // m: height of the mound\n\n"
    "Examples:\n"
    "  upbead scale cases/fig2b-model.toml --factor 20                  the prototype, its soil 20 times as stiff\n"
    "  upbead scale cases/fig2b-model.toml --factor 20 --soil same      the prototype on the model's soil\n"
    "  upbead scale cases/fig2b-model.toml --factor 20 --soil same \\\n"
    "      --ratio regions.seabed.shear_modulus=4.47 --ratio regions.mound.shear_modulus=4.47";

}  // namespace

void add_scale(CLI::App& program) {
  auto options = std::make_shared<ScaleOptionsOfCommand>();
  CLI::App* command = program.add_subcommand("scale", "write the similar case at another size, by Froude's law");
  add_common_options(*command, *options);
  command->get_option("--out")->description("folder for the case (default: results/NAME-scaled, NAME as the file's)");
  command->add_option("--factor", options->scale.factor, "new length over old length")->required();
  command
      ->add_option("--soil", options->soil,
                   "froude: moduli and conductivity similar too (default); same: the soil's constants stay")
      ->check(CLI::IsMember({"froude", "same"}))
      ->option_text("froude|same");
  command->add_option("--ratio", options->scale.ratios, "multiply one number of the case by that instead")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  command->footer(scale_footer);
  command->callback([options] {
    options->scale.soil = options->soil == "same" ? SoilScaling::same : SoilScaling::froude;
    scale(*options);
  });
}

}  // namespace upbead

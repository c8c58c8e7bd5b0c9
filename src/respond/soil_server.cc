#include "respond/soil_server.h"

#include <set>
#include <sstream>

#include "base/text.h"
#include "output/output_schema.h"
#include "respond/respond_warnings.h"

namespace upbead {

namespace {

const char* const example = "write such as {\"regions.seabed.shear_modulus\": 25e6}";

/// The object that a line is. Throws InputError where it is none, or names a key twice, of which one would be lost.
Json object_of(const std::string& line) {
  std::set<std::string> keys;
  std::string twice;
  const auto look = [&](int depth, Json::parse_event_t event, const Json& value) {
    if (event == Json::parse_event_t::key && depth == 1 && !keys.insert(value.get<std::string>()).second)
      twice = value.get<std::string>();
    return true;
  };
  const Json object = Json::parse(line, look, false);
  if (object.is_discarded()) throw InputError(Place(), "the line is not JSON: " + excerpt(line), example);
  if (!twice.empty()) throw InputError(Place(), "the key " + in_quotes(twice) + " is given twice", "give it once");
  return object;
}

Soil soil_of_json(const std::string& line) {
  Soil soil;
  Diagnostics mistakes;
  const Json object = object_of(line);
  for (const auto& [key, value] : object.items())
    if (value.is_number())
      soil[key] = value.get<double>();
    else
      mistakes.add(Place(), "the value of " + in_quotes(key) + " is no number", example);
  mistakes.throw_if_any();
  return soil;
}

}  // namespace

Soil soil_of_line(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  if (first != std::string::npos && line[first] == '{') return soil_of_json(line);
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return soil_of_options(words, "");
}

std::string why_no_slip(const SoilModelFile& file) {
  return file.family.reduced.slips() ? "a model of soils answers a caisson that sticks to the ground; one that slips "
                                       "as a whole is answered by the reduced model of its soil"
                                     : "";
}

SoilServer::SoilServer(SoilAnswers model, std::vector<WaveFile> waves, RespondOptions options)
    : model_(std::move(model)), waves_(std::move(waves)), options_(std::move(options)) {
  require_readings(model_.readings(), options_.histories.names);
  options_.why_no_slip = why_no_slip(model_.file());
}

std::string SoilServer::answer(const std::string& line) const {
  std::optional<Soil> soil;
  try {
    soil = soil_of_line(line);
    soil = model_.whole(*soil);
    return answer_soil(*soil);
  } catch (const InputError& error) {
    return soil_line(soil, error.what());
  } catch (const NumericsError& error) {
    return soil_line(soil, error.what());
  }
}

std::string SoilServer::answer_soil(const Soil& whole) const {
  const AnsweredSoil member = model_.member(whole, options_.histories.names);
  RespondOptions options = options_;
  options.histories.fewer = std::make_shared<const ModalModel>(member.fewer);
  options.histories.safety = member.model.nested->safety;
  const std::vector<WaveResponses> responses = respond_to_waves(member.model, waves_, options);
  NumberedWarnings warnings = warnings_of_files(waves_);
  append(warnings, cut_warnings(member.model, waves_, responses));
  append(warnings, warnings_of_answers(member.model, responses));
  return soil_line({member.model, "", whole}, responses, warnings);
}

}  // namespace upbead

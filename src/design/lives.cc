#include "design/lives.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/fingerprint.h"
#include "base/journal.h"
#include "base/version.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

/// Calls see() with each number of a life, in the order of a journal.
template <class Numbers, class See>
void each_number(Numbers& life, const See& see) {
  for (auto* number : {&life.sliding, &life.waves, &life.answered, &life.taken, &life.highest}) see(*number);
  for (auto* number :
       {&life.base.heel_pressure, &life.base.toe_pressure, &life.base.eccentricity, &life.base.overturning_margin})
    see(*number);
  for (auto* number : {&life.ways.sliding, &life.ways.sliding_seaward, &life.ways.overturning, &life.ways.heel_pressure,
                       &life.ways.toe_pressure, &life.ways.circles, &life.answered_for_ways})
    see(*number);
}

/// JSON knows no infinity: its name stands for it.
Json to_object(int number, const LifeByLaw& found) {
  Json json{{"life", number}, {"laws", Json::object()}};
  for (const auto& [law, life] : found) {
    Json& numbers = json["laws"][word(law)] = Json::array();
    each_number(life, [&numbers](double value) {
      numbers.push_back(std::isfinite(value) ? Json(value) : Json(std::to_string(value)));
    });
  }
  return json;
}

LifeByLaw life_of(const Json& json) {
  LifeByLaw found;
  for (const Law law : {Law::paper, Law::exact, Law::combined, Law::dynamic}) {
    if (!json.contains(word(law))) continue;
    auto value = json.at(word(law)).begin();
    each_number(found[law], [&value](double& number) {
      number = value->is_string() ? std::stod(value->get<std::string>()) : value->get<double>();
      ++value;
    });
  }
  return found;
}

/// Of all that a life rests on.
std::uint64_t fingerprint_of_lives(const Design& design) {
  Fingerprint fingerprint;
  fingerprint.add(program_version());
  const auto folder = std::filesystem::path(".") / std::filesystem::path(design.document.path()).parent_path();
  fingerprint.add(effective_design(design, folder.string()));
  for (const InputFile& file : input_files(design))
    if (file.path != design.document.path()) fingerprint.add_file(file.path);
  return fingerprint.value();
}

}  // namespace

KeptLives read_lives(const std::string& folder, const Design& design, const std::string& torn_of) {
  KeptLives kept{std::vector<LifeByLaw>(static_cast<std::size_t>(design.tables.life->lives))};
  const JournalsOf journals{folder, fingerprint_of_lives(design),
                            "other work, or of this design before it, its files or the program changed",
                            "remove " + journal_folder(folder).string() + ", or choose another folder with --out DIR"};
  kept.torn = read_lines(journals, torn_of, [&kept](const Json& line) {
    if (line.contains("life")) kept.lives.at(line.at("life").get<std::size_t>()) = life_of(line.at("laws"));
  });
  return kept;
}

void keep_lives(const std::string& folder, const Design& design, const std::vector<int>& lives,
                const std::string& journal) {
  JournalFile file(folder, fingerprint_of_lives(design), journal);
  compute_lives(design, lives, [&file](int life, const LifeByLaw& found) { file.write(to_object(life, found)); });
}

LivesByLaw by_law(const KeptLives& kept) {
  LivesByLaw lives;
  for (const LifeByLaw& found : kept.lives)
    for (const auto& [law, life] : found) lives[law].push_back(life);
  return lives;
}

}  // namespace upbead

#include "case/storm_cycles.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "case/case_schema.h"
#include "case/records/sea_states.h"
#include "case/wave_load.h"

namespace upbead {

namespace {

constexpr int classes_of_height = 8;
constexpr double waves_of_group = 200.;
constexpr int most_groups = 8;

/// Waves of a class: their share of all, and the height whose fourth power is the mean of theirs.
struct HeightClass {
  double share = 0., height = 0.;
};

/// Mean of (H/H_1/3)^4 of waves between a and b (over H_1/3) times their share: with x = 2 h^2 the share above is
/// exp(-x) (Longuet-Higgins 1952), and h^4 = x^2/4, so that it is -(x^2 + 2 x + 2) exp(-x)/4 between the ends.
double fourth_moment(double a, double b) {
  const auto rest = [](double h) {
    const double x = 2. * h * h;
    return 0.25 * (x * x + 2. * x + 2.) * std::exp(-x);
  };
  return rest(a) - rest(b);
}

/// Classes of equal width up to `highest`; waves beyond it are of the last one, with that height.
std::vector<HeightClass> height_classes(double highest) {
  const RayleighHeights heights(1., RayleighHeights::no_cut, highest);
  std::vector<HeightClass> list;
  for (int i = 0; i < classes_of_height; ++i) {
    const double low = highest * i / classes_of_height, high = highest * (i + 1) / classes_of_height;
    double share = heights.exceedance(low) - heights.exceedance(high), moment = fourth_moment(low, high);
    if (i + 1 == classes_of_height) moment += heights.at_limit() * std::pow(highest, 4);
    list.push_back({share, std::pow(moment / share, 0.25)});
  }
  return list;
}

/// The wave whose loads the case has, where it is one of [loads.NAME.wave]: the highest.
const WaveLoad* wave_of_loads(const Case& problem) {
  const WaveLoad* highest = nullptr;
  for (const WaveLoad* load : sources_of_type<WaveLoad>(problem))
    if (!highest || load->wave.height > highest->wave.height) highest = load;
  return highest;
}

std::optional<double> run_height(const Case& problem) {
  if (const auto& given = problem.tables->cycles_table->run_height) return given;
  if (const WaveLoad* load = wave_of_loads(problem)) return load->wave.height;
  const auto& sliding = problem.scene.sliding;
  return sliding && sliding->wave ? std::optional(sliding->wave->height) : std::nullopt;
}

/// Whether the storm is that of the record of the file: the table itself has none.
bool of_record(const CyclesTable& table) {
  return table.number.empty() && table.duration.empty() && table.significant_height.empty() && table.height.empty() &&
         table.period.empty();
}

/// Whether the table gives heights, or waves that are all as the run's, and no sea state.
bool of_table(const CyclesTable& table) {
  return !table.height.empty() ||
         (table.significant_height.empty() && table.duration.empty() && !table.number.empty() && !table.period.empty());
}

std::vector<SeaState> record_of(const Case& problem) {
  const std::string& file = *problem.document.find("sea.states")->text();
  RecordNotes notes;
  std::vector<SeaState> states = read_sea_states(problem.resolve(file), problem.place("sea.states"), notes);
  const auto no_waves = [](const SeaState& state) { return state.waves <= 0.; };
  states.erase(std::remove_if(states.begin(), states.end(), no_waves), states.end());
  return states;
}

/// The parts of the table; what it leaves out is that of the wave load.
std::vector<SeaState> states_of(const Case& problem, Diagnostics& wrong) {
  const CyclesTable& table = *problem.tables->cycles_table;
  const WaveLoad* load = wave_of_loads(problem);
  std::vector<double> heights = table.significant_height, periods = table.period;
  if (load && heights.empty()) heights = {load->wave.significant_height};
  if (load && periods.empty()) periods = {load->wave.period};
  const std::vector<double>& amount = table.duration.empty() ? table.number : table.duration;
  const auto need = [&](const std::string& key, std::size_t n, const std::string& cure) {
    if (n == 0) wrong.add(at_key(key), "'" + key + "' is missing", cure);
    if (n != 0 && n != amount.size() && !amount.empty())
      wrong.add(at_key(key),
                key + " has " + std::to_string(n) + (n == 1 ? " value" : " values") + ", and the storm " +
                    std::to_string(amount.size()) + (amount.size() == 1 ? " part" : " parts"),
                "give one value for every part of the storm");
  };
  need("number", amount.size(), "give the number of waves of each part, or its duration (s)");
  need("period", periods.size(), "give the period T_1/3 of each part (s), or a load by a wave");
  need("significant_height", heights.size(), "give H_1/3 of each part (m), or height, or a load by a wave");
  if (!wrong.empty()) return {};
  std::vector<SeaState> states(amount.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i].significant_height = heights[i];
    states[i].period = periods[i];
    states[i].waves = table.duration.empty() ? amount[i] : amount[i] / periods[i];
  }
  return states;
}

/// Explicit parts, as they were before there were sea states.
Cycles table_cycles(const Case& problem, Diagnostics& wrong) {
  const CyclesTable& table = *problem.tables->cycles_table;
  Cycles cycles = table;
  if (table.number.empty())  // all waves of a part have its period
    for (std::size_t i = 0; i < std::min(table.duration.size(), table.period.size()); ++i)
      cycles.number.push_back(table.period[i] > 0. ? table.duration[i] / table.period[i] : 0.);
  if (!cycles.height.empty()) cycles.run_height = run_height(problem);
  wrong.add(diagnose(cycles));
  return cycles;
}

/// Of the record of the file, or of sea states of the table.
Cycles sea_cycles(const Case& problem, bool record, Diagnostics& wrong) {
  std::vector<SeaState> states;
  const Node* file = problem.document.find("sea.states");
  if (!record)
    states = states_of(problem, wrong);
  else if (file && file->text())
    states = record_of(problem);
  if (states.empty() && wrong.empty())
    wrong.add(at_key("number"), file ? "the record of [sea] has no waves" : "nothing is said of the storm",
              "give number and period of each part, with height or significant_height, or [sea] states");
  const std::optional<double> height = run_height(problem);
  if (!height)
    wrong.add(at_key("run_height"), "the height of the run's wave is not known, over which those of the storm count",
              "add run_height, the height of the wave whose loads the case has (m)");
  if (!wrong.empty()) return {};
  Cycles cycles = rayleigh_cycles(states, problem.tables->cycles_table->highest, *height);
  cycles.calm = problem.tables->cycles_table->calm;
  return cycles;
}

}  // namespace

Diagnostics diagnose(const CyclesTable& table) {
  Diagnostics list;
  const auto one_of = [&](const char* first, bool has_first, const char* second, bool has_second) {
    if (has_first && has_second)
      list.add(at_key(second), std::string("both '") + first + "' and '" + second + "' are given", "keep one of them");
  };
  one_of("number", !table.number.empty(), "duration", !table.duration.empty());
  one_of("height", !table.height.empty(), "significant_height", !table.significant_height.empty());
  return list;
}

Cycles rayleigh_cycles(const std::vector<SeaState>& states, double highest, double run_height) {
  Cycles cycles;
  cycles.run_height = run_height;
  const std::vector<HeightClass> classes = height_classes(highest);
  for (const SeaState& state : states) {
    const int groups = std::clamp(static_cast<int>(std::ceil(state.waves / waves_of_group)), 1, most_groups);
    for (int group = 0; group < groups; ++group)
      for (const HeightClass& one : classes) {
        cycles.number.push_back(state.waves * one.share / groups);
        cycles.period.push_back(state.period);
        cycles.height.push_back(one.height * state.significant_height);
      }
  }
  return cycles;
}

void make_cycles(Case& problem, Diagnostics& report) {
  if (!problem.tables->cycles_table || !report.sound("cycles")) return;
  const CyclesTable& table = *problem.tables->cycles_table;
  const bool by_sea = !of_table(table), record = of_record(table);
  Diagnostics wrong;
  Cycles cycles;
  try {
    cycles = by_sea ? sea_cycles(problem, record, wrong) : table_cycles(problem, wrong);
  } catch (const InputError& error) {  // of the file of the record
    report.add_at("cycles", error.diagnostics());
    return;
  }
  for (const auto& [at, what, cure] : wrong)
    report.add(problem.place(dotted("cycles", at.key)), "[cycles]: " + what, cure);
  if (!wrong.empty()) return;
  problem.scene.cycles = cycles;
  if (by_sea)
    report.note(problem.place("cycles"),
                "assumed: heights of the storm by Rayleigh about H_1/3, up to " + significant(table.highest, 3) +
                    " H_1/3, in " + std::to_string(cycles.number.size()) + " parts" +
                    (record ? "; its sea states are all rows of [sea] states, one after the other" : "") +
                    "; shear in proportion to the height, over " + with_unit(*cycles.run_height, "m") +
                    " of the run's wave");
}

std::vector<InputFile> files_of_cycles(const Case& problem) {
  const auto& table = problem.tables->cycles_table;
  const Node* file = problem.document.find("sea.states");
  if (!table || !of_record(*table) || !file || !file->text()) return {};
  return {{problem.resolve(*file->text()), problem.place("sea.states")}};
}

TableSchema<CyclesTable> cycles_schema() {
  using T = CyclesTable;
  TableSchema<T> table;
  table
      .key("number", &T::number, "", "number of waves in each part of the storm, in order of time; as period",
           above(0.))
      .fallback("by duration; without both those of [sea] states, if the file has them");
  table.key("duration", &T::duration, "s", "of each part, in place of number: all its waves have its period", above(0.))
      .fallback("by number");
  table.key("period", &T::period, "s", "wave period in each part, of sea states T_1/3", above(0.))
      .fallback("that of the load by a wave");
  table
      .key("height", &T::height, "m",
           "wave height in each part; the shear of the run counts in proportion to it over run_height", above(0.))
      .fallback("all waves are as the run's");
  table
      .key("significant_height", &T::significant_height, "m",
           "H_1/3 in each part, in place of height: heights by Rayleigh", above(0.))
      .fallback("that of the load by a wave, where number or period is missing");
  table.key("highest", &T::highest, "", "largest height over significant_height; higher waves break to it",
            from_to(0.01, 10.));
  table
      .key("run_height", &T::run_height, "m", "height of the wave whose loads the case has; needed with height",
           above(0.))
      .fallback("that of the load by a wave, or of [sliding.wave]");
  table.key("calm", &T::calm, "s", "time after the storm that is followed, while the pressure goes", at_least(0.))
      .fallback("until a hundredth of the largest pressure is left, at most a thousand times the storm");
  return table;
}

}  // namespace upbead

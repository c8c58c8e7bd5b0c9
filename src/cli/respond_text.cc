#include "cli/respond_text.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "base/text.h"
#include "respond/answered_wave.h"
#include "respond/respond_warnings.h"
#include "upbead/input/node.h"

namespace upbead {

namespace {

constexpr std::size_t longest_table = 20;  // rows that people read

/// Whether the coupled slip of the wave was asked for.
bool is_asked(const AnsweredWave& row) {
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

std::string table(const std::vector<AnsweredWave>& waves) {
  const bool sliding = waves.front().wave->sliding.has_value();
  const bool coupled = std::any_of(waves.begin(), waves.end(), is_asked);
  std::size_t width = 12;
  for (const AnsweredWave& row : waves) width = std::max(width, row.name.size() + 2);
  std::string text = padded("wave", width) + "peak P         peak F_T       F_T / P   error of F_T";
  if (sliding) text += coupled ? "   S              S, coupled" : "   S";
  text += "\n";
  for (const AnsweredWave& row : waves) {
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

/// The least factor of each way to fail, where the ground has circles.
std::string factors(const std::vector<AnsweredWave>& waves) {
  if (std::none_of(waves.begin(), waves.end(), [](const AnsweredWave& row) { return row.wave->circle; })) return "";
  std::size_t width = 12;
  for (const AnsweredWave& row : waves) width = std::max(width, row.name.size() + 2);
  std::string text = padded("least", width) + "sliding   seaward   overturning  slip circles\n";
  for (const AnsweredWave& row : waves) {
    const WaveResponse& w = *row.wave;
    text += padded(row.name, width) + padded(factor_text(w.least_sliding_factor), 10) +
            padded(factor_text(w.least_sliding_factor_seaward), 10) +
            padded(factor_text(w.least_overturning_margin), 13) + circle_text(w.circle) + "\n";
  }
  return text;
}

/// The least factors of many waves.
std::string factors_overview(const std::vector<AnsweredWave>& waves) {
  const AnsweredWave* worst = nullptr;
  int below = 0;
  for (const AnsweredWave& row : waves) {
    if (!row.wave->circle) continue;
    if (row.wave->circle->factor < 1.) ++below;
    if (!worst || row.wave->circle->factor < worst->wave->circle->factor) worst = &row;
  }
  if (!worst) return "";
  return "circles     F below 1 in " + std::to_string(below) + " of them, least " + circle_text(worst->wave->circle) +
         " in " + worst->name + "\n";
}

/// How many waves slide the caisson, and how far.
std::string sliding_overview(const std::vector<AnsweredWave>& waves, const std::string& title,
                             const std::function<double(const WaveResponse&)>& S) {
  const auto farthest =
      std::max_element(waves.begin(), waves.end(),
                       [&S](const AnsweredWave& a, const AnsweredWave& b) { return S(*a.wave) < S(*b.wave); });
  const auto n = std::count_if(waves.begin(), waves.end(), [&S](const AnsweredWave& a) { return S(*a.wave) != 0.; });
  return title + std::to_string(n) + " of them slide the caisson, farthest " + with_unit(S(*farthest->wave), "m") +
         " in " + farthest->name + "\n";
}

std::string overview(const std::vector<AnsweredWave>& waves) {
  const auto [least, most] = std::minmax_element(
      waves.begin(), waves.end(),
      [](const AnsweredWave& a, const AnsweredWave& b) { return a.wave->peak_shear < b.wave->peak_shear; });
  const double top = most->wave->peak_shear;
  std::string text = "waves       " + std::to_string(waves.size()) + "\n";
  text += "peak F_T    " + with_unit(least->wave->peak_shear, "N/m", top) + " to " + with_unit(top, "N/m") +
          ", largest in " + most->name + " (peak P " + with_unit(most->wave->peak_force, "N/m") + ", F_T / P " +
          ratio_text(*most->wave) + ")\n";
  if (waves.front().wave->error_estimate) {
    const AnsweredWave& worst = *std::max_element(
        waves.begin(), waves.end(),
        [](const AnsweredWave& a, const AnsweredWave& b) { return a.wave->error_estimate < b.wave->error_estimate; });
    text += "error of F_T " + error_text(*worst.wave) + " of its largest value, largest in " + worst.name + "\n";
  }
  if (!waves.front().wave->sliding) return text;
  text += sliding_overview(waves, "sliding     ", [](const WaveResponse& w) { return *w.sliding; });
  if (std::none_of(waves.begin(), waves.end(), is_asked)) return text;
  std::vector<AnsweredWave> told;
  std::copy_if(waves.begin(), waves.end(), std::back_inserter(told),
               [](const AnsweredWave& a) { return a.wave->coupled; });
  if (told.empty()) return text + "S, coupled  could be computed for none of them\n";
  text += sliding_overview(told, "S, coupled  ", [](const WaveResponse& w) { return w.coupled->sliding; });
  const auto n =
      std::count_if(told.begin(), told.end(), [](const AnsweredWave& a) { return a.wave->coupled->lifted_time > 0.; });
  if (n > 0) text += "            " + std::to_string(n) + " of them would lift it\n";
  return text;
}

/// A row for each key.
std::string soil_rows(const std::map<std::string, double>& soil) {
  std::string text;
  for (const auto& [key, value] : soil)
    text += padded(text.empty() ? "soil" : "", 12) + key + " = " + number_text(value) + "\n";
  return text;
}

}  // namespace

std::string answers_text(const AnsweredModel& of, const std::vector<WaveResponses>& files,
                         const RespondTiming& timing) {
  const std::vector<AnsweredWave> waves = all_waves(files);
  const ReducedModelFile& model = of.model;
  std::string text = model.title + ", reduced to " + std::to_string(model.modes.n_modes()) + " modes: F_T within " +
                     significant(100. * model.error) + " % up to " + significant(model.highest_frequency) + " Hz\n";
  text += soil_rows(of.soil);
  text += waves.size() <= longest_table ? table(waves) + factors(waves) : overview(waves) + factors_overview(waves);
  text += "time        read " + significant(timing.read) + " s, respond " + significant(timing.respond) + " s";
  if (timing.respond > 0.)
    text += " (" + significant(static_cast<double>(waves.size()) / timing.respond) + " waves a second)";
  return text + ", write " + significant(timing.write) + " s\n";
}

}  // namespace upbead

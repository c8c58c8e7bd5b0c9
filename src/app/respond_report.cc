#include "respond_report.h"

#include <algorithm>
#include <functional>

#include "upbead/app/report.h"
#include "upbead/base/text.h"

namespace upbead {

namespace {

constexpr std::size_t longest_table = 20;  // rows that people read

/// A wave with its name.
struct Named {
  std::string name;
  const WaveResponse* wave;
};

std::vector<Named> all_waves(const std::vector<WaveResponses>& files) {
  std::vector<Named> list;
  for (const WaveResponses& file : files)
    for (std::size_t w = 0; w < file.waves.size(); ++w) list.push_back({file.wave_name(w), &file.waves[w]});
  return list;
}

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

std::string ratio_text(const WaveResponse& wave) {
  return wave.ratio ? significant(*wave.ratio, 4) : "none";
}

std::string table(const std::vector<Named>& waves) {
  const bool sliding = waves.front().wave->sliding.has_value();
  const bool coupled = waves.front().wave->coupled.has_value();
  std::size_t width = 12;
  for (const Named& row : waves) width = std::max(width, row.name.size() + 2);
  std::string text = padded("wave", width) + "peak P         peak F_T       F_T / P";
  if (sliding) text += coupled ? "   S              S, coupled" : "   S";
  text += "\n";
  for (const Named& row : waves) {
    const WaveResponse& w = *row.wave;
    const std::string ratio = ratio_text(w);
    text += padded(row.name, width) + padded(with_unit(w.peak_force, "N/m"), 15) +
            padded(with_unit(w.peak_shear, "N/m", w.peak_force), 15);
    text += sliding ? padded(ratio, 10) : ratio;
    if (sliding) text += coupled ? padded(with_unit(*w.sliding, "m"), 15) : with_unit(*w.sliding, "m");
    if (coupled) text += with_unit(w.coupled->sliding, "m");
    text += "\n";
  }
  return text;
}

/// How many slide the caisson, and how far.
std::string sliding_overview(const std::vector<Named>& waves, const std::string& title,
                             const std::function<double(const WaveResponse&)>& S) {
  const auto farthest = std::max_element(waves.begin(), waves.end(),
                                         [&S](const Named& a, const Named& b) { return S(*a.wave) < S(*b.wave); });
  const auto n = std::count_if(waves.begin(), waves.end(), [&S](const Named& a) { return S(*a.wave) != 0.; });
  return title + std::to_string(n) + " of them slide the caisson, farthest " + with_unit(S(*farthest->wave), "m") +
         " in " + farthest->name + "\n";
}

std::string overview(const std::vector<Named>& waves) {
  const auto [least, most] = std::minmax_element(waves.begin(), waves.end(), [](const Named& a, const Named& b) {
    return a.wave->peak_shear < b.wave->peak_shear;
  });
  const double top = most->wave->peak_shear;
  std::string text = "waves       " + std::to_string(waves.size()) + "\n";
  text += "peak F_T    " + with_unit(least->wave->peak_shear, "N/m", top) + " to " + with_unit(top, "N/m") +
          ", largest in " + most->name + " (peak P " + with_unit(most->wave->peak_force, "N/m") + ", F_T / P " +
          ratio_text(*most->wave) + ")\n";
  if (!waves.front().wave->sliding) return text;
  text += sliding_overview(waves, "sliding     ", [](const WaveResponse& w) { return *w.sliding; });
  if (!waves.front().wave->coupled) return text;
  text += sliding_overview(waves, "S, coupled  ", [](const WaveResponse& w) { return w.coupled->sliding; });
  const auto n =
      std::count_if(waves.begin(), waves.end(), [](const Named& a) { return a.wave->coupled->lifted_time > 0.; });
  if (n > 0) text += "            " + std::to_string(n) + " of them would lift it\n";
  return text;
}

}  // namespace

std::string describe(const ReducedModelFile& model, const std::vector<WaveResponses>& files,
                     const RespondTiming& timing) {
  const std::vector<Named> waves = all_waves(files);
  std::string text = model.title + ", reduced to " + std::to_string(model.modes.n_modes()) + " modes: F_T within " +
                     significant(100. * model.error) + " % up to " + significant(model.highest_frequency) + " Hz\n";
  text += waves.size() <= longest_table ? table(waves) : overview(waves);
  text += "time        read " + significant(timing.read) + " s, respond " + significant(timing.respond) + " s";
  if (timing.respond > 0.)
    text += " (" + significant(static_cast<double>(waves.size()) / timing.respond) + " waves a second)";
  return text + ", write " + significant(timing.write) + " s\n";
}

std::string band_warning(const ReducedModelFile& model, const std::vector<WaveResponses>& files) {
  const std::vector<Named> waves = all_waves(files);
  const auto n = std::count_if(waves.begin(), waves.end(),
                               [&model](const Named& row) { return row.wave->beyond_band > model.tolerance; });
  if (n == 0) return "";
  const Named& worst = *std::max_element(waves.begin(), waves.end(), [](const Named& a, const Named& b) {
    return a.wave->beyond_band < b.wave->beyond_band;
  });
  return "warning: " + std::to_string(n) + " of " + std::to_string(waves.size()) +
         " waves reach beyond the frequencies that the model has been checked for, " +
         significant(model.highest_frequency) + " Hz: worst " + worst.name + ", where " +
         significant(100. * worst.wave->beyond_band) + " % of F_T lies beyond (tolerance " +
         significant(100. * model.tolerance) +
         " %); reduce again with a shorter pulse or a smaller tolerance, or march it with 'upbead run'\n";
}

}  // namespace upbead

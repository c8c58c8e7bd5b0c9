#include "respond_report.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "base/text.h"

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

/// Whether somebody wants its coupled slip.
bool is_asked(const Named& row) {
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

std::string table(const std::vector<Named>& waves) {
  const bool sliding = waves.front().wave->sliding.has_value();
  const bool coupled = std::any_of(waves.begin(), waves.end(), is_asked);
  std::size_t width = 12;
  for (const Named& row : waves) width = std::max(width, row.name.size() + 2);
  std::string text = padded("wave", width) + "peak P         peak F_T       F_T / P   error of F_T";
  if (sliding) text += coupled ? "   S              S, coupled" : "   S";
  text += "\n";
  for (const Named& row : waves) {
    const WaveResponse& w = *row.wave;
    const std::string error = error_text(w);
    text += padded(row.name, width) + padded(with_unit(w.peak_force, "N/m"), 15) +
            padded(with_unit(w.peak_shear, "N/m", w.peak_force), 15) + padded(ratio_text(w), 10);
    text += sliding ? padded(error, 15) : error;
    if (sliding) text += coupled ? padded(with_unit(*w.sliding, "m"), 15) : with_unit(*w.sliding, "m");
    if (coupled) text += w.coupled ? with_unit(w.coupled->sliding, "m") : "not told";
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
  if (waves.front().wave->error_estimate) {
    const Named& worst = *std::max_element(waves.begin(), waves.end(), [](const Named& a, const Named& b) {
      return a.wave->error_estimate < b.wave->error_estimate;
    });
    text += "error of F_T " + error_text(*worst.wave) + " of its largest value, largest in " + worst.name + "\n";
  }
  if (!waves.front().wave->sliding) return text;
  text += sliding_overview(waves, "sliding     ", [](const WaveResponse& w) { return *w.sliding; });
  if (std::none_of(waves.begin(), waves.end(), is_asked)) return text;
  std::vector<Named> told;
  std::copy_if(waves.begin(), waves.end(), std::back_inserter(told), [](const Named& a) { return a.wave->coupled; });
  if (told.empty()) return text + "S, coupled  of none of them is told\n";
  text += sliding_overview(told, "S, coupled  ", [](const WaveResponse& w) { return w.coupled->sliding; });
  const auto n =
      std::count_if(told.begin(), told.end(), [](const Named& a) { return a.wave->coupled->lifted_time > 0.; });
  if (n > 0) text += "            " + std::to_string(n) + " of them would lift it\n";
  return text;
}

}  // namespace

std::string slip_warning(const std::vector<WaveResponses>& files) {
  const std::vector<Named> waves = all_waves(files);
  const auto untold = [](const Named& row) { return !row.wave->why_not_coupled.empty(); };
  const auto first = std::find_if(waves.begin(), waves.end(), untold);
  if (first == waves.end()) return "";
  return "warning: how far the caisson slips as a whole is not told for " +
         std::to_string(std::count_if(waves.begin(), waves.end(), untold)) + " of " + std::to_string(waves.size()) +
         " waves, such as " + first->name + ": " + first->wave->why_not_coupled + "\n";
}

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

NumberedWarnings error_warnings(const ReducedModelFile& model, const std::vector<WaveResponses>& files) {
  if (!model.nested)
    return {{"no_error_estimate", 0., model.tolerance, "1",
             "the model holds nothing that tells how wrong its answer to a wave is, so error_estimate is null; make it "
             "again with 'upbead reduce'"}};
  const std::vector<Named> waves = all_waves(files);
  const auto estimate = [](const Named& row) { return row.wave->error_estimate.value_or(0.); };
  const auto n =
      std::count_if(waves.begin(), waves.end(), [&](const Named& row) { return estimate(row) > model.tolerance; });
  if (n == 0) return {};
  const Named& worst = *std::max_element(waves.begin(), waves.end(),
                                         [&](const Named& a, const Named& b) { return estimate(a) < estimate(b); });
  return {{"reduced_model_error", estimate(worst), model.tolerance, "1",
           "F_T of " + std::to_string(n) + " of " + std::to_string(waves.size()) +
               " waves may be wrong by more than the model's tolerance: worst " + worst.name + ", by up to " +
               significant(100. * estimate(worst), 2) + " % of its largest F_T (tolerance " +
               significant(100. * model.tolerance) +
               " %); reduce again with an 'end' as long as the wave, a load as short as its pulse or a smaller "
               "[accuracy] tolerance, or march it with 'upbead run'"}};
}

}  // namespace upbead

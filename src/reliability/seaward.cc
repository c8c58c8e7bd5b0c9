#include "reliability/seaward.h"

#include <algorithm>
#include <boost/math/interpolators/makima.hpp>
#include <memory>

#include "upbead/waves/standing_stability.h"

namespace upbead {

namespace {

/// Whether a variable that acts there changes the standing wave of a given height, or the wall that it presses on.
bool changes_standing(const std::string& acts_on, const std::string& wave) {
  const std::string of_wave = dotted("waves", wave) + ".";
  const std::vector<std::string> keys{
      "section.water_depth", "section.foundation_depth", "section.crest", "section.width", "fluid.density",
      of_wave + "period",    of_wave + "angle",          "period",        "water_level"};
  return std::find(keys.begin(), keys.end(), acts_on) != keys.end();
}

constexpr int heights = 16;

}  // namespace

SeawardForce seaward_force(const DesignTables& tables) {
  const std::string name = random_wave(tables);
  for (const auto& [variable, random] : tables.reliability->variables)
    if (changes_standing(random.acts_on, name))
      return {
          {}, 0., variable + " changes the standing wave itself, which is solved for certain water, wall and period"};
  DesignWave wave = design_wave(tables.waves.at(name), tables.section, tables.water);
  const double given = wave.height;
  const double top = 1.5 * std::max(given, 0.5 * tables.section.water_depth);
  std::vector<double> height{0.}, force{0.};
  std::string why_not;
  std::optional<StandingWave> lower;
  for (int i = 1; i <= heights && why_not.empty(); ++i) {
    wave.height = top * i / heights;
    const StandingResult found = standing_answer(tables.section, tables.water, wave, 1., lower ? &*lower : nullptr);
    why_not = found.why_not;
    if (!found.answer) continue;
    lower = found.answer->wave;
    height.push_back(wave.height);
    force.push_back(-found.answer->worst.seaward.force);  // of the wave alone, without a push of still water
  }
  const double highest = height.back();
  if (height.size() < 4 || highest < given)  // fewer than the interpolation needs, or none for the wave itself
    return {{}, highest, "there is no standing wave of the design's height: " + why_not};
  const auto table =
      std::make_shared<boost::math::interpolators::makima<std::vector<double>>>(std::move(height), std::move(force));
  return {[table, highest](double H) { return (*table)(std::clamp(H, 0., highest)); }, highest, ""};
}

}  // namespace upbead

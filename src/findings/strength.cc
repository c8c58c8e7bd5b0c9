// What the states of linear soil and water come to: mobilised strength, and pressure down to that of vapour.
#include "base/text.h"
#include "fem/compile.h"
#include "findings/topics.h"
#include "run/monitors.h"

namespace upbead {

namespace {

/// Share of the area that must yield in addition to what yields at rest.
constexpr double least_yielding = 0.005;

OutputSchema<MobilisedStrength> strength_outputs() {
  using S = MobilisedStrength;
  return OutputSchema<S>()
      .key("region", &S::region, "", "its name")
      .key("initial", &S::initial, "", "largest mobilisation at rest; 1: yield, 10: more")
      .key("initial_share", &S::initial_share, "", "share of the area where it exceeds 1 at rest")
      .key("largest", &S::largest, "", "largest mobilisation at any time")
      .key("at[]", &S::at, "m", "where that is")
      .key("time", &S::time, "s", "and when")
      .key("share", &S::share, "", "share of the area where it exceeds 1 at some time")
      .key("left_out", &S::left_out, "", "share of the area that is left out: free surfaces");
}

std::vector<MobilisedStrength> find_strength(const Evidence& e) {
  const auto& strength = e.of(monitors_of)->strength;
  return strength && strength->has_seen() ? strength->found() : std::vector<MobilisedStrength>();
}

SkippedList skipped_strength(const Evidence& e, const Summary&) {
  const Monitors& monitors = *e.of(monitors_of);
  if (monitors.strength ? monitors.strength->has_seen() : monitors.why_no_strength.empty()) return {};
  return {{"mobilised strength", monitors.strength ? "the contact was not marched" : monitors.why_no_strength}};
}

SkippedList no_strength(const Simulation& simulation, bool) {
  if (!simulation.compiled()->caisson || has_strength(simulation.scene()) || yields(simulation.scene())) return {};
  return {{"strength of the soil", "no region has a table strength"}};
}

/// Warning rest_open: of elastic soil whose elastic stress at rest exceeds its strength in most of a region, as that of
/// a slope which does not stand; of mounds that do, two fifths exceed it.
void add_doubtful_rest(const MobilisedStrength& s, NumberedWarnings& list) {
  constexpr double of_mounds = 0.5;
  if (s.initial_share <= of_mounds) return;
  list.push_back(
      {"rest_open", s.initial_share, of_mounds, "1",
       "in " + significant(100. * s.initial_share, 2) + " % of region '" + s.region +
           "' the elastic stresses at rest exceed the soil's strength: whether the ground stands under its own "
           "weight is not known",
       "ask for it by initial.safety = true"});
}

/// Warnings strength and rest_open.
NumberedWarnings strength_warnings(const Evidence&, const Summary& summary) {
  NumberedWarnings list;
  for (const MobilisedStrength& s : summary.strength) {
    if (!summary.safety) add_doubtful_rest(s, list);
    if (s.share > s.initial_share + least_yielding)
      list.push_back({"strength", s.largest, 1., "1",
                      "in " + significant(100. * s.share, 2) + " % of region '" + s.region + "' (" +
                          significant(100. * s.initial_share, 2) +
                          " % at rest) the stresses exceed the soil's strength, at most " +
                          (s.largest < 10. ? "" : "more than ") + significant(s.largest) + " times at " +
                          place_text(s.at) + " at " + significant(s.time) +
                          " s: it would yield, which linear soil does not",
                      "use [regions." + s.region + ".strain], smaller loads, or a stronger soil"});
  }
  return list;
}

/// Warning cavitation.
NumberedWarnings cavitation_warnings(const Evidence& e, const Summary&) {
  const auto& pressure = e.of(monitors_of)->pressure;
  if (!pressure || !pressure->has_seen() || pressure->value() >= vapour_pressure) return {};
  return {{"cavitation", pressure->value(), vapour_pressure, "Pa",
           "the water of '" + pressure->region() + "' at " + place_text(pressure->place()) + " would come to " +
               significant(pressure->value() / 1e3) + " kPa absolute at " + significant(pressure->time()) +
               " s, below its vapour pressure of 2.3 kPa: it would boil or draw air, which is not modelled; what comes "
               "after is not to be trusted",
           "compare with fluid.bulk_modulus = 1e7 (air in the water)"}};
}

SkippedList skipped_cavitation(const Evidence& e, const Summary&) {
  const Monitors& monitors = *e.of(monitors_of);
  if (monitors.pressure && (!monitors.pressure->watches() || monitors.pressure->has_seen())) return {};
  if (!e.simulation.compiled()->caisson) return {};
  return {{"cavitation of the water", monitors.pressure ? "the contact was not marched" : monitors.why_no_pressure}};
}

/// Soils without a strength, which strength reduction leaves elastic.
std::vector<std::string> unfailing_soils(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const auto& [name, region] : simulation.scene().regions) {
    const bool is_soil =
        name != caisson_name && (region.kind == RegionKind::porous || region.kind == RegionKind::solid);
    if (is_soil && !region.strength) names.push_back(name);
  }
  return names;
}

}  // namespace

NumberedWarnings reduction_warnings(const Simulation& simulation, const std::string& key,
                                    const std::optional<double>& factor, const std::optional<double>& limit) {
  constexpr double coarse = 1.23;  // largest excess over a finer mesh or a circle that was seen
  if (!factor || !limit || *factor < *limit) return {};
  NumberedWarnings list;
  if (const std::vector<std::string> soils = unfailing_soils(simulation); !soils.empty())
    list.push_back({"strength_missing", *factor, *limit, "1",
                    key + " holds with a factor of ground in which " + join(soils) +
                        ", without a strength, cannot fail: ground that fails there may have less",
                    "give it a table strength; where it is rock, nothing is wrong"});
  if (*factor < coarse * *limit)
    list.push_back({"coarse_factor", *factor, coarse * *limit, "1",
                    key + " holds by " + percent(*factor / *limit - 1.) +
                        ", and factors by strength reduction of coarse cells were up to 23 % too large",
                    "halve the cells until the factor stays (mesh.refine = 1)"});
  return list;
}

Finding cavitation_finding() {
  Finding f;
  f.warnings = cavitation_warnings;
  f.skipped = skipped_cavitation;
  return f;
}

Finding strength_finding() {
  Finding f;
  f.keys.list("strength[]", &Summary::strength, strength_outputs(),
              "of each region with a [strength](warnings.md#strength)");
  f.skipped_of_scene = no_strength;
  f.warnings = strength_warnings;
  f.skipped = skipped_strength;
  return f.part(&Summary::strength, find_strength);
}

}  // namespace upbead

// The tables of a section, a wave of Goda's formulas, and the limits of the checks: a design and a case have the same
// keys.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "expected/dynamic_law.h"
#include "input/schema.h"
#include "upbead/base/error.h"
#include "upbead/model/scene.h"
#include "upbead/sliding/combined.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// A wave as written.
struct WaveGiven {
  std::optional<double> height;              ///< H, or from deep_water_height by random breaking (m)
  std::optional<double> significant_height;  ///< H_1/3 (m); default H/1.8
  std::optional<double> deep_water_height;   ///< H_0' (m)
  double period = 0.;                        ///< T (s)
  double angle = 0.;                         ///< degrees, already turned towards the wall's normal
  std::optional<double> direction;           ///< from which it comes, degrees from north; or angle
};

/// beta (degrees) between the wave and the wall's normal, already turned towards it.
double turned_angle(const WaveGiven& wave, const Section& section);

/// How the direction became beta, in words; "" where the angle is given.
std::string direction_text(const WaveGiven& wave, const Section& section);

/// Which force the caisson's dynamics are computed for.
enum class ImpactForce { impulse, goda_with_alpha_I, proverbs };
extern const std::vector<std::pair<std::string, ImpactForce>> impact_force_words;

/// Lengths with which no formula overflows (m).
inline Range formula_length() {
  return from_to(1e-3, 1e4);
}

/// [section].
TableSchema<CombinedModel> combined_schema();
TableSchema<DurationFactor> duration_schema();
TableSchema<Section> section_schema();

/// [limits].
TableSchema<Limits> limits_schema();

/// Declares the keys of WaveGiven.
template <class T>
void declare_wave(TableSchema<T>& table) {
  table.key("height", &T::height, "m", "height H of the wave; the highest one, H_D, for a design; or deep_water_height",
            formula_length());
  table
      .key("significant_height", &T::significant_height, "m", "significant height H_1/3; sets where h_b is taken",
           formula_length())
      .fallback("height / 1.8, or by random breaking");
  table.key("deep_water_height", &T::deep_water_height, "m",
            "equivalent deep-water height H_0'; H_1/3 and H are then those of random breaking", formula_length());
  table.key("period", &T::period, "s", "significant wave period T", from_to(0.01, 1e4)).required();
  table.key("angle", &T::angle, "deg",
            "angle beta between the wave's direction and the wall's normal; already turned by 15 deg towards it",
            from_to_below(0., 90.));
  table
      .key("direction", &T::direction, "deg",
           "in place of angle: where the wave comes from, clockwise from north, as on a chart; beta is its angle to "
           "section.facing, turned by up to 15 deg towards it (Goda 2000)",
           from_to(0., 360.))
      .fallback("by angle");
}

/// [impact.proverbs], and what of it contradicts `force`.
TableSchema<ImpactScatter> impact_scatter_schema();
Diagnostics diagnose(const ImpactAssumptions& impact, ImpactForce force);

/// The assumptions with the peak of that force.
ImpactAssumptions with_force(ImpactAssumptions impact, ImpactForce force);

/// Declares the keys of ImpactAssumptions.
template <class T>
void declare_impact(TableSchema<T>& table) {
  table
      .key("peak_gain", &T::peak_gain, "",
           "e in P_I = P_1 (1 + e alpha*), the peak of the impulsive force; an assumption: measured peaks scatter from "
           "about Goda's P to several times it, and below 1/alpha_1 this P_I is less than Goda's P, which a warning "
           "tells",
           from_to(0., 100.))
      .fallback("as much as makes P_I Goda's P with alpha*");
  table.key("rise_coefficient", &T::rise_coefficient, "",
            "c in t_r = c sqrt(d/g) rho g H^2 / P_I, its rise; an assumption", from_to(0.01, 100.));
  table.key("duration_least", &T::duration_least, "",
            "a in t_d = t_r (a + b exp(-c t_r/T)), its duration; an assumption", from_to(1.1, 1000.));
  table.key("duration_gain", &T::duration_gain, "", "b of the duration; an assumption", from_to(0., 1000.));
  table.key("duration_decay", &T::duration_decay, "", "c of the duration; an assumption", from_to(0., 1000.));
  table.table("proverbs", &T::proverbs, impact_scatter_schema())
      .doc(
          "Of force = \"proverbs\": a wave of at least H_b breaks on the wall with P_I = F* rho g H_b^2, a quantile of "
          "generalised extreme values, after Oumeraci et al. (2001), whose numbers are assumptions here.");
}

/// What is missing, or contradicts another key; without a section nothing of the direction.
Diagnostics diagnose(const WaveGiven& wave, const Section* section);

/// The design wave of a table without mistakes; where only the height in deep water is given, heights by random
/// breaking.
DesignWave design_wave(const WaveGiven& wave, const Section& section, const Water& water);

}  // namespace upbead

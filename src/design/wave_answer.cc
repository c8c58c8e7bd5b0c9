#include "wave_answer.h"

#include "upbead/sliding/combined.h"

namespace upbead {

namespace {

/// F_Smax = F_T + mu U, with F_T the P of Goda's formula with alpha_I, which already is an effective sliding force, or
/// the measured P times F_T/P.
void set_pulse(const WaveTable& table, const DesignTables& design, WaveAnswer& a) {
  const Section& s = design.section;
  a.measured = table.force.has_value();
  a.force = a.measured ? *table.force * table.shear_to_force_ratio.value_or(1.) : a.pressure.force;
  a.uplift = table.uplift.value_or(a.pressure.uplift);
  a.tau_0F = standing_duration(a.wave.height, s.water_depth, a.wave.period);
  a.k = design.duration(a.pressure.alpha_star);
  a.pulse = {a.force + s.friction * a.uplift, a.k * a.tau_0F};
  a.ratio = a.pulse.peak / a.stability.resistance;
}

void set_sliding(const DesignTables& design, double standing_force, WaveAnswer& a) {
  const Section& s = design.section;
  const double mass = s.weight / design.water.gravity, resistance = a.stability.resistance;
  a.sliding.paper = sliding_distance_paper(mass, resistance, a.pulse);
  a.sliding.paper_parts = sliding_distance_paper_parts(mass, resistance, a.pulse);
  a.sliding.exact = sliding_distance_exact(mass, resistance, a.pulse);
  const CombinedWave combined{a.wave.period, standing_force, {a.force, a.pulse.duration}, a.uplift};
  a.sliding.combined =
      sliding_distance_combined(mass + added_mass(design.water.density, s.foundation_depth, design.combined),
                                resistance, s.friction, combined, design.combined);
}

/// P as a triangle on a caisson that swings on the ground and slips on mu (W' - U), U held at its peak.
void set_elastic(const WaveTable& table, const DesignTables& design, WaveAnswer& a) {
  if (!design.ground || !table.pulse_duration) return;
  const Section& s = design.section;
  const double resistance = s.friction * (s.buoyant_weight - a.uplift);
  if (resistance <= 0.) return;  // it floats, which a warning says
  a.elastic = slide_on_base(s.weight / design.water.gravity, *design.ground,
                            history({*table.force, *table.pulse_duration}), resistance);
}

WaveAnswer answer(const std::string& name, const WaveTable& table, const DesignTables& design) {
  WaveAnswer a;
  a.name = name;
  a.wave = design_wave(table, design.section, design.water);
  const Goda goda(design.section, design.water, a.wave);
  a.wavelength = goda.wavelength();
  a.pressure = goda.at(a.wave.height);
  a.without_alpha_I = goda.at(a.wave.height, PressureFormula::goda);
  a.stability = stability(design.section, a.pressure);
  set_pulse(table, design, a);
  set_sliding(design, goda.at(a.wave.height, PressureFormula::standing).force, a);
  set_elastic(table, design, a);
  a.warnings = warnings(design.section, design.water, a.wave, a.pressure);
  return a;
}

}  // namespace

std::vector<WaveAnswer> answer_waves(const DesignTables& design) {
  std::vector<WaveAnswer> answers;
  for (const auto& [name, table] : design.waves) answers.push_back(answer(name, table, design));
  return answers;
}

}  // namespace upbead

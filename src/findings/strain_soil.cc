// Soil whose stiffness and damping have followed the strain of the response, its drag the velocity of the pore water.
#include "base/text.h"
#include "findings/topics.h"

namespace upbead {

namespace {

OutputSchema<SoilSummary> soil_outputs() {
  using S = SoilSummary;
  return OutputSchema<S>()
      .key("iterations", &S::iterations, "", "iterations")
      .key("converged", &S::converged, "", "settled: whether the last change was below 1 %")
      .key("change", &S::change, "", "of the peak of abs(F_T), or of a velocity, in the last one, relative")
      .key("peak_linear", &S::linear, "N/m",
           "largest abs(F_T) with stiffness, damping and drag at vanishing strain and velocity; without a caisson a "
           "strain or a velocity, as `peak`")
      .key("peak", &S::settled, "N/m", "largest abs(F_T), settled")
      .key("largest_strain", &S::largest_strain, "", "largest effective strain")
      .key("least_modulus_ratio", &S::least_modulus_ratio, "", "least stiffness over that at vanishing strain")
      .key("largest_damping", &S::largest_damping, "", "largest damping ratio")
      .key("largest_velocity", &S::largest_velocity, "m/s",
           "largest velocity w_c at which drag that grows with it was made linear")
      .key("least_conductivity_ratio", &S::least_conductivity_ratio, "", "least 1/(1 + b k w_c)");
}

std::optional<SoilSummary> find_soil(const Evidence& e) {
  return e.simulation.soil();
}

/// Finer cells have a larger strain at the corners of the base, and softer soil there.
NumberedWarnings estimate_warnings(const Evidence& e, const Summary& s) {
  const bool estimated = e.scene.accuracy.estimate || !e.scene.mesh.refine;
  constexpr double counts = 0.02;  // of its stiffness: less changes no estimate
  if (!s.soil || !estimated || 1. - s.soil->least_modulus_ratio <= counts) return {};
  return {
      {"estimate_of_kept_soil", 1. - s.soil->least_modulus_ratio, 0., "1",
       "errors are estimated with the stiffness that the soil has on these cells; with finer ones its strain at the "
       "corners of the base grows, so that the estimates are no bounds",
       "compare with mesh.refine = 1 and 2"}};
}

NumberedWarnings soil_warnings(const Evidence& e, const Summary& s) {
  NumberedWarnings list = estimate_warnings(e, s);
  if (!s.soil || s.soil->converged) return list;
  constexpr double settled = 0.01;
  list.push_back({"soil_not_settled", s.soil->change, settled, "1",
                  "stiffness, damping or drag still change F_T or velocities by " +
                      significant(100. * s.soil->change, 3) + " % after " + std::to_string(s.soil->iterations) +
                      " iterations",
                  "compare with soil that yields (law), or with fixed G, damping and k"});
  return list;
}

}  // namespace

Finding strain_soil_finding() {
  Finding f;
  f.keys.object("soil", &Summary::soil, soil_outputs(), "of soil that follows strain or velocity; else null");
  f.warnings = soil_warnings;
  return f.part(&Summary::soil, find_soil);
}

}  // namespace upbead

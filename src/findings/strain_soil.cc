// Soil whose stiffness and damping have followed the strain of the response.
#include "findings/topics.h"

namespace upbead {

namespace {

OutputSchema<SoilSummary> soil_outputs() {
  using S = SoilSummary;
  return OutputSchema<S>()
      .key("iterations", &S::iterations, "", "iterations")
      .key("converged", &S::converged, "", "settled: whether the last change was below 1 %")
      .key("change", &S::change, "", "of the peak of abs(F_T) in the last one, relative")
      .key("peak_linear", &S::linear, "N/m",
           "largest abs(F_T) with stiffness and damping at vanishing strain; without a caisson a strain, as `peak`")
      .key("peak", &S::settled, "N/m", "largest abs(F_T), settled")
      .key("largest_strain", &S::largest_strain, "", "largest effective strain")
      .key("least_modulus_ratio", &S::least_modulus_ratio, "", "least stiffness over that at vanishing strain")
      .key("largest_damping", &S::largest_damping, "", "largest damping ratio");
}

std::optional<SoilSummary> find_soil(const Evidence& e) {
  return e.simulation.soil();
}

}  // namespace

Finding strain_soil_finding() {
  Finding f;
  f.keys = [](OutputSchema<Summary>& s) {
    s.object("soil", &Summary::soil, soil_outputs(), "of soil that follows the strain; else null");
  };
  return f.part(&Summary::soil, find_soil);
}

}  // namespace upbead

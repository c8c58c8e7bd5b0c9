// Peak F_T of the prototype's section without its sea, built here, under a triangular force: GEO PEAK DURATION END.
#include <cstdlib>
#include <iostream>

#include "upbead/algebra/petsc_session.h"
#include "upbead/run/simulation.h"

using namespace upbead;

Region soil(double shear_modulus, double poissons_ratio, double conductivity) {
  Region region;
  region.shear_modulus = shear_modulus;
  region.poissons_ratio = poissons_ratio;
  region.porosity = 0.4;
  region.grain_density = 2650.;
  region.hydraulic_conductivity = conductivity;
  region.damping = Rayleigh{0.05, {1., 10.}};
  return region;
}

int main(int, char** argv) {
  const PetscSession petsc;
  Scene scene;
  scene.regions = {{"seabed", soil(29.382e6, 0.33, 1e-4)}, {"mound", soil(48.97e6, 0.3, 0.15)}};
  scene.regions["caisson"].kind = RegionKind::rigid;
  scene.regions["caisson"].density = 2100.;
  scene.boundaries["base"] = {DisplacementCondition::fixed, PressureCondition::sealed};
  for (const char* side : {"left", "right"})
    scene.boundaries[side] = {DisplacementCondition::roller, PressureCondition::sealed};
  for (const char* top : {"bed", "mound_surface"}) scene.boundaries[top].pressure = PressureCondition::open;
  for (const char* wall : {"front", "back", "top"}) scene.boundaries[wall] = {};
  const double peak = std::atof(argv[2]), duration = std::atof(argv[3]);
  scene.loads["impulse"].boundary = "front";
  scene.loads["impulse"].history = piecewise_linear({0., 0.5 * duration, duration}, {0., peak, 0.});
  scene.time.end = std::atof(argv[4]);
  const Simulation simulation(scene, read_mesh({argv[1], {}, {{"cells", 0.4}}, {}}));
  std::cout << simulation.run().summary.response->peak_shear << '\n';
}

#include "contact_case.h"

#include "fem/static_stage.h"
#include "system/interface.h"

namespace upbead::test {

namespace {

/// The system with its forces at rest.
System at_rest_on(const Mesh& mesh, double mu, const Compiled& compiled) {
  System system = compiled.system;
  system.interface->friction = mu;
  system.interface->normal_force = static_normal_forces(compiled.resolved, mesh, {});
  return system;
}

}  // namespace

Scene drained_section(const TimeFunction& force, double arm) {
  Scene scene = breakwater(force);
  for (const char* soil : {"seabed", "mound"}) scene.regions[soil].flow = Flow::drained;
  scene.initial = InitialState{15., {}};
  Load& load = scene.loads["impulse"];
  load.boundary.clear();
  load.region = caisson_name;
  load.at = {0., 6. + arm};
  return scene;
}

Scene wet_section(const TimeFunction& force, double arm) {
  Scene scene = drained_section(force, arm);
  for (const char* soil : {"seabed", "mound"}) scene.regions[soil].flow = Flow::automatic;
  scene.initial.reset();
  add_sea(scene);
  return scene;
}

void stiffen(Scene& scene) {
  for (const char* soil : {"seabed", "mound"}) *scene.regions[soil].shear_modulus *= 1e6;
}

double caisson_mass() {
  return 2100. * 18. * 16.;
}

double submerged_weight() {
  return 9.81 * (caisson_mass() - 1030. * 18. * 9.);
}

ContactMarch::ContactMarch(const Scene& scene, const Mesh& mesh, double mu, double end, double step, Bottom bottom)
    : compiled(scene, mesh, true), system(at_rest_on(mesh, mu, compiled)) {
  if (bottom == Bottom::whole) system = with_one_node(system);
  const std::unique_ptr<Scheme> scheme = make_contact_scheme(system);
  const int n = system.interface->n_nodes();
  const TimeGrid grid = make_time_grid(kinks(system), end, step);
  for (Eigen::MatrixXd* table : {&slip, &opening, &shear, &normal}) table->resize(n, grid.n_steps() + 1);
  MarchOptions options;
  ObserverFunction note([&](const State& state, int i, int) {
    slip.col(i) = state.x.segment(system.first_slip(), n);
    opening.col(i) = state.x.segment(system.first_opening(), n);
    shear.col(i) = scheme->contact()->forces.shear;
    normal.col(i) = scheme->contact()->forces.normal;
  });
  options.observers = {&note};
  response = march(system, *scheme, grid, options);
  report = *scheme->contact();
}

Eigen::RowVectorXd ContactMarch::mean_slip() const {
  const std::vector<double>& length = system.interface->length;
  const Eigen::Map<const Eigen::RowVectorXd> weight(length.data(), static_cast<Eigen::Index>(length.size()));
  return weight * slip / weight.sum();
}

}  // namespace upbead::test

#include "strip_scene.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <cmath>
#include <stdexcept>

#include "fem/space.h"
#include "fem/unknowns.h"
#include "tensor_mesh.h"
#include "unknowns_on.h"

namespace upbead::test {

namespace {

std::vector<double> columns(double b, const StripCells& cells) {
  constexpr double far_growth = 1.25;
  const double near = b + cells.near;
  const auto under = graded_lines(b, 0., cells.edge, cells.growth, cells.along);
  const auto beside = graded_lines(b, near, cells.edge, cells.growth, cells.along);
  const auto beyond = graded_lines(near, b + cells.width, cells.along, far_growth, cells.far);
  return joined(joined(under, beside), beyond);
}

std::unique_ptr<Mesh> strip_mesh(double b, const std::vector<Layer>& layers, const StripCells& cells) {
  const double height = 0.5 * b, width = b + cells.width;
  std::vector<double> y{0., height}, bottoms;
  for (const Layer& layer : layers) {
    const double top = bottoms.empty() ? 0. : bottoms.back(), first = bottoms.empty() ? cells.edge : cells.skin;
    bottoms.push_back(top - layer.thickness);
    y = joined(y, graded_lines(top, bottoms.back(), first, cells.growth, layer.tallest));
  }
  const auto surface = [&](const dealii::Point<dim>& p) -> std::string {
    if (p[1] > 0.) return p[0] < b ? caisson_name : "";
    std::size_t i = 0;
    while (p[1] < bottoms[i]) ++i;
    return layers[i].name;
  };
  const auto curve = [&](const dealii::Point<dim>& p) -> std::string {
    constexpr double tiny = 1e-6;
    if (p[1] > tiny) return p[0] < tiny || p[0] > b - tiny || p[1] > height - tiny ? "caisson_side" : "";
    if (p[0] < tiny) return "middle";
    if (p[0] > width - tiny) return "far";
    if (p[1] < bottoms.back() + tiny) return "rock";
    return p[1] > -tiny && p[0] > b ? "bed" : "";
  };
  return tensor_mesh(columns(b, cells), y, surface, curve);
}

Scene strip_scene(const StripCaisson& caisson, const std::vector<Layer>& layers, const Fluid& fluid, int degree) {
  Scene scene;
  scene.fluid = fluid;
  scene.mesh.degree = degree;
  bool water = false;
  for (const Layer& layer : layers) {
    scene.regions[layer.name] = layer.soil;
    water = water || layer.soil.kind == RegionKind::porous;
  }
  Region& region = scene.regions[caisson_name];
  region.kind = RegionKind::rigid;
  region.mass = 0.5 * caisson.mass;
  region.moment_of_inertia = 0.5 * caisson.moment_of_inertia;
  region.centre_of_gravity = {0., caisson.centre};
  scene.boundaries["rock"] = {DisplacementCondition::fixed, PressureCondition::sealed};
  scene.boundaries["far"] = {DisplacementCondition::absorbing, PressureCondition::sealed};
  scene.boundaries["bed"] = {DisplacementCondition::free, PressureCondition::open};
  scene.boundaries["middle"] = {DisplacementCondition::free, PressureCondition::open};
  scene.boundaries["caisson_side"] = {};
  if (!water)
    for (auto& [name, boundary] : scene.boundaries) boundary.pressure.reset();
  Load& load = scene.loads["impulse"];
  load.region = caisson_name;
  load.at = {0., caisson.attack};
  return scene;
}

/// Holds unknowns at zero by a huge mass.
void hold(System& system, const std::vector<int>& unknowns) {
  constexpr double immovable = 1e20;  // kg
  for (const int i : unknowns) system.M.coeffRef(i, i) += immovable;
  system.M.makeCompressed();
}

/// The integral of p x over the right half of the base.
Reading pressure_moment(const Compiled& compiled) {
  const Space& space = compiled.space;
  std::map<int, double> row;
  for (const auto& cell : space.dofs().active_cell_iterators())
    for (const unsigned f : cell->face_indices()) {
      if (!space.has_pressure(cell) || cell->at_boundary(f)) continue;
      if (space.mesh().surface_of(cell->neighbor(f)) != caisson_name) continue;
      dealii::FEFaceValues<dim> fe(
          space.mapping(), cell->get_fe(), dealii::QGauss<dim - 1>(4),
          dealii::update_values | dealii::update_quadrature_points | dealii::update_JxW_values);
      fe.reinit(typename dealii::Triangulation<dim>::cell_iterator(cell), f);
      std::vector<dealii::types::global_dof_index> dofs(fe.dofs_per_cell);
      cell->get_dof_indices(dofs);
      for (unsigned i = 0; i < dofs.size(); ++i)
        for (unsigned q = 0; q < fe.n_quadrature_points; ++q)
          compiled.unknowns.add_to(row, static_cast<unsigned>(dofs[i]),
                                   fe[phi_part].value(i, q) * fe.quadrature_point(q)[0] * fe.JxW(q));
    }
  return {"pressure_moment", "N m/m", "integral of p x over the base", {}, to_row(row), {}, {}};
}

Series combined(const Series& ramp, Eigen::Index half, double slope) {
  const auto combine = [&](const Eigen::MatrixXd& r) {
    Eigen::MatrixXd sum = r;
    for (const auto& [shift, weight] : {std::pair{half, -2.}, std::pair{2 * half, 1.}})
      if (const Eigen::Index n = r.cols() - shift; n > 0) sum.rightCols(n) += weight * r.leftCols(n);
    return Eigen::MatrixXd(slope * sum);
  };
  return {ramp.time, combine(ramp.reading), combine(ramp.load)};
}

}  // namespace

StripModel::StripModel(const StripCaisson& caisson, const std::vector<Layer>& layers, const Fluid& fluid,
                       const StripCells& cells)
    : caisson_(caisson),
      mesh_(strip_mesh(caisson.half_base, layers, cells)),
      compiled_(strip_scene(caisson, layers, fluid, cells.degree), *mesh_) {
  hold(compiled_.system, unknowns_on(compiled_, "middle", 1));  // u_y, also that of the caisson: its heave
  compiled_.system.readings.push_back(pressure_moment(compiled_));
}

void StripModel::march_ramp(double end, double step) {
  System& system = compiled_.system;
  system.loads.front().history = TimeFunction({0.}, {[](double) { return 0.; }, [](double t) { return 0.5 * t; }});
  SchemeOptions options;
  options.account_energy = false;
  const auto scheme = make_scheme(system, options);
  ramp_ = march(system, *scheme, make_time_grid({}, end, step));
}

Response StripModel::triangle_response(double duration) const {
  const double half = 0.5 * duration / ramp_.ends.time[1];
  const auto shift = static_cast<Eigen::Index>(std::lround(half));
  if (std::abs(half - static_cast<double>(shift)) > 1e-6) throw std::invalid_argument("a kink inside a step");
  Response response;
  response.ends = combined(ramp_.ends, shift, 2. / duration);
  response.balanced = combined(ramp_.balanced, shift, 2. / duration);
  response.order = ramp_.order;
  return response;
}

StripHistory StripModel::under_triangle(double duration) {
  compiled_.system.loads.front().history = triangle(0.5, duration);
  const Response response = triangle_response(duration);
  const auto read = [&](const char* name) { return history(compiled_, response, name); };
  StripHistory out;
  out.time = response.ends.time;
  out.shear = 2. * read("shear_force");
  out.rotation = read("caisson/rotation");
  out.sway = read("caisson/displacement_x") - caisson_.centre * out.rotation;
  // The program's moment is about the middle of the half base, as only one half is modelled.
  out.moment = 2. * (read("base_moment") + 0.5 * caisson_.half_base * read("normal_force"));
  out.pressure_moment = 2. * read("pressure_moment");
  out.peak_shear = 2. * shear_of(compiled_, response).peak_shear;
  return out;
}

}  // namespace upbead::test

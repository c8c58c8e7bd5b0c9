#include "reservoir.h"

#include <cmath>
#include <limits>

#include "fem/unknowns.h"
#include "frequency_response.h"
#include "tensor_mesh.h"
#include "without.h"

namespace upbead::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::unique_ptr<Mesh> reservoir_mesh(const ReservoirShape& shape) {
  const double size = shape.depth / shape.cells, L = shape.length, h = shape.depth;
  const auto x = joined(graded_lines(0., -L, size, 1., size), {0., size});
  return tensor_mesh(
      x, even_lines(0., h, shape.cells), [](const auto& at) { return at[0] < 0. ? "water" : "wall"; },
      [=](const auto& at) -> std::string {
        if (at[0] > 0.) return "wall";
        if (at[1] < 1e-9 * h) return "bottom";
        if (at[1] > h * (1. - 1e-9)) return "level";
        return at[0] < -L * (1. - 1e-9) ? "far" : "";
      });
}

Scene reservoir_scene(const ReservoirShape& shape, const Fluid& fluid, const std::vector<double>& heights) {
  Scene scene;
  scene.fluid = fluid;
  scene.mesh.degree = shape.degree;
  Region& water = scene.regions["water"];
  water.kind = RegionKind::water;
  water.compressibility =
      fluid.bulk_modulus < infinity ? Compressibility::compressible : Compressibility::incompressible;
  Region& wall = scene.regions["wall"];
  wall.kind = RegionKind::rigid;
  wall.mass = 1.;
  scene.boundaries["wall"] = {};
  scene.boundaries["bottom"].pressure = PressureCondition::sealed;
  scene.boundaries["level"].pressure = shape.level;
  scene.boundaries["far"].pressure = shape.far;
  for (std::size_t i = 0; i < heights.size(); ++i) scene.probes["y" + std::to_string(i)].at = {0., heights[i]};
  return scene;
}

/// A row of a matrix, without its entry on the diagonal.
Row row_of(const SparseMatrix& matrix, int i, double factor) {
  Row row;
  for (SparseMatrix::InnerIterator entry(matrix, i); entry; ++entry)
    if (entry.col() != i) row.emplace_back(static_cast<int>(entry.col()), factor * entry.value());
  return row;
}

void set_diagonal(SparseMatrix& matrix, int i, double value) {
  matrix.coeffRef(i, i) = value;
  matrix.makeCompressed();
}

}  // namespace

Reservoir::Reservoir(const ReservoirShape& shape, const Fluid& fluid, const std::vector<double>& heights)
    : mesh_(reservoir_mesh(shape)),
      compiled_(std::make_unique<Compiled>(reservoir_scene(shape, fluid, heights), *mesh_)),
      wall_centre_(0.5 * shape.depth) {}

System Reservoir::with_readings() const {
  System system = compiled_->system;
  const int x = compiled_->unknowns.coordinate(0, motion_x), turn = compiled_->unknowns.coordinate(0, motion_rotation);
  const Row force = row_of(system.C, x, -1.);  // C x' is the force of the wall on the water
  Row moment = row_of(system.C, turn, -1.);    // about the wall's middle
  for (const auto& [i, weight] : force) moment.emplace_back(i, wall_centre_ * weight);
  system.readings.push_back({"force", "N/m", "force of the water on the wall", {}, force, {}, {}});
  system.readings.push_back({"moment", "N m/m", "its moment about the wall's foot", {}, moment, {}, {}});
  return without(system, {compiled_->unknowns.coordinate(0, motion_y), turn});
}

System Reservoir::water(const TimeFunction& velocity) const {
  const System both = with_readings();
  const int x = compiled_->unknowns.coordinate(0, motion_x);  // the first of a body's coordinates keeps its index
  SystemLoad motion{"velocity", Vector::Zero(both.size()), velocity, -1};
  for (const auto& [i, weight] : row_of(both.C, x, 1.)) motion.vector[i] = weight;
  System water = both;
  water.loads = {motion};
  return without(water, {x});
}

System Reservoir::with_wall(double mass, double dashpot, double spring, const TimeFunction& force) const {
  System system = with_readings();
  const int x = compiled_->unknowns.coordinate(0, motion_x);
  set_diagonal(system.M, x, mass);
  set_diagonal(system.C, x, dashpot);
  set_diagonal(system.K, x, spring);
  system.loads = {{"force", Vector::Unit(system.size(), x), force, -1}};
  system.readings.push_back({"displacement", "m", "displacement of the wall", {{x, 1.}}, {}, {}, {}});
  system.readings.push_back({"support", "N/m", "force on spring and dashpot", {{x, spring}}, {{x, dashpot}}, {}, {}});
  return system;
}

Fluid incompressible_water(const Json& entry) {
  return {entry.at("rho"), infinity};
}

Fluid compressible_water(const Json& entry) {
  const double rho = entry.at("rho"), c = entry.at("c");
  return {rho, rho * c * c};
}

// The water's row is M phi'' + C phi' + K phi = b V with the wall's velocity V: phi over V is p = phi' over V'.
std::complex<double> per_acceleration(const System& water, double omega, const std::string& reading) {
  const ComplexVector phi = FrequencyResponse(water, omega)({1.});
  Complex sum = 0.;
  for (const auto& [i, weight] : water.readings[static_cast<std::size_t>(water.reading(reading))].velocity)
    sum += weight * phi[i];
  return sum;
}

// Mode n is cos(lambda y) (e^(-kappa s) + R e^(kappa (s - 2 L))) at the distance s from the wall; at the far end
// dp/ds = 0 (R = 1), p = 0 (R = -1) or dp/ds = -i omega p / c, which absorbs waves of normal incidence.
std::complex<double> modal_force(double depth, double length, double c, double omega, PressureCondition far) {
  const double pi = std::acos(-1.);
  Complex sum = 0.;
  for (int n = 20000; n > 0; --n) {  // the tail beyond is 1e-10 of the sum
    const double lambda = (2 * n - 1) * pi / (2. * depth);
    const Complex kappa = std::sqrt(Complex(lambda * lambda - omega * omega / (c * c), 0.)), admittance(0., omega / c);
    Complex R = 0.;
    if (length > 0.) {
      const Complex end = far == PressureCondition::sealed ? 1.
                          : far == PressureCondition::open ? -1.
                                                           : (kappa - admittance) / (kappa + admittance);
      R = end * std::exp(-2. * kappa * length);
    }
    sum += 2. / (lambda * lambda * depth * kappa) * (1. + R) / (1. - R);
  }
  return sum / (depth * depth);
}

}  // namespace upbead::test

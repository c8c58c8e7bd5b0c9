// One reduced basis for geometries that are maps of one mesh: errors of unseen widths and mound heights, and times.
//
// usage: bench_geometry CASE N_UNSEEN TOLERANCE [KEY=VALUE]...
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <random>

#include "case/case_run.h"
#include "dynamics/projection.h"
#include "dynamics/snapshot_basis.h"
#include "response/held_readings.h"
#include "response/reduction.h"
#include "response/soil_family.h"
#include "soils/soil_model.h"
#include "upbead/algebra/petsc_session.h"
#include "upbead/model/scene.h"

namespace upbead {
namespace {

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Factors of the caisson's width and of the mound's height.
struct Shape {
  double width = 1., height = 1.;
};

/// x from side to side and y from bottom to top of a region.
struct Extent {
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
};

Extent extent_of(const Mesh& mesh, const std::string& region) {
  Extent e;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    if (mesh.surface_of(cell) == region)
      for (unsigned int v = 0; v < cell->n_vertices(); ++v) {
        e.left = std::min(e.left, cell->vertex(v)[0]);
        e.right = std::max(e.right, cell->vertex(v)[0]);
        e.bottom = std::min(e.bottom, cell->vertex(v)[1]);
        e.top = std::max(e.top, cell->vertex(v)[1]);
      }
  return e;
}

/// Stretched by `factor` between two ends, moved beyond them; `held`: what stays.
double stretched(double x, double low, double high, double factor, double held) {
  const double in = std::clamp(x, low, high);
  return x + (factor - 1.) * (in - held);
}

std::shared_ptr<const Mesh> mapped(const Mesh& mesh, const Shape& shape) {
  const Extent caisson = extent_of(mesh, caisson_name), mound = extent_of(mesh, "mound");
  auto out = std::make_shared<Mesh>();
  out->triangulation.copy_triangulation(mesh.triangulation);
  out->surfaces = mesh.surfaces;
  out->curves = mesh.curves;
  dealii::GridTools::transform(
      [&](const dealii::Point<dim>& p) {
        const double middle = 0.5 * (caisson.left + caisson.right);
        return dealii::Point<dim>(stretched(p[0], caisson.left, caisson.right, shape.width, middle),
                                  stretched(p[1], mound.bottom, mound.top, shape.height, mound.bottom));
      },
      out->triangulation);
  return out;
}

/// As a family of soils takes them.
SnapshotOptions snapshot_options(const Scene& scene, const CompiledScene& compiled) {
  SnapshotOptions options;
  options.shift = krylov_shift(scene);
  options.exact = compiled.body_coordinates;
  options.vectors = 40;
  const SampledLoads loads = sampled_loads(scene, compiled.system);
  options.frequencies = snapshot_frequencies(loads.time.back(), 1.3 * bandwidth(scene), 64);
  options.weights = snapshot_weights(loads, options.frequencies);
  const Eigen::RowVectorXd any = options.weights.colwise().maxCoeff();
  options.n_readings = n_readings_as_loads;
  options.weights.conservativeResize(options.weights.rows() + n_readings_as_loads, Eigen::NoChange);
  options.weights.bottomRows(n_readings_as_loads).rowwise() = any;
  return options;
}

Eigen::MatrixXd held_of(Scene scene, double tolerance, const CompiledScene& compiled, int first_vectors) {
  scene.tolerance = tolerance;
  ReductionTargets targets;
  targets.tolerance_of_others = 1e-4;
  targets.first_vectors = first_vectors;
  targets.most_vectors = most_of_member;
  const Reduction reduction = reduce_scene(scene, compiled, targets);
  const HeldReadings held = held_readings(reduction.model.reading_label, compiled.caisson->bottom_width);
  return held.sums * respond(reduction.model, sampled_loads(scene, compiled.system)).reading;
}

/// A geometry in the basis.
SoilFamily in_basis(const Simulation& s, const SnapshotBasis& basis, const Eigen::MatrixXd& sorting, double shift) {
  const System& system = s.compiled()->system;
  const Projection projection(system, basis.displacements(), basis.phi(), shift);
  SoilFamily family{{rotated(projection.reduced(), sorting), {}, basis.n_kept()}, {}, *s.compiled(), {}};
  family.like.system = without_matrices(system);
  return family;
}

void tell_errors(const Simulation& s, const SoilFamily& family, const Eigen::MatrixXd& exact, double tolerance) {
  const CompiledScene small = family.at({});
  const Eigen::MatrixXd near = held_of(s.scene(), 0.2 * tolerance, small, first_of_member);
  Scene member = s.scene();
  member.tolerance = 0.2 * tolerance;
  std::cout
      << "  errors of F_T, x_G, heel, toe: "
      << (near - exact).cwiseAbs().rowwise().maxCoeff().cwiseQuotient(exact.cwiseAbs().rowwise().maxCoeff()).transpose()
      << ", peak of F_T " << near.row(0).maxCoeff() / exact.row(0).maxCoeff() - 1. << ", estimate "
      << family_error(family, member, {}) << std::endl;
}

int main(int argc, char** argv) {
  const PetscSession petsc;
  const Case input = read_case(argv[1], {argv + 4, argv + argc});
  const int n_unseen = std::stoi(argv[2]);
  const double tolerance = std::stod(argv[3]);
  const Simulation nominal = simulation_with_all_cells(input, nullptr);
  const auto with = [&](const Shape& shape) {
    return simulation_with_all_cells(input, mapped(*nominal.mesh(), shape));
  };
  const SnapshotOptions options = snapshot_options(nominal.scene(), *nominal.compiled());
  SnapshotBasis basis(nominal.compiled()->system, options.shift, options.exact);
  constexpr double w = 1.25, h = 1.5;
  const std::vector<Shape> points{{1., 1.}, {w, h}, {1. / w, 1. / h}, {w, 1. / h}, {1. / w, h}};
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> unit(-1., 1.);
  std::vector<Shape> unseen;
  for (int i = 0; i < n_unseen; ++i) {
    const double of_width = std::pow(w, unit(rng));
    unseen.push_back({of_width, std::pow(h, unit(rng))});
  }
  std::vector<Eigen::MatrixXd> exact;
  for (std::size_t p = 0; p < points.size(); ++p) {
    double begin = processor_seconds();
    basis.add(snapshots(with_readings_as_loads(with(points[p]).compiled()->system), options), 3e-6);
    std::cout << p + 1 << " points, " << basis.n_coordinates() << " coordinates, point took "
              << processor_seconds() - begin << " s\n";
    if (p != 2 && p != 4) continue;
    const Eigen::MatrixXd sorting = basis.sorting();
    for (std::size_t i = 0; i < unseen.size(); ++i) {
      begin = processor_seconds();
      const Simulation s = with(unseen[i]);
      const double assembled = processor_seconds();
      if (exact.size() <= i) exact.push_back(held_of(s.scene(), 1e-4, *s.compiled(), 24));
      const double solved = processor_seconds();
      const SoilFamily family = in_basis(s, basis, sorting, options.shift);
      const double projected = processor_seconds();
      std::cout << " width x " << unseen[i].width << ", mound x " << unseen[i].height << ": assembled "
                << assembled - begin << " s, by itself " << solved - assembled << " s, projected " << projected - solved
                << " s\n";
      tell_errors(s, family, exact[i], tolerance);
    }
  }
  return 0;
}

}  // namespace
}  // namespace upbead

int main(int argc, char** argv) {
  return argc < 4 ? 1 : upbead::main(argc, argv);
}

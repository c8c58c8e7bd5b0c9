#include "footing.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

#include "base/stopwatch.h"
#include "fem/unknowns.h"
#include "footing_mesh.h"
#include "mesh/refine.h"
#include "scenes.h"
#include "uneven_flow.h"
#include "unknowns_on.h"

namespace upbead::test {

namespace {

constexpr int degree = 3;
constexpr double share = 0.6;  ///< of the sum of uneven flow that lies in the cells to be split

Scene ground_scene(const Footing& f) {
  Scene scene;
  scene.mesh.degree = degree;
  Region& soil = scene.regions["soil"];
  soil.kind = RegionKind::solid;
  soil.deformation = Deformation::elastic;
  soil.density = 1e-3;
  soil.shear_modulus = f.shear_modulus;
  soil.poissons_ratio = f.poissons_ratio;
  scene.boundaries["base"].displacement = DisplacementCondition::fixed;
  scene.boundaries["far"].displacement = DisplacementCondition::roller;
  scene.boundaries["middle"].displacement = DisplacementCondition::roller;
  scene.boundaries["foot"] = scene.boundaries["bed"] = {};
  return scene;
}

/// Stresses at rest, equal in all directions.
PointStresses before(const Footing& f, const Space& space) {
  PointStresses found;
  const dealii::QGauss<dim> points(degree + 1);
  for (const auto& cell : space.dofs().active_cell_iterators()) {
    found.emplace_back();
    for (const auto& point : points.get_points()) {
      const double y = space.mapping().transform_unit_to_real_cell(cell, point)[1];
      const double s = -f.surcharge + f.unit_weight * y;
      found.back().push_back({s, s, 0., s});
    }
  }
  return found;
}

StaticPath path_of(const Footing& f, const Vector& weights, const std::vector<int>& down,
                   const std::vector<int>& along) {
  StaticPath path;
  path.held = down;
  path.held.insert(path.held.end(), along.begin(), along.end());
  path.load = [=](double) { return weights; };
  path.place = [=](double t) {
    std::vector<double> place(down.size(), -f.settlement * t);
    place.resize(down.size() + along.size(), f.sideways * f.settlement * t);
    return place;
  };
  return path;
}

FootingAnswer push_on(const Footing& f, const Mesh& mesh) {
  const Stopwatch watch;
  const Compiled compiled(ground_scene(f), mesh);
  const Space& space = compiled.space;
  StaticSoil soil(space, compiled.unknowns);
  const auto law = std::make_shared<const MohrCoulombLaw>(elastic_law(f.shear_modulus, f.poissons_ratio), f.soil);
  soil.follow(StaticLaws(mesh.triangulation.n_active_cells(), law));
  soil.keep_stiffness(1e-8);
  soil.start_from(before(f, space));
  Vector x = Vector::Zero(compiled.unknowns.size()), weights;
  soil.exert(x, weights);

  const std::vector<int> down = unknowns_on(compiled, "foot", 1), along = unknowns_on(compiled, "foot", 0);
  StaticSteps steps;
  steps.first = 0.15;
  steps.largest = 0.3;
  steps.tolerance = 1e-5;
  steps.associated = true;
  FootingAnswer answer;
  answer.unknowns = compiled.unknowns.size();
  answer.report =
      march_static(soil, path_of(f, weights, down, along), steps, x, [&](double t, const Vector&, const Vector& force) {
        const double sides = f.sideways != 0. ? 2. : 1.;
        // forces of the nodes beyond those by the ground's weight and by the surcharge beside the edge, which act
        // from the start
        double V = sides * half_width * f.surcharge, H = 0.;
        for (const int i : down) V -= force[i] - weights[i];
        for (const int i : along) H += force[i];
        answer.settlement.push_back(f.settlement * t);
        answer.load.push_back(V / (sides * half_width));
        answer.shear.push_back(H / (sides * half_width));
        return true;
      });
  answer.uneven = uneven_flow(compiled, answer.report.moved, soil.stresses());
  answer.seconds = watch.seconds();
  return answer;
}

}  // namespace

Footing on_clay() {
  Footing f;
  f.soil = {0., 1., 0., 1e12};
  f.shear_modulus = 1e3;
  f.width = 2.5;
  f.depth = 1.25;
  return f;
}

std::vector<FootingAnswer> push(const Footing& f, int times) {
  std::unique_ptr<Mesh> mesh = ground_mesh(f);
  std::vector<FootingAnswer> answers{push_on(f, *mesh)};
  while (times-- > 0 && answers.back().report.complete) {
    mesh = refined(*mesh, most_uneven(answers.back().uneven, share));
    answers.push_back(push_on(f, *mesh));
  }
  return answers;
}

}  // namespace upbead::test

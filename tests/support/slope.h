// A slope of ground whose strength follows Mohr and Coulomb.
#pragma once

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "tensor_mesh.h"
#include "upbead/model/scene.h"

namespace upbead::test {

constexpr double slope_weight = 20e3;  // N/m3

/// A slope from the crest at x = 0 to the toe at x = run, on ground down to y = -below; `uneven`: by which part of
/// their size nodes are moved at random.
struct Slope {
  static constexpr double height = 10., H = height;  // m
  double run = 2. * H, below = 0.5 * H, size = 1.25, uneven = 0.;
  unsigned seed = 1;
  double behind = 1.2 * H, before = 1.2 * H;
  double top(double x) const { return run > 0. ? H * (1. - std::clamp(x / run, 0., 1.)) : H; }

  std::unique_ptr<Mesh> mesh() const {
    const auto lines = [this](double from, double to, double scale = 1.) {
      return even_lines(from, to, static_cast<int>(std::lround((to - from) / size * scale)));
    };
    const auto beside = joined(lines(-behind, 0.), lines(run, run + before));
    auto mesh = tensor_mesh(
        run > 0. ? joined(beside, lines(0., run)) : beside, lines(0., 1., H + below),
        [](const dealii::Point<dim>&) { return "soil"; },
        [this](const dealii::Point<dim>& p) -> std::string {
          if (p[0] < 1e-9 - behind || p[0] > run + before - 1e-9) return "sides";
          return p[1] < 1e-9 ? "base" : p[1] > 1. - 1e-9 ? "surface" : "";
        });
    if (uneven > 0.) dealii::GridTools::distort_random(uneven, mesh->triangulation, true, seed);
    dealii::GridTools::transform(
        [this](const dealii::Point<dim>& p) { return dealii::Point<dim>(p[0], -below + p[1] * (top(p[0]) + below)); },
        mesh->triangulation);
    return mesh;
  }
};

inline Scene slope_scene(const Strength& strength, double unit_weight = slope_weight) {
  Scene scene;
  scene.gravity = 10.;
  Region& soil = scene.regions["soil"];
  soil.kind = RegionKind::solid;
  soil.deformation = Deformation::elastic;
  soil.density = unit_weight / scene.gravity;
  soil.shear_modulus = 4e7;
  soil.poissons_ratio = 0.3;
  soil.strength = strength;
  soil.law = SoilLaw::mohr_coulomb;
  scene.boundaries["base"].displacement = DisplacementCondition::fixed;
  scene.boundaries["sides"].displacement = DisplacementCondition::roller;
  scene.boundaries["surface"] = {};
  scene.initial.emplace().water_level = -1e3;
  return scene;
}

}  // namespace upbead::test

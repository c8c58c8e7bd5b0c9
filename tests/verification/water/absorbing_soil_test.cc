// Claims: an absorbing side of soil absorbs a plane wave of normal incidence: exactly in an elastic solid; nearly in
// undrained sand, and in rubble with little drag, where both pressure waves are absorbed. The reflection is the
// difference, in the middle of a column of soil, from a column so long that no reflection arrives from its end.
// Source: Lysmer and Kuhlemeyer (1969); docs/theory.md.
// Limits: 1e-3 of the largest incident value in the solid, 1e-2 in soils.

#include <gtest/gtest.h>

#include <cmath>

#include "column_case.h"
#include "fem/unknowns.h"
#include "without.h"

namespace upbead::test {
namespace absorbing_soil_test {

enum class Wave { pressure, shear };

/// A column under a smooth pulse at its top that absorbs at its base.
struct Hit {
  Region soil;
  Wave wave = Wave::pressure;
  bool pores_absorb = false;  ///< at the base
  bool on_water = false;      ///< a pressure of water at an open top, instead of a traction at a sealed one
};

constexpr double duration = 0.05;  // of the pulse (s)

/// A smooth pulse sin^4, over after `duration`.
TimeFunction smooth_pulse() {
  const double omega = std::acos(-1.) / duration;
  return {{0., duration},
          {[](double) { return 0.; }, [=](double t) { return 1e3 * std::pow(std::sin(omega * t), 4); },
           [](double) { return 0.; }}};
}

/// Approximate lower and upper bounds of the speeds of all waves of that kind (m/s).
std::pair<double, double> speeds(const Hit& hit, const Fluid& water) {
  const Material m = material(hit.soil, water, 9.81);
  if (hit.wave == Wave::shear) return {std::sqrt(m.G / m.rho), std::sqrt(2. * m.G / m.rho)};
  const double E = m.lambda + 2. * m.G, stiff = E + (m.storage > 0. ? m.alpha * m.alpha / m.storage : 0.);
  if (hit.soil.flow != Flow::inertial) return {std::sqrt(stiff / m.rho), std::sqrt(stiff / m.rho)};
  return {std::sqrt(E / m.rho), 1.3 * std::sqrt(stiff / m.rho)};
}

Scene scene_of(const Hit& hit, double height) {
  Scene scene = column(hit.soil, smooth_pulse());
  Load& load = scene.loads["top"];
  if (hit.wave == Wave::shear) load.direction = {1., 0.};
  if (hit.on_water) load.kind = LoadKind::pressure;
  if (hit.wave == Wave::shear) scene.boundaries["left"].displacement = DisplacementCondition::free;
  if (hit.wave == Wave::shear) scene.boundaries["right"].displacement = DisplacementCondition::free;
  if (!hit.on_water) scene.boundaries["top"].pressure = PressureCondition::sealed;
  scene.boundaries["base"] = {DisplacementCondition::absorbing,
                              hit.pores_absorb ? PressureCondition::absorbing : PressureCondition::sealed};
  scene.probes["middle"].at = {0.5, height};
  return scene;
}

/// Between free sides a shear wave is plane if there is no motion along the column and no pressure, as if water could
/// leave through the column's sides.
System in_plane_shear(const Compiled& compiled) {
  std::vector<int> gone = unknowns_of(compiled, 1);
  if (compiled.space.has_pores(compiled.space.dofs().begin_active()))
    for (const int i : unknowns_of(compiled, phi_component)) gone.push_back(i);
  return without(compiled.system, gone);
}

/// A reading and its values at the ends of the steps.
using History = std::pair<std::string, Eigen::RowVectorXd>;

/// Histories half of `height` under the top of a column `total` high, in cells of one size. They are read in the
/// middle of a cell, as W is discontinuous between cells.
std::vector<History> histories(const Hit& hit, double height, double total, double end) {
  const int cells = static_cast<int>(std::lround(40. * total / height));
  const auto lines = even_lines(0., total, cells);
  const auto mesh = tensor_mesh(
      {0., 1.}, lines, [](const auto&) { return "soil"; },
      [total](const auto& at) -> std::string {
        if (at[1] < 1e-9) return "base";
        if (at[1] > total - 1e-9) return "top";
        return at[0] < 1e-9 ? "left" : at[0] > 1. - 1e-9 ? "right" : "";
      });
  const Compiled compiled(scene_of(hit, total - 20.5 * total / cells), *mesh);
  const bool shear = hit.wave == Wave::shear;
  const System system = shear ? in_plane_shear(compiled) : compiled.system;
  SchemeOptions options;
  options.account_energy = false;
  const auto scheme = make_scheme(system, options);
  const Response response = march(system, *scheme, make_time_grid({0., duration}, end, duration / 50.));
  std::vector<History> found;
  const auto add = [&](const std::string& reading) {
    found.emplace_back(reading, response.ends.reading.row(system.reading("probes/middle/" + reading)));
  };
  add(shear ? "velocity_x" : "velocity_y");
  if (!shear && hit.soil.kind == RegionKind::porous) add("pressure");
  if (hit.soil.flow == Flow::inertial) add(shear ? "darcy_velocity_x" : "darcy_velocity_y");
  return found;
}

struct Echo {
  std::string reading;
  double size = 0.;  ///< over the largest incident value
};

std::vector<Echo> echoes(const Hit& hit) {
  const auto [slow, fast] = speeds(hit, Fluid());
  const double height = 1.5 * slow * duration, end = 2. * height / slow + 2. * duration;
  const double cell = height / 40., total = cell * std::ceil(std::max(3. * height, 0.55 * fast * end + height) / cell);
  const std::vector<History> with = histories(hit, height, height, end),
                             without_end = histories(hit, height, total, end);
  std::vector<Echo> found;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const Eigen::RowVectorXd& exact = without_end[i].second;
    found.push_back({with[i].first, (with[i].second - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff()});
  }
  return found;
}

std::string name_of(Wave wave) {
  return wave == Wave::shear ? "shear wave" : "pressure wave";
}

Region undamped(Region soil, Flow flow, double conductivity) {
  soil.damping.reset();
  soil.flow = flow;
  soil.hydraulic_conductivity = conductivity;
  return soil;
}

TEST(AbsorbingSide, LetsPlaneWavesOfASolidOut) {
  Record record("absorbing_soil");
  Region solid;
  solid.kind = RegionKind::solid;
  solid.deformation = Deformation::elastic;
  solid.shear_modulus = 32e6;
  solid.poissons_ratio = 0.33;
  solid.density = 2000.;
  for (const Wave wave : {Wave::pressure, Wave::shear})
    for (const Echo& echo : echoes({solid, wave}))
      record.at_most("elastic solid, " + name_of(wave) + ": echo in " + echo.reading, echo.size, 1e-3);
}

TEST(AbsorbingSide, LetsPlaneWavesOfUndrainedSandOut) {
  Record record("absorbing_soil");
  for (const Wave wave : {Wave::pressure, Wave::shear})
    for (const Echo& echo : echoes({undamped(sand(), Flow::darcy, 1e-6), wave}))
      record.at_most("sand of k = 1e-6 m/s, " + name_of(wave) + ": echo in " + echo.reading, echo.size, 1e-2);
}

TEST(AbsorbingSide, LetsAllWavesOfDragFreeRubbleOut) {
  Record record("absorbing_soil");
  for (const double k : {1e3, 0.1})
    for (const auto& [wave, on_water] :
         {std::pair{Wave::pressure, false}, {Wave::pressure, true}, {Wave::shear, false}})
      for (const Echo& echo : echoes({undamped(rubble(), Flow::inertial, k), wave, true, on_water})) {
        const std::string what = "rubble of k = " + Json(k).dump() + " m/s, " + name_of(wave) +
                                 (on_water ? "s by water on the open top" : "") + ": echo in " + echo.reading;
        if (k > 1.)
          record.at_most(what, echo.size, 1e-2);
        else
          record.measured(what, echo.size);
      }
}

}  // namespace absorbing_soil_test
}  // namespace upbead::test

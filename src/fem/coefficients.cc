#include "fem/coefficients.h"

namespace upbead {

namespace {

using C = Coefficient;

/// The member of constants that a coefficient is; of a product its factor that is not Rayleigh's.
double& member(RegionConstants& constants, Coefficient coefficient) {
  Material& m = constants.material;
  switch (coefficient) {
    case C::G:
    case C::stiffness_damping_G:
      return m.G;
    case C::lambda:
    case C::stiffness_damping_lambda:
      return m.lambda;
    case C::rho:
    case C::mass_damping_rho:
      return m.rho;
    case C::a:
      return m.a;
    case C::b:
      return m.b;
    case C::mobility:
      return m.mobility;
    case C::alpha:
      return m.alpha;
    case C::storage:
      return m.storage;
    case C::sealed_normal:
      return constants.sealed.normal;
    case C::sealed_tangential:
      return constants.sealed.tangential;
    case C::open_normal:
      return constants.open.normal;
    case C::open_tangential:
      return constants.open.tangential;
    case C::open_coupling:
      return constants.open.coupling;
    case C::open_mobility:
      break;
  }
  return constants.open.mobility;
}

double& rayleigh_factor(Material& material, Coefficient coefficient) {
  return coefficient == C::mass_damping_rho ? material.mass_damping : material.stiffness_damping;
}

double& at(Coefficients& values, Coefficient coefficient) {
  return values[static_cast<std::size_t>(coefficient)];
}

}  // namespace

Coefficients coefficients(const Material& m, CellKind kind) {
  Coefficients values{};
  const bool water = kind == CellKind::water, pores = kind == CellKind::darcy || kind == CellKind::inertial;
  if (!water) {
    at(values, C::G) = m.G;
    at(values, C::lambda) = m.lambda;
    at(values, C::rho) = m.rho;
    at(values, C::mass_damping_rho) = m.mass_damping * m.rho;
    at(values, C::stiffness_damping_G) = m.stiffness_damping * m.G;
    at(values, C::stiffness_damping_lambda) = m.stiffness_damping * m.lambda;
  }
  if (kind == CellKind::inertial) {
    at(values, C::a) = m.a;
    at(values, C::b) = m.b;
  }
  if (pores) {
    at(values, C::mobility) = m.mobility;
    at(values, C::alpha) = m.alpha;
  }
  if (pores || water) at(values, C::storage) = m.storage;
  const Impedance sealed = impedance(m, kind, false), open = impedance(m, kind, true);
  at(values, C::sealed_normal) = sealed.normal;
  at(values, C::sealed_tangential) = sealed.tangential;
  at(values, C::open_normal) = open.normal;
  at(values, C::open_tangential) = open.tangential;
  at(values, C::open_coupling) = open.coupling;
  at(values, C::open_mobility) = open.mobility;
  return values;
}

Coefficients coefficients(const Region& region, const Fluid& fluid, double gravity) {
  if (region.kind == RegionKind::rigid) return {};
  return coefficients(material(region, fluid, gravity), kind_of(region));
}

std::map<std::string, Coefficients> coefficients(const std::map<std::string, Region>& regions, const Fluid& fluid,
                                                 double gravity) {
  std::map<std::string, Coefficients> all;
  for (const auto& [name, region] : regions) all[name] = coefficients(region, fluid, gravity);
  return all;
}

bool is_of_damping(Coefficient c) {
  return c == C::mass_damping_rho || c == C::stiffness_damping_G || c == C::stiffness_damping_lambda;
}

RegionConstants unit_constants(Coefficient coefficient) {
  RegionConstants constants;
  member(constants, coefficient) = 1.;
  if (is_of_damping(coefficient)) rayleigh_factor(constants.material, coefficient) = 1.;
  return constants;
}

RegionConstants without(RegionConstants constants, const std::array<bool, n_coefficients>& left_out) {
  for (int i = 0; i < n_coefficients; ++i) {
    if (!left_out[static_cast<std::size_t>(i)]) continue;
    const auto coefficient = static_cast<Coefficient>(i);
    if (is_of_damping(coefficient))
      rayleigh_factor(constants.material, coefficient) = 0.;
    else
      member(constants, coefficient) = 0.;
  }
  return constants;
}

}  // namespace upbead

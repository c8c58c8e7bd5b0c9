#include "mms.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace upbead::test {

namespace {

const std::string lower_layer = "lower layer", upper_layer = "upper layer";

/// A region with the given constants of the equations. The porosity is arbitrary, as rho_s, K_s and the tortuosity
/// are chosen to match; `fluid` must have K_f.
Region region_of(const Json& constants, const Fluid& fluid, double gravity, Flow flow) {
  const double n = 0.4, rho_f = constants.at("rho_f"), alpha = constants.at("alpha"), iM = constants.at("iM");
  const double lambda = constants.at("lam"), G = constants.at("mu");
  Region region;
  region.kind = RegionKind::porous;
  region.flow = flow;
  region.shear_modulus = G;
  region.poissons_ratio = 0.5 * lambda / (lambda + G);
  region.porosity = n;
  region.grain_density = (constants.at("rho").get<double>() - n * rho_f) / (1. - n);
  region.hydraulic_conductivity = constants.at("kappa").get<double>() * rho_f * gravity;
  region.biot = alpha;
  const double in_grains = iM - n / fluid.bulk_modulus;
  if (in_grains > 1e-12 * iM) region.grain_bulk_modulus = (alpha - n) / in_grains;
  if (flow == Flow::inertial) region.tortuosity = constants.at("m").get<double>() * n / rho_f;
  const double aM = constants.at("aM"), bK = constants.at("bK");
  if (aM > 0. && bK > 0.) {  // of all pairs of frequencies with w1 w2 = aM/bK, the one with w2 = 2 w1
    const double w1 = std::sqrt(0.5 * aM / bK), to_Hz = 0.5 / std::acos(-1.);
    region.damping = Rayleigh{1.5 * w1 * bK, {w1 * to_Hz, 2. * w1 * to_Hz}};
  }
  return region;
}

/// The pore water for which the layer of least storage stores in its water alone.
Fluid fluid_of(const std::vector<Json>& layers) {
  double least = std::numeric_limits<double>::infinity();
  for (const Json& constants : layers) least = std::min(least, constants.at("iM").get<double>());
  return {layers.front().at("rho_f"), 0.4 / least};
}

/// 1, t, t^2 for the patch; else the span of the functions T1, T2, T3 of the reference and their derivatives.
std::vector<std::function<double(double)>> time_functions(const std::string& kind, double w, double z) {
  if (kind == "patch")
    return {[](double) { return 1.; }, [w](double t) { return w * t; }, [w](double t) { return w * w * t * t; }};
  return {[](double) { return 1.; },
          [w, z](double t) { return std::exp(-z * t) * std::cos(w * t); },
          [w, z](double t) { return std::exp(-z * t) * std::sin(w * t); },
          [w](double t) { return std::cos(1.3 * w * t); },
          [w](double t) { return std::sin(1.3 * w * t); },
          [w](double t) { return std::cos(0.7 * w * t); },
          [w](double t) { return std::sin(0.7 * w * t); }};
}

const Json& entry_of(const Json& file, const std::string& kind) {
  for (const Json& entry : file.at("mms"))
    if (entry.at("kind") == kind) return entry;
  throw std::runtime_error("no manufactured solution " + kind);
}

}  // namespace

const std::string& Manufactured::surface_at(const dealii::Point<dim>& at) const {
  return at[1] < interface ? lower_layer : upper_layer;
}

Manufactured manufactured(const std::string& file, const std::string& kind, std::size_t set, int degree) {
  const Json all = reference(file);
  Manufactured mms;
  mms.kind = kind;
  mms.entry = entry_of(all, kind);
  const Json& chosen = mms.entry.at("sets").at(set);
  const std::string domain = chosen.at("domain");
  if (std::sscanf(domain.c_str(), "[%lf,%lf]x[%lf,%lf]", &mms.lower[0], &mms.upper[0], &mms.lower[1], &mms.upper[1]) !=
      4)
    throw std::runtime_error("not a rectangle: " + domain);
  mms.end = chosen.at("t_end");

  const Json& parameters = chosen.at("parameters");
  const std::vector<Json> constants =
      parameters.is_array() ? parameters.get<std::vector<Json>>() : std::vector<Json>{parameters};
  mms.interface = constants.size() > 1 ? 0. : mms.lower[1];
  mms.scene.mesh.degree = degree;
  mms.scene.fluid = fluid_of(constants);
  mms.scene.boundaries["side"] = {DisplacementCondition::free, PressureCondition::sealed};
  const Flow flow = kind == "inertial" ? Flow::inertial : Flow::darcy;
  for (std::size_t i = 0; i < constants.size(); ++i) {
    const std::string& surface = i + 1 < constants.size() ? lower_layer : upper_layer;
    mms.scene.regions[surface] = region_of(constants[i], mms.scene.fluid, mms.scene.gravity, flow);
    mms.layers[surface] = std::make_shared<ClosedForms>(mms.entry.at("expressions"), constants[i]);
  }
  mms.time_functions = time_functions(kind, constants.front().at("w"), constants.front().at("z"));
  return mms;
}

}  // namespace upbead::test

#include "reference.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace upbead::test {

namespace {

double gravity(const Json& m) {
  return m.value("g", 9.81);
}

/// Sets the skeleton's stiffness from the pair of constants that the table has.
void set_stiffness(const Json& m, Region& region) {
  if (m.contains("Ey")) {
    region.youngs_modulus = m.at("Ey").get<double>();
    region.poissons_ratio = m.at("nu").get<double>();
    return;
  }
  const double G = m.at("mu");
  const double lambda = m.contains("lam") ? m.at("lam").get<double>() : m.at("K").get<double>() - 2. / 3. * G;
  region.shear_modulus = G;
  region.poissons_ratio = 0.5 * lambda / (lambda + G);
}

}  // namespace

Json reference(const std::string& name) {
  std::ifstream file(std::string(UPBEAD_REFERENCE_DIR) + "/" + name + ".json");
  if (!file) throw std::runtime_error("no reference " + name);
  return Json::parse(file);
}

Region soil(const Json& m, Flow flow) {
  Region region;
  region.kind = RegionKind::porous;
  set_stiffness(m, region);
  const double n = m.at("n"), rho_f = m.at("rho_f");
  region.porosity = n;
  region.grain_density =
      m.contains("rho_s") ? m.at("rho_s").get<double>() : (m.at("rho").get<double>() - n * rho_f) / (1. - n);
  region.hydraulic_conductivity =
      m.contains("k") ? m.at("k").get<double>() : m.at("kappa").get<double>() * rho_f * gravity(m);
  region.tortuosity = m.value("a_inf", 1.);
  if (m.contains("Ks") && m.at("Ks").get<double>() < 1e20) {
    region.grain_bulk_modulus = m.at("Ks");
    if (m.contains("K")) region.biot = 1. - m.at("K").get<double>() / m.at("Ks").get<double>();
  }
  if (m.contains("alpha")) region.biot = m.at("alpha");
  region.flow = flow;
  return region;
}

Fluid fluid(const Json& m) {
  return {m.at("rho_f"), m.value("Kf", std::numeric_limits<double>::infinity())};
}

std::vector<double> sampled(const std::vector<double>& times, const Eigen::RowVectorXd& values,
                            const std::vector<double>& at) {
  std::vector<double> out;
  for (const double t : at) {
    auto k = std::upper_bound(times.begin(), times.end(), t) - times.begin();
    k = std::clamp<std::ptrdiff_t>(k, 1, static_cast<std::ptrdiff_t>(times.size()) - 1);
    const double t0 = times[static_cast<std::size_t>(k - 1)], t1 = times[static_cast<std::size_t>(k)];
    if (t > t1 * (1. + 1e-9)) throw std::out_of_range("a time past the history's end");
    const double weight = (t - t0) / (t1 - t0);
    out.push_back((1. - weight) * values[k - 1] + weight * values[k]);
  }
  return out;
}

double largest_error(const std::vector<double>& computed, const std::vector<double>& exact, double scale) {
  double worst = 0., largest = 0.;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double difference = std::abs(computed[i] - exact[i]);
    worst = std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::max(worst, difference);
    largest = std::max(largest, std::abs(exact[i]));
  }
  return worst / (scale > 0. ? scale : largest);
}

}  // namespace upbead::test

#include "shear_column.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace upbead::test {

Sliders sliders(double G, const std::vector<double>& gamma, const std::vector<double>& tau) {
  Sliders found;
  double slope = G;
  for (std::size_t i = 0; i < gamma.size(); ++i) {
    const double next = i + 1 < gamma.size() ? (tau[i + 1] - tau[i]) / (gamma[i + 1] - gamma[i]) : 0.;
    found.push_back({slope - next, (slope - next) * gamma[i]});
    slope = next;
  }
  return found;
}

Sliders sliders(const ShearSoil& soil, int n) {
  std::vector<double> gamma, tau;
  for (int i = 0; i < n; ++i) {
    const double x = 0.01 * std::pow(3000., double(i) / (n - 1));
    gamma.push_back(x * soil.gamma_r);
    tau.push_back(soil.G * gamma.back() / (1. + x));
  }
  // the first line has slope G and ends on the line through the first two points
  const double second = (tau[1] - tau[0]) / (gamma[1] - gamma[0]);
  gamma[0] = (tau[0] - second * gamma[0]) / (soil.G - second);
  tau[0] = soil.G * gamma[0];
  return sliders(soil.G, gamma, tau);
}

namespace {

/// Elements of a column, with the slip of each slider.
class Springs {
 public:
  Springs(Sliders sliders, int n_elements)
      : sliders_(std::move(sliders)), slid_(static_cast<std::size_t>(n_elements) * sliders_.size(), 0.) {}

  double stress(int element, double gamma) {
    double* slid = &slid_[static_cast<std::size_t>(element) * sliders_.size()];
    double sum = 0.;
    for (std::size_t k = 0; k < sliders_.size(); ++k) {
      const double h = sliders_[k][0], most = sliders_[k][1], trial = h * (gamma - slid[k]);
      const double held = std::clamp(trial, -most, most);
      slid[k] += (trial - held) / h;
      sum += held;
    }
    return sum;
  }

 private:
  Sliders sliders_;
  std::vector<double> slid_;
};

}  // namespace

ShearHistory shake(const ShearSoil& soil, const std::function<double(double)>& tau, double end, double at,
                   int n_elements, const Sliders& sliders, int n_kept) {
  const double size = soil.height / n_elements, speed = std::sqrt(soil.G / soil.density);
  const int between = static_cast<int>(std::ceil(end * speed / (0.3 * size) / n_kept)), n = n_kept * between;
  const double h = end / n;
  const auto n_nodes = static_cast<std::size_t>(n_elements) + 1;
  std::vector<double> u(n_nodes, 0.), v(n_nodes, 0.), force(n_nodes, 0.);
  Springs springs(sliders, n_elements);
  const int watched = std::min(n_elements - 1, static_cast<int>(at / size));
  ShearHistory kept;
  for (int step = 0; step < n; ++step) {
    std::fill(force.begin(), force.end(), 0.);
    force.back() = tau(step * h);
    double seen = 0.;
    for (int e = 0; e < n_elements; ++e) {
      const auto i = static_cast<std::size_t>(e);
      const double s = springs.stress(e, (u[i + 1] - u[i]) / size);
      if (e == watched) seen = s;
      force[i] += s;
      force[i + 1] -= s;
    }
    if (step % between == 0 && step > 0) {
      kept.time.push_back(step * h);
      kept.displacement.push_back(u.back());
      kept.velocity.push_back(v.back() + 0.5 * h * force.back() / (0.5 * soil.density * size));
      const auto w = static_cast<std::size_t>(watched);
      kept.strain.push_back((u[w + 1] - u[w]) / size);
      kept.stress.push_back(seen);
    }
    for (std::size_t i = soil.absorbing ? 0 : 1; i < n_nodes; ++i) {
      const double mass = soil.density * size * (i == 0 || i + 1 == n_nodes ? 0.5 : 1.);
      const double dashpot = i == 0 ? soil.density * speed : 0.;  // Lysmer and Kuhlemeyer (1969)
      v[i] = ((mass / h - 0.5 * dashpot) * v[i] + force[i]) / (mass / h + 0.5 * dashpot);
      u[i] += h * v[i];
    }
  }
  return kept;
}

}  // namespace upbead::test

#include "strip_theory.h"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <functional>
#include <vector>

namespace upbead::test {

namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXcd;

constexpr int n_terms = 24;     ///< of each parity
constexpr double k_end = 150.;  ///< the kernels' remainders beyond their asymptotes fall as k^-3

/// Nodes in k with the kernel at them.
struct Samples {
  std::vector<double> k, weight;
  std::vector<Flexibility> kernel;
};

/// Gauss points on panels that are halved until the kernel's integral no longer changes.
class AdaptivePanels {
 public:
  using Kernel = std::function<Flexibility(double)>;
  explicit AdaptivePanels(Kernel kernel) : kernel_(std::move(kernel)) {}

  void add(double a, double b, int depth = 0) {
    const double middle = 0.5 * (a + b);
    const Samples whole = panel(a, b), left = panel(a, middle), right = panel(middle, b);
    const Eigen::Vector3cd halves = total(left) + total(right);
    if ((total(whole) - halves).norm() <= 1e-9 * (1. + halves.norm()) || depth > 40) return append(whole);
    add(a, middle, depth + 1);
    add(middle, b, depth + 1);
  }

  Samples samples;

 private:
  Samples panel(double a, double b) const {
    using Gauss = boost::math::quadrature::gauss<double, 16>;
    Samples out;
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
      for (const double sign : {-1., 1.}) {
        out.k.push_back(0.5 * (a + b) + 0.5 * (b - a) * sign * Gauss::abscissa()[i]);
        out.weight.push_back(0.5 * (b - a) * Gauss::weights()[i]);
        out.kernel.push_back(kernel_(out.k.back()));
      }
    return out;
  }

  static Eigen::Vector3cd total(const Samples& s) {
    Eigen::Vector3cd sum = Eigen::Vector3cd::Zero();
    for (std::size_t i = 0; i < s.k.size(); ++i)
      sum += s.weight[i] * Eigen::Vector3cd(s.kernel[i].xx, s.kernel[i].zz, s.kernel[i].xz);
    return sum;
  }

  void append(const Samples& s) {
    samples.k.insert(samples.k.end(), s.k.begin(), s.k.end());
    samples.weight.insert(samples.weight.end(), s.weight.begin(), s.weight.end());
    samples.kernel.insert(samples.kernel.end(), s.kernel.begin(), s.kernel.end());
  }

  Kernel kernel_;
};

Samples sample(const ElasticSoil& soil, Complex omega) {
  AdaptivePanels panels([&](double k) { return surface_flexibility(soil, k, omega); });
  for (double a = 0.; a < k_end;) {
    const double b = std::min(k_end, a + std::clamp(0.3 * a, 0.05, 2.));
    panels.add(a, b);
    a = b;
  }
  return std::move(panels.samples);
}

/// J_0 ... J_{n-1} at k by backward recurrence (Miller), normed by J_0 + 2 sum J_2m = 1.
std::vector<double> bessel(int n, double k) {
  const int start = 2 * ((std::max(n, static_cast<int>(k)) + 40) / 2);
  std::vector<double> J(static_cast<std::size_t>(start) + 2, 0.);
  J[static_cast<std::size_t>(start)] = 1e-300;
  double sum = 0.;
  for (int m = start; m > 0; --m) {
    const auto i = static_cast<std::size_t>(m);
    if (m % 2 == 0) sum += 2. * J[i];
    J[i - 1] = 2. * m / k * J[i] - J[i + 1];
    if (std::abs(J[i - 1]) > 1e250) {
      for (double& value : J) value *= 1e-250;
      sum *= 1e-250;
    }
  }
  sum += J[0];
  J.resize(static_cast<std::size_t>(n));
  for (double& value : J) value /= sum;
  return J;
}

/// Integrals of kernel times Bessel functions; the asymptotes of the kernels at large k are integrated in closed
/// form.
class Integrals {
 public:
  Integrals(const Samples& samples, double nu) : samples_(samples), nu_(nu) {
    const auto n = static_cast<Eigen::Index>(samples.k.size());
    even_.resize(n_terms, n);
    odd_.resize(n_terms, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto J = bessel(2 * n_terms, samples.k[static_cast<std::size_t>(i)]);
      for (int m = 0; m < n_terms; ++m) {
        const double sign = m % 2 ? -1. : 1.;
        even_(m, i) = sign * J[static_cast<std::size_t>(2 * m)];
        odd_(m, i) = sign * J[static_cast<std::size_t>(2 * m + 1)];
      }
    }
  }

  /// 1/pi int C J_m J_n dk between terms of one parity; C ~ (1 - nu) k / (k^2 + 1), with
  /// int k / (k^2 + 1) J_m J_n dk = (-1)^((m - n)/2) I_m(1) K_n(1), m >= n, whose sign cancels those of the
  /// transforms.
  Matrix same(Complex Flexibility::*part, int parity) const {
    const Eigen::MatrixXd& J = parity ? odd_ : even_;
    Matrix out = J * rest(part, [&](double k) { return (1. - nu_) * k / (k * k + 1.); }).asDiagonal() *
                 J.transpose().cast<Complex>();
    for (int m = 0; m < n_terms; ++m)
      for (int n = 0; n < n_terms; ++n)
        out(m, n) += (1. - nu_) * boost::math::cyl_bessel_i(2 * std::max(m, n) + parity, 1.) *
                     boost::math::cyl_bessel_k(2 * std::min(m, n) + parity, 1.);
    return out / M_PI;
  }

  /// Between even and odd terms; C ~ (1 - 2 nu) / (2 k), with int J_m J_n / k dk = 2/pi sin((m - n) pi/2) / (m^2 -
  /// n^2).
  Matrix cross() const {
    const double c = 0.5 * (1. - 2. * nu_);
    Matrix out =
        even_ * rest(&Flexibility::xz, [&](double k) { return c / k; }).asDiagonal() * odd_.transpose().cast<Complex>();
    for (int m = 0; m < n_terms; ++m)
      for (int n = 0; n < n_terms; ++n) {
        // the product of the sine and the signs of both transforms is -1
        const double even = 2. * m, odd = 2. * n + 1.;
        out(m, n) -= c * 2. / M_PI / (even * even - odd * odd);
      }
    return out / M_PI;
  }

 private:
  template <typename Asymptote>
  Eigen::VectorXcd rest(Complex Flexibility::*part, const Asymptote& asymptote) const {
    Eigen::VectorXcd out(even_.cols());
    for (Eigen::Index i = 0; i < out.size(); ++i) {
      const auto s = static_cast<std::size_t>(i);
      out[i] = samples_.weight[s] * (samples_.kernel[s].*part - asymptote(samples_.k[s]));
    }
    return out;
  }

  const Samples& samples_;
  double nu_;
  Eigen::MatrixXd even_, odd_;  ///< Bessel functions with their signs, one row per term, one column per node
};

Matrix blocks(const Matrix& a, const Matrix& b, const Matrix& c, int n) {
  Matrix out(2 * n, 2 * n);
  out << a.topLeftCorner(n, n), b.topLeftCorner(n, n), b.topLeftCorner(n, n).transpose(), c.topLeftCorner(n, n);
  return out;
}

/// Heave: t_z even, t_x odd. Sway and rotation: t_x even, t_z odd; u_z = x under a unit rotation.
Stiffness with_terms(const Matrix& heave, const Matrix& sway, int n) {
  Eigen::VectorXcd up = Eigen::VectorXcd::Zero(2 * n);
  up[0] = 1.;
  Eigen::MatrixXcd motion = Eigen::MatrixXcd::Zero(2 * n, 2);
  motion(0, 0) = 1.;
  motion(n, 1) = 0.5;
  const Matrix traction = sway.partialPivLu().solve(motion);
  const Eigen::Matrix2cd K = motion.transpose() * traction;
  Stiffness out = Stiffness::Zero();
  out(1, 1) = up.transpose() * heave.partialPivLu().solve(up);
  out(0, 0) = K(0, 0), out(0, 2) = K(0, 1), out(2, 0) = K(1, 0), out(2, 2) = K(1, 1);
  return out;
}

Stiffness damped_stiffness(const ElasticSoil& soil, Complex omega) {
  const Samples samples = sample(soil, omega);
  const Integrals integrals(samples, soil.nu);
  const Matrix zz_even = integrals.same(&Flexibility::zz, 0), zz_odd = integrals.same(&Flexibility::zz, 1);
  const Matrix xx_even = integrals.same(&Flexibility::xx, 0), xx_odd = integrals.same(&Flexibility::xx, 1);
  const Matrix xz = integrals.cross();
  const auto stiffness = [&](int n) {
    return with_terms(blocks(zz_even, -xz, xx_odd, n), blocks(xx_even, xz, zz_odd, n), n);
  };
  return (4. * stiffness(n_terms) - stiffness(n_terms / 2)) / 3.;
}

}  // namespace

Stiffness theoretical_stiffness(const ElasticSoil& soil, double a0) {
  const auto at = [&](double damping) { return damped_stiffness(soil, a0 * Complex(1., -damping)); };
  return 3. * at(1e-4) - 3. * at(2e-4) + at(3e-4);
}

}  // namespace upbead::test

#include "spring_chain.h"

#include <cmath>

namespace upbead::test {

System SpringChain::system(const TimeFunction& force) const {
  std::vector<Eigen::Triplet<double>> springs, masses;
  for (int i = 0; i < n; ++i) {
    masses.emplace_back(i, i, 1.);
    springs.emplace_back(i, i, i + 1 < n ? 2. : 1.);
    if (i == 0) continue;
    springs.emplace_back(i, i - 1, -1.);
    springs.emplace_back(i - 1, i, -1.);
  }
  System system;
  for (SparseMatrix* A : {&system.M, &system.C, &system.K}) A->resize(n, n);
  system.M.setFromTriplets(masses.begin(), masses.end());
  system.C = damping * system.M;
  system.K.setFromTriplets(springs.begin(), springs.end());
  system.field.assign(static_cast<std::size_t>(n), Field::displacement);
  system.loads.push_back({"end", Vector::Unit(n, n - 1), force, -1});
  system.readings.push_back({"end", "m", "", {{n - 1, 1.}}, {}, {}, {}});
  system.readings.push_back({"inside", "m", "", {{3 * n / 4 - 1, 1.}}, {}, {}, {}});
  return system;
}

ModalModel SpringChain::exact() const {
  const double pi = std::acos(-1.);
  ModalModel model;
  model.pole.resize(n);
  model.load.setOnes(n, 1);
  model.reading.resize(2, n);
  model.feedthrough.setZero(2, 1);
  model.impulse.setZero(2, 1);
  model.load_name = {"end"};
  model.reading_label = {{"end", "m", ""}, {"inside", "m", ""}};
  for (int j = 0; j < n; ++j) {
    const double a = (2 * j + 1) * pi / (2 * n + 1), omega = 2. * std::sin(0.5 * a);
    const std::complex<double> pole =
        -0.5 * damping + std::sqrt(std::complex<double>(0.25 * damping * damping - omega * omega));
    const double at_end = std::sin(n * a) * 4. / (2 * n + 1);
    model.pole[j] = pole;
    // x = 2 Re z / (2 i omega_d) = sum over both poles of z / (pole - conj(pole))
    model.reading(0, j) = std::sin(n * a) * at_end / std::complex<double>(0., pole.imag());
    model.reading(1, j) = std::sin(3 * n / 4 * a) * at_end / std::complex<double>(0., pole.imag());
  }
  return model;
}

}  // namespace upbead::test

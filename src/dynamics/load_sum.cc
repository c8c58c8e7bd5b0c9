#include "load_sum.h"

namespace upbead::detail {

void LoadSum::evaluate(double t, double inside, std::vector<double>& f) const {
  f.resize(system_.loads.size());
  for (std::size_t k = 0; k < f.size(); ++k) f[k] = system_.loads[k].history(t, inside);
}

void LoadSum::sum(const std::vector<double>& f, Vector& b) const {
  b.setZero(system_.size());
  for (std::size_t k = 0; k < f.size(); ++k)
    if (system_.loads[k].prescribed < 0 && f[k] != 0.) b += f[k] * system_.loads[k].vector;
}

void LoadSum::prescribe(const std::vector<double>& f, Vector& v) const {
  v.tail(system_.n_prescribed).setZero();
  for (std::size_t k = 0; k < f.size(); ++k)
    if (const int i = system_.loads[k].prescribed; i >= 0) v[i] += f[k];
}

}  // namespace upbead::detail

#include "upbead/dynamics/modal_model.h"

#include <stdexcept>

namespace upbead {

int index_of(const std::vector<ReadingLabel>& labels, const std::string& name) {
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i].name == name) return static_cast<int>(i);
  throw std::out_of_range("the reduced model has no reading '" + name + "'");
}

ModalModel ModalModel::with_readings(const std::vector<int>& list) const {
  ModalModel some = *this;
  some.reading = reading(list, Eigen::all);
  some.feedthrough = feedthrough(list, Eigen::all);
  some.impulse = impulse(list, Eigen::all);
  some.reading_label.clear();
  for (const int i : list) some.reading_label.push_back(reading_label[static_cast<std::size_t>(i)]);
  return some;
}

void ModalModel::join_loads(int kept, int joined) {
  std::vector<int> rest;
  for (int k = 0; k < n_loads(); ++k)
    if (k != joined) rest.push_back(k);
  load.col(kept) += load.col(joined);
  load = Eigen::MatrixXcd(load(Eigen::all, rest));
  for (Eigen::MatrixXd* part : {&feedthrough, &impulse}) {
    part->col(kept) += part->col(joined);
    *part = Eigen::MatrixXd((*part)(Eigen::all, rest));
  }
  load_name.erase(load_name.begin() + joined);
}

std::complex<double> ModalModel::transfer(int i, int k, std::complex<double> s) const {
  // The real part of a mode's sum is half the sum of the mode and its conjugate; for a real pole that is the mode
  // itself.
  std::complex<double> H = feedthrough(i, k) + impulse(i, k) / s;
  for (int m = 0; m < n_modes(); ++m) {
    const std::complex<double> product = reading(i, m) * load(m, k);
    H += 0.5 * (product / (s - pole[m]) + std::conj(product) / (s - std::conj(pole[m])));
  }
  return H;
}

void join_pore_pressures(ModalModel& model) {
  const std::string suffix = ".pore_pressure";
  for (int k = model.n_loads() - 1; k > 0; --k) {
    const std::string& name = model.load_name[static_cast<std::size_t>(k)];
    const std::string& before = model.load_name[static_cast<std::size_t>(k - 1)];
    if (name == before + suffix) model.join_loads(k - 1, k);
  }
}

}  // namespace upbead

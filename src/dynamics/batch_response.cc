#include "dynamics/batch_response.h"

#include <stdexcept>

#include "mode_sum.h"
#include "phi_functions.h"

namespace upbead {

namespace {

using detail::ModeTable;
using detail::padded;
using detail::SplitArray;

/// The modes of one reading, and one more of pole 0 where it takes up integrals of loads.
struct OneReading {
  Eigen::VectorXcd pole, reading;
  Eigen::MatrixXcd load;
};

OneReading one_reading(const ModalModel& model, int i) {
  const int n = model.n_modes(), n_more = (model.impulse.row(i).array() != 0.).any() ? 1 : 0;
  OneReading one{Eigen::VectorXcd::Zero(n + n_more), Eigen::VectorXcd::Ones(n + n_more),
                 Eigen::MatrixXcd(n + n_more, model.n_loads())};
  one.pole.head(n) = model.pole;
  one.reading.head(n) = model.reading.row(i).transpose();
  one.load.topRows(n) = model.load;
  if (n_more > 0) one.load.row(n) = model.impulse.row(i).cast<std::complex<double>>();
  return one;
}

}  // namespace

/// A mode's step is z' = E z + h (phi_1 - phi_2) b f_n + h phi_2 b f_(n+1). For zeta = z - h phi_2 b f_n it needs the
/// load once, zeta' = E zeta + h phi_1^2 b f_n, because E = 1 + x phi_1 and phi_1 = 1 + x phi_2. Then
/// w = zeta / (h phi_1^2 b) takes the load up unchanged, and b stands in the reading only, where it may be zero. Before
/// a jump to f_0 z is zero, which makes zeta = -h phi_2 b f_0.
BatchResponse::BatchResponse(const ModalModel& model, int reading, double step)
    : direct_(model.feedthrough.row(reading)) {
  const OneReading one = one_reading(model, reading);
  Eigen::VectorXcd E(one.pole.size()), start(E.size()), input(E.size()), at_once(E.size());
  for (Eigen::Index m = 0; m < E.size(); ++m) {
    const detail::PhiFunctions phi = detail::phi_functions(one.pole[m] * step);
    const std::complex<double> square = phi.phi1 * phi.phi1;
    E[m] = phi.exp;
    start[m] = -phi.phi2 / square;
    input[m] = one.reading[m] * step * square;
    at_once[m] = one.reading[m] * step * phi.phi2;
  }
  ModeTable modes{padded(E), padded(start), {}};
  for (int k = 0; k < model.n_loads(); ++k) modes.reading.push_back(padded(input.cwiseProduct(one.load.col(k))));
  modes_ = std::make_shared<const ModeTable>(std::move(modes));
  direct_ += (at_once.transpose() * one.load).real();
}

void BatchResponse::respond(const Eigen::Ref<const WaveSamples>& loads, Eigen::Ref<Eigen::RowVectorXd> y) const {
  if (loads.rows() != direct_.size() || loads.cols() != y.size())
    throw std::invalid_argument("a wave's loads do not fit the reduced model or the answer");
  constexpr int block = detail::samples_at_a_time;
  const Eigen::Index n = y.size(), n_padded = (n + block - 1) / block * block;
  if (n == 0) return;
  Eigen::RowVectorXd f = Eigen::RowVectorXd::Zero(n_padded), sum = Eigen::RowVectorXd::Zero(n_padded);
  for (Eigen::Index k = 0; k < loads.rows(); ++k) {
    f.head(n) = loads.row(k);
    SplitArray w{modes_->start.re * f[0], modes_->start.im * f[0]};
    detail::add_mode_sum(modes_->E, modes_->reading[k], f.data(), n_padded, w, sum.data());
    sum += direct_[k] * f;
  }
  y = sum.head(n);
}

}  // namespace upbead

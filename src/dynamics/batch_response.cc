#include "dynamics/batch_response.h"

#include <stdexcept>
#include <vector>

#include "dynamics/lanes.h"
#include "dynamics/phi_functions.h"

namespace upbead::detail {

/// Modes w(n + 1) = E w(n) + f_n, whose response to samples f_n is y_n = Re sum_m reading_m w_m(n). Their number is
/// padded to a multiple of `lanes` by modes of zeros.
struct ModeTable {
  SplitArray E;
  SplitArray start;                 ///< w(0) for f_0 = 1
  std::vector<SplitArray> reading;  ///< one for each load
};

namespace {

struct BlockPointers {
  const double *E_re, *E_im, *reading_re, *reading_im, *f;
  double *w_re, *w_im, *y;
};

/// One block of samples for all modes. What a mode adds to a sample depends only on the mode's last value, so that
/// the processor can work on several modes at once.
UPBEAD_CLONES void add_block(Eigen::Index n_modes, const BlockPointers& p) {
  Lanes sum[samples_at_a_time] = {};
  for (Eigen::Index m = 0; m < n_modes; m += lanes) {
    Lanes E_re, E_im, c_re, c_im, re, im;
    load(p.E_re + m, E_re);
    load(p.E_im + m, E_im);
    load(p.reading_re + m, c_re);
    load(p.reading_im + m, c_im);
    load(p.w_re + m, re);
    load(p.w_im + m, im);
    for (int n = 0; n < samples_at_a_time; ++n) {
      sum[n] += c_re * re;
      sum[n] -= c_im * im;
      const Lanes next = p.f[n] + E_re * re - E_im * im;
      im = E_re * im + E_im * re;
      re = next;
    }
    store(re, p.w_re + m);
    store(im, p.w_im + m);
  }
  for (int n = 0; n < samples_at_a_time; ++n)
    for (int lane = 0; lane < lanes; ++lane) p.y[n] += sum[n][lane];
}

}  // namespace

SplitArray padded(const Eigen::VectorXcd& values) {
  const Eigen::Index n = (values.size() + lanes - 1) / lanes * lanes;
  SplitArray split{Eigen::ArrayXd::Zero(n), Eigen::ArrayXd::Zero(n)};
  split.re.head(values.size()) = values.real();
  split.im.head(values.size()) = values.imag();
  return split;
}

void flush_denormals(SplitArray& z) {
  constexpr double gone = 1e-250;
  for (Eigen::ArrayXd* part : {&z.re, &z.im}) *part = (part->abs() < gone).select(0., *part);  // NaN is kept
}

void add_mode_sum(const SplitArray& E, const SplitArray& reading, const double* f, Eigen::Index n_samples,
                  SplitArray& w, double* y) {
  constexpr int blocks_between_drops = 8;
  for (Eigen::Index n = 0; n < n_samples; n += samples_at_a_time) {
    if (n % (blocks_between_drops * samples_at_a_time) == 0) flush_denormals(w);
    add_block(E.re.size(),
              {E.re.data(), E.im.data(), reading.re.data(), reading.im.data(), f + n, w.re.data(), w.im.data(), y + n});
  }
}

}  // namespace upbead::detail

namespace upbead {

namespace {

using detail::ModeTable;
using detail::padded;
using detail::SplitArray;

/// The modes of one reading, with another mode of pole 0 where the reading contains integrals of loads.
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

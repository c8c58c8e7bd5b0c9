#include "mode_sum.h"

namespace upbead::detail {

namespace {

struct BlockPointers {
  const double *E_re, *E_im, *reading_re, *reading_im, *f;
  double *w_re, *w_im, *y;
};

/// One block of samples for all modes. What a mode adds to a sample waits for nothing but the mode's last value, so
/// that the processor works on several modes at once.
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

void drop_what_is_gone(SplitArray& z) {
  constexpr double gone = 1e-250;
  for (Eigen::ArrayXd* part : {&z.re, &z.im})
    *part = (part->abs() < gone).select(0., *part);  // which keeps what is no number
}

void add_mode_sum(const SplitArray& E, const SplitArray& reading, const double* f, Eigen::Index n_samples,
                  SplitArray& w, double* y) {
  constexpr int blocks_between_drops = 8;
  for (Eigen::Index n = 0; n < n_samples; n += samples_at_a_time) {
    if (n % (blocks_between_drops * samples_at_a_time) == 0) drop_what_is_gone(w);
    add_block(E.re.size(),
              {E.re.data(), E.im.data(), reading.re.data(), reading.im.data(), f + n, w.re.data(), w.im.data(), y + n});
  }
}

}  // namespace upbead::detail

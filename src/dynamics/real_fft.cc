#include "real_fft.h"

#include <fftw3.h>
#include <mutex>

namespace upbead::detail {

namespace {

std::mutex planner;  // FFTW makes and destroys plans in one thread at a time

Eigen::Index good_size(Eigen::Index n_least) {
  for (Eigen::Index n = n_least + n_least % 2;; n += 2) {
    Eigen::Index rest = n;
    for (const int prime : {2, 3, 5})
      while (rest > 1 && rest % prime == 0) rest /= prime;
    if (rest == 1) return n;
  }
}

fftw_complex* fftw(Eigen::VectorXcd& amplitude) {
  return reinterpret_cast<fftw_complex*>(amplitude.data());
}

}  // namespace

/// Plans for any memory (FFTW_UNALIGNED), so that they may be used on vectors made later.
struct RealFft::Plans {
  explicit Plans(Eigen::Index n) {
    Eigen::VectorXd series(n);
    Eigen::VectorXcd amplitude(n / 2 + 1);
    const std::lock_guard<std::mutex> lock(planner);
    constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
    forward = fftw_plan_dft_r2c_1d(static_cast<int>(n), series.data(), fftw(amplitude), flags);
    backward = fftw_plan_dft_c2r_1d(static_cast<int>(n), fftw(amplitude), series.data(), flags);
  }
  ~Plans() {
    const std::lock_guard<std::mutex> lock(planner);
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;

  fftw_plan forward, backward;
};

RealFft::RealFft(Eigen::Index n_least) : size_(good_size(n_least)), plans_(std::make_shared<const Plans>(size_)) {}

Eigen::VectorXcd RealFft::forward(const Eigen::Ref<const Eigen::VectorXd>& series) const {
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(size_);
  padded.head(series.size()) = series;
  Eigen::VectorXcd amplitude(size_ / 2 + 1);
  fftw_execute_dft_r2c(plans_->forward, padded.data(), fftw(amplitude));
  return amplitude;
}

Eigen::VectorXd RealFft::backward(Eigen::VectorXcd amplitude) const {
  Eigen::VectorXd series(size_);
  fftw_execute_dft_c2r(plans_->backward, fftw(amplitude), series.data());
  return series / static_cast<double>(size_);
}

}  // namespace upbead::detail

namespace upbead {

Versions dynamics_versions() {
  return {{"FFTW", fftw_version + sizeof "fftw"}};  // of "fftw-3.3.10-sse2-avx"
}

}  // namespace upbead

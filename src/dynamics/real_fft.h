// Fourier transforms of real series.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "base/version.h"

namespace upbead::detail {

/// Transforms series of a fixed length, forward with exp(-i ...), backward with 1/n, so that backward undoes forward.
/// Any number of threads may use one object.
class RealFft {
 public:
  /// For series of the next length from n_least on that is even and has no other prime factors than 2, 3 and 5.
  explicit RealFft(Eigen::Index n_least);

  Eigen::Index size() const { return size_; }
  /// n/2 + 1 amplitudes of a series, which is padded by zeros.
  Eigen::VectorXcd forward(const Eigen::Ref<const Eigen::VectorXd>& series) const;
  /// The n values of a series from its n/2 + 1 amplitudes.
  Eigen::VectorXd backward(Eigen::VectorXcd amplitude) const;

 private:
  struct Plans;
  Eigen::Index size_;
  std::shared_ptr<const Plans> plans_;
};

}  // namespace upbead::detail

namespace upbead {

/// The version of FFTW.
Versions dynamics_versions();

}  // namespace upbead

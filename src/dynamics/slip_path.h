// How a phase of a slip model moves between two samples of its loads.
#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <vector>

#include "dynamics/lanes.h"
#include "dynamics/slip_model.h"

namespace upbead {

/// The amplitudes z of a phase's modes, padded by zeros.
using ModalState = detail::SplitArray;

/// The state in the modes of a phase; a stuck phase drops s'.
ModalState modal_state(const SlipPhase& phase, const Eigen::VectorXd& state);
/// The state in energy coordinates.
Eigen::VectorXd energy_state(const SlipPhase& phase, const ModalState& z);

/// One reading along a stretch of time, made to be evaluated often: modes that hardly change over it share one Taylor
/// polynomial, all other modes keep their exponentials. Accurate to a few roundings of its parts.
class SlipCurve {
 public:
  /// At t (s) from the start, not beyond the length of the stretch.
  double operator()(double t) const;
  static constexpr int n_terms = 20;  ///< 1/20! is below round-off

 private:
  friend class SlipPath;
  double length_ = 0.;
  std::array<double, n_terms> taylor_{};  ///< of powers of t / length
  std::vector<std::complex<double>> pole_, amplitude_;
};

/// The motion from a state under loads that run along straight lines: exact at any time t (s) from there on.
class SlipPath {
 public:
  /// `load`, `slope`: all loads of the phase at t = 0, and their change per second; `length` (s). The phase must
  /// outlive the object.
  SlipPath(const SlipPhase& phase, const ModalState& start, const Eigen::VectorXd& load, const Eigen::VectorXd& slope,
           double length);
  double length() const { return length_; }
  SlipCurve reading(int row) const;

  struct Place {
    ModalState z;
    double distance = 0.;  ///< integral of s' from 0 to t (m)
  };
  Place at(double t) const;

 private:
  const SlipPhase& phase_;
  Eigen::VectorXcd z_, whole_, rise_;  ///< at t = 0; what the load and its slope add to z'
  Eigen::VectorXd load_, slope_;
  double length_;
};

}  // namespace upbead

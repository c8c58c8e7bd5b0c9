// The generalised-alpha method.
#pragma once

#include "dirk.h"
#include "scheme_base.h"
#include "symmetric_pair.h"

namespace upbead::detail {

/// Chung & Hulbert, J. Appl. Mech. 60 (1993) 371, eqs. (17), (18), (25); with rho the spectral radius at infinite
/// frequency: alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1), gamma = 1/2 - alpha_m + alpha_f,
/// beta = (1 - alpha_m + alpha_f)^2 / 4.
struct AlphaCoefficients {
  explicit AlphaCoefficients(double rho_inf);
  double alpha_m, alpha_f, gamma, beta;
};

/// M a_m + C v_f + K x_f = f_f with y_m = (1 - alpha_m) y_(n+1) + alpha_m y_n (alpha_f alike), solved for a_m. The
/// acceleration carried from step to step is only first order accurate. Where a load jumps, or a prescribed velocity
/// has a kink, and where steps lengthen, an L-stable step comes first: see `step_l_stable` and `is_lengthened`.
class GeneralisedAlpha : public SchemeBase {
 public:
  GeneralisedAlpha(const System& system, const SchemeOptions& options);
  std::string name() const override { return "generalised_alpha"; }
  int order() const override { return 2; }
  int solves_per_step() const override { return 1; }
  void start(const State& state) override;
  void advance(State& state, double h) override;
  SchemeMemory memory() const override;
  void recall(const SchemeMemory& memory) override;

 private:
  bool loads_start_anew(double t, double h);
  void note_end_load();
  bool is_lengthened(double h) const;
  void step_l_stable(State& state, double h);
  void predict(const State& state, double h, State& middle);
  void finish(State& state, double h) const;
  void account(const State& before, const State& after, double h);
  /// dv_f / da_m and dx_f / da_m.
  double v_gain(double h) const { return (1. - p_.alpha_f) * h * p_.gamma / (1. - p_.alpha_m); }
  double x_gain(double h) const { return (1. - p_.alpha_f) * h * h * p_.beta / (1. - p_.alpha_m); }

  AlphaCoefficients p_;
  SymmetricPair damping_and_stiffness_;
  Dirk sdirk4_;
  std::vector<double> begin_load_;
  std::vector<double> largest_load_;  ///< |f_k| so far, to tell a jump from round-off
  double last_step_ = 0.;             ///< s; 0 before the first; negative: a second L-stable one is due
  State before_;
  Vector x_, v_, f_, rhs_;
  VectorBlock pair_, triple_;
};

}  // namespace upbead::detail

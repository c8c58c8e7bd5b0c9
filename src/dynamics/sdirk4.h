// L-stable SDIRK of order 4.
#pragma once

#include "dirk.h"
#include "scheme_base.h"

namespace upbead::detail {

/// Hairer & Wanner, Solving ODEs II, table IV.6.5. Its last stage is the end of the step, so the state satisfies the
/// equation of motion; its stage order is 1, so accelerations converge more slowly than x and x'. A jump of a load or
/// of a prescribed velocity needs no care.
class Sdirk4 : public SchemeBase {
 public:
  Sdirk4(const System& system, const SchemeOptions& options)
      : SchemeBase(system, options), dirk_(system, sdirk4_tableau()) {}
  std::string name() const override { return "sdirk4"; }
  int order() const override { return 4; }
  int solves_per_step() const override { return dirk_.n_stages(); }
  void advance(State& state, double h) override;

 private:
  Dirk dirk_;
};

}  // namespace upbead::detail

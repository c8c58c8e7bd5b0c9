#include "upbead/dynamics/scheme.h"

#include "dynamics/dirk.h"
#include "dynamics/scheme_base.h"

namespace upbead {

namespace {

/// Hairer & Wanner, Solving ODEs II, table IV.6.5. Its last stage is the end of the step, so the state satisfies the
/// equation of motion; its stage order is 1, so accelerations converge more slowly than x and x'. A jump of a load or
/// of a prescribed velocity needs no special treatment.
class Sdirk4 : public detail::SchemeBase {
 public:
  Sdirk4(const System& system, const SchemeOptions& options)
      : SchemeBase(system, options), dirk_(system, detail::sdirk4_tableau()) {}
  std::string name() const override { return "sdirk4"; }
  int order() const override { return 4; }
  int solves_per_step() const override { return dirk_.n_stages(); }
  void advance(State& state, double h) override { advance_by(dirk_, state, h); }

 private:
  detail::Dirk dirk_;
};

}  // namespace

std::unique_ptr<Scheme> make_scheme(const System& system, const SchemeOptions& options) {
  if (options.kind == SchemeKind::sdirk4) return std::make_unique<Sdirk4>(system, options);
  return detail::make_generalised_alpha(system, options);
}

}  // namespace upbead

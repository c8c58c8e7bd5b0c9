// What all schemes have in common.
#pragma once

#include <optional>

#include "dynamics/dirk.h"
#include "effective_matrix.h"
#include "energy_meter.h"
#include "upbead/dynamics/march.h"
#include "upbead/dynamics/scheme.h"

namespace upbead::detail {

/// Holds the factorised matrices, the account of energy and the results of the last step.
class SchemeBase : public Scheme {
 public:
  void start(const State& state) override {
    balanced_.state = state;
    balanced_.load.assign(system_.loads.size(), 0.);
    end_load_ = balanced_.load;
    if (meter_) meter_->start(state);
  }
  SchemeMemory memory() const override { return {balanced_, end_load_, {}, 0., energy()}; }
  void recall(const SchemeMemory& memory) override {
    balanced_ = memory.balanced;
    end_load_ = memory.end_load;
    if (meter_) meter_->restore(memory.energy);
  }
  const std::vector<double>& end_load() const override { return end_load_; }
  const LoadedState& balanced() const override { return balanced_; }
  const EnergyAccount& energy() const override { return meter_ ? meter_->account() : no_account_; }
  bool accounts_energy() const override { return meter_.has_value(); }
  int n_solves() const override { return n_solves_; }
  int n_factorisations() const override { return matrices_.n_factorisations(); }
  double factorise_seconds() const override { return matrices_.seconds(); }

 protected:
  SchemeBase(const System& system, const SchemeOptions& options)
      : system_(system), loads_(system), matrices_(system, options.refined && !system.is_divided()) {
    if (options.account_energy) meter_.emplace(system);
    SchemeBase::start(at_rest(system));
  }
  /// A step of `dirk` as this scheme's own: its end satisfies the equation of motion.
  void advance_by(Dirk& dirk, State& state, double h) {
    dirk.step(state, h, state.time + 0.5 * h, matrices_, meter(), nullptr);
    n_solves_ += dirk.n_stages();
    end_load_ = dirk.load();
    balanced_ = {state, end_load_};
  }

  EnergyMeter* meter() { return meter_ ? &*meter_ : nullptr; }

  const System& system_;
  LoadSum loads_;
  EffectiveMatrices matrices_;
  LoadedState balanced_;
  std::vector<double> end_load_;
  int n_solves_ = 0;

 private:
  std::optional<EnergyMeter> meter_;
  EnergyAccount no_account_;
};

/// See generalised_alpha.cc.
std::unique_ptr<Scheme> make_generalised_alpha(const System& system, const SchemeOptions& options);

}  // namespace upbead::detail

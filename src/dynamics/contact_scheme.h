// A march with frictional contact.
#pragma once

#include "contact_stage.h"
#include "dirk.h"
#include "scheme_base.h"

namespace upbead::detail {

/// Three tableaux with the same gamma share one matrix: order 4 while all nodes stick; order 2 while some move; four
/// steps of backward Euler where one closes, as velocities jump there and later stages of a higher order would make the
/// node bounce. A step that meets what its tableau is not made for is done anew with the next one.
class FrictionalContact : public SchemeBase {
 public:
  FrictionalContact(const System& system, const SchemeOptions& options);
  std::string name() const override { return "contact"; }
  int order() const override { return 2; }
  int solves_per_step() const override { return glued_.n_stages(); }
  void start(const State& state) override;
  void advance(State& state, double h) override;
  const ContactReport* contact() const override { return &report_; }
  SchemeMemory memory() const override;
  void recall(const SchemeMemory& memory) override;

 private:
  bool attempt(Dirk& dirk, int n, StopAt stop, State& state, double h);
  bool settled(const State& state) const;
  void report();

  Dirk glued_, moving_, impact_;
  ContactStage stage_;
  ContactReport report_;
  int fallbacks_before_ = 0;
};

}  // namespace upbead::detail

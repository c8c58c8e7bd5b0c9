// What a march with contact leaves behind of the caisson's bottom.
#pragma once

#include "dynamics/contact.h"
#include "upbead/dynamics/march.h"
#include "upbead/output/summary.h"

namespace upbead {

/// Sees every step of a march; system and scheme must outlive it.
class ContactRecorder : public MarchObserver {
 public:
  ContactRecorder(const System& system, const Scheme& scheme) : system_(system), scheme_(scheme) {}
  void see(const State& state, int step, int n_steps) override;
  ContactHistory history() const;
  NodeContact summary() const;

 private:
  const System& system_;
  const Scheme& scheme_;
  ContactHistory history_;
};

}  // namespace upbead

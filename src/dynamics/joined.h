// What the processes of a divided system have found, joined; with one process alone nothing is done.
#pragma once

#include "upbead/dynamics/krylov.h"
#include "upbead/dynamics/march.h"

namespace upbead {

/// Adds up the readings and energies of all processes.
void add_up(const System& system, Response& response);

/// A checkpoint of the whole system, on every process: it does not depend on how many there are.
MarchCheckpoint joined(const System& part, MarchCheckpoint checkpoint);
/// This process's part of it: the first one has the readings and energies so far.
MarchCheckpoint restricted(const System& part, const MarchCheckpoint& whole);

/// Directions in all unknowns of the whole system.
FieldBasis joined(const System& part, FieldBasis basis);

/// Shows another observer the states of the whole system. Both must outlive the march.
class WholeStates : public MarchObserver {
 public:
  WholeStates(const System& part, MarchObserver& observer) : part_(part), observer_(observer) {}
  void see(const State& state, int step, int n_steps) override;
  bool wants(double time) const override { return observer_.wants(time); }
  std::vector<double> memory() const override { return observer_.memory(); }
  void recall(const std::vector<double>& memory) override { observer_.recall(memory); }

 private:
  const System& part_;
  MarchObserver& observer_;
};

}  // namespace upbead

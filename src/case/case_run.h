// A case from its file to what came out: its mesh read, its scene solved, its records held against that.
#pragma once

#include "records/measured.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Calls what throws InputError at keys of the scene; gives these their places in the case.
template <class Work>
auto in_places_of(const Case& input, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw input.placed(error);
  }
}

/// The case's scene on its mesh, which is read where it is not given. Throws InputError with all objections at their
/// places in the case.
Simulation simulation_of(const Case& input, std::shared_ptr<const Mesh> mesh = nullptr,
                         std::shared_ptr<const Processes> processes = nullptr);

/// The records that the case is held against. Throws InputError with every mistake in them.
std::vector<MeasuredRecord> read_records(const Case& input, const Simulation& simulation);

/// The one end of every run of a case: solves it, holds it against the records and transducers, and tells what of the
/// files was left out or may be wrong. Throws as Simulation::run, at places of the case.
Run solve(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& records,
          const RunOptions& options = {});

/// Those of the scene and of the case's files.
NumberedWarnings warnings(const Case& input, const Simulation& simulation);

/// What is skipped of the scene and of the case's files.
std::vector<Skipped> skipped(const Case& input, const Simulation& simulation, bool reduced);

/// Of all loads by transducers and of the uplift; forces and arms are those on the caisson of the scene.
std::vector<GaugeSummary> gauge_summaries(const Case& input, const Simulation& simulation);

std::string describe(const std::vector<GaugeSummary>& gauges);

}  // namespace upbead

// Runs of a case beside upbead/case/case_run.h: after other runs, with records that were read before, with what is
// told.
#pragma once

#include <functional>

#include "output/output_schema.h"
#include "records/measured.h"
#include "upbead/case/case_run.h"
#include "upbead/findings/find.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Calls `work`; where it throws InputError at keys of the scene, adds their places in the case.
template <class Work>
auto in_places_of(const Case& input, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw input.placed(error);
  }
}

/// The end of a case on its mesh (s). Where it gives no time.end: when its loads are over and the section has come to
/// rest after them.
double end_on(const Case& input, const Mesh& mesh);

/// The period (s) in which a caisson sways and rocks on its ground or springs, about; 0 without a caisson.
double swing_period(const Scene& scene, const Mesh& mesh);

/// Where the case gives no end, reads its mesh and sets the end, and why; returns that mesh, null where it is given.
std::shared_ptr<const Mesh> settle_end(Case& input);

/// The case's scene with what follows with the mesh: profiles, an end that is left to be chosen, pieces of its loads.
Scene scene_on(const Case& input, const Mesh& mesh);

/// The case's simulation as `make` makes it of that scene, checked as simulation_of() does; the mesh is read where it
/// is not given.
Simulation simulation_by(const Case& input, std::shared_ptr<const Mesh> mesh,
                         const std::function<Simulation(Scene scene, const std::shared_ptr<const Mesh>& mesh)>& make);

/// simulation_of(input, mesh) on one process, after another simulation, see Simulation.
Simulation simulation_after(const Simulation* before, const Case& input, std::shared_ptr<const Mesh> mesh);

/// The measured records with which the results are compared. Throws InputError with every mistake in them.
std::vector<MeasuredRecord> read_records(const Case& input, const Simulation& simulation);

/// Every run of a case ends here: the same with records that were read before the work.
Run solve(const Case& input, const Simulation& simulation, const std::vector<MeasuredRecord>& records,
          const RunOptions& options = {});

/// The same of a case whose scene was solved before, or of one that is solved alike and differs from it in what is only
/// told: [sliding] (but see needs_sliding()), limits but that of safety, title and report.
Run answer(const Case& input, const Solution& solution, const std::function<void(double)>& progress);

/// Warnings of the scene and of the case's files.
NumberedWarnings warnings(const Case& input, const Simulation& simulation);

/// What of the scene and of the case's files is skipped.
std::vector<Skipped> skipped(const Case& input, const Simulation& simulation, bool reduced);

/// How each column of the files of loads, uplift and measurements was read.
std::vector<RecordSummary> record_summaries(const Case& input, const std::vector<MeasuredRecord>& records);

/// Summaries of all loads by transducers and of the uplift; forces and arms are those on the caisson of the scene.
std::vector<GaugeSummary> gauge_summaries(const Case& input, const Simulation& simulation);
OutputSchema<GaugeSummary> gauge_outputs();

/// Warnings of all transducers (model/gauges.h).
NumberedWarnings transducer_warnings(const Case& input, const Simulation& simulation);

}  // namespace upbead

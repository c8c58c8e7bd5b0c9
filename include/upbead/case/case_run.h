// A case from its file to its results: its simulation on its mesh, and its run.
//
//   const Case input = read_case("cases/fig2b-prototype.toml");
//   const Run run = solve(input, simulation_of(input));
#pragma once

#include <memory>

#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// The case's scene on its mesh; where the case gives no end, when its loads are over and the section has come to rest
/// after them; the mesh is read where it is not given. Throws InputError with all mistakes at their places in the case.
Simulation simulation_of(const Case& input, std::shared_ptr<const Mesh> mesh = nullptr,
                         std::shared_ptr<const Processes> processes = nullptr);

/// Solves it, compares the results with the records and transducers of the case, and reports what of the files was left
/// out or may be wrong. Throws as Simulation::run, at places of the case.
Run solve(const Case& input, const Simulation& simulation, const RunOptions& options = {});

}  // namespace upbead

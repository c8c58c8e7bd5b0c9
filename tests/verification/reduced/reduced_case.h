// A reduced model and a march of the same scene.
#pragma once

#include <string>

#include "record.h"
#include "response/reduction.h"
#include "scenes.h"
#include "upbead/case/case_run.h"

namespace upbead::test {

/// Errors of F_T: largest differences from the march over the peak of the march.
struct ShearError {
  double history = 0.;
  double peak = 0.;  ///< of the largest and of the least value
};

/// Error of the model's response to the system's loads, against SDIRK of order 4 in steps of at most `step` that meet
/// all kinks.
ShearError error_against(const ModalModel& model, const System& system, double end, double step);

/// The breakwater, drained, under that force. Ends at 0.5 s.
Scene dry_scene(const TimeFunction& force);
/// The same with pore water between seas of three depths; for a mesh with_sea().
Scene sea_scene(const TimeFunction& force, Compressibility compressibility = Compressibility::compressible);

struct Limits {
  double history, peak;
};

/// Reduces the scene, compares with 64 steps per duration, or with `step` if it is given, and records errors, vectors
/// and the model's own estimate.
void compare(Record& record, const std::string& what, const Scene& scene, const Mesh& mesh, Limits limits,
             double step = 0.);
/// Records an error with its limits.
void write_down(Record& record, const std::string& what, const ShearError& error, Limits limits);

/// The shipped case of the prototype.
Case prototype(const std::vector<std::string>& overrides = {});

}  // namespace upbead::test

// A case as a reduced model for waves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "findings/circle_model.h"
#include "respond/respond_slip.h"
#include "response/reduction.h"
#include "run/contact/contact_model.h"
#include "run/sliding/coupled_sliding.h"
#include "upbead/case/case.h"
#include "upbead/output/model_file.h"

namespace upbead {

/// Larger models of the same loads, which estimate the error for any wave.
struct Nested {
  std::optional<NestedModels> models;
  std::string why_not;
  double seconds = 0.;
};

/// All that a run tells of a case without solving it: what concerns its scene in any wave, and its own loads alone.
struct WarningsOfCase {
  NumberedWarnings scene, loads;
};

/// [sliding] of a case as its model keeps it; without what still water at two levels adds.
std::optional<ModelSliding> sliding_of_case(const Scene& scene, const Simulation& simulation);

WarningsOfCase warnings_of_case(const Case& input, const Simulation& simulation);

/// All results of `reduce` for a case.
struct Reduced {
  ReducedModelFile file;
  Reduction reduction;
  ReducedSlip slip;
  std::vector<Skipped> skipped;
  Nested nested;
  CircleModelMade circles;
  ContactModelMade contact;
  NumberedWarnings of_loads;  ///< those of the scene are in the file
  NumberedWarnings warnings() const;
  std::string path;
  Timing timing;
};

struct CaseModelOptions {
  bool all_readings = false;   ///< vectors are added until all readings are good, not F_T alone
  bool against_march = false;  ///< finds the error against a march, too
  bool bare = false;           ///< without larger models, slip and circles
};

/// Makes the model of the case, bonded, with progress on the terminal. `folder`: from where the model's own copy of the
/// case sees its files. Throws InputError at the keys of a case that no reduced model can hold, and NumericsError where
/// the model does not converge.
Reduced reduced_case(Case& input, const CaseModelOptions& options, const std::string& folder);

/// The same of a simulation of the case, whose System, converged soil and basis are used where they serve. The case's
/// end must be settled.
Reduced reduced_case(const Case& input, const Simulation& of_case, const CaseModelOptions& options,
                     const std::string& folder);

}  // namespace upbead

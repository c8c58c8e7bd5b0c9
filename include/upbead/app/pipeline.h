// The one-way flow of a scene: Case -> Mesh -> Space -> System -> Response -> summary.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "upbead/app/case.h"
#include "upbead/dynamics/march.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/fem/compile.h"
#include "upbead/fem/resolve.h"
#include "upbead/mesh/mesh.h"
#include "upbead/output/summary.h"

namespace upbead {

/// How wrong cells make F_T.
struct ShearError {
  double peak = 0.;     ///< of the peak, relative
  double history = 0.;  ///< of the largest |F_T|, at any time
};

/// How a mesh came about that was refined for a tolerance.
struct MeshAccuracy {
  struct Level {
    int unknowns = 0;
    ShearError error;
  };
  std::vector<Level> levels;  ///< that were held against cells half as large; the last is used
};

/// A scene on its mesh, compiled, before anything is solved.
struct CompiledCase {
  Scene scene;                                 ///< as solved: with everything decided that the case leaves open
  std::vector<Decision> decisions;             ///< about its regions
  std::shared_ptr<const Processes> processes;  ///< that the system is divided among; null: whole
  std::shared_ptr<const Mesh> mesh;
  std::unique_ptr<Space> space;
  std::unique_ptr<Unknowns> unknowns;
  CompiledScene compiled;
  std::vector<bool> absent;              ///< cells left out
  SoilState soil_state;                  ///< what differs from cell to cell
  bool with_interface = false;           ///< the caisson may slip and lift; a mesh for the tolerance is made without
  std::optional<SoilSummary> soil;       ///< where the soil has been settled by the strain of the response
  std::optional<MeshAccuracy> accuracy;  ///< where the mesh was made for the tolerance
  Timing timing;
};

/// Throws InputError where a case asks for more than 1,000,000 steps or 10,000 fields, at the key that drives it; of
/// automatic steps as far as the loads alone tell. Needs no mesh.
void check_size(const Case& input);

/// Meshes, checks (its size too) and compiles. Throws InputError with all objections at their places in the case.
/// `mesh`: of this very case, where it has been read already; not for a mesh that the tolerance makes. `processes`, who
/// all call this: to divide the system among.
CompiledCase compile_case(const Case& input, std::shared_ptr<const Mesh> mesh = nullptr,
                          std::shared_ptr<const Processes> processes = nullptr);

/// Compiles the scene anew with other soil on the same cells, for its processes undivided: see compile().
void recompile(CompiledCase& scene, const SoilState& soil);

/// What was solved.
struct Run {
  Response response;
  Summary summary;
  std::optional<CoupledHistoryTable> coupled;  ///< where the caisson slipped as a whole
  std::optional<ContactHistory> contact;       ///< where it was marched with a law of contact
  std::optional<PressureModel> pressures;      ///< where it was reduced
  std::string scheme_reason;                   ///< why it was solved as it was
  std::string step_reason;                     ///< why the steps are as long as they are
};

/// Settles the soil where it follows the strain, and solves a compiled case in time. Where it is marched the observer
/// sees every step, where it is reduced `reducing` is called after every solve with 0 to 1. Where a way to solve it is
/// refused the next one is tried, and an observer sees another march from step 0. Throws NumericsError where no answer
/// balances (require_balance of response/shear_response.h).
Run run_case(const Case& input, CompiledCase& scene, const MarchOptions& marching,
             const std::function<void(double)>& reducing = {});

/// What may be wrong with the numbers of a scene, as far as that can be told without solving: docs/warnings.md.
NumberedWarnings warnings(const Case& input, const CompiledCase& scene);

/// What is skipped in a scene and why, with the numbers; `reduced`: whether a reduced model solves it.
std::vector<Skipped> skipped(const Case& input, const CompiledCase& scene, bool reduced);

}  // namespace upbead

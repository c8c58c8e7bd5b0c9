// A scene on its mesh, and its solution: no files, no text. docs/install.md has a program that uses it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "upbead/dynamics/march.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/fem/resolve.h"
#include "upbead/mesh/mesh.h"
#include "upbead/output/summary.h"

namespace upbead {

class Space;
class Unknowns;
class YieldingSoil;
struct CompiledScene;
struct CellsCompared;

/// Error of F_T by the size of the cells.
struct ShearError {
  double peak = 0.;     ///< of the peak, relative
  double history = 0.;  ///< of the largest |F_T|, at any time
};

/// How a mesh was refined for a tolerance.
struct MeshAccuracy {
  struct Level {
    int unknowns = 0;
    ShearError error;
  };
  std::vector<Level> levels;  ///< meshes that were compared with cells half as large; the last is used
  std::shared_ptr<const CellsCompared> compared;  ///< of the last
};

struct Run;
struct Simulation;

using SoilFollower = std::function<void(YieldingSoil&)>;

/// What a run reports while it is solved.
struct RunOptions {
  std::function<void(double)> progress;  ///< called with 0 to 1, again and again; may throw to end the run
  /// Of what follows the march; called once, with the scene as it is marched (its soil converged), before the march.
  /// Null where nobody follows. The observer outlives the run.
  std::function<MarchObserver*(const Simulation&)> observer;
  /// Told the soil that yields before it is marched, and another one where another way is tried: what it bears may be
  /// read whenever the observer sees a state. It dies with the march. Null where nobody follows.
  SoilFollower soil;
  Checkpointing checkpoints;
};

/// A scene on its mesh, assembled: a value that nothing changes. What other soil, cells or contact make of it is
/// another one; copies share all that is large.
struct Simulation {
  /// Checks the scene on the mesh, decides what it leaves open, and assembles. Where scene.mesh.refine has no number
  /// the cells are split as the tolerance asks, from this mesh on. `among`: processes, who all call this, to divide the
  /// system among. Throws InputError whose places are keys of the scene, such as "boundaries.left".
  Simulation(Scene asked, std::shared_ptr<const Mesh> on, std::shared_ptr<const Processes> among = nullptr);

  /// Lets soil come to the strain of its response, and solves in time. Where a way to solve it is refused the next one
  /// is tried. Throws NumericsError where no answer balances (require_balance of response/shear_response.h).
  Run run(const RunOptions& options = {}) const;

  Scene given;                                 ///< as it was asked for
  Scene scene;                                 ///< as solved: with everything decided that it leaves open
  std::vector<Decision> decisions;             ///< about its regions
  std::shared_ptr<const Processes> processes;  ///< that the system is divided among; null: whole
  std::shared_ptr<const Mesh> given_mesh;      ///< that the refinement for the tolerance started from; else `mesh`
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const Space> space;
  std::shared_ptr<const Unknowns> unknowns;
  std::shared_ptr<const CompiledScene> compiled;
  std::vector<bool> absent;              ///< cells left out
  SoilState soil_state;                  ///< what differs from cell to cell
  bool with_interface = false;           ///< the caisson may slip and lift; a mesh for the tolerance is made without
  std::optional<SoilSummary> soil;       ///< where the soil has converged with the strain of the response
  std::optional<MeshAccuracy> accuracy;  ///< where the mesh was made for the tolerance
  Timing timing;

 private:
  Simulation() = default;
  friend Simulation resolved_on(const Scene& given, std::shared_ptr<const Mesh> mesh,
                                std::shared_ptr<const Processes> processes);
};

/// What was solved.
struct Run {
  std::shared_ptr<const Simulation> simulation;  ///< as solved: its soil converged, its base bonded or sliding
  Response response;
  std::optional<Series> at_times;  ///< where [output] times asks for them: those that the run has come to
  std::optional<Series> dense;     ///< where [output] every asks for it: at equal times
  Summary summary;
  std::optional<CoupledHistoryTable> coupled;  ///< where the caisson slipped as a whole
  std::optional<ContactHistory> contact;       ///< where it was marched with a law of contact
  std::optional<PressureModel> pressures;      ///< where it was reduced
  std::optional<StateModel> states;            ///< where it was, and fields or a strength are asked for
  std::string scheme_reason;                   ///< why it was solved as it was
  std::string step_reason;                     ///< why the steps are as long as they are
  std::shared_ptr<const CellsCompared> cells;  ///< where it was compared with cells half as large
};

/// Throws InputError where a scene asks for more than 1,000,000 steps or 10,000 fields, at the key that drives it; of
/// automatic steps as far as the loads alone show. Needs no mesh.
void check_size(const Scene& scene);

/// The same scene, its soil converged with the strain of its response: marched with the stiffness and damping of every
/// cell, whose largest shear strains tell, by their effective part, the stiffness and damping to begin anew with, until
/// the peak of F_T (without a caisson: the largest strain) changes by less than 1 %, or 15 times. Seed and Idriss
/// (1969); Schnabel, Lysmer and Seed (1972). As it is where no region has a strain law, or where it has been done.
/// Throws NumericsError.
Simulation with_converged_soil(const Simulation& simulation, const std::function<void(double)>& progress = {});

/// The same scene with its caisson bonded to the ground, where it may slip and lift.
Simulation bonded(const Simulation& simulation);

/// What may be wrong with the numbers of a scene, as far as that is known without solving: docs/warnings.md.
/// `peak_time`: of F_T, where it is known.
NumberedWarnings warnings(const Simulation& simulation, const std::optional<double>& peak_time = {});

/// What is skipped in a scene and why, with the numbers; `reduced`: whether a reduced model solves it.
std::vector<Skipped> skipped(const Simulation& simulation, bool reduced);

}  // namespace upbead

// A scene on its mesh, and its solution: no files, no text. docs/install.md has a program that uses it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "upbead/base/memo.h"
#include "upbead/dynamics/march.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/fem/resolve.h"
#include "upbead/mesh/mesh.h"
#include "upbead/output/summary.h"
#include "upbead/system/system.h"

namespace upbead {

class Space;
class Unknowns;
class YieldingSoil;
struct CompiledScene;
struct CellsCompared;
struct SoilMember;

/// Error of F_T caused by the size of the cells.
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
  /// Meshes that were compared with cells half as large; the last, which is used, may have its error from the one
  /// before.
  std::vector<Level> levels;
  std::shared_ptr<const CellsCompared> compared;  ///< of the last
};

class SlipAhead;
class Monitors;
struct Run;
class Simulation;
struct Solution;

using SoilFollower = std::function<void(YieldingSoil&)>;

/// What a run reports while it is solved.
struct RunOptions {
  std::function<void(double)> progress;  ///< called repeatedly with the part done, 0 to 1; may throw to end the run
  /// Makes the observer of the march, or null for none. Called once before the march, with the scene as it is marched
  /// (its soil converged). The observer must outlive the run.
  std::function<MarchObserver*(const Simulation&)> observer;
  /// Called with the soil that yields before the march, and again where another way is tried. Its stresses may be read
  /// whenever the observer sees a state. The soil is destroyed with the march. May be null.
  SoilFollower soil;
  Checkpointing checkpoints;
};

/// A scene on its mesh, assembled: everything is decided, and nothing changes. Other soil, cells or contact make
/// another Simulation; copies share all large members.
class Simulation {
 public:
  /// What a simulation is made of.
  struct Parts {
    Scene given;                      ///< as it was asked for: resolved anew on other meshes, else for the echo
    Scene scene;                      ///< as solved: everything that it left open is decided
    std::vector<Decision> decisions;  ///< about its regions
    std::shared_ptr<const Processes> processes;  ///< among which the system is divided; null: not divided
    std::shared_ptr<const Mesh> given_mesh;      ///< from which the refinement for the tolerance started; else `mesh`
    std::shared_ptr<const Mesh> mesh;
    std::vector<bool> absent;     ///< cells left out
    SoilState soil_state;         ///< what differs from cell to cell
    bool with_interface = false;  ///< the caisson may slip and lift; the mesh for the tolerance is made with it bonded
    std::shared_ptr<const Space> space;  ///< this and the next two: made of all members above
    std::shared_ptr<const Unknowns> unknowns;
    std::shared_ptr<const CompiledScene> compiled;
    /// What is solved in place of `compiled`, where one model answers all soils (src/run/soil_member.h): `compiled` is
    /// then of another soil, and tells loads and readings alone; null: the scene itself is solved.
    std::shared_ptr<const SoilMember> member;
    std::shared_ptr<BasisRoom> room;       ///< for the basis of `compiled` as it was assembled; null: none is kept
    std::optional<SoilSummary> soil;       ///< where the soil has converged with the strain of the response
    std::optional<MeshAccuracy> accuracy;  ///< where the mesh was made for the tolerance
    Timing timing;
  };

  /// Checks the scene on the mesh, decides what it leaves open, and assembles. Where scene.mesh.refine has no number,
  /// the cells of this mesh are split as the tolerance asks. `among`: the processes among which the system is divided;
  /// all of them make this call. Throws InputError whose places are keys of the scene, such as "boundaries.left".
  Simulation(Scene asked, std::shared_ptr<const Mesh> on, std::shared_ptr<const Processes> among = nullptr);

  /// The same, after another simulation: where both have the same System but for the course in time of its loads
  /// (system_scene.h in src/fem), and `before` keeps room for a basis, System and room are taken from there. Every
  /// number is the same to the last bit as without `before`.
  Simulation(Scene asked, std::shared_ptr<const Mesh> on, const Simulation& before);

  explicit Simulation(Parts parts) : parts_(std::move(parts)) {}

  /// Solves it, and finds what is to be said: solve() below, then find() of upbead/findings/find.h.
  Run run(const RunOptions& options = {}) const;

  const Parts& parts() const { return parts_; }
  const Scene& given() const { return parts_.given; }
  const Scene& scene() const { return parts_.scene; }
  const std::vector<Decision>& decisions() const { return parts_.decisions; }
  const std::shared_ptr<const Processes>& processes() const { return parts_.processes; }
  const std::shared_ptr<const Mesh>& given_mesh() const { return parts_.given_mesh; }
  const std::shared_ptr<const Mesh>& mesh() const { return parts_.mesh; }
  const std::vector<bool>& absent() const { return parts_.absent; }
  const SoilState& soil_state() const { return parts_.soil_state; }
  bool with_interface() const { return parts_.with_interface; }
  const std::shared_ptr<const Space>& space() const { return parts_.space; }
  const std::shared_ptr<const Unknowns>& unknowns() const { return parts_.unknowns; }
  const std::shared_ptr<const CompiledScene>& compiled() const { return parts_.compiled; }
  /// Its equations, with what is read off their answer: row system().reading("shear_force") of the readings is F_T.
  const System& system() const;
  const std::shared_ptr<const SoilMember>& member() const { return parts_.member; }
  const std::shared_ptr<BasisRoom>& room() const { return parts_.room; }
  const std::optional<SoilSummary>& soil() const { return parts_.soil; }
  const std::optional<MeshAccuracy>& accuracy() const { return parts_.accuracy; }
  const Timing& timing() const { return parts_.timing; }

  /// Another simulation, of the same parts but for those that change(Parts&) sets.
  template <class Change>
  Simulation with(const Change& change) const {
    Parts parts = parts_;
    change(parts);
    return Simulation(std::move(parts));
  }

 private:
  Parts parts_;
};

/// What only the march of soil that yields knows.
struct YieldingSolution {
  NonlinearSummary found;
  std::optional<ResidualSummary> residual;  ///< of a caisson
  std::vector<CompactedSoil> densification;
};

/// What only the solution with a law of contact knows.
struct ContactSolution {
  ContactSummary found;
  std::optional<ContactHistory> history;   ///< where it was marched with that law
  std::shared_ptr<const Solution> bonded;  ///< then: the bonded caisson, whose F_T the formulas of sliding take
};

/// What was solved, and what was done for it. What is said of it: upbead/findings/find.h.
struct Solution {
  std::shared_ptr<const Simulation> simulation;  ///< as solved: its soil converged, its bottom bonded or not
  Response response;
  Discretisation discretisation;
  Ladder ladder;  ///< the ways tried; the last one was taken
  Timing timing;
  std::optional<ReductionSummary> reduction;  ///< where it was reduced, as the next four
  int n_spared = 0;                           ///< of its solves, those that an earlier reduction had done
  std::optional<ModalModel> model;
  std::optional<PressureModel> pressures;
  std::optional<StateModel> states;  ///< where fields or a strength are asked for
  std::optional<YieldingSolution> yielding;
  std::optional<ContactSolution> contact;
  std::optional<ConstructionSummary> construction;  ///< where that was solved for the stresses of soil that yields
  std::shared_ptr<const Monitors> monitors;         ///< what was looked at in each state, where it was marched
  std::shared_ptr<SlipAhead> ahead;  ///< the space of a caisson that slips as a whole, where it was begun
  /// What findings have made of the solution alone, whatever [sliding] says; copies share it.
  std::shared_ptr<Memo> found = std::make_shared<Memo>();
};

/// Lets the soil converge with the strain of its response, and solves in time. Where a way is refused, the next one is
/// tried. Throws NumericsError where no answer balances (require_balance of response/shear_response.h).
Solution solve(const Simulation& simulation, const RunOptions& options = {});

/// Whether already the solution depends on [sliding], and not only what is said of it: friction node by node slips by
/// it, and a mesh for the tolerance is made for S, too.
bool needs_sliding(const Scene& scene);

/// The same solution of a scene that, unless needs_sliding(), may differ in [sliding]. Throws InputError at keys of the
/// scene.
Solution with_sliding(Solution solution, const Scene& given);

/// All readings in rows between which straight lines follow the response within the scene's tolerance.
struct HistoryRows {
  Series series;
  double error = 0.;  ///< of the straight lines, over the largest value of each reading; negative: ends of steps
};

/// A solution, and what is said of it.
struct Run : Solution {
  Summary summary;
  HistoryRows history;  ///< the rows of /history of results.h5
};

/// Throws InputError where a scene asks for more than 1,000,000 steps or 10,000 fields, at the key that causes it.
/// Automatic steps are counted as far as they follow from the loads. Needs no mesh.
void check_size(const Scene& scene);

/// The same scene, its soil converged with the strain of its response. Each iteration marches the scene with the
/// stiffness and damping of every cell; the effective part of a cell's largest shear strain then gives its stiffness
/// and damping for the next iteration. It ends when the peak of F_T (without a caisson: the largest strain) changes by
/// less than 1 %, or after 15 iterations. Seed and Idriss (1969); Schnabel, Lysmer and Seed (1972). Unchanged where no
/// region has a strain law, or where the soil has converged already. Throws NumericsError.
Simulation with_converged_soil(const Simulation& simulation, const std::function<void(double)>& progress = {});

/// The same scene with its caisson bonded to the ground, where it may slip and lift.
Simulation bonded(const Simulation& simulation);

}  // namespace upbead

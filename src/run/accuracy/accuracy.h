// How wrong F_T and S are, by source; the mesh that a tolerance asks for.
#pragma once

#include "fem/compile.h"
#include "upbead/base/history.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// F_T of one solution.
struct ShearHistory {
  History history;   ///< N/m
  double peak = 0.;  ///< that shear_to_force_ratio takes, found inside the steps (N/m)
};
ShearHistory shear_history(const CompiledScene& compiled, const Response& response);
ShearHistory marched_shear(const CompiledScene& compiled, SchemeKind kind, const TimeGrid& grid);

/// Differences of the peaks, over that of `better`, and at all times, over its largest |F_T|; of times that both do not
/// share, linear between them.
ShearError difference(const ShearHistory& answer, const ShearHistory& better);

/// Splits the cells of a coarse mesh that make F_T wrong (mesh_error) until F_T moves little enough on cells half
/// as large (error_of_cells), and assembles the scene on that; `accuracy` of what it returns is set. Throws InputError
/// where that cannot be measured or takes too many unknowns.
Simulation adapted(const Scene& given, std::shared_ptr<const Mesh> coarse);

/// The scene on its mesh with every cell split into four, undivided. Soil that has followed the strain keeps what it
/// came to in each cell; an interface stays, or is as is said.
Simulation with_halved_cells(const Simulation& simulation);
Simulation with_halved_cells(const Simulation& simulation, bool with_interface);

/// The same on the same cells.
Simulation assembled_again(const Simulation& simulation);

/// What a scene answers on its mesh and on cells half as large, bonded.
struct CellsCompared {
  /// What reduced models answer: on both meshes with as many vectors, until their difference is known, and on the
  /// scene's own until F_T is.
  struct Reduced {
    Response coarse, finer, own;
  };

  ShearError error;                ///< a bound, see with_margin()
  std::optional<Reduced> reduced;  ///< none where they were marched
};

/// How wrong the cells of a scene make F_T: by so much it moves on cells half as large, times what is measured in
/// docs/accuracy.md. Both are solved alike, by reduced models, or marched where these do not tell it. Throws
/// NumericsError as a march does.
CellsCompared compare_cells(const Simulation& simulation);

/// A bound of the error, of what an answer moved by on cells half as large.
ShearError with_margin(const ShearError& moved);

/// A caisson that slips as a whole, on both meshes and on the scene's own until it is known (m).
struct SlipCompared {
  double coarse = 0., finer = 0., own = 0.;
};

/// As compare_cells() does by reduced models; `bonded`: as it is without slip. None where they do not tell it.
std::optional<SlipCompared> compare_slip(const Simulation& simulation, const Response& bonded);

/// Fills in how wrong S is by eq. (4) on F_T(t) and of the caisson that slips as a whole, with [sliding]; the errors of
/// F_T must be there. S moves by so much on cells half as large, and where F_T, uplift and normal force are all larger
/// or smaller by the estimated error of the peak: near the threshold the one is zero while the other is not.
void estimate_slip_error(Run& run);

/// Fills in why nothing is told of it.
void tell_why_no_slip_error(Run& run);

/// Fills in what a run's F_T and S are wrong by, where its mesh was made for the tolerance (`simulation.accuracy`) or
/// the case asks for it (accuracy.estimate); else why that is not told. From
/// - the cells: F_T and S on cells half as large;
/// - the steps of a march: F_T moves by so much with steps half as long, on the coarse mesh that the refinement started
///   from; of contact node by node on the mesh itself;
/// - the vectors of a reduced model: its F_T against that of the last smaller one;
/// - the far sides, of the peak alone, on the coarse mesh: sides that hold what comes (roller, sealed) and sides that
///   give way (free, open) send back waves of opposite signs, so that the mean of both is without (Smith 1974); F_T of
///   the case differs from it by so much at the time of its peak. Far sides may be meant as they are, and the truth
///   that the other parts are about has them, too.
void estimate_errors(Run& run);

}  // namespace upbead

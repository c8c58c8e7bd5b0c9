// What the cells change in F_T and S, and the mesh that meets a tolerance.
#pragma once

#include "fem/compile.h"
#include "upbead/algebra/layout.h"
#include "upbead/base/history.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// F_T of one solution.
struct ShearHistory {
  History history;   ///< N/m
  double peak = 0.;  ///< the one in shear_to_force_ratio, found inside the steps (N/m)
};
ShearHistory shear_history(const CompiledScene& compiled, const Response& response);
ShearHistory marched_shear(const CompiledScene& compiled, SchemeKind kind, const TimeGrid& grid);

/// Difference of the peaks, over the peak of `better`, and largest difference at any time, over its largest |F_T|;
/// linear interpolation at times that only one of them has.
ShearError difference(const ShearHistory& answer, const ShearHistory& better);

/// Splits those cells of a coarse mesh that contribute most to the error of F_T (mesh_error), until F_T on cells half
/// as large differs little enough (compare_cells), there or on a mesh not much coarser (carry), and assembles the scene
/// on that mesh; sets `accuracy` of the result. Of several processes each makes the whole, by the errors that the first
/// one finds. Throws InputError where the error cannot be measured or the mesh needs too many unknowns.
Simulation adapted(const Scene& given, std::shared_ptr<const Mesh> coarse, const Layout& among = {});

/// The scene on its mesh with every cell split into four, undivided. Soil that has followed the strain keeps its
/// state in each cell; the interface is kept, or is as `with_interface` says.
Simulation with_halved_cells(const Simulation& simulation);
Simulation with_halved_cells(const Simulation& simulation, bool with_interface);

/// The same without splitting the cells.
Simulation assembled_again(const Simulation& simulation);

/// The results of a bonded scene on its mesh, or on one that is coarser, and on cells half as large.
struct CellsCompared {
  /// Responses of reduced models: on both meshes with equally many vectors, until the difference between both is
  /// known, and on the scene's own mesh until F_T is; `own` is empty until then.
  struct Reduced {
    Response coarse, finer, own;
  };

  ShearError error;                ///< a bound, see with_margin()
  std::optional<Reduced> reduced;  ///< none where both meshes were marched
  /// Both meshes, with rooms that hold the bases of F_T; only where slip can be asked of the scene. `coarse` is null
  /// where it is the scene's own mesh.
  std::shared_ptr<const Simulation> coarse, finer;
  double share_of_slip = 1.;  ///< of the change of S, which the scene's own mesh has left
};

/// The error that the cells cause in F_T: the difference to F_T on cells half as large, times a factor measured in
/// docs/accuracy.md. Both meshes are solved alike, by reduced models, or marched where reduced models do not give the
/// difference. Throws NumericsError as a march does.
CellsCompared compare_cells(const Simulation& simulation);

/// The same with only the chosen cells split, without `own`.
CellsCompared compare_cells(const Simulation& simulation, const std::vector<bool>& split);

/// Finds `own` of `reduced`, which is none after that where reduced models do not give F_T.
void complete(CellsCompared& compared, const Simulation& simulation);

/// What was compared on the mesh of `coarse`, for a finer mesh whose cells have this share of the errors that those of
/// `coarse` have (mesh_error), at least a quarter; without `own`.
CellsCompared carried(const CellsCompared& compared, const Simulation& coarse, double share);

/// What each process has compared for itself: takes the errors that the first one has found, and reduced models only
/// where all have them, as what follows is done by all or by none.
void agree(CellsCompared& compared, const Layout& among);

/// A bound of the error, from the change on cells half as large.
ShearError with_margin(const ShearError& moved);

/// S of a caisson that slips as a whole: on both meshes, and on the scene's own until it is known (m).
struct SlipCompared {
  double coarse = 0., finer = 0., own = 0.;
};

/// As compare_cells() does by reduced models, beside those of `cells`, which has them. None where they do not give S.
std::optional<SlipCompared> compare_slip(const Simulation& simulation, const CellsCompared& cells);

}  // namespace upbead

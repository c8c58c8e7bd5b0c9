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
/// as large differs little enough (compare_cells), and assembles the scene on that mesh; sets `accuracy` of the
/// result. Of several processes each makes the whole, by the errors that the first one finds. Throws InputError where
/// the error cannot be measured or the mesh needs too many unknowns.
Simulation adapted(const Scene& given, std::shared_ptr<const Mesh> coarse, const Layout& among = {});

/// The scene on its mesh with every cell split into four, undivided. Soil that has followed the strain keeps its
/// state in each cell; the interface is kept, or is as `with_interface` says.
Simulation with_halved_cells(const Simulation& simulation);
Simulation with_halved_cells(const Simulation& simulation, bool with_interface);

/// The same without splitting the cells.
Simulation assembled_again(const Simulation& simulation);

/// The results of a bonded scene on its mesh and on cells half as large.
struct CellsCompared {
  /// Responses of reduced models: on both meshes with equally many vectors, until the difference between both is
  /// known, and on the scene's own mesh until F_T is.
  struct Reduced {
    Response coarse, finer, own;
  };

  ShearError error;                ///< a bound, see with_margin()
  std::optional<Reduced> reduced;  ///< none where both meshes were marched
  /// Cells half as large, with room that holds the basis of F_T; only where slip can be asked of the scene.
  std::shared_ptr<const Simulation> finer;
};

/// The error that the cells cause in F_T: the difference to F_T on cells half as large, times a factor measured in
/// docs/accuracy.md. Both meshes are solved alike, by reduced models, or marched where reduced models do not give the
/// difference. Throws NumericsError as a march does.
CellsCompared compare_cells(const Simulation& simulation);

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

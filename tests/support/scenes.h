// Scenes for tests, built in code, and the few steps that run them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "upbead/base/error.h"
#include "upbead/dynamics/march.h"
#include "upbead/dynamics/time_grid.h"
#include "upbead/fem/load_on_caisson.h"
#include "upbead/fem/resolve.h"
#include "upbead/mesh/mesh.h"
#include "upbead/response/findings.h"
#include "upbead/system/system.h"

namespace upbead {

class Space;
class Unknowns;
struct CompiledScene;

namespace test {

/// A triangle of that peak, duration and rise (half the duration where none is given), starting at t = 0.
TimeFunction triangle(double peak, double duration, double rise = 0.);

/// Saturated sand and rubble with the numbers of the shipped prototype.
Region sand();
Region rubble();

/// A column of one soil, drained and loaded by `top_pressure` (Pa, total stress) at the top.
Scene column(const Region& soil, const TimeFunction& top_pressure);
/// `grading`: size of the lowest cell over that of the highest; the thin drained skin at the top needs small cells.
std::unique_ptr<Mesh> column_mesh(double height, int cells, double grading = 1.);

/// The prototype breakwater of the shipped cases under a force on its front.
Scene breakwater(const TimeFunction& force);
/// Adds water on both sides with an open level and closed ends.
void add_sea(Scene& breakwater);
/// `cells`: relative density of composite.geo, whose other parameters may be changed.
std::unique_ptr<Mesh> breakwater_mesh(double cells, std::map<std::string, double> parameters = {});
/// Its parameters with a sea of three depths on both sides.
std::map<std::string, double> with_sea();

/// A scene compiled on a mesh; with an interface under the caisson if asked for. Copies share all but `resolved`.
struct Compiled {
  Compiled(const Scene& scene, const Mesh& mesh, bool interface = false);
  Compiled(const ResolvedScene& scene, const Mesh& mesh, bool interface = false);
  Scene resolved;
  struct Parts;
  std::shared_ptr<Parts> parts;
  const Space& space;        ///< of fem/space.h, as the next two of their headers
  const Unknowns& unknowns;  ///< fem/unknowns.h
  CompiledScene& scene;      ///< fem/compile.h
  System& system;            ///< of `scene`, as the next one
  const std::vector<LoadOnCaisson>& loads_on_caisson;
};

/// Marches from rest with steps of at most `step`.
Response run(const Compiled& compiled, double end, double step, SchemeKind scheme = SchemeKind::sdirk4);

/// F_T of such a march, and what else a coastal engineer reads off it; of a scene with a caisson.
ShearResponse shear_of(const Compiled& compiled, const Response& response);

/// The mistakes for which a scene is refused on a mesh.
std::vector<Diagnostic> mistakes(const Scene& scene, const Mesh& mesh);

/// The history of one reading at the ends of the steps.
Eigen::RowVectorXd history(const Compiled& compiled, const Response& response, const std::string& reading);

}  // namespace test
}  // namespace upbead

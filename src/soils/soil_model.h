// One reduced model for all soils of a case: where it can be made, how, and a scene as a member of it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/soil_model_file.h"
#include "response/soil_family.h"
#include "upbead/base/error.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Coefficients of all regions of a resolved scene.
std::map<std::string, Coefficients> coefficients_of(const Scene& resolved);

/// Why no model can answer other soils of that scene, at its keys; empty where one can.
std::vector<Diagnostic> why_no_soils(const Simulation& simulation);

/// Why a scene is none of the same with another soil: it differs in more than constants of its regions, or numbers
/// decide otherwise about flow, deformation or compressibility; "" where it is one. Both are resolved on one mesh.
std::string why_not_of_family(const Scene& resolved, const Scene& other);

/// The estimated error that a member's model of all soils brings: of the histories of held_readings() over their peaks.
double error_of_soils(const Simulation& member);

/// A scene's given form that is resolved with all cells: soils differ in how far waves come.
Scene with_all_cells(Scene given);

/// A case's simulation with all cells; the mesh is read where it is null.
Simulation simulation_with_all_cells(const Case& input, const std::shared_ptr<const Mesh>& mesh);

/// Share of a scene's tolerance that the basis of all soils may take.
constexpr double share_of_tolerance = 0.6;

struct SoilModelOptions {
  double tolerance = 2e-3;  ///< of the histories of held_readings() over their peaks, for each of the soils
  std::optional<double> of_estimates{};  ///< see SoilFamilyOptions
  int most_points = 12;
  std::function<void(double)> progress{};  ///< 0 to 1; may be empty
};

/// How a family was made of a scene's soils.
struct SoilsMade {
  SoilFamilyFile family;
  std::vector<int> points;  ///< soils that were solved: 0: the first scene, 1: the first of the others
};

/// Makes a scene's System as a sum over its soils, and one basis for all of them. `first`: assembled with all cells;
/// `soils`: scenes as given, on the same mesh, that differ in soils alone. They are the candidates for points of the
/// basis and say which constants vary. Throws InputError where one is no member, and NumericsError where the sum does
/// not equal an assembled System, or a soil cannot be reduced.
SoilsMade make_soils(const Simulation& first, const std::vector<Scene>& soils, const SoilModelOptions& options);

/// A case's scene and a family for all its soils.
class SoilModel {
 public:
  /// Throws InputError where the family has other loads or readings than the scene.
  SoilModel(const Simulation& first, SoilFamilyFile family);

  /// The scene as a member: what is solved in place of its System, and the error that it brings. Throws InputError as
  /// Simulation does and where it is no member.
  Simulation member(const Scene& given) const;

  const Simulation& first() const { return first_; }

 private:
  Simulation first_;
  std::vector<AffineTerm> terms_;  ///< by part of the family
  SoilFamily family_;
  std::shared_ptr<const FieldBasis> phi_;  ///< see SoilMember
};

}  // namespace upbead

// The System of a scene as a sum over constants of its soils.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "fem/coefficients.h"
#include "fem/compile.h"
#include "system/affine_system.h"

namespace upbead {

/// Which coefficients of a region's constants vary.
using Varied = std::array<bool, n_coefficients>;

/// A scene whose System is a sum of parts, multiplied by coefficients of the regions that vary. All that is decided by
/// numbers is frozen as the scene has it: flow, deformation, compressibility, cells left out.
struct AffineScene {
  CompiledScene fixed;            ///< all but the parts
  std::vector<AffineTerm> terms;  ///< by part
  std::vector<System> parts;      ///< without loads of their own

  /// The coefficients of soils that differ in nothing else, by part.
  std::vector<double> factors(const std::map<std::string, Coefficients>& of_region) const;
  /// Assembled of the parts.
  CompiledScene at(const std::vector<double>& factors) const;
};

/// Assembles the parts. `scene` is resolved and `varied` are those of its regions whose constants vary; parts that are
/// zero everywhere are left out. `with_interface` as in assemble_scene().
AffineScene affine_scene(const Scene& scene, const Mesh& mesh, const std::vector<bool>& absent,
                         const std::map<std::string, Varied>& varied, bool with_interface);

}  // namespace upbead

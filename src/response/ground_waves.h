// Waves in the ground: whether cells resolve them, when their echo from the far sides is back, and where they are
// read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fem/compile.h"
#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// A region thinner than a quarter of the caisson's width, and at most a fifth as stiff as the stiffest ground: it is
/// sheared and squeezed as a film, and disturbances at the film's ends decay within about its own thickness.
struct ThinLayer {
  std::string region;
  double thickness = 0.;  ///< mean, under the caisson and half its width beside it (m)
  double longest = 0.;    ///< horizontal extent of the longest cell there (m)
  double contrast = 1.;   ///< shear modulus of the stiffest ground over its own; infinite if there is no other ground
  double cells_per_thickness() const { return thickness / longest; }
};

/// By name of the region. Needs a caisson.
std::vector<ThinLayer> thin_layers(const Space& space, const Caisson& caisson);

struct BoundaryReflection {
  std::string side;
  double distance = 0.;    ///< from the side to the nearest part that is not just ground going on (m)
  double speed = 0.;       ///< of shear waves in the ground at the side, mean over its area (m/s)
  bool absorbing = false;  ///< it lets waves out, but not completely
  double time() const { return 2. * distance / speed; }  ///< of shear waves, there and back (s)
};

/// The far side whose echo is back first, of the upright sides at which ground ends. Sides of water alone have no
/// effect (docs/sides.md), and absorbing sides of dry ground are good enough; neither counts. Distances are from the
/// toe of the mound, or from whatever else stands on the ground. None without a caisson. `scene` as solved, from
/// which `space` was made.
std::optional<BoundaryReflection> first_reflection(const Scene& scene, const Space& space);

/// A load on a side of ground that deforms, and a region in which the waves from this load are read.
struct LoadedGround {
  std::string load;
  std::string region;                   ///< where a probe stands; with fields any region that deforms
  std::string onlooker;                 ///< "probe 'A'", the nearest of several, or "the fields"
  bool pushes = false, shears = false;  ///< whether it acts along the side's mean normal, and along the side
  bool is_plane = false;                ///< its ends are as far apart as the mesh is wide, so waves do not spread
  double cell = 0.;                     ///< h of the largest cell on the way through the region, along the normal (m)
  double nearest = 0., farthest = 0.;   ///< onlooker, from the side (m); with fields from the side to the mesh's end
};

/// All of a scene as solved, for loads that are not switched off. Loads on rigid bodies and on free water are left
/// out: a rigid body sends out smoother waves than the loads on it.
std::vector<LoadedGround> loaded_grounds(const Scene& scene, const Mesh& mesh);

/// A region within one wavelength of the caisson's bottom, and its cells.
struct WaveResolution {
  std::string region;
  double speed = 0.;       ///< V_s, mean over its area (m/s)
  double wavelength = 0.;  ///< V_s D + B (m)
  double cell = 0.;        ///< root of the area of the largest cell there (m)
  double cells_per_wave() const { return wavelength / cell; }
};

/// For every region that deforms. D is the shortest duration of the loads (s), B the width of the caisson's bottom: a
/// body as wide as that sends out no shorter waves, however short the load is. Measured on the shipped section, D
/// from 0.02 to 0.4 s: docs/warnings.md. Needs a caisson.
std::vector<WaveResolution> wave_resolution(const Space& space, const Caisson& caisson, double duration);

/// Distance from the line between a and b (m).
double distance_to_line(const dealii::Point<dim>& point, const dealii::Point<dim>& a, const dealii::Point<dim>& b);

/// V_s of a cell that deforms (m/s), 0 for any other cell.
double shear_speed(const Space& space, const Space::MeshCell& cell);

}  // namespace upbead

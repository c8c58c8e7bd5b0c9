// Waves in the ground: how finely it is meshed for them, when they are back from its sides, who looks at them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fem/compile.h"
#include "upbead/mesh/mesh.h"
#include "upbead/model/scene.h"

namespace upbead {

/// A region that is thinner than a quarter of the caisson's width, and at most a fifth as stiff as the stiffest ground:
/// it is sheared and squeezed as a film, and what happens at the film's ends decays within about its own thickness.
struct ThinLayer {
  std::string region;
  double thickness = 0.;  ///< mean over what of it lies below the caisson and half its width beside it (m)
  double longest = 0.;    ///< horizontal extent of the longest cell there (m)
  double contrast = 1.;   ///< of the stiffest ground's shear modulus over its own; infinite where it is all ground
  double cells_per_thickness() const { return thickness / longest; }
};

/// By name. Needs a caisson.
std::vector<ThinLayer> thin_layers(const Space& space, const Caisson& caisson);

struct BoundaryReflection {
  std::string side;
  double distance = 0.;    ///< from the side to the nearest of all that is not only ground going on (m)
  double speed = 0.;       ///< of shear waves in the ground behind it, mean over its area (m/s)
  bool absorbing = false;  ///< it lets waves out, but not all
  double time() const { return 2. * distance / speed; }  ///< that shear waves take there and back (s)
};

/// The far side that is felt first, of the upright sides where the ground ends; those of water alone are not felt
/// (docs/sides.md), and absorbing ones of dry ground are good enough. Distances are from the toe of the mound, or from
/// what else stands on the ground. None without a caisson. `scene` as solved, of which the space is.
std::optional<BoundaryReflection> first_reflection(const Scene& scene, const Space& space);

/// A load on a side of ground that deforms, and a region in which somebody looks at the waves that it sends out.
struct LoadedGround {
  std::string load;
  std::string region;                   ///< in which a probe stands; with fields any that deforms
  std::string onlooker;                 ///< "probe 'A'", of several the nearest, or "the fields"
  bool pushes = false, shears = false;  ///< whether it acts along the side's mean normal, and along the side
  bool is_plane = false;                ///< its ends are as far apart as the mesh is wide: waves do not spread
  double cell = 0.;                     ///< h, of the largest cell of the region on the way, along the normal (m)
  double nearest = 0., farthest = 0.;   ///< onlookers, from the side (m); with fields from the side to the mesh's end
};

/// All of a scene as solved, with loads that are switched on. A rigid body sends out smoother waves than the loads on
/// it and makes none; nor does free water.
std::vector<LoadedGround> loaded_grounds(const Scene& scene, const Mesh& mesh);

/// One region within a wavelength of the caisson's bottom.
struct WaveResolution {
  std::string region;
  double speed = 0.;       ///< V_s, mean over its area (m/s)
  double wavelength = 0.;  ///< V_s D + B (m)
  double cell = 0.;        ///< root of the area of the largest cell there (m)
  double cells_per_wave() const { return wavelength / cell; }
};

/// Of every region that deforms. D is the shortest duration of the loads (s), B the width of the caisson's bottom: a
/// body as wide as that sends out no shorter waves, however short the load is. So measured on the shipped section, D
/// from 0.02 to 0.4 s: docs/warnings.md. Needs a caisson.
std::vector<WaveResolution> wave_resolution(const Space& space, const Caisson& caisson, double duration);

/// From the line between a and b (m).
double distance_to_line(const dealii::Point<dim>& point, const dealii::Point<dim>& a, const dealii::Point<dim>& b);

/// V_s of a cell that deforms (m/s), 0 of any other.
double shear_speed(const Space& space, const Space::MeshCell& cell);

}  // namespace upbead

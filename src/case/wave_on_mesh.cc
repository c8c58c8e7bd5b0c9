// Loads by waves on the walls of a mesh.
#include <cmath>

#include "base/text.h"
#include "case/wave_load.h"
#include "fem/compile.h"
#include "fem/outline.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

namespace {

/// By what share of the wall's height or of P two lengths or resultants of one wall may differ; a mesh file has 1e-9.
constexpr double same_wall = 1e-6;

constexpr double same_weight = 0.01;

std::string at_height(double y) {
  return "y = " + significant(y, 6);
}

/// Compares the wall of a load by a wave with the section.
class WallCheck {
 public:
  WallCheck(const WaveLoad& wave, const Bounds& wall, Diagnostics& mistakes)
      : path_(wave.title), wave_(wave), wall_(wall), tolerance_(same_wall * height()), mistakes_(mistakes) {}

  double height() const { return wave_.section.foundation_depth + wave_.section.crest; }

  void run(const Scene& scene, const Outline& outline) const {
    const auto caisson = scene.regions.find(caisson_name);
    const bool has_ground = caisson == scene.regions.end() || !caisson->second.springs;
    if (wall_.right - wall_.left > tolerance_)
      mistakes_.add(at_key(path_ + ".boundary"),
                    "'" + wave_.load.boundary + "' is not upright: it reaches from x = " + significant(wall_.left, 6) +
                        " to " + significant(wall_.right, 6) + " m, and Goda's formulas are those of an upright wall",
                    "name the curve of the caisson's seaward wall");
    if (differ(wall_.highest - wall_.lowest, height()))
      mistakes_.add(at_key("section.crest"),
                    "foundation_depth + crest = " + significant(height(), 6) + " m, but the wall '" +
                        wave_.load.boundary + "' is " + significant(wall_.highest - wall_.lowest, 6) +
                        " m high, from " + at_height(wall_.lowest) + " to " + significant(wall_.highest, 6) + " m",
                    "give the section that is meshed, or the mesh of the section");
    if (const auto body = outline.surfaces.find(caisson_name); body != outline.surfaces.end() &&
                                                               body->second.left <= wall_.left + tolerance_ &&
                                                               body->second.highest > wall_.highest + tolerance_)
      mistakes_.add(at_key(path_ + ".boundary"),
                    "the caisson goes on above '" + wave_.load.boundary + "', up to " +
                        at_height(body->second.highest) +
                        " m: of a wall that is set back or slopes there Goda's formulas say nothing",
                    "name the whole seaward wall where it is one upright plane; else give the pressures on all of its "
                    "parts, by a source of your own: kind = \"pressures\" or \"pressure\"");
    if (scene.initial && scene.initial->water_level) check_level(*scene.initial->water_level, "initial.water_level");
    for (const auto& [name, region] : scene.regions)
      if (const auto sea = outline.surfaces.find(name); region.kind == RegionKind::water &&
                                                        sea != outline.surfaces.end() &&
                                                        sea->second.right <= wall_.left + tolerance_)
        check_sea(name, sea->second, has_ground);
  }

 private:
  bool differ(double a, double b) const { return std::abs(a - b) > tolerance_; }

  void check_level(double level, const std::string& of) const {
    const double still = wall_.lowest + wave_.section.foundation_depth;
    if (differ(level, still))
      mistakes_.add(at_key("section.foundation_depth"),
                    "still water stands at " + at_height(still) + " m, foundation_depth = " +
                        significant(wave_.section.foundation_depth, 6) + " m above the foot of '" +
                        wave_.load.boundary + "', but " + of + " at " + at_height(level) + " m",
                    "give one water level in both");
  }

  /// Beside a caisson on springs the sea ends at the height of its base.
  void check_sea(const std::string& name, const Bounds& sea, bool has_ground) const {
    check_level(sea.highest, "'" + name + "'");
    if (has_ground && differ(sea.highest - sea.lowest, wave_.section.water_depth))
      mistakes_.add(at_key("section.water_depth"),
                    "water_depth = " + significant(wave_.section.water_depth, 6) + " m, but the sea '" + name +
                        "' is " + significant(sea.highest - sea.lowest, 6) + " m deep",
                    "give one depth in both");
  }

  std::string path_;
  const WaveLoad& wave_;
  const Bounds& wall_;
  double tolerance_;
  Diagnostics& mistakes_;
};

/// Bounds of the faces of a curve; empty where there is no such curve.
Bounds extent_of_curve(const Mesh& mesh, const std::string& curve) {
  Bounds extent;
  for (const auto& cell : mesh.triangulation.active_cell_iterators())
    for (const auto& face : cell->face_iterators())
      if (mesh.curve_of(face) == curve)
        for (unsigned v = 0; v < 2; ++v) extent.add(face->vertex(v));
  return extent;
}

void set_row(const std::string& name, const Gauges& row, Scene& scene) {
  for (std::size_t i = 0; i < row.count(); ++i)
    if (const auto load = scene.loads.find(name + "." + row.name[i]); load != scene.loads.end())
      load->second.shape = share(row, i);
}

/// Sets the pressures of a wave on mound and bed.
void set_mound(const WaveLoad& wave, double wall, const Mesh& mesh, Scene& scene, Diagnostics& mistakes) {
  for (const std::string& curve : wave.table.mound) {
    const auto load = scene.loads.find(wave.name + "." + curve);
    const Bounds extent = extent_of_curve(mesh, curve);
    if (load == scene.loads.end() || extent.highest < extent.lowest) continue;
    const auto side = scene.boundaries.find(curve);
    if (side == scene.boundaries.end() || side->second.pressure != PressureCondition::open)
      mistakes.add(at_key(wave.title + ".wave.mound"), "no water passes through '" + curve + "'",
                   "write pressure = \"open\" in [boundaries." + curve + "], or leave it out");
    load->second.shape = profile_on_mound(wave, wall, std::min(extent.left, wall));
  }
}

}  // namespace

Scene with_profiles(const Case& input, const Mesh& mesh) {
  Scene scene = input.scene;
  const std::vector<const WaveLoad*> waves = sources_of_type<WaveLoad>(input);
  if (waves.empty()) return scene;
  const Outline outline = outline_of(mesh);
  Diagnostics mistakes;
  for (const WaveLoad* wave : waves) {
    const Bounds wall = extent_of_curve(mesh, wave->load.boundary);
    if (wall.highest < wall.lowest) continue;  // no such curve, which the scene's checks report
    WallCheck(*wave, wall, mistakes).run(scene, outline);
    if (wave->standing)
      set_row(wave->name, row_on_wall(*wave->standing, wall.lowest + wave->section.foundation_depth), scene);
    else
      scene.loads.at(wave->name).shape = pressure_profile(*wave, wall.lowest);
    set_mound(*wave, wall.left, mesh, scene, mistakes);
  }
  mistakes.throw_if_any();
  return scene;
}

namespace {

/// Force and moment on the meshed caisson per unit of P; for a standing wave per unit of pressure over the loaded
/// height.
LoadOnCaisson resultant_of(const WaveLoad& wave, const CompiledScene& compiled) {
  LoadOnCaisson sum{wave.name};
  const double height = wave.standing ? wave.standing->gauges.place.back() - wave.standing->gauges.place.front() : 1.;
  for (const LoadOnCaisson& load : compiled.loads_on_caisson) {
    if (load.name != wave.name && !(wave.standing && load.name.rfind(wave.name + ".", 0) == 0)) continue;
    sum.force_x += load.force_x / height;
    sum.moment += load.moment / height;
  }
  return sum;
}

void check_resultants(const WaveLoad& wave, const CompiledScene& compiled, Diagnostics& mistakes) {
  const LoadOnCaisson load = resultant_of(wave, compiled);
  const double arm = wave.standing ? 0.5 * (wave.standing->gauges.place.back() - wave.standing->gauges.place.front())
                                   : wave.pressure.force_moment / wave.pressure.force;
  if (std::abs(load.force_x - 1.) <= same_wall && std::abs(load.moment - arm) <= same_wall * arm) return;
  mistakes.add(at_key(wave.title + ".boundary"),
               "on the caisson as meshed acts " + significant(load.force_x, 6) + " of P, with " +
                   significant(load.moment, 6) + " m of moment above its bottom in place of " + significant(arm, 6),
               "name the curve of the caisson's seaward wall, whole, from its bottom to its crest");
}

}  // namespace

void check_waves(const Case& input, const Simulation& simulation) {
  Diagnostics mistakes;
  for (const WaveLoad* wave : acting_waves(input)) {
    const auto& caisson = simulation.compiled()->caisson;
    if (!caisson) {
      mistakes.add(at_key(wave->title + ".kind"), "a load by a wave acts on a caisson, and there is none",
                   "name its surface 'caisson'");
      continue;
    }
    if (std::abs(caisson->bottom_width - wave->section.width) > same_wall * wave->section.width)
      mistakes.add(at_key("section.width"),
                   "width = " + significant(wave->section.width, 6) + " m, but the caisson is " +
                       significant(caisson->bottom_width, 6) + " m wide at its bottom",
                   "give one width in both");
    const double weight = caisson->body.mass * input.scene.gravity;
    if (std::abs(weight - wave->section.weight) > same_weight * weight)
      mistakes.add(at_key("section.weight"),
                   "weight = " + significant(wave->section.weight, 5) + " N/m is not mass x g of the caisson, " +
                       significant(weight, 5) + " N/m",
                   "give one caisson in both, within 1 %");
    if (extent_of_curve(*simulation.mesh(), wave->load.boundary).left > caisson->bottom_centre[0])
      mistakes.add(at_key(wave->title + ".boundary"),
                   "'" + wave->load.boundary + "' is the landward wall of the caisson",
                   "name the seaward one: x points landward");
    check_resultants(*wave, *simulation.compiled(), mistakes);
  }
  mistakes.throw_if_any();
}

}  // namespace upbead

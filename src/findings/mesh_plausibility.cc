// Whether the numbers of a scene that only its mesh can judge are those of breakwaters: lengths, masses, levels, loads.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/compile.h"
#include "findings/finding.h"
#include "findings/plausibility.h"
#include "mesh/extent.h"
#include "model/quantities.h"

namespace upbead {

namespace {

/// Springs and dashpots of boundaries stand for ground beyond the mesh, of the width W: about G over a length that is
/// neither far beyond W nor far below a hundredth of it, and rho V of soils (Lysmer and Kuhlemeyer 1969).
void judge_boundaries(const Scene& scene, double width, NumberedWarnings& list) {
  constexpr double soil_density = 2e3;
  double least = infinity, largest = 0.;
  for (const auto& [name, region] : scene.regions)
    if (const double G = name == caisson_name ? 0. : stiffness_of(region); G > 0.) {
      least = std::min(least, G);
      largest = std::max(largest, G);
    }
  if (!(largest > 0.)) return;
  const double softest = least / width, stiffest = largest / width, slow = std::sqrt(soil_density * least),
               fast = std::sqrt(soil_density * largest);
  const Quantity spring{"Pa/m",
                        0.02 * softest,
                        1e5 * stiffest,
                        0.2 * softest,
                        1e3 * stiffest,
                        {{"kPa/m", 1e3}, {"MPa/m", 1e6}},
                        "about G of the ground over its depth or width"},
      dashpot{"Pa s/m",
              0.02 * slow,
              50. * fast,
              0.2 * slow,
              5. * fast,
              {{"kPa s/m", 1e3}, {"MPa s/m", 1e6}},
              "about density times wave speed of the ground"};
  for (const auto& [name, boundary] : scene.boundaries)
    for (const int i : {0, 1}) {
      const std::string at = "boundaries." + name + ".", way = i == 0 ? ", along the normal" : ", along the tangent";
      if (boundary.spring) judge(at + "spring" + way, (*boundary.spring)[static_cast<std::size_t>(i)], spring, list);
      if (boundary.dashpot)
        judge(at + "dashpot" + way, (*boundary.dashpot)[static_cast<std::size_t>(i)], dashpot, list);
    }
}

/// Numbers of a scene that only its mesh can judge, as it may be a model of any scale, in a centrifuge or not.
class OnItsMesh {
 public:
  OnItsMesh(const Simulation& simulation, NumberedWarnings& list)
      : simulation_(simulation), scene_(simulation.given()), list_(list) {
    for (const auto& cell : simulation.mesh()->triangulation.active_cell_iterators()) {
      all_.add(cell);
      regions_[simulation.mesh()->surface_of(cell)].add(cell);
    }
  }

  void run() {
    judge_extent();
    for (const auto& [name, region] : scene_.regions)
      if (regions_.count(name) > 0) judge_region("regions." + name + ".", region, regions_.at(name));
    judge_level();
    judge_boundaries(scene_, all_.width(), list_);
    judge_loads();
    judge_shapes();
  }

 private:
  static constexpr double tallest = 400., widest_caisson = 80.;  ///< m; the deepest breakwaters stand in 65 m of water

  /// Lengths of a model in a centrifuge are those of its prototype over gravity / g.
  void judge_extent() {
    const double scale = scene_.gravity / 9.81, height = all_.height();
    judge("gravity", scene_.gravity, quantities::gravity, list_);
    const bool in_feet = scene_.gravity > 32. && scene_.gravity < 32.4;
    if ((height <= tallest && scale * height > tallest && scene_.gravity <= quantities::gravity.high) || in_feet) {
      Quantity q = quantities::gravity;
      q.high = 9.81;
      return judge("gravity", scene_.gravity, q, list_);
    }
    const std::vector<MeantUnit> lengths{{"cm", 1e-2}, {"mm", 1e-3}};
    const Quantity tall{"m", 0., tallest / scale, 0.3, 150., lengths, "a mesh in metres"};
    const auto& caisson = regions_.find(caisson_name);
    const Quantity wide{"m", 0., widest_caisson / scale, 0.1, 60., lengths, "a mesh in metres"};
    if (height > tall.high)
      judge("mesh, its height", height, tall, list_);
    else if (caisson != regions_.end())
      judge("mesh, width of the caisson", caisson->second.width(), wide, list_);
  }

  void judge_region(const std::string& at, const Region& region, const Extent& extent) {
    if (region.mass)
      judge(
          at + "mass", *region.mass,
          of(quantities::density, extent.area, "kg/m", "over its area a density", {{"t/m", 1e3}, {"kN/m", 1e3 / 9.81}}),
          list_);
    if (region.moment_of_inertia) judge_inertia(at, region, extent);
    if (region.centre_of_gravity) judge_centre(at, *region.centre_of_gravity, extent);
    if (region.kind != RegionKind::porous || !region.porosity || !region.grain_density) return;
    // Less than five times the weight that it bears, soil would be squeezed to nothing: quantities.cc
    const double submerged = (1. - *region.porosity) * (*region.grain_density - scene_.fluid.density);
    const double least = 5. * submerged * scene_.gravity * extent.height();
    Quantity soil = quantities::soil_modulus;
    if (!(least > soil.low)) return;
    soil.low = least;
    soil.common_low = std::max(soil.common_low, least);
    soil.usual = "five times the soil's own weight over its height; sand has 1e7 to 3e8";
    const bool told = (region.shear_modulus && *region.shear_modulus < quantities::modulus.low) ||
                      (region.youngs_modulus && *region.youngs_modulus < quantities::modulus.low);
    if (told) return;
    if (region.shear_modulus && *region.shear_modulus < least)
      judge(at + "shear_modulus", region.shear_modulus, soil, list_);
    if (region.youngs_modulus && *region.youngs_modulus < 2. * least)
      judge(at + "youngs_modulus", region.youngs_modulus, soil, list_);
  }

  void judge_centre(const std::string& at, const std::array<double, 2>& centre, const Extent& extent) {
    const auto [x, y] = centre;
    if (x >= extent.left && x <= extent.right && y >= extent.low && y <= extent.high) return;
    list_.push_back({"implausible", y, y < extent.low ? extent.low : extent.high, "m",
                     at + "centre_of_gravity = " + place_text(x, y, 6) +
                         " lies outside the region, which reaches from " + place_text(extent.left, extent.low, 6) +
                         " to " + place_text(extent.right, extent.high, 6),
                     "give it in the coordinates of the mesh, in m", true});
  }

  /// Radii of gyration are 0.29 diagonals of an evenly filled rectangle.
  void judge_inertia(const std::string& at, const Region& region, const Extent& extent) {
    const double square = region.mass_over(extent.area) * (std::pow(extent.width(), 2) + std::pow(extent.height(), 2));
    judge(at + "moment_of_inertia", *region.moment_of_inertia,
          {"kg m2/m", 0.01 * square, 0.5 * square, 0.03 * square, 0.25 * square, {{"t m2/m", 1e3}}, "by mass and size"},
          list_);
  }

  void judge_level() {
    if (!scene_.initial || !scene_.initial->water_level) return;
    const double level = *scene_.initial->water_level, H = all_.height();
    const auto fits = [&](double y) { return y >= all_.low - H && y <= all_.high + 2. * H; };
    if (fits(level) || level < all_.low) return;  // below all ground: how dry ground is said
    const std::string text = "initial.water_level = " + significant(level, 4) +
                             " m is far from the mesh, from y = " + significant(all_.low, 4) + " to " +
                             significant(all_.high, 4) + " m";
    std::string cure = "check the level, and the unit and the origin of the mesh";
    for (const MeantUnit& unit : {MeantUnit{"cm", 1e-2}, MeantUnit{"mm", 1e-3}})
      if (const double meant = unit.in_si(level); fits(meant)) {
        cure = cure_of_unit(unit, meant);
        break;
      }
    list_.push_back({"implausible", level, all_.high, "m", text, cure, true});
  }

  /// Largest value of the history; a factor below 1, by which a study weakens a load, is left out.
  static double peak_of(const Load& load, double end) {
    if (load.factor == 0. || load.history.kinks().empty()) return 0.;
    const double up = extremum(load.history, 0., end, 1).value, down = -extremum(load.history, 0., end, -1).value;
    return std::max(up, down) / std::min(std::abs(load.factor), 1.);
  }

  void judge_loads() {
    std::map<std::string, double> forces;  // of the transducers of a row together
    const auto& caisson = simulation_.compiled()->caisson;
    for (const LoadOnCaisson& on : simulation_.compiled()->loads_on_caisson) {
      const auto found = scene_.loads.find(on.name);
      if (found == scene_.loads.end()) continue;
      const Load& load = found->second;
      const double peak = peak_of(load, scene_.time.end), force = peak * std::hypot(on.force_x, on.force_y);
      if (is_motion(load.kind))
        judge("loads." + on.name + ", its largest velocity", peak, quantities::velocity, list_);
      else if (caisson && force > 0. && !(load.transducer.empty() && is_unit_load(peak)))
        forces[load.transducer.empty() ? on.name : on.name.substr(0, on.name.rfind('.'))] += force;
      else if (!is_on_volume(load.kind) && load.kind != LoadKind::force && !is_unit_load(peak) &&
               (load.transducer.empty() || (load.cosine && load.transducer == "cosine")))
        judge("loads." + (load.cosine ? on.name.substr(0, on.name.rfind('.')) : on.name) + ", its largest value", peak,
              of(quantities::load_on_weight, scene_.fluid.density * scene_.gravity * all_.height(), "Pa",
                 "beside the weight of water as high as the mesh", {{"kPa", 1e3}, {"MPa", 1e6}}),
              list_);
    }
    for (const auto& [name, force] : forces)
      judge("loads." + name + ", its largest force", force,
            of(quantities::load_on_weight, caisson->body.mass * scene_.gravity, "N/m", "beside the caisson's weight"),
            list_);
    if (caisson && scene_.sliding && scene_.sliding->uplift) judge_uplift(*scene_.sliding->uplift);
  }

  /// Ends of the curve of a load on the caisson, in the coordinate of its shape; the first above the second where the
  /// curve does not touch the caisson.
  std::pair<double, double> on_curve(const Load& load) const {
    double low = infinity, high = -infinity;
    bool on_caisson = false;
    for (const auto& cell : simulation_.mesh()->triangulation.active_cell_iterators())
      for (const unsigned f : cell->face_indices()) {
        const auto face = cell->face(f);
        if (simulation_.mesh()->curve_of(face) != load.boundary) continue;
        on_caisson = on_caisson || simulation_.mesh()->surface_of(cell) == caisson_name;
        for (const unsigned v : {0U, 1U}) {
          const double at = shape_coordinate(load, face->vertex(v)[0], face->vertex(v)[1]);
          low = std::min(low, at);
          high = std::max(high, at);
        }
      }
    return on_caisson ? std::pair(low, high) : std::pair(infinity, -infinity);
  }

  /// The part of a shape's force that lies above a height.
  static double share_above(const std::vector<std::array<double, 2>>& shape, double height) {
    double all = 0., above = 0.;
    for (std::size_t i = 1; i < shape.size(); ++i) {
      const auto [y0, p0] = shape[i - 1];
      const auto [y1, p1] = shape[i];
      const double from = std::clamp(height, y0, y1), at = y1 > y0 ? p0 + (p1 - p0) * (from - y0) / (y1 - y0) : p1;
      all += 0.5 * std::abs(p0 + p1) * (y1 - y0);
      above += 0.5 * std::abs(at + p1) * (y1 - from);
    }
    return all > 0. ? above / all : 0.;
  }

  /// A shape in heights above another datum presses above the wall, and not at its foot. One that is drawn on to eta* =
  /// 2.7 H_1/3 (Goda 2000) has up to a third of its force above a crest of 0.6 H_1/3.
  void judge_above(const std::string& name, const Load& load, double low, double high) {
    constexpr double overtopping = 0.5, counts = 0.1;
    const double share = share_above(load.shape, high);
    const bool leaves_foot = load.shape.front()[0] > low + counts * (high - low);
    if (load.over_x || load.along_curve || share <= (leaves_foot ? counts : overtopping)) return;
    list_.push_back({"implausible", share, leaves_foot ? counts : overtopping, "1",
                     "loads." + name + ".shape has " + percent(share) + " of its force above '" + load.boundary +
                         "', which reaches up to " + significant(high, 5) + " m: that part is left out",
                     "give its places in the coordinates of the mesh, not above another datum", true});
  }

  /// A shape in heights above the foot of the wall, or of another datum, presses below the wall.
  void judge_shapes() {
    constexpr double hair = 1e-3;  // of the wall's height
    for (const auto& [name, load] : scene_.loads) {
      if (load.shape.empty() || load.boundary.empty() || load.factor == 0. || !load.transducer.empty()) continue;
      const auto [low, high] = on_curve(load);
      const auto presses_below = [&, end = low - hair * (high - low)](const std::array<double, 2>& corner) {
        return corner[0] < end && corner[1] != 0.;
      };
      if (high > low) judge_above(name, load, low, high);
      if (!(high > low) || std::none_of(load.shape.begin(), load.shape.end(), presses_below)) continue;
      list_.push_back({"implausible", load.shape.front()[0], low, "m",
                       "loads." + name + ".shape begins at " + significant(load.shape.front()[0], 5) + " m, and '" +
                           load.boundary + "' reaches from " + significant(low, 5) + " to " + significant(high, 5) +
                           " m: what lies below the wall is left out",
                       "give its places in the coordinates of the mesh, not above the foot of the wall", true});
    }
  }

  void judge_uplift(const UpliftChoice& uplift) {
    const double weight = simulation_.compiled()->caisson->body.mass * scene_.gravity;
    double largest = 0.;  // of a history
    Quantity on_weight = quantities::load_on_weight;
    on_weight.high = 3.;  // more lifts any caisson
    if (!uplift.history.kinks().empty()) largest = extremum(uplift.history, 0., scene_.time.end, 1).value;
    for (const auto& [key, value] : {std::pair{"sliding.uplift.peak", uplift.peak.value_or(0.)},
                                     {"sliding.uplift.history, its largest uplift", largest}})
      if (value > 0. && !is_unit_load(value))
        judge(key, value, of(on_weight, weight, "N/m", "beside the caisson's weight"), list_);
  }

  const Simulation& simulation_;
  const Scene& scene_;
  NumberedWarnings& list_;
  Extent all_;
  std::map<std::string, Extent> regions_;
};

}  // namespace

Finding mesh_plausibility_finding() {
  Finding f;
  f.of_scene = [](const Simulation& simulation, const std::optional<double>&) {
    NumberedWarnings list;
    OnItsMesh(simulation, list).run();
    return list;
  };
  return f;
}

}  // namespace upbead

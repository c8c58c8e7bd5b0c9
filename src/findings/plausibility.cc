// Whether the numbers of a scene are those of breakwaters, and in which unit they may have been meant.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/numbers.h"
#include "base/text.h"
#include "fem/compile.h"
#include "findings/effective_base.h"
#include "findings/finding.h"
#include "mesh/extent.h"
#include "model/quantities.h"

namespace upbead {

namespace {

/// About its G (Pa); 0 where it has none.
double stiffness_of(const Region& region) {
  if (region.shear_modulus) return *region.shear_modulus;
  if (region.stress_law) return region.stress_law->reference;
  return region.youngs_modulus.value_or(0.) / 3.;
}

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

void judge_weight(const std::string& key, double given, const Simulation& simulation, NumberedWarnings& list) {
  const double in_air = simulation.compiled()->caisson->body.mass * simulation.scene().gravity;
  const std::optional<double> in_water = weight_in_water(simulation);
  if (!in_water) {
    if (given < 0.99 * in_air)
      list.push_back({"no_water", given, in_air, "N/m",
                      key + " = " + significant(given, 4) + " N/m is below the weight in air, " +
                          significant(in_air, 4) + " N/m, but the scene has no still water",
                      "give regions of water, or [initial] water_level"});
    return;
  }
  // footings, rounded corners and layers of ballast are less than a tenth of W'; more than it is a safety that is not
  constexpr double tolerable = 0.1, unsafe = 0.02;
  const double difference = given - *in_water, size = std::abs(*in_water);
  if (difference <= unsafe * size && difference >= -tolerable * size) return;
  const std::string text = key + " = " + significant(given, 4) + " N/m, but the caisson less the water " +
                           "that it displaces weighs " + significant(*in_water, 4) + " N/m";
  std::string cure;
  for (const MeantUnit& unit :
       {MeantUnit{"kN/m", 1e3}, MeantUnit{"MN/m", 1e6}, MeantUnit{"t/m", 9.81e3}, MeantUnit{"kg/m", 9.81}})
    if (std::abs(unit.in_si(given) - *in_water) <= 0.3 * *in_water)
      cure += (cure.empty() ? "" : "; ") + cure_of_unit(unit, unit.in_si(given));
  if (cure.empty()) cure = "check submerged_weight, the mass of the caisson and the level of still water";
  list.push_back({"submerged_weight", given, *in_water, "N/m", text, cure, std::abs(difference) > tolerable * size});
}

namespace {

/// Viscosity and the air's pressure only where a region uses them: `upbead scale` scales both.
void judge_fluid(const Scene& scene, NumberedWarnings& list) {
  const Fluid& fluid = scene.fluid;
  const auto any = [&](const auto& uses) {
    return std::any_of(scene.regions.begin(), scene.regions.end(), [&](const auto& r) { return uses(r.second); });
  };
  judge("fluid.density", fluid.density, quantities::water_density, list);
  judge("fluid.bulk_modulus", fluid.bulk_modulus, quantities::water_modulus, list);
  if (any([](const Region& region) { return region.permeability.has_value(); }))
    judge("fluid.viscosity", fluid.viscosity, quantities::viscosity, list);
  if (any([](const Region& region) { return region.saturation < 1.; }))
    judge("fluid.atmospheric_pressure", fluid.atmospheric_pressure, quantities::atmosphere, list);
}

/// The strain at which a table of G over strain falls to half; none where it does not.
std::optional<double> half_strain(const StrainLaw& law) {
  for (std::size_t i = 1; i < law.modulus.size(); ++i) {
    const auto [strain_0, ratio_0] = law.modulus[i - 1];
    const auto [strain_1, ratio_1] = law.modulus[i];
    if (ratio_0 >= 0.5 && ratio_1 < 0.5)
      return strain_0 * std::pow(strain_1 / strain_0, (ratio_0 - 0.5) / (ratio_0 - ratio_1));
  }
  return std::nullopt;
}

/// Stiffness falls with the strain, damping rises (side: -1, 1; Seed and Idriss 1970): columns may be mixed up.
void judge_course(const std::string& key, const std::string& what, const std::vector<std::array<double, 2>>& table,
                  double side, NumberedWarnings& list) {
  constexpr double scatter = 0.02;  // of measured points
  for (std::size_t i = 1; i < table.size(); ++i) {
    const double before = table[i - 1][1], value = table[i][1];
    if (side * (value - before) >= -scatter * std::max(value, before)) continue;
    list.push_back({"implausible", value, before, "1",
                    key + ": " + what + (side < 0. ? " rises" : " falls") + " from " + significant(before) + " to " +
                        significant(value) + " at a strain of " + significant(table[i][0]) + ", and that of soil " +
                        (side < 0. ? "falls" : "rises") + " with the strain",
                    "give pairs (strain, value) of one curve"});
    return;
  }
}

void judge_strain_law(const std::string& at, const StrainLaw& law, NumberedWarnings& list) {
  const Quantity effective{"1", 0.1, 1.01, 0.4, 1., {{"percent", 1e-2}}, "0.65 is usual"};
  judge(at + "effective", law.effective, effective, list);
  judge(at + "modulus, the strain at half of G", half_strain(law), quantities::reference_strain, list);
  judge_course(at + "modulus", "G/G_max", law.modulus, -1., list);
  judge_course(at + "damping", "the damping ratio", law.damping, 1., list);
  double largest = 0.;
  for (const auto& [strain, ratio] : law.damping) largest = std::max(largest, ratio);
  judge(at + "damping, its largest ratio", largest, quantities::largest_damping, list);
}

/// The damping that two frequencies give where the motion is: its least between the length of the run and the faster of
/// the shortest load and a shear wave that passes a caisson of the width B.
void judge_damping(const std::string& at, const Region& region, const Scene& scene, double B, NumberedWarnings& list) {
  const Rayleigh& damping = *region.damping;
  judge(at + "damping.ratio", damping.ratio, quantities::damping, list);
  const double duration = shortest_duration(scene), slow = 1. / scene.time.end;
  if (!(duration > 0.) || !std::isfinite(duration)) return;
  const double G = stiffness_of(region);
  const double wave = B > 0. ? std::sqrt(G / 2e3) / (2. * B) : 0.;  // of 2 t/m3
  const double f = std::clamp(std::sqrt(damping.frequencies[0] * damping.frequencies[1]), slow,
                              std::max({slow, wave, 0.5 / duration}));
  const double ratio = damping.ratio_at(f);
  if (ratio > quantities::damping.high && damping.ratio <= quantities::damping.high)
    list.push_back({"implausible", ratio, quantities::damping.high, "1",
                    at + "damping: at " + significant(f) + " Hz, where the motion is, the ratio is " +
                        significant(ratio) + ", more than soil has",
                    "look at damping.frequencies (Hz), between which the ratio is that of damping.ratio", true});
}

void judge_soil(const std::string& at, const Region& region, const Scene& scene, double B, NumberedWarnings& list) {
  if (region.densification)
    judge(at + "densification.threshold", region.densification->threshold, quantities::threshold_strain, list);
  if (region.damping) judge_damping(at, region, scene, B, list);
  if (const auto& law = region.stress_law) {
    judge(at + "shear_modulus.reference", law->reference, quantities::modulus, list);
    judge(at + "shear_modulus.pressure", law->pressure, quantities::stress_scale, list);
    Quantity floor = quantities::stress_scale;
    floor.low = floor.common_low = 1e-6;
    judge(at + "shear_modulus.floor", law->floor, floor, list);
  }
  if (const auto& law = region.strain_law) {
    judge_strain_law(at + "strain.", *law, list);
    judge(at + "strain.reference_strain", law->reference_strain, quantities::reference_strain, list);
    judge(at + "strain.smallest_damping", law->smallest_damping, quantities::smallest_damping, list);
    judge(at + "strain.largest_damping", law->largest_damping, quantities::largest_damping, list);
  }
  if (!region.strength) return;
  constexpr double none = 0.15;  // degrees: a small angle in place of zero
  if (region.strength->friction_angle > none)
    judge(at + "strength.friction_angle", region.strength->friction_angle, quantities::friction_angle, list);
  judge(at + "strength.cohesion", region.strength->cohesion, quantities::cohesion, list);
}

void judge_pores(const std::string& at, const Region& region, NumberedWarnings& list) {
  constexpr double rock = 1e9, coarse = 1e-5;  // Pa, m/s
  if (region.kind != RegionKind::porous) return;
  const auto k = region.hydraulic_conductivity;
  const double G = region.shear_modulus.value_or(region.youngs_modulus.value_or(0.));
  judge(at + "porosity", region.porosity,
        G >= rock           ? quantities::porosity
        : k && *k >= coarse ? quantities::porosity_of_coarse
                            : quantities::porosity_of_soil,
        list);
  judge(at + "grain_density", region.grain_density, quantities::grain_density, list);
  judge(at + "grain_bulk_modulus", region.grain_bulk_modulus, quantities::grain_modulus, list);
  // Darcy's law ends where water is no longer slow
  judge(at + "hydraulic_conductivity", k,
        region.flow == Flow::inertial ? quantities::conductivity : quantities::darcy_conductivity, list);
  // deposits in layers 0.1 to 1, varved clay down to 0.02; above 1 where cracks or drains stand upright
  judge(at + "conductivity_ratio", region.conductivity_ratio,
        {"1", 1e-3, 15., 0.02, 10., {{"percent", 1e-2}}, "layered soils have 0.02 to 1"}, list);
  judge(at + "permeability", region.permeability, quantities::permeability, list);
  // beta (1 - n)/(n^3 g d): of 1 m to 0.1 mm
  judge(at + "forchheimer", region.forchheimer,
        {"s2/m2", 1e-3, 1e6, 0.1, 3e4, {}, "stones of 1 m have 1 to 3, gravel of 1 cm 100 to 300"}, list);
  judge(at + "tortuosity", region.tortuosity, quantities::tortuosity, list);
}

/// Springs under a caisson of the weight W and the width B, at any scale. W over a spring is how far the caisson sinks
/// into it at rest: between a third of its width and less than on rock, 5e-6 of it. A rotation of less than W B/2 would
/// not keep it upright. Of strips on layers K_r/(K_x B^2) is 0.1 to 0.3 (Gazetas 1983).
void judge_springs(const std::string& at, const BaseSupport& springs, double W, double B, NumberedWarnings& list) {
  const Quantity spring{"Pa",
                        3. * W / B,
                        2e5 * W / B,
                        10. * W / B,
                        3e4 * W / B,
                        {{"kPa", 1e3}, {"MPa", 1e6}},
                        "so stiff that the caisson sinks by 3e-5 to 0.1 of its width"};
  const std::size_t before = list.size();
  judge(at + "horizontal", springs.horizontal, spring, list);
  const bool horizontal_fits = list.size() == before;
  judge(at + "vertical", springs.vertical, spring, list);
  const double usual = horizontal_fits ? springs.horizontal * B * B : 100. * W * B;
  judge(at + "rotation", springs.rotation,
        {"N",
         std::max(0.005 * usual, 0.5 * W * B),
         (horizontal_fits ? 10. : 1e3) * usual,
         std::max(0.05 * usual, W * B),
         (horizontal_fits ? 1. : 300.) * usual,
         {{"kN", 1e3}, {"MN", 1e6}},
         "0.1 to 0.3 times horizontal B^2"},
        list);
}

/// Dashpots by their share of critical damping c/(2 sqrt(k m)), at any scale: of footings on a half-space 0.3 to 0.6
/// in sliding, 0.5 to 1 in heave and 0.05 to 0.3 in rocking (Richart, Hall and Woods 1970). None at all is a choice.
void judge_dashpots(const std::string& at, const BaseSupport& dashpots, const BaseSupport& springs, const Body& body,
                    double bottom, NumberedWarnings& list) {
  const double about_base = body.moment_of_inertia + body.mass * std::pow(body.centre[1] - bottom, 2);
  const auto see = [&](const char* key, double c, double k, double m, const char* unit,
                       const std::vector<MeantUnit>& meant) {
    const double all = 2. * std::sqrt(k * m);  // critical
    if (c > 0. && all > 0.)
      judge(at + key, c, {unit, 1e-3 * all, 5. * all, 0.01 * all, 2. * all, meant, "0.05 to 1 of critical damping"},
            list);
  };
  const std::vector<MeantUnit> along{{"kN s/m2", 1e3}, {"MN s/m2", 1e6}}, about{{"kN s", 1e3}, {"MN s", 1e6}};
  see("horizontal", dashpots.horizontal, springs.horizontal, body.mass, "N s/m2", along);
  see("vertical", dashpots.vertical, springs.vertical, body.mass, "N s/m2", along);
  see("rotation", dashpots.rotation, springs.rotation, about_base, "N s", about);
}

/// Dashpots only where the springs fit.
void judge_support(const std::string& at, const Region& region, const Caisson& caisson, double gravity,
                   NumberedWarnings& list) {
  const std::size_t before = list.size();
  judge_springs(at + "springs.", *region.springs, caisson.body.mass * gravity, caisson.bottom_width, list);
  if (region.dashpots && list.size() == before)
    judge_dashpots(at + "dashpots.", *region.dashpots, *region.springs, caisson.body, caisson.bottom_centre[1], list);
}

NumberedWarnings plausibility_warnings(const Simulation& simulation, const std::optional<double>&) {
  NumberedWarnings list;
  const Scene& scene = simulation.given();
  const auto& caisson = simulation.compiled()->caisson;
  judge_fluid(scene, list);
  for (const auto& [name, region] : scene.regions) {
    const std::string at = "regions." + name + ".";
    const Quantity& modulus = name == caisson_name ? quantities::caisson_modulus : quantities::modulus;
    judge(at + "shear_modulus", region.shear_modulus, modulus, list);
    judge(at + "youngs_modulus", region.youngs_modulus, modulus, list);
    judge(at + "density", region.density, quantities::density, list);
    for (const auto& [part, values] : region.parts)
      judge(at + "parts." + part + ".density", values.density, quantities::density, list);
    judge_soil(at, region, scene, caisson ? caisson->bottom_width : 0., list);
    judge_pores(at, region, list);
    if (region.porosity && region.biot < *region.porosity)
      list.push_back({"biot_below_porosity", region.biot, *region.porosity, "1",
                      at + "biot = " + significant(region.biot) + " is less than the porosity, " +
                          significant(*region.porosity) +
                          ", which no grains that fill the skeleton alone can have: the pore pressure counts for less "
                          "than it is",
                      "give " + at + "biot of at least the porosity; 1 where grains are far stiffer than the soil"});
    if (region.springs && caisson) judge_support(at, region, *caisson, scene.gravity, list);
    if (region.interface)
      judge(at + "interface.coefficient", region.interface->coefficient, quantities::friction, list);
  }
  if (const int n = simulation.mesh()->n_divided_triangles; n > 0)
    list.push_back({"triangles_divided", static_cast<double>(n), 0., "1",
                    std::to_string(n) +
                        " triangles of the mesh were divided into three quadrilaterals each, and its "
                        "quadrilaterals into four: " +
                        std::to_string(simulation.mesh()->triangulation.n_active_cells()) +
                        " cells; quadrilaterals from the start need fewer unknowns",
                    "mesh by transfinite blocks with Recombine Surface, or Mesh.SubdivisionAlgorithm = 1"});
  constexpr double straight = 1e-6;
  if (const double bent = simulation.mesh()->most_bent; bent > straight)
    list.push_back({"sides_straightened", bent, straight, "1",
                    "cells of second order have curved sides, up to " + percent(bent) +
                        " of a side's length from its chord; they are read by their corners, with straight sides",
                    "use more cells along curved boundaries"});
  if (scene.sliding) judge("sliding.friction", scene.sliding->friction, quantities::friction, list);
  if (scene.initial)
    for (const auto& [name, surcharge] : scene.initial->surcharge)
      judge("initial.surcharge." + name + ".weight", surcharge.weight, quantities::surcharge, list);
  if (scene.cycles)  // a wave at least; of ten years of swell 3e7
    judge("cycles, all its waves,", std::accumulate(scene.cycles->number.begin(), scene.cycles->number.end(), 0.),
          {"1", 1., 1e8, 100., 1e5, {{"thousands", 1e3}}, "storms have 500 to 2e4"}, list);
  if (scene.sliding && simulation.compiled()->caisson)
    judge_weight("sliding.submerged_weight", scene.sliding->submerged_weight, simulation, list);
  OnItsMesh(simulation, list).run();
  return list;
}

}  // namespace

Finding plausibility_finding() {
  Finding f;
  f.of_scene = plausibility_warnings;
  return f;
}

}  // namespace upbead

#include "fem/checker.h"
#include "fem/static_stage.h"
#include "fem/volume_loads.h"

namespace upbead {

namespace {

/// Checks one load on volumes, and reports mistakes at its keys.
class VolumeLoadCheck {
 public:
  VolumeLoadCheck(Checker& checker, const std::string& name, const Load& load)
      : checker_(checker), table_("loads." + name), load_(load) {}

  void run() {
    if (!load_.boundary.empty()) object("boundary", "it acts on the volume of a region", "give region instead");
    if (load_.kind == LoadKind::gravity) return check_gravity();
    if (load_.region.empty())
      object("region", "it is not said in which region it acts", "add region = \"NAME\"");
    else if (load_.kind == LoadKind::source && !checker_.has_pore_water(load_.region))
      object("region", "'" + load_.region + "' has no pore water that could enter it",
             "name a porous region, with flow = \"auto\", \"darcy\" or \"inertial\"");
    else if (checker_.is(load_.region, RegionKind::water))
      object("region", "'" + load_.region + "' is free water, which has no equation of forces",
             "load its level by a pressure");
  }

 private:
  void object(const std::string& key, const std::string& what, const std::string& cure) {
    checker_.object(table_ + "." + key, what, cure);
  }

  void check_gravity() {
    for (const auto& [name, bounds] : checker_.outline.surfaces) {
      if (checker_.is(name, RegionKind::water))
        object("kind", "free water (region '" + name + "') does not feel gravity here",
               "remove the region, and give the water's pressure on bed, mound and walls as a load");
      const auto region = checker_.scene.regions.find(name);
      if (acts_on(load_, name) && region != checker_.scene.regions.end() && region->second.forchheimer)
        object("kind", "the velocity by which drag in '" + name + "' grows leaves out the weight of its water",
               "remove forchheimer, or the load from that region");
      if (acts_on(load_, name) && checker_.is(name, RegionKind::porous) && !checker_.has_pore_water(name))
        object("kind", "'" + name + "' is drained, so that nothing carries the weight of its water",
               "write flow = \"darcy\" in [regions." + name +
                   "], or kind = \"solid\" with the density of its grains alone, less buoyancy under water");
    }
    for (const auto& [name, curve] : checker_.outline.outer)
      for (const std::string& surface : curve.surfaces)
        if (acts_on(load_, surface) && absorbs(name))
          object("kind", "the absorbing side '" + name + "' gives way to weight for as long as that acts",
                 "write \"roller\" or \"fixed\", and \"sealed\" or \"open\", in [boundaries." + name + "]");
    check_weights_at_rest();
  }

  bool absorbs(const std::string& curve) const {
    const auto side = checker_.scene.boundaries.find(curve);
    return side != checker_.scene.boundaries.end() && (side->second.displacement == DisplacementCondition::absorbing ||
                                                       side->second.pressure == PressureCondition::absorbing);
  }

  /// Weights must not act twice: some parts of a scene take them from the state at rest.
  void check_weights_at_rest() {
    const Scene& scene = checker_.scene;
    const auto twice = [&](const std::string& by) {
      object("kind", "weights would count twice, as " + by + " has them from the state at rest",
             "remove the load: what is computed are changes from that state");
    };
    if (yields(scene)) twice("soil that yields");
    if (has_strength(scene)) twice("the check of strength");
    if (needs_static_stage(scene)) twice("stiffness by stress");
    if (has_frictional_contact(scene)) twice("contact node by node");
    if (scene.sliding && acts_on(load_, caisson_name)) twice("[sliding]");
  }

  Checker& checker_;
  std::string table_;
  const Load& load_;
};

}  // namespace

void check_volume_loads(Checker& checker) {
  for (const auto& [name, load] : checker.scene.loads)
    if (is_on_volume(load.kind)) VolumeLoadCheck(checker, name, load).run();
}

}  // namespace upbead

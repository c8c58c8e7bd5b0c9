#include "fem/construction.h"

#include <set>

namespace upbead {

namespace {

/// Free water instead of a region that does not stand yet: at rest it has neither weight nor stiffness.
Region nothing_yet() {
  Region water;
  water.kind = RegionKind::water;
  return water;
}

/// Makes the scene of each stage, one after the other.
class Builder {
 public:
  Builder(const Scene& scene, const Mesh& mesh)
      : scene_(scene), rest_(at_rest(scene)), level_(water_level(scene, mesh)) {}

  Stage stage(const std::string& name, bool is_first, bool is_last) {
    const ConstructionStage& given = scene_.construction.at(name);
    standing_.insert(given.regions.begin(), given.regions.end());
    share_ = given.caisson_share.value_or(share_);
    Stage stage{name, rest_, given.water_level.value_or(level_), is_first};
    for (auto& [region, values] : stage.scene.regions)
      if (values.kind != RegionKind::water && standing_.count(region) == 0) values = nothing_yet();
    if (const auto caisson = stage.scene.regions.find(caisson_name); caisson != stage.scene.regions.end()) {
      for (std::optional<double>* mass : {&caisson->second.mass, &caisson->second.density})
        if (*mass) *mass = share_ * **mass;
      for (auto& [part, values] : caisson->second.parts) values.density *= share_;
    }
    if (!is_last && stage.scene.initial) {
      stage.scene.initial->surcharge.clear();
      stage.scene.initial->harbour_level.reset();
    }
    return stage;
  }
  Stage at_once() const { return {"", rest_, level_, true}; }

 private:
  const Scene& scene_;
  Scene rest_;
  double level_ = 0.;
  double share_ = 1.;
  std::set<std::string> standing_;
};

}  // namespace

std::vector<Stage> stages_of(const Scene& scene, const Mesh& mesh) {
  Builder builder(scene, mesh);
  if (scene.construction.empty()) return {builder.at_once()};
  std::vector<Stage> stages;
  const std::vector<std::string> names = stages_in_order(scene);
  for (const std::string& name : names)
    stages.push_back(builder.stage(name, name == names.front(), name == names.back()));
  return stages;
}

namespace {

/// Soil after the last stage; without stress where that is the first.
StaticSoil soil_after(const PointStresses& before, const Ground& ground) {
  StaticSoil soil(ground.space(), ground.unknowns());
  soil.start_from(before.empty() ? PointStresses(ground.space().mesh().triangulation.n_active_cells()) : before);
  return soil;
}

}  // namespace

Vector added_weights(const Stage& stage, const Ground& ground, const PointStresses& before) {
  StaticSoil soil = soil_after(before, ground);
  Vector borne;
  soil.exert(Vector::Zero(ground.unknowns().size()), borne);
  return ground.weights(stage.level) - borne;
}

PointStresses stresses_after(const Ground& ground, const PointStresses& before, const Vector& x) {
  StaticSoil soil = soil_after(before, ground);
  soil.commit(x);
  return soil.stresses();
}

}  // namespace upbead

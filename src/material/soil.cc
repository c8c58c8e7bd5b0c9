#include "material/soil.h"

#include <utility>

namespace upbead {

namespace {

/// One point in each lane, each by its own law.
class PackOfPoints : public SoilPack {
 public:
  explicit PackOfPoints(SoilPoints points) : points_(std::move(points)) {}
  bool asks() const override { return at(0).asks(); }
  void foresee(const PackTensor& strain) const override {
    for (int lane = 0; lane < size(); ++lane) at(lane).foresee(in_lane(strain, lane));
  }
  void correct(const PackTensor& strain, PackStress& correction) const override {
    correction = {};
    for (int lane = 0; lane < size(); ++lane) {
      PlaneStress of_point;
      at(lane).correct(in_lane(strain, lane), of_point);
      set_lane(of_point, lane, correction);
    }
  }
  void commit(const PackTensor& strain, Number& dissipated) override {
    for (int lane = 0; lane < size(); ++lane) {
      double of_point = 0.;
      at(lane).commit(in_lane(strain, lane), of_point);
      dissipated[lane] += of_point;
    }
  }
  void stored_beside_elastic(const PackTensor& strain, Number& energy) const override {
    energy = Number{};
    for (int lane = 0; lane < size(); ++lane) {
      double of_point = 0.;
      at(lane).stored_beside_elastic(in_lane(strain, lane), of_point);
      energy[lane] = of_point;
    }
  }
  double mobilised(int lane, const PlaneStress& change) const override { return at(lane).mobilised(0, change); }
  void remember(std::vector<double>& memory) const override {
    for (const auto& point : points_) point->remember(memory);
  }
  const double* recall(const double* memory) override {
    for (const auto& point : points_) memory = point->recall(memory);
    return memory;
  }

 private:
  int size() const { return static_cast<int>(points_.size()); }
  SoilPoint& at(int lane) const { return *points_[static_cast<std::size_t>(lane)]; }

  SoilPoints points_;
};

}  // namespace

std::vector<std::unique_ptr<SoilPack>> side_by_side(std::vector<SoilPoints> cells, bool by_points) {
  std::vector<std::unique_ptr<SoilPack>> packs;
  if (!by_points) packs = cells.front().front()->in_lanes(cells);
  if (!packs.empty()) return packs;
  for (std::size_t q = 0; q < cells.front().size(); ++q) {
    SoilPoints points;
    for (SoilPoints& cell : cells) points.push_back(std::move(cell[q]));
    packs.push_back(std::make_unique<PackOfPoints>(std::move(points)));
  }
  return packs;
}

}  // namespace upbead

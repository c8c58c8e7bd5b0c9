#include "material/soil_pack.h"

#include <algorithm>
#include <utility>

namespace upbead {

namespace {

bool is_at_rest(const MohrCoulombSoil& a) {
  const PlaneStress &now = a.now.stress, &rest = a.rest;
  return a.now.strain.xx == 0. && a.now.strain.yy == 0. && a.now.strain.xy == 0. && now.xx == rest.xx &&
         now.yy == rest.yy && now.xy == rest.xy && now.zz == rest.zz;
}

bool same(const HystereticSoil& a, const HystereticSoil& b) {
  const auto equal = [](const PlaneStrain& one, const PlaneStrain& other) {
    return one.xx == other.xx && one.yy == other.yy && one.xy == other.xy;
  };
  return a.law == b.law && equal(a.now.strain, {}) && equal(b.now.strain, {}) &&
         std::equal(a.now.plastic.begin(), a.now.plastic.end(), b.now.plastic.begin(), b.now.plastic.end(), equal);
}

/// Evaluates one point after another, each by its own law.
class PackOfPoints : public SoilPack {
 public:
  explicit PackOfPoints(std::vector<PackedCell> cells) : cells_(std::move(cells)) {}
  void correct(int n, const PackTensor& strain, PackStress& correction) override {
    correction = {};
    for (std::size_t lane = 0; lane < cells_.size(); ++lane) {
      const PlaneStrain e{strain.xx[lane], strain.yy[lane], strain.xy[lane]};
      const PlaneStress elastic = cells_[lane].elastic.stress(e), s = point(lane, n).stress(e);
      correction.xx[lane] = elastic.xx - s.xx;
      correction.yy[lane] = elastic.yy - s.yy;
      correction.xy[lane] = elastic.xy - s.xy;
      correction.zz[lane] = elastic.zz - s.zz;
    }
  }
  void commit(int n, const PackTensor& strain, detail::Lanes& dissipated) override {
    for (std::size_t lane = 0; lane < cells_.size(); ++lane)
      dissipated[lane] += point(lane, n).commit({strain.xx[lane], strain.yy[lane], strain.xy[lane]});
  }
  void stored_beside_elastic(int n, const PackTensor& strain, detail::Lanes& energy) const override {
    energy = detail::Lanes{};
    for (std::size_t lane = 0; lane < cells_.size(); ++lane)
      energy[lane] = point(lane, n).stored() -
                     elastic_energy(cells_[lane].elastic, {strain.xx[lane], strain.yy[lane], strain.xy[lane]});
  }
  double mobilised(int n, int lane, const PlaneStress& change) const override {
    return point(static_cast<std::size_t>(lane), n).mobilised(change);
  }
  void remember(std::vector<double>& memory) const override {
    for (const PackedCell& cell : cells_)
      for (const auto& point : cell.points) point->remember(memory);
  }
  const double* recall(const double* memory) override {
    for (const PackedCell& cell : cells_)
      for (const auto& point : cell.points) memory = point->recall(memory);
    return memory;
  }

 private:
  SoilPoint& point(std::size_t lane, int n) const { return *cells_[lane].points[static_cast<std::size_t>(n)]; }

  std::vector<PackedCell> cells_;
};

}  // namespace

PackKind pack_kind(const PackedCell& cell) {
  const auto all = [&](const auto& is) {
    return std::all_of(cell.points.begin(), cell.points.end(), [&](const auto& point) { return is(*point); });
  };
  const HystereticSoil* first = cell.points.front()->hysteretic();
  if (first && all([&](const SoilPoint& p) { return p.hysteretic() && same(*first, *p.hysteretic()); }))
    return PackKind::hysteretic;
  const MohrCoulombSoil* other = cell.points.front()->mohr_coulomb();
  if (other && all([&](const SoilPoint& p) {
        return p.mohr_coulomb() && p.mohr_coulomb()->law == other->law && is_at_rest(*p.mohr_coulomb());
      }))
    return PackKind::mohr_coulomb;
  return PackKind::points;
}

std::unique_ptr<SoilPack> soil_pack(PackKind kind, std::vector<PackedCell> cells) {
  switch (kind) {
    case PackKind::hysteretic:
      return hysteretic_pack(cells);
    case PackKind::mohr_coulomb:
      return mohr_coulomb_pack(cells);
    case PackKind::points:
      break;
  }
  return std::make_unique<PackOfPoints>(std::move(cells));
}

}  // namespace upbead

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "material/soil_pack.h"

namespace upbead {

namespace {

using detail::Lanes;

UPBEAD_IN_CLONES PackTensor minus(const PackTensor& a, const PackTensor& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy};
}

UPBEAD_IN_CLONES void add(const Lanes& factor, const PackTensor& a, PackTensor& sum) {
  sum.xx += factor * a.xx;
  sum.yy += factor * a.yy;
  sum.xy += factor * a.xy;
}

UPBEAD_IN_CLONES PackTensor deviator_of(const PackTensor& strain) {
  const Lanes mean = (strain.xx + strain.yy) / 3.;
  return {strain.xx - mean, strain.yy - mean, strain.xy};
}

/// a : b of two deviators.
UPBEAD_IN_CLONES void inner(const PackTensor& a, const PackTensor& b, Lanes& product) {
  product = a.xx * b.xx + a.yy * b.yy + (a.xx + a.yy) * (b.xx + b.yy) + 2. * a.xy * b.xy;
}

UPBEAD_IN_CLONES bool any_above(const Lanes& a, const Lanes& b) {
  const auto above = a > b;
  long long found = 0;
  for (int i = 0; i < detail::lanes; ++i) found |= above[i];
  return found != 0;
}

/// An element of the overlay in all cells: h (Pa), the elastic strain at which it slides, and its plastic strain at
/// rest.
struct Element {
  Lanes h{}, most{}, most_squared{};
  PackTensor rest;
};

/// History of a point; the plastic strains of its elements since rest are kept apart.
struct Memory {
  PackTensor strain;
  int n_moved = 0;  ///< elements from here on have never slid in any cell
};

struct Overlay {
  std::vector<Element> elements;
  int n_uneven = 0;       ///< elements from here on are alike at rest
  Lanes dG{}, dlambda{};  ///< D less the law's own constants (Pa)
};

/// The share of its elastic strain by which an element slides: 1 - most/length where that is positive, else 0.
UPBEAD_IN_CLONES void share_of(const Element& element, const Lanes& squared, Lanes& share) {
  Lanes root;
  detail::square_root(element.most_squared / squared, root);
  share = squared > element.most_squared ? 1. - root : Lanes{};
}

/// The knees of the elements ascend: if one has never slid and does not slide now, neither do later ones that are
/// alike at rest.
UPBEAD_CLONES void correct_point(const Overlay& overlay, const Memory& memory, const PackTensor* slid,
                                 const PackTensor& strain, PackStress& correction) {
  const PackTensor e = deviator_of(strain);
  const int n = static_cast<int>(overlay.elements.size()), n_all = std::max(memory.n_moved, overlay.n_uneven);
  PackTensor sum;
  for (int i = 0; i < n; ++i) {
    const Element& element = overlay.elements[i];
    const PackTensor elastic = minus(minus(e, element.rest), slid[i]);
    Lanes squared, share;
    inner(elastic, elastic, squared);
    PackTensor now = slid[i];
    if (any_above(squared, element.most_squared)) {
      share_of(element, squared, share);
      add(share, elastic, now);
    } else if (i >= n_all) {
      break;
    }
    add(element.h, now, sum);
  }
  const Lanes mean = overlay.dlambda * (strain.xx + strain.yy);
  correction.xx = 2. * (sum.xx + overlay.dG * strain.xx) + mean;
  correction.yy = 2. * (sum.yy + overlay.dG * strain.yy) + mean;
  correction.xy = 2. * (sum.xy + overlay.dG * strain.xy);
  correction.zz = mean - 2. * (sum.xx + sum.yy);
}

/// Dissipation is the average stress times the plastic strain, as in HystereticLaw::update.
UPBEAD_CLONES void commit_point(const Overlay& overlay, Memory& memory, PackTensor* slid, const PackTensor& strain,
                                Lanes& dissipated) {
  const PackTensor e = deviator_of(strain), e_before = deviator_of(memory.strain);
  const int n = static_cast<int>(overlay.elements.size()), n_all = std::max(memory.n_moved, overlay.n_uneven);
  for (int i = 0; i < n; ++i) {
    const Element& element = overlay.elements[i];
    const PackTensor elastic = minus(minus(e, element.rest), slid[i]);
    Lanes squared, share, along, length;
    inner(elastic, elastic, squared);
    if (!any_above(squared, element.most_squared)) {
      if (i >= n_all) break;
      continue;
    }
    const PackTensor before = minus(minus(e_before, element.rest), slid[i]);
    share_of(element, squared, share);
    inner(before, elastic, along);
    detail::square_root(squared, length);
    dissipated += share > Lanes{} ? element.h * share * (element.most * length + along) : Lanes{};
    add(share, elastic, slid[i]);
    memory.n_moved = std::max(memory.n_moved, i + 1);
  }
  memory.strain = strain;
}

/// sum h (|e - q|^2 + 2 r : q) less sum h |e|^2; q is the plastic strain since rest, r that at rest.
UPBEAD_CLONES void stored_of_point(const Overlay& overlay, const Memory& memory, const PackTensor* slid,
                                   const PackTensor& strain, Lanes& energy) {
  const PackTensor e = deviator_of(strain);
  const Lanes volume = strain.xx + strain.yy;
  energy = -overlay.dG * (strain.xx * strain.xx + strain.yy * strain.yy + 2. * strain.xy * strain.xy) -
           0.5 * overlay.dlambda * volume * volume;
  for (int i = 0; i < memory.n_moved; ++i) {
    const Element& element = overlay.elements[i];
    const PackTensor& q = slid[i];
    const PackTensor left = minus(e, element.rest);
    Lanes own, with_left;
    inner(q, q, own);
    inner(q, left, with_left);
    energy += element.h * (own - 2. * with_left);
  }
}

/// Least distance of the elements' elastic strains from sliding.
UPBEAD_CLONES void margin_of_point(const Overlay& overlay, const PackTensor* slid, const PackTensor& strain,
                                   Lanes& margin) {
  const PackTensor e = deviator_of(strain);
  margin = Lanes{} + std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < overlay.elements.size(); ++i) {
    const Element& element = overlay.elements[i];
    const PackTensor elastic = minus(minus(e, element.rest), slid[i]);
    Lanes squared, length;
    inner(elastic, elastic, squared);
    detail::square_root(squared, length);
    const Lanes left = element.most - length;
    margin = left < margin ? left : margin;
  }
  const auto own = (overlay.dG == Lanes{}) & (overlay.dlambda == Lanes{});
  margin = own ? margin : Lanes{};
}

class HystereticPack : public SoilPack {
 public:
  explicit HystereticPack(const std::vector<PackedCell>& cells) : memory_(cells.front().points.size()) {
    std::size_t n = 0;
    for (const PackedCell& cell : cells) n = std::max(n, soil_of(cell).law->elements().size());
    // missing elements of a law, and those of lanes without a cell, have no stiffness and never slide
    Element idle;
    idle.most += infinite;
    idle.most_squared += infinite;
    overlay_.elements.assign(n, idle);
    for (std::size_t lane = 0; lane < cells.size(); ++lane) fill(cells[lane], static_cast<int>(lane));
    overlay_.n_uneven = n_uneven(cells);
    slid_.resize(memory_.size() * n);
  }
  void correct(int n, const PackTensor& strain, PackStress& correction) override {
    correct_point(overlay_, memory_[at(n)], slid(n), strain, correction);
  }
  void commit(int n, const PackTensor& strain, Lanes& dissipated) override {
    commit_point(overlay_, memory_[at(n)], slid(n), strain, dissipated);
  }
  void stored_beside_elastic(int n, const PackTensor& strain, Lanes& energy) const override {
    stored_of_point(overlay_, memory_[at(n)], &slid_[at(n) * overlay_.elements.size()], strain, energy);
  }
  void margin(int n, const PackTensor& strain, Lanes& margin) const override {
    margin_of_point(overlay_, &slid_[at(n) * overlay_.elements.size()], strain, margin);
  }
  double mobilised(int /*n*/, int lane, const PlaneStress& change) const override {
    const auto& [law, rest] = law_and_rest_[at(lane)];
    return law->mobilised(sum(rest, change));
  }
  void remember(std::vector<double>& memory) const override {
    for (const Memory& point : memory_) {
      remember_lanes(point.strain, memory);
      memory.push_back(point.n_moved);
    }
    for (const PackTensor& slid : slid_) remember_lanes(slid, memory);
  }
  const double* recall(const double* memory) override {
    for (Memory& point : memory_) {
      memory = recall_lanes(memory, point.strain);
      point.n_moved = static_cast<int>(*memory++);
    }
    for (PackTensor& slid : slid_) memory = recall_lanes(memory, slid);
    return memory;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static const HystereticSoil& soil_of(const PackedCell& cell) { return *cell.points.front()->hysteretic(); }
  static std::size_t at(int n) { return static_cast<std::size_t>(n); }
  PackTensor* slid(int n) { return &slid_[at(n) * overlay_.elements.size()]; }

  void fill(const PackedCell& cell, int lane) {
    const HystereticSoil& soil = soil_of(cell);
    const ElasticLaw& own = soil.law->elastic();
    law_and_rest_.emplace_back(soil.law, soil.rest);
    overlay_.dG[lane] = cell.elastic.G - own.G;
    overlay_.dlambda[lane] = cell.elastic.lambda - own.lambda;
    // the law's bulk modulus is that of `own`; its shear modulus is the sum over the elements, own.G to round-off
    for (std::size_t i = 0; i < soil.law->elements().size(); ++i) {
      const auto [h, y] = soil.law->elements()[i];
      const PlaneStrain& rest = soil.now.plastic[i];
      Element& element = overlay_.elements[i];
      element.h[lane] = h;
      element.most[lane] = y / (std::sqrt(2.) * h);
      element.most_squared[lane] = element.most[lane] * element.most[lane];
      element.rest.xx[lane] = rest.xx;
      element.rest.yy[lane] = rest.yy;
      element.rest.xy[lane] = rest.xy;
    }
  }
  static int n_uneven(const std::vector<PackedCell>& cells) {
    std::size_t most = 0;
    for (const PackedCell& cell : cells) {
      const std::vector<PlaneStrain>& rest = soil_of(cell).now.plastic;
      std::size_t n = rest.size();
      const PlaneStrain& last = rest.back();
      while (n > 0 && rest[n - 1].xx == last.xx && rest[n - 1].yy == last.yy && rest[n - 1].xy == last.xy) --n;
      most = std::max(most, n);
    }
    return static_cast<int>(most);
  }

  Overlay overlay_;
  std::vector<std::pair<std::shared_ptr<const HystereticLaw>, PlaneStress>> law_and_rest_;  ///< by lane
  std::vector<Memory> memory_;                                                              ///< by points
  std::vector<PackTensor> slid_;  ///< by points and elements, since rest
};

}  // namespace

std::unique_ptr<SoilPack> hysteretic_pack(const std::vector<PackedCell>& cells) {
  return std::make_unique<HystereticPack>(cells);
}

}  // namespace upbead

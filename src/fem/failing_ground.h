// Ground whose soils may fail, under given loads.
#pragma once

#include <functional>
#include <string>

#include "fem/ground.h"
#include "fem/limit_state.h"
#include "fem/rest_state.h"
#include "fem/static_march.h"

namespace upbead {

/// Whether soil of this region may fail; it has a strength.
using Fails = std::function<bool(const Region&)>;

class FailingGround {
 public:
  /// At rest, under all weights. What is not said to fail is elastic.
  FailingGround(const Scene& scene, const Mesh& mesh, const SoilState& state, Fails fails, RestProgress progress);

  /// Other loads from now on; searches start from the elastic stress under them.
  void put_on(Vector loads);
  /// Applies all loads in steps: the elastic stress is returned to the strength, and the loads that it then does not
  /// bear are applied. Steps from zero stress would be no easier without cohesion: stresses would only scale.
  /// `patient`: a step that fails is cut.
  StaticReport bear_loads(bool associated, bool patient);
  /// Whether any stress bears the loads within the strength over F.
  LimitAnswer bear_at_limit(double F, double done);

  /// "region 'mound' at (3.2, 1.5) m", of an active cell.
  std::string name_of(unsigned index) const;
  const Ground& ground() const { return ground_; }
  StaticSoil& soil() { return soil_; }

 private:
  std::size_t n_cells() const { return ground_.space().mesh().triangulation.n_active_cells(); }
  void tell(double done) const;
  void start_from_elastic();
  StaticLaws laws(double F, bool associated) const;

  Scene scene_;
  Ground ground_;
  Fails fails_;
  Vector loads_;
  StaticSoil soil_;
  Vector x_;
  PointStresses elastic_;
  RestProgress progress_;
};

/// Whether the region has a table strength.
bool has_some_strength(const Region& region);

}  // namespace upbead

// Ground whose soils may fail, under given loads.
#pragma once

#include <functional>
#include <string>

#include "fem/construction.h"
#include "fem/ground.h"
#include "fem/limit_state.h"
#include "fem/rest_state.h"
#include "fem/static_march.h"

namespace upbead {

/// Whether soil of this region may fail; it has a strength.
using Fails = std::function<bool(const Region&)>;

class FailingGround {
 public:
  /// At rest, under all weights of the stage. What is not said to fail is elastic. `before`: stresses of the last
  /// stage; empty before the first.
  FailingGround(const Stage& stage, const Mesh& mesh, const SoilState& state, Fails fails, RestProgress progress,
                PointStresses before = {});

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
  /// The stage as it stands. `followed`: whether the motion led to these stresses; where it did not, it is not known.
  BuiltStage built(const RestState& rest, bool followed) const;

 private:
  std::size_t n_cells() const { return ground_.space().mesh().triangulation.n_active_cells(); }
  void tell(double done) const;
  void start_from_elastic();
  StaticLaws laws(double F, bool associated) const;

  Stage stage_;
  Ground ground_;
  Fails fails_;
  PointStresses before_;
  Vector loads_;
  StaticSoil soil_;
  Vector elastic_move_, x_;  ///< of the elastic ground; of the soil after that
  PointStresses elastic_;
  RestProgress progress_;
};

/// A section that is built at once: whether any stress is in equilibrium does not depend on how it was built.
Stage built_at_once(Scene scene, const Mesh& mesh);

/// Whether the region has a table strength.
bool has_some_strength(const Region& region);

}  // namespace upbead

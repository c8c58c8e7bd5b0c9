// A caisson on springs and dashpots at the middle of its base, which stand for its ground.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fem/caisson/caisson.h"
#include "fem/faces.h"
#include "fem/unknowns.h"

namespace upbead {

/// The level side on which a caisson stands: its middle, and its length B.
struct BaseLine {
  dealii::Point<dim> middle;
  double width = 0.;
};

/// The lowest outer side of the caisson of that mesh, where it is level; none where it is not.
std::optional<BaseLine> lowest_side(const Mesh& mesh);

/// Whether the caisson of that space stands on springs.
bool is_on_springs(const Space& space);

/// What springs and dashpots add to the system. With e the motions of the base's middle, m one of them:
///   e_x = x_G + (y_b - y_G) phi - slip,  e_y = y_G - (x_b - x_G) phi - opening,  e_phi = phi
///   K  +spring_m e_m(dx) e_m(x),   C  +dashpot_m e_m(dx) e_m(x)
/// and, under a slip, a mass that is small beside the caisson's.
class BaseSprings {
 public:
  /// Of a caisson that stands on springs and is one of the bodies.
  BaseSprings(const Region& region, const Space& space, const Unknowns& unknowns, const std::vector<Body>& bodies,
              const Caisson& caisson);
  const FaceTerms& terms() const { return terms_; }
  /// Adds their forces on the base, in its unit motions about its middle.
  void add_to(NodalReaction& ground) const;

 private:
  std::array<double, n_motions> spring_, dashpot_;
  std::array<Row, n_motions> motion_;  ///< e_m
  FaceTerms terms_;
};

}  // namespace upbead

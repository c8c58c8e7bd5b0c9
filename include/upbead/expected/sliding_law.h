// Sea states, the forces of their waves on the caisson, the sliding distance of one wave, and its expected value over
// all waves, after Shimosako and Takahashi (1994).
#pragma once

#include <functional>
#include <limits>
#include <memory>

#include "upbead/sliding/base_pressure.h"
#include "upbead/sliding/combined.h"
#include "upbead/waves/goda.h"
#include "upbead/waves/wave_heights.h"

namespace upbead {

/// Waves of one significant height.
struct SeaState {
  double significant_height = 0.;  ///< H_1/3 at the wall (m)
  double period = 0.;              ///< T, the significant one (s)
  double waves = 0.;               ///< their number
  double angle = 0.;               ///< beta, already turned towards the wall's normal (rad)
  double water_level = 0.;         ///< still water above that of the section (m)
};

/// The sea in deep water that the sea state comes from, and its highest random breaker, at its water level [Goda 2000].
SeaBefore sea_before(const Section& section, const Water& water, const SeaState& state);

/// Heights after Rayleigh (Longuet-Higgins 1952): exp(-2 (H / H_1/3)^2) of all waves are higher than H. Two options
/// concern the highest waves. Waves above a `limit` break and arrive with the height of the limit: none is lost, which
/// is on the safe side. Waves beyond a `cut` are set aside: they count as waves that do not slide the caisson, and the
/// number of the others is not raised to replace them.
class RayleighHeights {
 public:
  static constexpr double no_cut = std::numeric_limits<double>::infinity();

  /// `cut`: over H_1/3; `limit`: m. Throws std::invalid_argument where one is not above 0.
  explicit RayleighHeights(double significant_height, double cut = no_cut, double limit = no_cut);
  /// Share of all waves that are higher than H and not beyond the cut.
  double exceedance(double height) const;
  /// Density of H (1/m), without the waves at the limit; their share is at_limit().
  double density(double height) const;
  /// The height H that this share of all waves exceeds: 0 for the largest share, the highest wave for the share 0.
  double height(double exceedance) const;
  double significant_height() const { return significant_height_; }
  /// The highest wave (m); infinity without cut and limit.
  double highest() const { return highest_; }
  /// Share of all waves that broke at the limit.
  double at_limit() const { return at_limit_; }
  /// Share of all waves that broke at the limit or were set aside by the cut.
  double taken() const { return at_limit_ + beyond_; }

 private:
  double significant_height_, highest_;
  double beyond_;  ///< share of all waves beyond the cut
  double at_limit_;
};

/// What is certain; WaveFactors hold what is not.
struct Breakwater {
  Section section;
  Water water;
  DurationFactor k;        ///< tau_0 = k tau_0F
  CombinedModel combined;  ///< of the law `combined`
};

/// The uncertainty of one wave and of the section under it, as factors.
struct WaveFactors {
  double force = 1.;     ///< of P
  double uplift = 1.;    ///< of U
  double friction = 1.;  ///< of mu
  double weight = 1.;    ///< of W; the buoyancy W - W' stays
};

/// W, W' and mu after the factors.
Section with_factors(const Section& section, const WaveFactors& factors);

/// Goda's forces at the water level of the sea state.
class WaveForces {
 public:
  WaveForces(const Breakwater& breakwater, const SeaState& state);
  /// At the water level of the sea state.
  const Breakwater& breakwater() const { return breakwater_; }
  /// What still water does there by the harbour_level of the section.
  const StillWater& still() const { return still_; }
  double period() const { return period_; }
  double wavelength() const { return goda_.wavelength(); }  ///< L (m)
  WavePressure at(double height, const WaveFactors& factors, PressureFormula formula = PressureFormula::extended) const;
  /// F_Smax - mu W' (N/m), with alpha*, and with still water's push where it acts with the wave, as in stability().
  double excess(double height, const WaveFactors& factors) const;
  /// The height at which excess() is zero (m), approached from below to the last digits; infinity where it is negative
  /// even at 1 km.
  double threshold(const WaveFactors& factors) const;
  /// Edge pressures, eccentricity and overturning margin, at rest and at the peak of a wave, by Goda's P, M_P, U and
  /// M_U with alpha*: his p_e and safety factor, see stability().
  WorstBase base(double height, const WaveFactors& factors) const;

 private:
  Breakwater breakwater_;
  StillWater still_;
  double period_;
  Goda goda_;
};

enum class Law {
  paper,     ///< eq. (7) of Shimosako and Takahashi (1994)
  exact,     ///< the integral of their eqs. (4) and (6)
  combined,  ///< Shimosako and Takahashi (1998): a standing wave and a pulse, added mass
  dynamic,   ///< the caisson's own shear force F_T(t) under an impulsive force
};

/// The law's name in files.
const char* word(Law law);

/// How far one wave of a sea state slides the caisson. Several threads may share one law.
class SlidingLaw {
 public:
  virtual ~SlidingLaw() = default;
  /// S of a wave (m); not negative.
  virtual double distance(double height, const WaveFactors& factors = {}) const = 0;
  /// Whether a wave of that height is above the threshold. Much cheaper than threshold().
  virtual bool may_slide(double height, const WaveFactors& factors = {}) const { return height > threshold(factors); }
  /// A height (m) below which no wave slides the caisson; infinity where no wave does.
  virtual double threshold(const WaveFactors& factors = {}) const = 0;
  /// Forces and moments of the waves by formulas; null where the law has none.
  virtual const WaveForces* forces() const { return nullptr; }
};

/// The law `paper`, `exact` or `combined`. Throws std::invalid_argument for the law `dynamic`, which needs a model, and
/// where Goda's formulas do not accept the section at the sea state's water level.
std::unique_ptr<SlidingLaw> formula_law(Law law, const Breakwater& breakwater, const SeaState& state);

struct Expectation {
  double distance = 0.;       ///< N (int S(H) p(H) dH + S of the limit times the share of waves at it) (m)
  double broken = 0.;         ///< the part of the waves at the limit (m)
  double error = 0.;          ///< estimate of its error (m)
  double sliding_waves = 0.;  ///< expected number of waves with S > 0
  double threshold = 0.;      ///< height from which S > 0 (m); infinity where there is none
};

/// Accuracy of the quadrature.
struct QuadratureChoice {
  double tolerance = 1e-9;  ///< relative, of a sea state's distance
  unsigned depth = 14;      ///< how often an interval may be halved
};

/// Adaptive Gauss-Kronrod quadrature (Boost). It begins at the height where sliding begins, and ends at the height that
/// 1e-18 of the sliding waves exceed, at the cut, or at the limit; the waves at the limit are added.
Expectation expected_distance(const SlidingLaw& law, const RayleighHeights& heights, double waves,
                              const QuadratureChoice& choice = {});

namespace detail {

/// The height (m) at which an increasing function stops being negative, approached from below: to the last digit.
/// Infinity where the function is negative up to 1 km.
double first_height(const std::function<double(double)>& f);

}  // namespace detail

}  // namespace upbead

// Sliding by the caisson's own dynamics: the force of every breaking wave acts on the caisson's reduced model.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "dynamics/batch_response.h"
#include "dynamics/readings_at.h"
#include "dynamics/truncate.h"
#include "expected/ways_to_fail.h"
#include "upbead/expected/sliding_law.h"
#include "upbead/rupture/circle_family.h"
#include "upbead/waves/breaking_impact.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// The part of a reduced model that is used.
struct ShearModel {
  ModalModel modes;            ///< the whole reduced model
  int load = 0;                ///< index of the load that stands for the wave
  int shear = 0;               ///< index of the reading F_T
  double force_per_load = 1.;  ///< P (N/m) of a unit of that load
  double caisson_mass = 0.;    ///< W/g (kg/m)
  /// Indices of the readings N, M, U of the pores, and the moment of this U about the bottom's middle; empty where
  /// the model has no such readings.
  std::vector<int> base{};
  std::shared_ptr<const CircleModel> circles{};  ///< null where the model has no slip circles
};

/// What is known of a force before it is sampled: P(0) = 0, its largest value and its slopes.
struct ForceLimits {
  double largest = 0.;      ///< |P| (N/m)
  double rise = 0.;         ///< time from the start in which it may be steep (s)
  double first_slope = 0.;  ///< largest |P'| in that time (N/m/s)
  double later_slope = 0.;  ///< largest |P'| afterwards (N/m/s)
};

/// Computes F_T of a wave by the reduced model, or bounds of it. Safe to share between threads.
class ShearAnswer {
 public:
  /// `step`: of the samples of all waves (s). `longest`: longest wave for which bound() by limits is known (s).
  ShearAnswer(const ShearModel& model, double step, double longest);
  /// F_T for P, both in n samples from t = 0, where P is 0; straight in between.
  void respond(const double* force, int n, double* shear) const;
  /// Whether the model has the readings of the base.
  bool knows_base() const { return !base_.empty(); }
  /// The four readings of the base under such a P, one in each row; only where knows_base().
  Eigen::MatrixXd base(const std::vector<double>& force) const;
  /// The slip circles under the caisson; null where the model has none, or no readings of the base.
  const CircleFamily* circles() const { return circles_ && knows_base() ? &circles_->family : nullptr; }
  /// Their readings under such a P at some of its samples, a column each; only where there are circles.
  Eigen::MatrixXd pressures(const std::vector<double>& force, const std::vector<std::size_t>& moments) const;
  /// A value that no |F_T| among the first n samples exceeds; infinity for waves longer than `longest`.
  double bound(const ForceLimits& force, int n) const;
  /// A value that no |F_T| under P exceeds: the response of a few modes, plus a bound of all other modes. P as for
  /// respond().
  double bound(const double* force, int n) const;
  double step() const { return step_; }
  double caisson_mass() const { return mass_; }

 private:
  void make_bounds(int n);

  double step_, mass_, load_per_force_;
  BatchResponse batch_;
  TruncatedModel few_;
  BatchResponse few_batch_;
  std::vector<BatchResponse> base_;
  std::shared_ptr<const CircleModel> circles_;
  std::optional<ReadingsAt> pressures_;
  /// With the response a to a hat function, and the response s to a ramp that rises in one step to 1 and stays there:
  std::vector<double> hat_;           ///< sum of the first |a|
  std::vector<double> late_;          ///< sum of the first |s - 1| times the step (s)
  std::vector<double> late_windows_;  ///< the largest such sum over i * stride_ neighbours (s)
  int stride_ = 1;
};

/// The course of the uplift under an impulsive force.
enum class ImpactUplift {
  held,        ///< U_max until T/4, then U_max sin(2 pi t/T): on the safe side
  in_phase,    ///< U_max P(t) / P_max
  sinusoidal,  ///< U_max sin(2 pi t/T)
};

/// Assumptions made here: no published method gives the history of a wave's force from its height.
struct ImpactAssumptions {
  /// e in P_I = P_1 (1 + e alpha*). None: P_I is Goda's P with alpha*, the least that may be assumed: that P already is
  /// an effective sliding force, and measured impulsive peaks are several times as large (Shimosako and Takahashi
  /// 1994).
  std::optional<double> peak_gain{};
  /// P_I = F* rho g H_b^2 in place of that for waves of at least H_b, never below Goda's P.
  std::optional<ImpactScatter> proverbs{};
  double rise_coefficient = .769;  ///< c in t_r = c sqrt(d/g) / F*; 8.94 x 0.086
  double duration_least = 2.;      ///< t_d/t_r for the slowest rise
  double duration_gain = 8.;       ///< by how much t_d/t_r is larger for the fastest rise
  double duration_decay = 18.;     ///< t_d = t_r (least + gain exp(-decay t_r/T))
  ImpactUplift uplift = ImpactUplift::held;
};

/// A wave on the wall: P(t) = max(gamma P_1 sin(2 pi t/T), triangle) for 0 <= t <= T/2.
struct ImpactWave {
  double period = 0.;          ///< T (s)
  double standing_force = 0.;  ///< P_1, by alpha_1 alone (N/m)
  double reduction = 1.;       ///< gamma: half a period keeps the impulse P_1 T/pi
  double peak = 0.;            ///< P_I (N/m)
  double rise = 0.;            ///< t_r (s)
  double duration = 0.;        ///< t_d (s), at most T/2
  double uplift = 0.;          ///< U_max (N/m)
};

/// The forces of a wave on the wall by Goda's formulas.
struct WaveOnWall {
  double height = 0.;          ///< H (m)
  double period = 0.;          ///< T (s)
  double standing_force = 0.;  ///< P_1 (N/m)
  double alpha_star = 0.;
  double uplift = 0.;      ///< U_max (N/m)
  double goda_force = 0.;  ///< P with alpha* (N/m)
  /// H_b (m), from which it breaks on the wall; none where P_I asks for none.
  std::optional<double> breaker{};
};

/// Of Goda's pressures by alpha_1 alone, and by alpha*.
WaveOnWall wave_on_wall(double height, double period, const WavePressure& standing, const WavePressure& extended,
                        const std::optional<double>& breaker = {});

/// H_b of impacts by PROVERBS; none without them.
std::optional<double> breaker_of(const ImpactAssumptions& assumptions, const Section& section, double wavelength);

/// The impulsive wave by these assumptions. `berm_depth`: d (m). Where the triangle would outlast the half period it
/// ends with it, and rises in at most half its duration.
ImpactWave impact_wave(const ImpactAssumptions& assumptions, const WaveOnWall& on_wall, const Water& water,
                       double berm_depth);

/// P(t).
double force_at(const ImpactWave& wave, double t);

/// The times between which the triangle is the larger part (s); both are equal where it never is.
std::array<double, 2> where_triangle_leads(const ImpactWave& wave);

/// Largest value and slopes of the wave's force.
ForceLimits limits(const ImpactWave& wave);

/// Number of samples at 0, step, 2 step, ... until T/2 is over.
int number_of_samples(const ImpactWave& wave, double step);
/// P and U at the first `n` of these times.
void sample_force(const ImpactWave& wave, double step, int n, double* force);
void sample_uplift(const ImpactWave& wave, ImpactUplift shape, double step, int n, const double* force, double* uplift);

/// One wave, from its force to the sliding distance of the caisson.
struct DynamicWave {
  ImpactWave wave;
  std::vector<double> time, force, shear, sliding_force;  ///< P, F_T, F_S = F_T + mu U at the samples
  double sliding = 0.;                                    ///< S (m)
};

/// What such a wave does to the caisson's bottom, for contact node by node.
struct WaveOnBottom {
  double step = 0.;                              ///< of the samples, from t = 0 (s)
  std::vector<double> force, uplift;             ///< P, U (N/m)
  double friction = 0., weight = 0., push = 0.;  ///< mu; W', and the push of still water at two levels (N/m)
  double mass_ratio = 1.;                        ///< the model's mass over that of the caisson
};

/// S by slide() of F_S = F_T(t) + mu U(t), with F_T the reduced model's response to the force of impact_wave(). A
/// scatter of the weight changes the resistance and the sliding mass, not the model.
class DynamicLaw : public SlidingLaw {
 public:
  DynamicLaw(const Breakwater& breakwater, const SeaState& state, const ImpactAssumptions& assumptions,
             std::shared_ptr<const ShearAnswer> answer);
  double distance(double height, const WaveFactors& factors) const override;
  bool may_slide(double height, const WaveFactors& factors) const override;
  /// From a bound of F_T under any force with that peak: waves above the threshold may still not slide.
  double threshold(const WaveFactors& factors) const override;
  /// All histories of one wave, also where it does not slide the caisson.
  DynamicWave wave(double height, const WaveFactors& factors = {}) const;
  const WaveForces* forces() const override { return &forces_; }
  /// U comes with P: until P is largest it is no larger than in phase with it.
  WaveOnBottom on_bottom(double height, const WaveFactors& factors = {}) const;
  /// At rest and in such a wave: the model's N and M, with U(t) as Goda's triangle and the model's uplift of the
  /// pores, as `respond` computes it. None where the model has no such readings.
  std::optional<WorstBase> base(double height, const WaveFactors& factors = {}) const;
  /// Every way to fail in such a wave, with that base; none where the model has no slip circles.
  std::optional<WaysToFail> ways(double height, const WaveFactors& factors = {}) const;

 private:
  ImpactWave on_wall(double height, const WaveFactors& factors) const;
  /// mu (W' + dW') (N/m): the resistance with still water at two levels, whose push is a part of the force.
  double resistance(const Section& section) const;
  /// A bound of |F_S| and still water's push for such a wave, minus that resistance (N/m).
  double most(const ImpactWave& wave, const Section& section) const;
  double slide_under(const DynamicWave& wave, const Section& section) const;
  EffectiveBase base_under(const ImpactWave& wave, const std::vector<double>& force, const Section& section) const;
  std::vector<double> sampled(const ImpactWave& wave) const;
  std::vector<double> times(std::size_t n) const;

  WaveForces forces_;
  ImpactAssumptions assumptions_;
  std::shared_ptr<const ShearAnswer> answer_;
};

}  // namespace upbead

// Sliding by the caisson's own dynamics: the force of every wave that breaks on it goes through its reduced model.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "dynamics/batch_response.h"
#include "dynamics/truncate.h"
#include "upbead/expected/sliding_law.h"
#include "upbead/waves/goda.h"

namespace upbead {

/// Which part of a reduced model answers.
struct ShearModel {
  ModalModel modes;            ///< of everything that was reduced
  int load = 0;                ///< the load that is the wave
  int shear = 0;               ///< the reading F_T
  double force_per_load = 1.;  ///< P (N/m) of a unit of that load
  double caisson_mass = 0.;    ///< W/g (kg/m)
  /// The readings N, M, U of the pores and their moment about the bottom's middle; empty where it has none.
  std::vector<int> base{};
};

/// What is known of a force before it is sampled: P(0) = 0 and how steep it is.
struct ForceLimits {
  double largest = 0.;      ///< |P| (N/m)
  double rise = 0.;         ///< how long it may be steep at first (s)
  double first_slope = 0.;  ///< largest |P'| until then (N/m/s)
  double later_slope = 0.;  ///< and afterwards
};

/// Safe to share between threads.
class ShearAnswer {
 public:
  /// `step`: of all waves (s). `longest`: how long a wave may last for bound() to know it (s).
  ShearAnswer(const ShearModel& model, double step, double longest);
  /// F_T for P, both in n samples from t = 0, where P is 0; straight in between.
  void respond(const double* force, int n, double* shear) const;
  /// Whether it knows what presses on the base.
  bool knows_base() const { return !base_.empty(); }
  /// The four readings of the base for such a P, a row each; only where it knows them.
  Eigen::MatrixXd base(const std::vector<double>& force) const;
  /// No |F_T| among the first n samples exceeds this; infinity for longer waves than known.
  double bound(const ForceLimits& force, int n) const;
  /// No |F_T| for P exceeds this: the answer of few modes, and what the others may add. P as of respond().
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
  /// Of the answer a to a hat function and the answer s to a ramp of one step that stays at 1:
  std::vector<double> hat_;           ///< sum of the first |a|
  std::vector<double> late_;          ///< sum of the first |s - 1| times the step (s)
  std::vector<double> late_windows_;  ///< the largest such sum over i * stride_ neighbours (s)
  int stride_ = 1;
};

/// How the uplift runs beside an impulsive force.
enum class ImpactUplift {
  held,        ///< U_max until T/4, then U_max sin(2 pi t/T): on the safe side
  in_phase,    ///< U_max P(t) / P_max
  sinusoidal,  ///< U_max sin(2 pi t/T)
};

/// Assumptions of ours: no published method tells the force history of a wave from its height.
struct ImpactAssumptions {
  double peak_gain = 0.5;          ///< e in P_I = P_1 (1 + e alpha*)
  double rise_coefficient = .769;  ///< c in t_r = c sqrt(d/g) / F*; 8.94 x 0.086
  double duration_least = 2.;      ///< t_d/t_r of the slowest rise
  double duration_gain = 8.;       ///< how much more of the fastest
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

/// What Goda's formulas tell of a wave on the wall.
struct WaveOnWall {
  double height = 0.;          ///< H (m)
  double period = 0.;          ///< T (s)
  double standing_force = 0.;  ///< P_1 (N/m)
  double alpha_star = 0.;
  double uplift = 0.;  ///< U_max (N/m)
};

/// What the assumptions make of it. `berm_depth`: d (m). The triangle ends with the half period; it then rises in at
/// most half its duration.
ImpactWave impact_wave(const ImpactAssumptions& assumptions, const WaveOnWall& on_wall, const Water& water,
                       double berm_depth);

/// P(t).
double force_at(const ImpactWave& wave, double t);

/// Between which times the triangle is the larger part (s); two equal ones where it never is.
std::array<double, 2> where_triangle_leads(const ImpactWave& wave);

/// How large and steep its force is.
ForceLimits limits(const ImpactWave& wave);

/// How many samples at 0, step, 2 step, ... there are until T/2 is over.
int number_of_samples(const ImpactWave& wave, double step);
/// P and U at the first `n` of them.
void sample_force(const ImpactWave& wave, double step, int n, double* force);
void sample_uplift(const ImpactWave& wave, ImpactUplift shape, double step, int n, const double* force, double* uplift);

/// One wave, from its force to how far it slides the caisson.
struct DynamicWave {
  ImpactWave wave;
  std::vector<double> time, force, shear, sliding_force;  ///< P, F_T, F_S = F_T + mu U at the answer's steps
  double sliding = 0.;                                    ///< S (m)
};

/// S of F_S = F_T(t) + mu U(t) by slide(), with F_T the reduced model's answer to the force of impact_wave(). A scatter
/// of the weight changes the resistance and the mass that slides, not the model.
class DynamicLaw : public SlidingLaw {
 public:
  DynamicLaw(const Breakwater& breakwater, const SeaState& state, const ImpactAssumptions& assumptions,
             std::shared_ptr<const ShearAnswer> answer);
  double distance(double height, const WaveFactors& factors) const override;
  bool may_slide(double height, const WaveFactors& factors) const override;
  /// By a bound on the answer to any force of that peak: waves above it may still not slide.
  double threshold(const WaveFactors& factors) const override;
  /// Everything about one wave, also if it does not slide.
  DynamicWave wave(double height, const WaveFactors& factors = {}) const;
  const WaveForces* forces() const override { return &forces_; }
  /// At rest and in such a wave, by the model's N and M beside U(t) as Goda's triangle and the model's uplift of pores;
  /// as `respond` has it. None where the model has no such readings.
  std::optional<WorstBase> base(double height, const WaveFactors& factors = {}) const;

 private:
  ImpactWave on_wall(double height, const WaveFactors& factors) const;
  /// The largest |F_S| that such a wave might have, less mu W' (N/m).
  double most(const ImpactWave& wave, const Section& section) const;
  double slide_under(const DynamicWave& wave, const Section& section) const;

  WaveForces forces_;
  ImpactAssumptions assumptions_;
  std::shared_ptr<const ShearAnswer> answer_;
};

}  // namespace upbead

// A section in one wave whose numbers are random, and the margins of its limit states by Goda's formulas with alpha*.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "design/design_tables.h"
#include "reliability/ground.h"
#include "reliability/seaward.h"
#include "upbead/expected/sliding_law.h"

namespace upbead {

/// What acts and resists at one point of the variables, per metre.
struct SectionPoint {
  Section section;        ///< at its water level, with the factors of mu and W
  WavePressure pressure;  ///< with the factors of P and U
  StillWater still;       ///< by the harbour's level
  SlidingLoad load;
  Limits limits;
  double height = 0.;                            ///< H (m)
  double force_factor = 1.;                      ///< of P
  double sliding_factor = 1.;                    ///< of S
  GroundWave wave;                               ///< what the ground is asked; set where there is a ground
  std::function<const GroundPoint&()> ground{};  ///< its answer, found when it is asked for; none without a ground
};

/// What a ground does in a wave. Throws NumericsError where its soil has no answer.
using AskGround = std::function<GroundPoint(const GroundWave&)>;

/// The section at values x of the variables of [reliability.variables], in the order of their names.
class SectionModel {
 public:
  /// `tables`: of a design that check_reliability() has accepted.
  explicit SectionModel(const DesignTables& tables, AskGround ground = nullptr);
  SectionModel(const SectionModel&) = delete;
  SectionModel& operator=(const SectionModel&) = delete;
  /// Throws std::invalid_argument where Goda's formulas do not accept x: a depth that is not above 0.
  SectionPoint at(const std::vector<double>& x);
  /// The numbers of the design, where all variables are certain: characteristic values.
  const std::vector<double>& certain() const { return certain_; }
  /// Points whose soil has no answer, and why the first of them has none.
  int n_unanswered() const { return n_unanswered_; }
  const std::string& why_unanswered() const { return why_unanswered_; }

 private:
  void ask_ground(const std::vector<double>& x, double uplift, const DesignWave& wave, SectionPoint& out);

  DesignTables tables_;
  std::string wave_;
  std::vector<double> factors_;   ///< in the order of random_factors
  std::vector<double*> targets_;  ///< the number of each variable, in tables_ or factors_
  std::vector<double> certain_;
  AskGround ground_;
  std::map<std::vector<double>, GroundPoint> answered_;
  int n_unanswered_ = 0;
  std::string why_unanswered_;
};

/// A way to fail, with its margin: below 0 it fails. All margins are without unit, smooth where S or p_e is not.
struct SectionLimitState {
  std::string name, meaning;
  std::function<double(const SectionPoint&)> margin;
  std::string why_not;     ///< it cannot be asked; "" where it can
  bool of_codes = false;   ///< a distance that codes ask for, no failure of the section
  bool by_ground = false;  ///< the margin follows from a reduced model, whose error is no smooth function
};

/// S > limit (m), as a margin that does not end where S = 0. See limit_states.cc.
double sliding_margin(const SectionPoint& at, double limit);

/// Sliding and overturning, S and p_e beyond [limits]; then S beyond 0.1, 0.3 and 1.0 m of codes. `at`: the section
/// where all is certain. With its ground, the same by F_T: see ground_states.cc.
std::vector<SectionLimitState> section_limit_states(const SectionPoint& at, const SeawardForce& seaward);

/// Sliding, S beyond limits.sliding, overturning and heel pressure by F_T and the forces on the base under the wave's
/// P(t).
std::vector<SectionLimitState> ground_states(const SectionPoint& at, bool knows_base);

}  // namespace upbead

// Steps of contact on a ground of few coordinates.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "dynamics/contact_stage.h"
#include "dynamics/ground_matrices.h"

namespace upbead::detail {

/// E = M + g C + g^2 K of a ground, condensed on its interface. The right-hand side has rows along U, see
/// GroundProducts.
class GroundStage : public CondensedStage {
 public:
  GroundStage(const GroundMatrices& ground, double g, double friction);
  Vector begin(const DirkStage& stage) override;
  void finish(DirkStage& stage) override;
  ContactProblem& problem() override { return problem_; }
  const Vector& moved() const { return moved_; }

 private:
  const Eigen::MatrixXd& along_;  ///< U
  Eigen::MatrixXd inverse_;       ///< E_ff^-1
  Eigen::MatrixXd follows_;       ///< E_ff^-1 A
  ContactProblem problem_;
  Vector moved_;  ///< along U, by a of the stage
};

/// Motion of a ground with what it is along U, and what its matrices make of it, which each stage changes by their
/// products with a alone.
struct GroundMotion {
  Vector x, v, Kx, Kv, Cv, Mv;
  int steps = 0;  ///< since these products were made anew
};

/// What the steps of all tableaux share, and marches on the same ground after each other: `motion` is of the present
/// one.
struct GroundStages {
  std::map<double, GroundStage> by_g;
  GroundMotion motion;
};

/// Dirk for a ground: the same stages, by one product with each matrix.
class GroundSteps : public Steps {
 public:
  GroundSteps(const System& system, const GroundMatrices& ground, Tableau tableau, ContactStage& contact,
              std::shared_ptr<GroundStages> shared);
  bool step(State& state, double h, double inside, EffectiveMatrices& matrices, EnergyMeter* meter,
            StageLaw* law) override;
  int n_stages() const override { return static_cast<int>(c_.size()); }
  const std::vector<double>& load() const override { return load_; }

 private:
  GroundStage& stage_of(double g);
  void follow(const State& state);
  void predict(const GroundMotion& motion, double h, int i);
  void multiply(const GroundStage& E, double g, int i);
  void keep(double h, const State& state, EnergyMeter* meter);
  void account(double h, const GroundMotion& now, EnergyMeter& meter) const;

  const System& system_;
  const GroundMatrices& ground_;
  LoadSum loads_;
  Tableau tableau_;
  Vector b_, c_;
  ContactStage& contact_;
  std::shared_ptr<GroundStages> shared_;
  std::vector<double> load_;
  Eigen::MatrixXd V_, A_, KV_, KA_, CV_, CA_, MA_;  ///< of the stages, one per column, as GroundProducts
  Vector f_, residual_, sign_;
  DirkStage now_;
  Vector v_predicted_, K_of_v_, C_of_v_;  ///< the velocity that is predicted, with what it is along U
};

}  // namespace upbead::detail

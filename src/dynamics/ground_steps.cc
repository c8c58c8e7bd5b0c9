#include "dynamics/ground_steps.h"

#include <utility>

#include "algebra/dense.h"

namespace upbead::detail {

namespace {

constexpr std::size_t kept_stages = 12;
constexpr int steps_of_products = 64;  ///< then products are made anew, so that their round-off does not add up

/// The block of the free coordinates, with what couples them: [E_ff, A].
Eigen::MatrixXd ground_block(const GroundMatrices& ground, double g) {
  const Eigen::Index r = ground.n_free();
  Eigen::MatrixXd E(r, r + ground.U.cols());
  E.leftCols(r) = ground.M_ff + g * ground.C_ff;
  E.diagonal() += g * g * ground.K_ff;
  E.rightCols(ground.U.cols()) = ground.M_f + g * ground.C_f + g * g * ground.K_f;
  return E;
}

/// E_ff^-1, and below it A' E_ff^-1.
Eigen::MatrixXd ground_inverse(const Eigen::MatrixXd& E) {
  const Eigen::Index r = E.rows(), k = E.cols() - r;
  Eigen::MatrixXd inverse(r + k, r);
  inverse.topRows(r) = solve_dense(E.leftCols(r), Eigen::MatrixXd::Identity(r, r));
  inverse.topRows(r) = (0.5 * (inverse.topRows(r) + inverse.topRows(r).transpose())).eval();
  inverse.bottomRows(k) = transposed_product(E.rightCols(k), inverse.topRows(r));
  return inverse;
}

Eigen::MatrixXd condensed_ground(const GroundMatrices& ground, double g, const Eigen::MatrixXd& inverse) {
  const Eigen::Index k = ground.U.cols();
  const Eigen::MatrixXd A = ground_block(ground, g).rightCols(k);
  const Eigen::MatrixXd taken = product(inverse.bottomRows(k), A);
  const Eigen::MatrixXd D =
      ground.M_ii + g * ground.C_ii + g * g * ground.K_ii - product(product(ground.U, taken), ground.U.transpose());
  return 0.5 * (D + D.transpose());
}

}  // namespace

GroundStage::GroundStage(const GroundMatrices& ground, double g, double friction)
    : along_(ground.U),
      inverse_(ground_inverse(ground_block(ground, g))),
      follows_(inverse_.bottomRows(ground.U.cols()).transpose()),
      problem_(condensed_ground(ground, g, inverse_), friction) {}

/// With the interface at rest the free coordinates are E_ff^-1 rhs_f; what its motion adds is in D.
Vector GroundStage::begin(const DirkStage& stage) {
  const Eigen::Index r = inverse_.cols(), k = along_.cols(), m = along_.rows();
  alone_ = product(inverse_, stage.rhs.head(r));
  Vector residual = product(along_, alone_.tail(k)) - stage.rhs.tail(m);
  residual += product_of_some(problem_.stiffness(), stage.a.tail(m));
  return residual;
}

void GroundStage::finish(DirkStage& stage) {
  const Eigen::Index r = inverse_.cols(), m = along_.rows();
  stage.a.head(r) = alone_.head(r);
  if (const auto motion = stage.a.tail(m); !motion.isZero(0.))
    stage.a.head(r) -= product(follows_, transposed_product(along_, motion));
}

GroundSteps::GroundSteps(const System& system, const GroundMatrices& ground, Tableau tableau, ContactStage& contact,
                         std::shared_ptr<GroundStages> shared)
    : system_(system),
      ground_(ground),
      loads_(system),
      tableau_(std::move(tableau)),
      b_(tableau_.b()),
      c_(tableau_.c()),
      contact_(contact),
      shared_(std::move(shared)),
      sign_(system.size()),
      now_{{}, {}, {}, {}, Vector::Zero(system.size()), {}, nullptr, 0., 0.} {
  for (Eigen::MatrixXd* stages : {&V_, &A_, &KV_, &KA_, &CV_, &CA_, &MA_}) stages->resize(system.size(), c_.size());
  for (int i = 0; i < system.size(); ++i)
    sign_[i] = system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse ? -1. : 1.;
}

GroundStage& GroundSteps::stage_of(double g) {
  auto& stages = shared_->by_g;
  const auto found = stages.find(g);
  if (found != stages.end()) {
    found->second.problem().set_friction(system_.interface->friction);
    return found->second;
  }
  if (stages.size() == kept_stages) stages.clear();
  return stages.try_emplace(g, ground_, g, system_.interface->friction).first->second;
}

/// Makes the products those of the state: it may have been set back, or be another one.
void GroundSteps::follow(const State& state) {
  GroundMotion& motion = shared_->motion;
  if (++motion.steps < steps_of_products && motion.x.size() == state.x.size() && motion.x == state.x &&
      motion.v == state.v)
    return;
  GroundProducts of_v = ground_.products(state.v);
  motion = {state.x, state.v, ground_.products(state.x).K, std::move(of_v.K), std::move(of_v.C), std::move(of_v.M)};
}

void GroundSteps::predict(const GroundMotion& motion, double h, int i) {
  const double g = h * tableau_.gamma();
  const Vector weights = h * tableau_.a.row(i).head(i).transpose();
  const auto with = [&](const Vector& start, const Eigen::MatrixXd& stages) -> Vector {
    return start + stages.leftCols(i) * weights;
  };
  now_.v_predicted = with(motion.v, A_);
  K_of_v_ = with(motion.Kv, KA_);
  C_of_v_ = with(motion.Cv, CA_);
  now_.x = with(motion.x, V_);
  now_.x_explicit = now_.x.tail(system_.n_prescribed);
  now_.x += g * now_.v_predicted;
  now_.rhs = f_ - C_of_v_ - with(motion.Kx, KV_) - g * K_of_v_;
}

/// Products of the stage that was solved.
void GroundSteps::multiply(double g, int i) {
  now_.rhs.tail(residual_.size()) += residual_;
  const GroundProducts of = ground_.products(now_.a, now_.rhs, g);
  MA_.col(i) = of.M;
  KA_.col(i) = of.K;
  CA_.col(i) = of.C;
  KV_.col(i) = K_of_v_ + g * of.K;
  CV_.col(i) = C_of_v_ + g * of.C;
  V_.col(i) = now_.v;
  A_.col(i) = now_.a;
}

bool GroundSteps::step(State& state, double h, double inside, EffectiveMatrices&, EnergyMeter* meter, StageLaw*) {
  const double g = h * tableau_.gamma();
  GroundStage& E = stage_of(g);
  follow(state);
  const GroundMotion& motion = shared_->motion;
  const Eigen::Index n = system_.interface->n_nodes();
  residual_.resize(2 * n);
  for (int i = 0; i < n_stages(); ++i) {
    loads_.evaluate(state.time + c_[i] * h, inside, load_);
    loads_.sum(load_, f_);
    predict(motion, h, i);
    now_.a.tail(system_.n_prescribed) = -now_.v_predicted.tail(system_.n_prescribed) / g;
    if (!contact_.solve(E, g, now_)) return false;
    const InterfaceForces& forces = contact_.now().forces;
    residual_ << -forces.shear, forces.normal - system_.interface->normal_force;
    multiply(g, i);
    if (meter == nullptr) continue;
    const Vector reaction = -(residual_ + f_.tail(2 * n));
    meter->add_frame(h * b_[i], now_.v, load_);
    meter->add_work(h * b_[i], now_.v, f_, now_.x, now_.v, now_.a, &reaction);
  }
  state.time += h;
  state.x = now_.x;
  state.v = now_.v;
  state.a = now_.a;
  keep(h, state, meter);
  return true;
}

/// The last stage is the end of the step.
void GroundSteps::keep(double h, const State& state, EnergyMeter* meter) {
  GroundMotion& motion = shared_->motion;
  motion.x = state.x;
  motion.v = state.v;
  motion.Kx += h * KV_ * b_;
  motion.Kv = KV_.rightCols(1);
  motion.Cv = CV_.rightCols(1);
  motion.Mv += h * MA_ * b_;
  if (meter != nullptr) account(h, motion, *meter);
}

/// As Dirk::account(), in which fields of unknowns are not told apart.
void GroundSteps::account(double h, const GroundMotion& now, EnergyMeter& meter) const {
  const int s = n_stages();
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(s, s), signed_V = sign_.asDiagonal() * V_;
  const Eigen::MatrixXd stored = transposed_product(sign_.asDiagonal() * A_, MA_) + transposed_product(signed_V, KV_);
  const Losses losses{{transposed_product(signed_V, CV_), none, none}, none};
  for (int i = 0; i < s; ++i) meter.add_losses(losses, i, h * b_[i]);
  meter.add_scheme(0.5 * h * h * tableau_.stability().cwiseProduct(stored).sum());
  const auto one = [&](double value) {
    return FieldGrams{Eigen::MatrixXd::Constant(1, 1, value), Eigen::MatrixXd::Zero(1, 1), Eigen::MatrixXd::Zero(1, 1)};
  };
  meter.set_stored(one((sign_.array() * now.v.array() * now.Mv.array()).sum()),
                   one((sign_.array() * now.x.array() * now.Kx.array()).sum()), 0);
}

}  // namespace upbead::detail

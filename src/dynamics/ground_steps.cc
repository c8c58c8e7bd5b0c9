#include "dynamics/ground_steps.h"

#include <utility>

#include "algebra/dense.h"
#include "algebra/dense_factors.h"

namespace upbead::detail {

namespace {

constexpr std::size_t kept_stages = 12;
constexpr int steps_of_products = 64;  ///< then products are made anew, so that their round-off does not add up

/// E_ff.
Eigen::MatrixXd free_block(const GroundMatrices& ground, double g) {
  Eigen::MatrixXd E = ground.M_ff + g * ground.C_ff;
  E.diagonal() += g * g * ground.K_ff;
  return E;
}

/// A, which couples them with what is along U.
Eigen::MatrixXd coupling_block(const GroundMatrices& ground, double g) {
  return ground.M_f + g * ground.C_f + g * g * ground.K_f;
}

Eigen::MatrixXd ground_inverse(const GroundMatrices& ground, double g) {
  const Eigen::Index r = ground.n_free();
  const Eigen::MatrixXd inverse = solve_dense(free_block(ground, g), Eigen::MatrixXd::Identity(r, r));
  return 0.5 * (inverse + inverse.transpose());
}

Eigen::MatrixXd condensed_ground(const GroundMatrices& ground, double g, const Eigen::MatrixXd& follows) {
  const Eigen::MatrixXd taken = transposed_product(coupling_block(ground, g), follows);
  const Eigen::MatrixXd D =
      ground.M_ii + g * ground.C_ii + g * g * ground.K_ii - product(product(ground.U, taken), ground.U.transpose());
  return 0.5 * (D + D.transpose());
}

}  // namespace

GroundStage::GroundStage(const GroundMatrices& ground, double g, double friction)
    : along_(ground.U),
      inverse_(ground_inverse(ground, g)),
      follows_(product(inverse_, coupling_block(ground, g))),
      problem_(condensed_ground(ground, g, follows_), friction) {}

/// With the interface at rest the free coordinates are E_ff^-1 rhs_f; what its motion adds is in D.
Vector GroundStage::begin(const DirkStage& stage) {
  const Eigen::Index r = inverse_.cols(), k = along_.cols(), m = along_.rows();
  const Vector along = transposed_product(follows_, stage.rhs.head(r)) - stage.rhs.tail(k);
  Vector residual = product(along_, along) - stage.rhs.segment(r, m);
  residual += product_of_some(problem_.stiffness(), stage.a.tail(m));
  return residual;
}

void GroundStage::finish(DirkStage& stage) {
  const Eigen::Index r = inverse_.cols(), m = along_.rows();
  stage.a.head(r) = symmetric_product(inverse_, stage.rhs.head(r));
  moved_ = Vector::Zero(along_.cols());
  if (const auto motion = stage.a.tail(m); !motion.isZero(0.)) {
    moved_ = transposed_product(along_, motion);
    stage.a.head(r) -= product(follows_, moved_);
  }
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
      sign_(Vector::Ones(system.size() + ground.U.cols())),
      now_{{}, {}, {}, {}, Vector::Zero(system.size()), {}, nullptr, 0., 0.} {
  for (Eigen::MatrixXd* stages : {&V_, &A_, &KV_, &KA_, &CV_, &CA_, &MA_}) stages->resize(sign_.size(), c_.size());
  for (int i = 0; i < system.size(); ++i)
    if (system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse) sign_[i] = -1.;
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
  const Eigen::Index n = state.x.size();
  if (++motion.steps < steps_of_products && motion.x.size() == sign_.size() && motion.x.head(n) == state.x &&
      motion.v.head(n) == state.v)
    return;
  Vector x = ground_.with_along(state.x), v = ground_.with_along(state.v), Kx = ground_.products(x).K;
  GroundProducts of_v = ground_.products(v);
  motion = {std::move(x), std::move(v), std::move(Kx), std::move(of_v.K), std::move(of_v.C), std::move(of_v.M)};
}

void GroundSteps::predict(const GroundMotion& motion, double h, int i) {
  const double g = h * tableau_.gamma();
  const Eigen::Index n = system_.size();
  const Vector weights = h * tableau_.a.row(i).head(i).transpose();
  const auto with = [&](const Vector& start, const Eigen::MatrixXd& stages) -> Vector {
    return start + stages.leftCols(i) * weights;
  };
  v_predicted_ = with(motion.v, A_);
  K_of_v_ = with(motion.Kv, KA_);
  C_of_v_ = with(motion.Cv, CA_);
  now_.v_predicted = v_predicted_.head(n);
  now_.x = with(motion.x, V_).head(n);
  now_.x_explicit = now_.x.tail(system_.n_prescribed);
  now_.x += g * now_.v_predicted;
  now_.rhs = -(C_of_v_ + with(motion.Kx, KV_) + g * K_of_v_);
  now_.rhs.head(n) += f_;
}

/// Products of the stage that was solved.
void GroundSteps::multiply(const GroundStage& E, double g, int i) {
  now_.rhs.segment(ground_.n_free(), residual_.size()) += residual_;
  A_.col(i) << now_.a, E.moved();
  V_.col(i) << now_.v, v_predicted_.tail(E.moved().size()) + g * E.moved();
  const GroundProducts of = ground_.products(A_.col(i), now_.rhs, g);
  MA_.col(i) = of.M;
  KA_.col(i) = of.K;
  CA_.col(i) = of.C;
  KV_.col(i) = K_of_v_ + g * of.K;
  CV_.col(i) = C_of_v_ + g * of.C;
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
    multiply(E, g, i);
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
  motion.x += h * V_ * b_;
  motion.x.head(state.x.size()) = state.x;
  motion.v = V_.rightCols(1);
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

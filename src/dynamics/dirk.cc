#include "dirk.h"

#include <utility>

namespace upbead::detail {

void LoadSum::evaluate(double t, double inside, std::vector<double>& f) const {
  f.resize(system_.loads.size());
  for (std::size_t k = 0; k < f.size(); ++k) f[k] = system_.loads[k].history(t, inside);
}

void LoadSum::sum(const std::vector<double>& f, Vector& b) const {
  b.setZero(system_.size());
  for (std::size_t k = 0; k < f.size(); ++k)
    if (system_.loads[k].prescribed < 0 && f[k] != 0.) b += f[k] * system_.loads[k].vector;
}

void LoadSum::prescribe(const std::vector<double>& f, Vector& v) const {
  v.tail(system_.n_prescribed).setZero();
  for (std::size_t k = 0; k < f.size(); ++k)
    if (const int i = system_.loads[k].prescribed; i >= 0) v[i] += f[k];
}

Eigen::MatrixXd Tableau::stability() const {
  const Eigen::MatrixXd ba = b().asDiagonal() * a;
  return ba + ba.transpose() - b() * b().transpose();
}

Tableau euler_tableau() {
  return {Eigen::MatrixXd::Ones(1, 1)};
}

Tableau sdirk4_tableau() {
  Tableau tableau{Eigen::MatrixXd(5, 5)};
  tableau.a << 1. / 4., 0., 0., 0., 0.,                      //
      1. / 2., 1. / 4., 0., 0., 0.,                          //
      17. / 50., -1. / 25., 1. / 4., 0., 0.,                 //
      371. / 1360., -137. / 2720., 15. / 544., 1. / 4., 0.,  //
      25. / 24., -49. / 48., 125. / 16., -85. / 12., 1. / 4.;
  return tableau;
}

Tableau friction_tableau() {
  Tableau tableau{Eigen::MatrixXd(3, 3)};
  tableau.a << 1. / 4., 0., 0.,  //
      1. / 4., 1. / 4., 0.,      //
      1. / 2., 1. / 4., 1. / 4.;
  return tableau;
}

Dirk::Dirk(const System& system, Tableau tableau)
    : Dirk(system, std::move(tableau), std::make_shared<const SymmetricPair>(system.C, system.K)) {}

Dirk::Dirk(const System& system, Tableau tableau, std::shared_ptr<const SymmetricPair> damping_and_stiffness)
    : system_(system),
      loads_(system),
      damping_and_stiffness_(std::move(damping_and_stiffness)),
      tableau_(std::move(tableau)),
      b_(tableau_.b()),
      c_(tableau_.c()),
      stability_(tableau_.stability()),
      V_(system.size(), c_.size()),
      A_(system.size(), c_.size()),
      now_{{}, {}, {}, {}, Vector::Zero(system.size()), {}, nullptr, 0., 0.} {}

void Dirk::predict(const State& state, double h, int stage) {
  now_.v_predicted = state.v;
  now_.x = state.x;
  for (int j = 0; j < stage; ++j) {
    const double weight = h * tableau_.a(stage, j);
    now_.v_predicted += weight * A_.col(j);
    now_.x += weight * V_.col(j);
  }
  now_.x_explicit = now_.x.tail(system_.n_prescribed);
  now_.x += h * tableau_.gamma() * now_.v_predicted;
}

bool Dirk::step(State& state, double h, double inside, EffectiveMatrices& matrices, EnergyMeter* meter, StageLaw* law) {
  const double g = h * tableau_.gamma();
  const EffectiveMatrix& E = matrices.get({1., g, g * g});
  const int n_prescribed = system_.n_prescribed;
  for (int i = 0; i < n_stages(); ++i) {
    loads_.evaluate(state.time + c_[i] * h, inside, load_);
    loads_.sum(load_, f_);
    if (law != nullptr) law->add_load(state.time + c_[i] * h, inside, f_);
    predict(state, h, i);
    if (n_prescribed > 0) {
      loads_.prescribe(load_, now_.a);
      now_.a.tail(n_prescribed) = (now_.a.tail(n_prescribed) - now_.v_predicted.tail(n_prescribed)) / g;
    }
    now_.rhs = f_;
    now_.load = &f_;
    now_.weight = h * b_[i];
    now_.time = state.time + c_[i] * h;
    damping_and_stiffness_->subtract_products(now_.v_predicted, now_.x, now_.rhs);
    if (law == nullptr) {
      E.solve(now_.rhs, now_.a);
      now_.move(g);
    } else if (!law->solve(E, g, now_)) {
      return false;
    }
    V_.col(i) = now_.v;
    A_.col(i) = now_.a;
    if (meter == nullptr) continue;
    const Vector* internal = law != nullptr ? law->force_on_prescribed() : nullptr;
    meter->add_frame(now_.weight, now_.v, load_);
    meter->add_work(now_.weight, now_.v, f_, now_.x, now_.v, now_.a, internal);
  }
  state.time += h;
  state.x = now_.x;
  state.v = now_.v;
  state.a = now_.a;
  if (meter != nullptr) account(h, *meter);
  return true;
}

void Dirk::account(double h, EnergyMeter& meter) {
  const int s = n_stages();
  block_.resize(system_.size(), s + 1);
  block_.leftCols(s) = A_;
  block_.col(s) = now_.v;
  const FieldGrams mass = meter.mass(block_);
  block_.leftCols(s) = V_;
  block_.col(s) = now_.x;
  const FieldGrams stiffness = meter.stiffness(block_);
  const Losses losses = meter.losses(block_);
  for (int i = 0; i < s; ++i) meter.add_losses(losses, i, h * b_[i]);
  const Eigen::MatrixXd gram = mass.total() + stiffness.total();
  meter.add_scheme(0.5 * h * h * stability_.cwiseProduct(gram.topLeftCorner(s, s)).sum());
  meter.set_stored(mass, stiffness, s);
}

}  // namespace upbead::detail

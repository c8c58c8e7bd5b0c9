#include "energy_meter.h"

#include <algorithm>
#include <cmath>

#include "system/part.h"

namespace upbead::detail {

namespace {

/// The part of A that couples phi with u and W, or the part that does not.
SparseMatrix part_of(SparseMatrix A, const System& system, bool coupling) {
  const auto is_phi = [&](Eigen::Index i) {
    return system.field[static_cast<std::size_t>(i)] == Field::pressure_impulse;
  };
  A.prune([&](Eigen::Index i, Eigen::Index j, double) { return (is_phi(i) != is_phi(j)) == coupling; });
  return A;
}

SparseMatrix inside(const System& system) {
  return system.radiation.nonZeros() > 0 ? SparseMatrix(system.C - system.radiation) : system.C;
}

}  // namespace

EnergyMeter::EnergyMeter(const System& system)
    : system_(system),
      mass_(system.M, system.field),
      stiffness_(system.K, system.field),
      dissipative_(part_of(inside(system), system, false), system.field),
      radiating_(part_of(system.radiation, system, false), system.field),
      coupling_(part_of(system.C, system, true), system.field),
      radiates_(system.radiation.nonZeros() > 0),
      prescribed_M_(system.M.bottomRows(system.n_prescribed)),
      prescribed_C_(system.C.bottomRows(system.n_prescribed)),
      prescribed_K_(system.K.bottomRows(system.n_prescribed)),
      sign_(system.size()) {
  for (int i = 0; i < system.size(); ++i) sign_[i] = system.field[i] == Field::pressure_impulse ? -1. : 1.;
}

void EnergyMeter::start(const State& state) {
  account_ = {};
  set_stored(mass(state.v), stiffness(state.x), 0);
  if (system_.interface) account_.lifted = forces_at_rest().dot(state.x.tail(system_.interface->n_nodes()));
  account_.work = account_.stored();
  account_.largest_work = std::abs(account_.work);
}

void EnergyMeter::add_work(double weight, const Vector& path, const Vector& f, const Vector& x, const Vector& v,
                           const Vector& a, const Vector* internal) {
  account_.work += weight * (path.array() * sign_.array() * f.array()).sum();
  if (const int n = system_.n_prescribed; n > 0) {
    Vector reaction = prescribed_M_ * a + prescribed_C_ * v + prescribed_K_ * x - f.tail(n);
    if (internal != nullptr) reaction -= *internal;
    const int given = system_.interface ? n - 2 * system_.interface->n_nodes() : n;
    account_.work +=
        weight *
        (path.tail(n).head(given).array() * sign_.tail(n).head(given).array() * reaction.head(given).array()).sum();
    if (given < n) add_contact(weight, path, reaction, x);
  }
  account_.largest_work = std::max(account_.largest_work, std::abs(account_.work));
}

Vector EnergyMeter::forces_at_rest() const {
  const Vector& at_rest = system_.interface->normal_force;
  return counts_for_prescribed(system_) ? at_rest : Vector::Zero(at_rest.size());
}

void EnergyMeter::add_contact(double weight, const Vector& path, const Vector& reaction, const Vector& x) {
  const Vector at_rest = forces_at_rest();
  const Eigen::Index n = at_rest.size();
  account_.friction -= weight * (path.tail(2 * n).head(n).dot(reaction.tail(2 * n).head(n)) +
                                 path.tail(n).dot(at_rest + reaction.tail(n)));
  account_.lifted = at_rest.dot(x.tail(n));
}

void EnergyMeter::add_frame(double time, const Vector& v, const std::vector<double>& load) {
  const auto correct = [&](const FrameDashpots& on, double& taken) {
    double power = 0.;
    for (std::size_t k = 0; k < on.loads.size(); ++k) {
      const auto number = static_cast<std::size_t>(on.loads[k]);
      const Vector& b = system_.loads[number].vector;
      double with_frame = v.dot(b) + (v.array() * sign_.array() * b.array()).sum();  // twice v' b without rows of phi
      for (std::size_t l = 0; l < on.loads.size(); ++l)
        with_frame -= on.own(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l)) *
                      load[static_cast<std::size_t>(on.loads[l])];
      power += load[number] * with_frame;
    }
    taken -= time * power;
    account_.work -= time * power;
  };
  correct(system_.frame_damping, account_.damping);
  correct(system_.frame_radiation, account_.radiated);
}

void EnergyMeter::add_yielding(double internal_work, double dissipated, double stored_before, double stored_now) {
  account_.plastic += dissipated;
  account_.strain += stored_now;
  account_.scheme -= internal_work + dissipated + stored_now - stored_before;
}

Losses EnergyMeter::losses(const VectorBlock& Z) const {
  Losses losses{dissipative_.grams(Z, system_.field), Eigen::MatrixXd::Zero(Z.cols(), Z.cols())};
  if (radiates_) losses.radiated = radiating_.grams(Z, system_.field).total();
  return losses;
}

void EnergyMeter::add_losses(const Losses& losses, int column, double time) {
  const FieldGrams& inside = losses.inside;
  account_.damping += time * inside.displacement(column, column);
  account_.drag += time * (inside.relative_fluid(column, column) + inside.pressure(column, column));
  account_.radiated += time * losses.radiated(column, column);
}

void EnergyMeter::set_stored(const FieldGrams& mass, const FieldGrams& stiffness, int column) {
  const auto half = [&](const Eigen::MatrixXd& gram) { return 0.5 * gram(column, column); };
  account_.kinetic = half(mass.displacement) + half(mass.relative_fluid) + half(stiffness.pressure);
  account_.fluid = half(mass.pressure);
  account_.strain = half(stiffness.displacement) + half(stiffness.relative_fluid);
}

}  // namespace upbead::detail

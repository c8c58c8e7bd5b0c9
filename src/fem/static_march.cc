#include "fem/static_march.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra/newton.h"

namespace upbead {

namespace {

/// Up to `quick` iterations the next step may be longer; after `most` a step has failed.
struct Patience {
  int quick, most;
};
constexpr Patience usual{8, 25}, associated{25, 60};
constexpr double longer = 1.5, shorter = 0.5;  ///< than the step before

double largest_diagonal(const SparseMatrix& pattern, const Vector& values) {
  double largest = 0.;
  for (int i = 0; i < pattern.rows(); ++i)
    for (int k = pattern.outerIndexPtr()[i]; k < pattern.outerIndexPtr()[i + 1]; ++k)
      if (pattern.innerIndexPtr()[k] == i) largest = std::max(largest, values[k]);
  return largest;
}

/// Forces out of balance at one parameter. Held unknowns are moved by stiff springs, which one Newton step does
/// exactly.
class Balance {
 public:
  Balance(StaticSoil& soil, const StaticPath& path) : soil_(soil), path_(path) {
    const SparseMatrix& pattern = soil.pattern();
    for (const int i : path.held)
      for (int k = pattern.outerIndexPtr()[i]; k < pattern.outerIndexPtr()[i + 1]; ++k)
        held_entries_.emplace_back(k, pattern.innerIndexPtr()[k] == i);
  }
  void at(double parameter) {
    load_ = path_.load(parameter);
    if (!path_.held.empty()) place_ = path_.place(parameter);
  }
  /// The springs' stiffness is the largest of the diagonal.
  void start(double parameter, const Vector& x) {
    at(parameter);
    Vector r, values(soil_.pattern().nonZeros());
    residual(x, r);
    soil_.tangent(values);
    spring_ = largest_diagonal(soil_.pattern(), values);
  }
  void residual(const Vector& x, Vector& r) {
    if (!x.allFinite()) {
      r = x;
      return;
    }
    if (path_.each) path_.each();
    soil_.exert(x, force_);
    r = force_ - load_;
    for (std::size_t k = 0; k < path_.held.size(); ++k) r[path_.held[k]] = spring_ * (x[path_.held[k]] - place_[k]);
  }
  void derivative(Eigen::Ref<Vector> values) const {
    soil_.tangent(values);
    for (const auto& [entry, diagonal] : held_entries_) values[entry] = diagonal ? spring_ : 0.;
  }
  /// Norm of the loads and of the reactions at held unknowns; not zero where there are none.
  double size() const {
    double sum = load_.squaredNorm();
    for (const int i : path_.held) sum += force_[i] * force_[i];
    return std::max(std::sqrt(sum), std::numeric_limits<double>::min());
  }
  /// A thousandth of the elastic force that moves held unknowns to their places: an estimate of the reactions.
  double pull(const Vector& x) const {
    double sum = 0.;
    for (std::size_t k = 0; k < path_.held.size(); ++k) sum += std::pow(x[path_.held[k]] - place_[k], 2);
    return 1e-3 * spring_ * std::sqrt(sum);
  }
  const Vector& force() const { return force_; }

 private:
  StaticSoil& soil_;
  const StaticPath& path_;
  std::vector<std::pair<int, bool>> held_entries_;
  Vector load_, force_;
  std::vector<double> place_;
  double spring_ = 1.;
};

/// The march, step by step.
class March {
 public:
  March(StaticSoil& soil, const StaticPath& path, const StaticSteps& steps, Vector& x)
      : soil_(soil),
        steps_(steps),
        patience_(steps.associated ? associated : usual),
        x_(x),
        balance_(soil, path),
        newton_(
            soil.pattern(), [this](const Vector& at, Vector& r) { balance_.residual(at, r); },
            [this](Eigen::Ref<Vector> values) { balance_.derivative(values); }, patience_.most,
            steps.associated ? StepLength::by_potential : StepLength::by_residual),
        leap_(
            soil.pattern(), [this](const Vector& at, Vector& r) { balance_.residual(at, r); },
            [this](Eigen::Ref<Vector> values) { balance_.derivative(values); }, 1, StepLength::whole),
        rate_(Vector::Zero(x.size())) {
    balance_.start(steps.from, x);
    report_.reached = steps.from;
    report_.failed = steps.to;
    report_.moved = rate_;
  }

  StaticReport run(const StaticObserver& observer) {
    double step = steps_.first;
    bool failed_before = false;
    while (report_.reached < steps_.to * (1. - 1e-12)) {
      const double next = std::min(report_.reached + step, steps_.to), length = next - report_.reached;
      if (!advance(next)) {
        report_.failed = next;
        if (length <= steps_.least * (1. + 1e-9)) break;
        ++report_.cuts;
        failed_before = true;
        step = std::max(shorter * length, steps_.least);
        continue;
      }
      if (report_.failed <= next) report_.failed = steps_.to;
      if (last_iterations_ <= patience_.quick && !failed_before) step = std::min(longer * step, steps_.largest);
      failed_before = false;
      if (observer && !observer(next, x_, balance_.force())) break;
    }
    report_.complete = report_.reached >= steps_.to * (1. - 1e-12);
    balance_.at(report_.reached);
    return report_;
  }

 private:
  bool advance(double next) {
    const double length = next - report_.reached;
    balance_.at(next);
    Vector tried = x_ + length * rate_, r;
    balance_.residual(tried, r);
    // before the first motion tangents are elastic, and a line search along their step may find no smaller residual
    if (rate_.isZero(0.)) leap_.solve(tried, steps_.tolerance * std::max(balance_.size(), balance_.pull(x_)));
    NewtonReport found = newton_.solve(tried, steps_.tolerance * std::max(balance_.size(), balance_.pull(x_)));
    last_iterations_ = found.iterations;
    if (found.converged) balance_.residual(tried, r);
    if (found.converged && r.norm() > steps_.tolerance * balance_.size()) {  // reactions are known only now
      found = newton_.solve(tried, steps_.tolerance * balance_.size());
      last_iterations_ += found.iterations;
      balance_.residual(tried, r);
    }
    report_.iterations += last_iterations_;
    report_.moved = tried - x_;
    if (!found.converged) return false;
    soil_.commit(tried);
    rate_ = report_.moved / length;
    x_ = tried;
    report_.reached = next;
    report_.residual = r.norm() / balance_.size();
    ++report_.steps;
    return true;
  }

  StaticSoil& soil_;
  const StaticSteps& steps_;
  Patience patience_;
  Vector& x_;
  Balance balance_;
  Newton newton_, leap_;  ///< with a line search; with one whole step
  Vector rate_;           ///< derivative of x by the parameter, in the last step
  int last_iterations_ = 0;
  StaticReport report_;
};

}  // namespace

StaticReport march_static(StaticSoil& soil, const StaticPath& path, const StaticSteps& steps, Vector& x,
                          const StaticObserver& observer) {
  return March(soil, path, steps, x).run(observer);
}

}  // namespace upbead

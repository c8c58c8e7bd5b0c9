#include "fem/limit_state.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "algebra/factorisation.h"
#include "algebra/slope_bracket.h"

namespace upbead {

namespace {

constexpr double tolerance = 1e-6;  ///< |forces out of balance| over |loads|, as of StaticSteps
constexpr double most_energy = 100.;
constexpr int most_iterations = 150, most_lengths = 12;

class Search {
 public:
  Search(StaticSoil& soil, const Vector& load, Vector begin) : soil_(soil), load_(load), K_(soil.pattern()) {
    answer_.x = Vector::Zero(load.size());
    balance(answer_.x);
    energy_ = soil_.energy();
    if (begin.size() == load.size()) {
      answer_.x = std::move(begin);
      balance(answer_.x);
    }
    answer_.moved = answer_.x;
  }

  LimitAnswer run(const std::function<void()>& each) {
    for (;; ++answer_.iterations) {
      answer_.residual = r_.norm() / std::max(load_.norm(), std::numeric_limits<double>::min());
      if (answer_.residual <= tolerance) {
        answer_.found = RestFound::rest;
        return answer_;
      }
      if (soil_.energy_of_change() - r_.dot(answer_.x) > most_energy * energy_) return none();
      if (answer_.iterations == most_iterations) return answer_;
      if (each) each();
      step();
    }
  }

 private:
  void balance(const Vector& x) {
    soil_.exert(x, force_);
    r_ = force_ - load_;
  }

  LimitAnswer none() {
    answer_.found = RestFound::none;
    const double resists = soil_.resistance(answer_.moved);
    answer_.resisting = resists / (resists - r_.dot(answer_.moved));
    return answer_;
  }

  /// Newton's step, to a length that comes near the least value along it.
  void step() {
    soil_.tangent(Eigen::Map<Vector>(K_.valuePtr(), K_.nonZeros()));
    if (factors_)
      factors_->refactor(K_);
    else
      factors_.emplace(K_);
    const Vector step = -factors_->solve(r_), from = answer_.x;
    const double start = -r_.dot(step);
    SlopeBracket bracket(start);
    double length = 1.;
    for (int i = 0; i < most_lengths; ++i) {
      answer_.moved = length * step;
      answer_.x = from + answer_.moved;
      balance(answer_.x);
      const double slope = -r_.dot(step);
      if (bracket.is_little(slope)) break;
      length = bracket.after(length, slope);
    }
  }

  StaticSoil& soil_;
  const Vector& load_;
  SparseMatrix K_;
  std::optional<Factorisation> factors_;
  LimitAnswer answer_;
  Vector force_, r_;
  double energy_ = 0.;
};

}  // namespace

LimitAnswer seek_rest(StaticSoil& soil, const Vector& load, Vector begin, const std::function<void()>& each) {
  return Search(soil, load, std::move(begin)).run(each);
}

}  // namespace upbead

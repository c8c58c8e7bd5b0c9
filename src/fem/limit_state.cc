#include "fem/limit_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "algebra/factorisation.h"
#include "fem/second_order_cone.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Fields = std::vector<Vector3d>;  ///< by point of quadrature

constexpr double balanced = 1e-6;  ///< |forces out of balance| over |loads|, as of StaticSteps
constexpr double most_energy = 50., trifle_of_strength = 1e-5;
/// Once it is shown that there is no rest, a search goes on for some iterations, until its bounds of D lie closer than
/// this share of D: so that `factor` is good.
constexpr double known = 0.2;
constexpr int most_after = 4;
constexpr int most_newton_steps = 60;

/// One limit of the stress at a point: (limit + D - slope m, half the difference of stresses, shear stress) in the
/// cone.
struct Limit {
  std::size_t point;
  double limit, slope;
  double by_factor;  ///< -d limit / d ln F at zero mean stress, over limit; also that of the slope
  cone::Point s, z, ds, dz, correction, q;
  std::optional<cone::Scaling> scaling;

  Matrix3d by_stress() const {
    Matrix3d d;
    d << -0.5 * slope, -0.5 * slope, 0., 0.5, -0.5, 0., 0., 0., 1.;
    return d;
  }
  cone::Point at(const Vector3d& stress, double D) const {
    return by_stress() * stress + cone::Point(limit + D, 0., 0.);
  }
};

Matrix3d stiffness(const ElasticLaw& law) {
  Matrix3d D;
  const auto tangent = law.tangent();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) D(i, j) = tangent[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return D;
}

class Search {
 public:
  Search(const StaticSoil& soil, const Vector& load)
      : soil_(soil), load_(load), points_(soil.points()), K_(soil.pattern()) {
    for (const StaticSoil::Point& p : points_) {
      start_.emplace_back(p.stress.xx, p.stress.yy, p.stress.xy);
      scale_ = std::max(scale_, start_.back().lpNorm<Eigen::Infinity>());
      flexibility_.push_back(stiffness(p.elastic).inverse());
    }
    stress_ = start_;
    double energy = 0.;
    for (std::size_t i = 0; i < points_.size(); ++i)
      energy += 0.5 * points_[i].area * start_[i].dot(flexibility_[i] * start_[i]);
    trifle_ = trifle_of_strength * scale_ / (most_energy * energy);
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (points_[i].law) add_limits(i);
    begin();
  }

  LimitAnswer run(const std::function<void()>& each) {
    int since_none = 0;
    for (;; ++answer_.iterations) {
      const Vector out = soil_.forces(stress_) - load_;
      answer_.residual = out.norm() / std::max(load_.norm(), std::numeric_limits<double>::min());
      if (D_ <= 0. && answer_.residual <= balanced) return finish(RestFound::rest);
      const double least = bound(), trifle = trifle_of_strength * scale_;
      if (least > trifle && (D_ - least <= known * least || since_none++ == most_after)) return finish(RestFound::none);
      if (since_none > 0 && !(least > trifle)) return answer_;
      if (answer_.iterations == most_newton_steps || !std::isfinite(D_)) return finish(RestFound::open);
      if (since_none > 0) finish(RestFound::none);  // holds whatever comes
      if (each) each();
      try {
        step(out);
      } catch (const NumericsError&) {  // numbers beyond what a factorisation bears: what was shown so far holds
        return answer_;
      }
    }
  }

 private:
  void add_limits(std::size_t i) {
    const MohrCoulombPlanes& planes = points_[i].law->planes();
    const double sine = (planes.k - 1.) / (planes.k + 1.);
    limits_.push_back({i, planes.strength / (planes.k + 1.), sine, 1. - sine * sine, {}, {}, {}, {}, {}, {}, {}});
    const double tip = planes.k > 1. ? planes.strength / (planes.k - 1.) : 1e4 * scale_;
    if (planes.tension < tip * (1. - 1e-12)) limits_.push_back({i, planes.tension, 1., 1., {}, {}, {}, {}, {}, {}, {}});
  }

  /// D large enough for the committed stress; all multipliers alike.
  void begin() {
    for (Limit& l : limits_) {
      l.s = l.at(start_[l.point], 0.);
      D_ = std::max(D_, l.s.tail<2>().norm() - l.s[0]);
    }
    D_ += scale_;
    for (Limit& l : limits_) {
      l.s = l.at(start_[l.point], D_);
      l.z = cone::Point(1. / static_cast<double>(limits_.size()), 0., 0.);
    }
    u_ = Vector::Zero(load_.size());
  }

  /// The least of D + trifle energy over all D and all stresses, by Lagrange's function with the present multipliers.
  double bound() const {
    double sum = 0., value = u_.dot(load_);
    Fields g = soil_.strains(u_);
    for (std::size_t i = 0; i < g.size(); ++i) g[i] *= points_[i].area;
    for (const Limit& l : limits_) {
      sum += l.z[0];
      value -= l.limit * l.z[0];
      g[l.point] += l.by_stress().transpose() * l.z;
    }
    double energy = 0.;
    for (std::size_t i = 0; i < g.size(); ++i) {
      value -= g[i].dot(start_[i]);
      energy += g[i].dot(flexibility_[i].inverse() * g[i]) / points_[i].area;
    }
    return value / sum - 0.5 * energy / (trifle_ * sum * sum);
  }

  /// Newton's equations, with the cones' rows eliminated point by point, then the stresses:
  ///   H dstress + h dD - area B du = ...,  sum of h . dstress + ... dD = ...,  forces(dstress) = -out.
  void step(const Vector& out) {
    const std::size_t n = points_.size();
    out_ = out;
    right_ = soil_.strains(u_);
    H_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      H_[i] = trifle_ * points_[i].area * flexibility_[i];
      right_[i] = points_[i].area * right_[i] - H_[i] * (stress_[i] - start_[i]);
    }
    eliminate_D();
    for (Limit& l : limits_) {
      const Matrix3d d = l.by_stress();
      H_[l.point] += d.transpose() * (l.scaling->inverse * l.scaling->inverse) * d;
      l.correction = -l.scaling->middle;
    }
    inverse_.resize(n);
    for (std::size_t i = 0; i < n; ++i) inverse_[i] = H_[i].inverse();
    factorise();
    u_by_D_ = factors_->solve(soil_.forces(by_D_));
    strain_by_D_ = soil_.strains(u_by_D_);
    newton();
    centre();
    newton();
    const double primal = std::min(1., 0.99 * farthest(&Limit::s, &Limit::ds));
    const double dual = std::min(1., 0.99 * farthest(&Limit::z, &Limit::dz));
    u_ += dual * du_;
    D_ += primal * dD_;
    for (std::size_t i = 0; i < n; ++i) stress_[i] += primal * dstress_[i];
    for (Limit& l : limits_) {
      l.s += primal * l.ds;
      l.z += dual * l.dz;
    }
  }

  /// For each point q = Q^-1 e, with Q = W^2 + d M^-1 d^T over its cones (d: derivative by the stress, e: by D, M: the
  /// trifle's part of H). Then H^-1 h = M^-1 d^T q, and e^T W^-2 e - h^T H^-1 h = e . q, in which no digits cancel.
  void eliminate_D() {
    by_D_.assign(points_.size(), Vector3d::Zero());
    schur_ = 0.;
    for (std::size_t first = 0; first < limits_.size();) {
      const std::size_t point = limits_[first].point;
      const Eigen::Index count = first + 1 < limits_.size() && limits_[first + 1].point == point ? 2 : 1;
      Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(3 * count, 3 * count), d(3 * count, 3);
      Eigen::VectorXd e = Eigen::VectorXd::Zero(3 * count);
      for (Eigen::Index k = 0; k < count; ++k) {
        Limit& l = limits_[first + static_cast<std::size_t>(k)];
        l.scaling.emplace(l.s, l.z);
        Q.block<3, 3>(3 * k, 3 * k) = l.scaling->W * l.scaling->W;
        d.middleRows<3>(3 * k) = l.by_stress();
        e[3 * k] = 1.;
      }
      const Matrix3d inverse = stiffness(points_[point].elastic) / (trifle_ * points_[point].area);
      Q += d * inverse * d.transpose();
      const Eigen::VectorXd q = Q.ldlt().solve(e);
      by_D_[point] = inverse * (d.transpose() * q);
      schur_ += e.dot(q);
      for (Eigen::Index k = 0; k < count; ++k) limits_[first + static_cast<std::size_t>(k)].q = q.segment<3>(3 * k);
      first += static_cast<std::size_t>(count);
    }
  }

  void factorise() {
    std::vector<Matrix3d> D = inverse_;
    for (std::size_t i = 0; i < D.size(); ++i) D[i] *= points_[i].area;
    soil_.assemble(D, Eigen::Map<Vector>(K_.valuePtr(), K_.nonZeros()));
    if (factors_)
      factors_->refactor(K_);
    else
      factors_.emplace(K_);
  }

  /// Mehrotra's corrector (1992): towards the path of equal products, with the second-order terms of the first step.
  void centre() {
    const double primal = std::min(1., farthest(&Limit::s, &Limit::ds));
    const double dual = std::min(1., farthest(&Limit::z, &Limit::dz));
    double product = 0., ahead = 0.;
    for (const Limit& l : limits_) {
      product += l.s.dot(l.z);
      ahead += (l.s + primal * l.ds).dot(l.z + dual * l.dz);
    }
    const double target = std::pow(ahead / product, 3) * product / static_cast<double>(limits_.size());
    for (Limit& l : limits_) {
      const cone::Scaling& w = *l.scaling;
      const cone::Point r =
          cone::Point(target, 0., 0.) - cone::product(w.middle, w.middle) - cone::product(w.inverse * l.ds, w.W * l.dz);
      l.correction = cone::divided(r, w.middle);
    }
  }

  void newton() {
    Fields b = right_;
    double top = -1., below = schur_;
    for (const Limit& l : limits_) {
      const Matrix3d& W = l.scaling->W;
      const cone::Point t = l.scaling->inverse * l.correction + l.z;
      b[l.point] += l.by_stress().transpose() * t;
      top += l.q.dot(W * (W * t));
    }
    dstress_.resize(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) dstress_[i] = inverse_[i] * b[i];
    const Vector u0 = factors_->solve(-out_ - soil_.forces(dstress_));
    const Fields strain = soil_.strains(u0);
    for (std::size_t i = 0; i < b.size(); ++i) {
      top -= by_D_[i].dot(right_[i] + points_[i].area * strain[i]);
      below += by_D_[i].dot(points_[i].area * strain_by_D_[i]);
    }
    dD_ = top / below;
    du_ = u0 + dD_ * u_by_D_;
    for (std::size_t i = 0; i < b.size(); ++i) {
      const Vector3d right = b[i] + points_[i].area * (strain[i] + dD_ * strain_by_D_[i]);
      dstress_[i] = inverse_[i] * right;
      dstress_[i] += inverse_[i] * (right - H_[i] * dstress_[i]);  // the inverse loses digits near the tip of a cone
      dstress_[i] -= dD_ * by_D_[i];
    }
    for (Limit& l : limits_) {
      const Matrix3d& inverse = l.scaling->inverse;
      l.ds = l.by_stress() * dstress_[l.point] + cone::Point(dD_, 0., 0.);
      l.dz = inverse * (l.correction - inverse * l.ds);
    }
  }

  double farthest(cone::Point Limit::*from, cone::Point Limit::*step) const {
    double t = 1e3;
    for (const Limit& l : limits_) t = cone::farthest(l.*from, l.*step, t);
    return t;
  }

  LimitAnswer finish(RestFound found) {
    answer_.found = found;
    answer_.moved = u_;
    answer_.work.clear();
    double sum = 0., slope = 0., most = 0.;
    for (const Limit& l : limits_) {
      const Vector3d& s = stress_[l.point];
      sum += l.z[0];
      slope += l.z[0] * l.by_factor * (l.limit - (l.by_factor < 1. ? 0.5 * l.slope * (s[0] + s[1]) : 0.));
      const unsigned cell = points_[l.point].cell;
      if (answer_.work.size() <= cell) answer_.work.resize(cell + 1, 0.);
      answer_.work[cell] += l.z.tail<2>().norm() * std::hypot(0.5 * (s[0] - s[1]), s[2]);
      const double shear = l.z.tail<2>().norm() / points_[l.point].area;
      if (shear <= most) continue;
      most = shear;
      answer_.shears_most = points_[l.point].cell;
    }
    if (slope > 0.) answer_.factor = std::exp(-D_ * sum / slope);
    if (found == RestFound::rest) keep_stresses();
    return answer_;
  }

  void keep_stresses() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const StaticSoil::Point& p = points_[i];
      if (answer_.stresses.size() <= p.cell) answer_.stresses.resize(p.cell + 1);
      const Vector3d& s = stress_[i];
      const double mean = 0.5 * (s[0] + s[1]), R = std::hypot(0.5 * (s[0] - s[1]), s[2]);
      const double zz = p.law ? std::clamp(p.stress.zz, mean - R, mean + R) : p.stress.zz;
      answer_.stresses[p.cell].push_back({s[0], s[1], s[2], zz});
    }
  }

  const StaticSoil& soil_;
  const Vector& load_;
  std::vector<StaticSoil::Point> points_;
  SparseMatrix K_;
  std::optional<Factorisation> factors_;
  std::vector<Matrix3d> flexibility_, H_, inverse_;  ///< the last of H
  std::vector<Limit> limits_;
  Fields start_, stress_, dstress_;
  Fields right_, by_D_, strain_by_D_;  ///< right-hand side of the stresses; -dstress by D, and strain by D
  double scale_ = std::numeric_limits<double>::min(), trifle_ = 0., D_ = 0., dD_ = 0., schur_ = 0.;
  Vector out_, u_, du_, u_by_D_;
  LimitAnswer answer_;
};

}  // namespace

LimitAnswer seek_rest(const StaticSoil& soil, const Vector& load, const std::function<void()>& each) {
  return Search(soil, load).run(each);
}

}  // namespace upbead

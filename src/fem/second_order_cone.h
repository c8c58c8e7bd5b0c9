// The cone s0 >= |(s1, s2)|, its Jordan product, and the scaling between two of its points.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace upbead::cone {

using Point = Eigen::Vector3d;

/// s0^2 - s1^2 - s2^2.
inline double determinant(const Point& s) {
  const double r = s.tail<2>().norm();
  return (s[0] - r) * (s[0] + r);
}

inline Point product(const Point& a, const Point& b) {
  Point c;
  c << a.dot(b), a[0] * b.tail<2>() + b[0] * a.tail<2>();
  return c;
}

/// x with product(a, x) = r; a within the cone.
inline Point divided(const Point& r, const Point& a) {
  Point x;
  x[0] = (a[0] * r[0] - a.tail<2>().dot(r.tail<2>())) / determinant(a);
  x.tail<2>() = (r.tail<2>() - x[0] * a.tail<2>()) / a[0];
  return x;
}

/// The largest t <= most with s + t d in the cone; s within it.
inline double farthest(const Point& s, const Point& d, double most) {
  const double a = determinant(d), b = s[0] * d[0] - s.tail<2>().dot(d.tail<2>()), c = determinant(s);
  double t = d[0] < 0. ? std::min(most, -s[0] / d[0]) : most;
  const double root = b * b - a * c;
  if (root < 0.) return t;
  // roots of a t^2 + 2 b t + c without cancellation
  const double q = -(b + std::copysign(std::sqrt(root), b));
  for (const double at : {a != 0. ? q / a : -1., q != 0. ? c / q : -1.})
    if (at > 0.) t = std::min(t, at);
  return t;
}

/// W with W z = W^-1 s (Nesterov and Todd 1998); symmetric.
struct Scaling {
  Eigen::Matrix3d W, inverse;
  Point middle;  ///< W z

  Scaling(const Point& s, const Point& z) {
    const double ds = determinant(s), dz = determinant(z), eta = std::pow(ds / dz, 0.25);
    const Point a = s / std::sqrt(ds), b = z / std::sqrt(dz);
    const double gamma = std::sqrt(0.5 * (1. + a.dot(b)));
    const Point w = (a + Point(b[0], -b[1], -b[2])) / (2. * gamma);
    const Eigen::Vector2d v = w.tail<2>();
    W << w[0], v.transpose(), v, Eigen::Matrix2d::Identity() + v * v.transpose() / (1. + w[0]);
    inverse << w[0], -v.transpose(), -v, Eigen::Matrix2d::Identity() + v * v.transpose() / (1. + w[0]);
    W *= eta;
    inverse /= eta;
    middle = W * z;
  }
};

}  // namespace upbead::cone

#include "random_waves.h"

#include <algorithm>
#include <cmath>

namespace upbead::test {

namespace {

constexpr double pi = 3.14159265358979323846;

class Waves {
 public:
  Waves(double step, int n) : time_(Eigen::VectorXd::LinSpaced(n, 0., step * (n - 1))) {}

  Eigen::VectorXd church_roof() {
    const double duration = between(0.15, 0.6), rise = between(0.2, 0.6) * duration, plateau = between(0.2, 0.5);
    const double gone = duration + between(0.3, 1.) * duration;
    return time_.unaryExpr([=](double t) {
      if (t < rise) return t / rise;
      if (t < duration) return 1. - (1. - plateau) * (t - rise) / (duration - rise);
      return std::max(0., plateau * (gone - t) / (gone - duration));
    });
  }

  Eigen::VectorXd double_peak() {
    const double first = between(0.15, 0.3), second = between(0.15, 0.4), start = between(0.5, 1.2) * first;
    return triangle(0., first) + between(0.4, 1.) * triangle(start, second);
  }

  Eigen::VectorXd noisy_triangle() {
    Eigen::VectorXd f = triangle(0., between(0.15, 0.4));
    std::normal_distribution<double> noise(0., 0.01);
    for (Eigen::Index i = 1; i < f.size(); ++i) f[i] += noise(random_);
    return f;
  }

  Eigen::VectorXd measured() {
    const double length = between(0.3, 0.8);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(time_.size());
    for (int i = 0; i < 20; ++i) {
      const double omega = 2. * pi * between(0.5, 15.), phase = between(0., 2. * pi), size = between(0., 1.) / omega;
      f.array() += size * (omega * time_.array() + phase).cos();
    }
    const auto swell = [length](double t) { return t < length ? std::pow(std::sin(pi * t / length), 2) : 0.; };
    return f.cwiseProduct(time_.unaryExpr(swell));
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  Eigen::VectorXd triangle(double start, double duration) {
    const double rise = between(0.3, 0.7) * duration;
    return time_.unaryExpr([=](double t) {
      return std::max(0., std::min((t - start) / rise, (start + duration - t) / (duration - rise)));
    });
  }

  Eigen::VectorXd time_;
  std::mt19937 random_{2024};
};

}  // namespace

std::vector<RandomWave> random_waves(int each, double step, int n) {
  Waves waves(step, n);
  std::vector<RandomWave> list;
  for (int i = 0; i < each; ++i) {
    list.push_back({"church roof", waves.church_roof()});
    list.push_back({"double peak", waves.double_peak()});
    list.push_back({"triangle with noise", waves.noisy_triangle()});
    list.push_back({"as measured", waves.measured()});
  }
  return list;
}

}  // namespace upbead::test

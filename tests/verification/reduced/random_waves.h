// Random histories of wave forces of realistic kinds, the same in every run.
#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <vector>

namespace upbead::test {

struct RandomWave {
  std::string kind;
  Eigen::VectorXd force;  ///< at 0, step, 2 step, ...; zero at first
};

/// `each` waves of every kind, n samples long: church roofs, double peaks, triangles with white noise of 1 %, noise
/// up to 15 Hz that grows and decays.
std::vector<RandomWave> random_waves(int each, double step, int n);

}  // namespace upbead::test

#include "halving.h"

#include <algorithm>

#include "dynamics/contact.h"

namespace upbead::test {

namespace {

/// Differences below this are within the accuracy of F_T (Bounds::reaction): they may be round-off, which grows as
/// steps shrink.
constexpr double round_off = 1e-7;

TimeGrid refined(TimeGrid grid, int times) {
  for (TimeSegment& segment : grid.segments) {
    segment.step /= 1 << times;
    segment.n_steps *= 1 << times;
  }
  return grid;
}

Series march_once(const System& system, SchemeKind kind, const TimeGrid& grid) {
  SchemeOptions options;
  options.kind = kind;
  options.account_energy = false;
  const auto scheme = system.interface ? make_contact_scheme(system, false) : make_scheme(system, options);
  return march(system, *scheme, grid).ends;
}

/// The reading to compare: F_T; if it vanishes by symmetry the normal force; without a caisson the largest
/// displacement of a probe.
std::string choose_reading(const System& system, const Series& ends) {
  const auto largest = [&](const std::string& name) {
    return ends.reading.row(system.reading(name)).cwiseAbs().maxCoeff();
  };
  const bool caisson = std::any_of(system.readings.begin(), system.readings.end(),
                                   [](const Reading& r) { return r.name.text() == "shear_force"; });
  if (caisson) return largest("shear_force") > 1e-6 * largest("normal_force") ? "shear_force" : "normal_force";
  std::string best;
  for (const Reading& r : system.readings)
    if (const std::string name = r.name.text();
        name.find("/displacement") != std::string::npos && (best.empty() || largest(name) > largest(best)))
      best = name;
  return best;
}

/// Every 2^k-th value.
Eigen::VectorXd at_coarse_steps(const System& system, const std::string& reading, const Series& ends, int k) {
  const Eigen::VectorXd all = ends.reading.row(system.reading(reading));
  const Eigen::Index stride = Eigen::Index(1) << k;
  Eigen::VectorXd out((all.size() - 1) / stride + 1);
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = all[i * stride];
  return out;
}

}  // namespace

Halving halve(const System& system, SchemeKind kind, double end, double h, int most) {
  const TimeGrid grid = make_time_grid(kinks(system), end, h);
  Halving found;
  std::vector<Eigen::VectorXd> answers;
  for (int k = 0; k <= most; ++k) {
    const Series ends = march_once(system, kind, refined(grid, k));
    if (k == 0) found.reading = choose_reading(system, ends);
    answers.push_back(at_coarse_steps(system, found.reading, ends, k));
    found.largest.push_back(answers.back().cwiseAbs().maxCoeff());
    found.scale = std::max(found.scale, found.largest.back());
    if (k > 0) found.difference.push_back((answers[k] - answers[k - 1]).cwiseAbs().maxCoeff());
    if (k < 2) continue;
    const double before = found.difference[k - 2];
    found.closer = found.difference[k - 1] <= before || before <= round_off * found.scale;
    if (found.closer) break;
  }
  for (auto* list : {&found.difference, &found.largest})
    for (double& value : *list) value = found.scale > 0. ? value / found.scale : 0.;
  return found;
}

}  // namespace upbead::test

// The probability that a limit state is passed, by several methods of OpenTURNS (Baudin, Dutfoy, Iooss and Popelin,
// Handbook of Uncertainty Quantification, 2017) in standard space.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace upbead {

/// g(u) of independent standard normal u: below 0 it fails. Of any unit; its size near 0 does not matter.
using Margin = std::function<double(const std::vector<double>& u)>;

/// One method's answer, or why there is none.
struct MethodAnswer {
  std::string method;                 ///< "form", "sorm", "importance", "subset", "plain"
  std::optional<double> probability;  ///< of one occasion
  std::optional<double> index;        ///< beta = -Phi^-1(probability)
  std::optional<double> variation;    ///< coefficient of variation of a sampled probability
  double evaluations = 0.;            ///< of g
  std::string why_not;
};

/// The point of failure that is nearest to the origin, and that makes it likeliest.
struct DesignPoint {
  std::vector<double> u;      ///< u* = beta alpha
  std::vector<double> alpha;  ///< unit vector from the origin to u*, or towards failure where u* is the origin
  double index = 0.;          ///< beta, negative where the origin fails
  double evaluations = 0.;
};

/// The design point, or why none was found.
struct DesignPointSearch {
  std::optional<DesignPoint> point;
  std::string why_not;
};

/// Steps of the differences: u has the size of 1, and g is smooth over that.
struct Steps {
  double gradient = 1e-5, hessian = 1e-3;
};

struct Sampling {
  std::uint32_t seed = 1;
  int samples = 20000;          ///< most of importance sampling; of each level of subset sampling
  int plain_samples = 1000000;  ///< of plain sampling
  double variation = 0.01;      ///< importance sampling ends once its probability is known that well
};

/// Steps of Abdo and Rackwitz (1990) along the gradient, then COBYLA (Powell 1994), which needs none, where these find
/// nothing. A point counts where g vanishes at it and u* is normal to g = 0 (Hasofer and Lind 1974).
DesignPointSearch find_design_point(const Margin& margin, std::size_t size, const Steps& steps = {});

/// Phi(-beta): g as flat at u* (Hasofer and Lind 1974; Rackwitz and Fiessler 1978).
MethodAnswer by_form(const DesignPointSearch& found);
/// Breitung (1984): with the curvatures of g = 0 at u*.
MethodAnswer by_sorm(const Margin& margin, const DesignPointSearch& found, const Steps& steps = {});
/// Samples around the design points, weighted: unbiased, whatever g is between them, and blind to a region of failure
/// that is far from all of them.
MethodAnswer by_importance(const Margin& margin, const std::vector<DesignPoint>& points, const Sampling& sampling);
/// Au and Beck (2001): levels of g that a tenth of the samples of the one before fall below.
MethodAnswer by_subset(const Margin& margin, std::size_t size, const Sampling& sampling);
/// As many samples as asked for: the judge of all other methods.
MethodAnswer by_plain(const Margin& margin, std::size_t size, const Sampling& sampling);

}  // namespace upbead

#include "study_tables.h"

#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "base/fingerprint.h"
#include "upbead/expected/distribution.h"

namespace upbead {

namespace {

double inside(const VaryTable& vary, int i) {
  const int n = *vary.n - 1;
  if (i == 0 || i == n) return i == 0 ? *vary.from : *vary.to;
  const double part = static_cast<double>(i) / n;
  if (vary.spacing == Spacing::log) return *vary.from * std::pow(*vary.to / *vary.from, part);
  return *vary.from + part * (*vary.to - *vary.from);
}

/// The quantile of the distribution at a probability.
double quantile(const VaryTable& vary, double probability) {
  switch (*vary.distribution) {
    case DrawnBy::uniform:
      return *vary.low + probability * (*vary.high - *vary.low);
    case DrawnBy::log_uniform:
      return *vary.low * std::pow(*vary.high / *vary.low, probability);
    case DrawnBy::normal:
      return *vary.mean * (1. + *vary.cov * boost::math::quantile(boost::math::normal(), probability));
    case DrawnBy::log_normal: {
      // mean m and coefficient of variation c: ln X is normal with variance ln(1 + c^2) and mean ln m minus half of
      // that
      const double variance = std::log1p(*vary.cov * *vary.cov);
      const double score = boost::math::quantile(boost::math::normal(), probability);
      return *vary.mean * std::exp(std::sqrt(variance) * score - variance / 2.);
    }
  }
  return 0.;
}

}  // namespace

std::vector<Literal> values_of(const VaryTable& vary) {
  if (!vary.from) return vary.values;
  std::vector<Literal> values;
  for (int i = 0; i < *vary.n; ++i) values.push_back(literal(inside(vary, i)));
  return values;
}

Literal value_at(const Axis& axis, double probability) {
  const std::vector<Literal>& values = axis.vary.values;
  if (values.empty()) return literal(quantile(axis.vary, probability));
  return values[static_cast<std::size_t>(probability * static_cast<double>(values.size()))];
}

Literal drawn_value(const Axis& axis, std::uint64_t seed, int draw) {
  Fingerprint key;
  key.add(axis.key);
  const double probability =
      Stream(seed).uniform({static_cast<std::uint32_t>(draw), static_cast<std::uint32_t>(key.value()),
                            static_cast<std::uint32_t>(key.value() >> 32), 0});
  return value_at(axis, probability);
}

double number_of_runs(const StudyTables& study, const std::vector<Axis>& axes) {
  if (study.sample == Sampling::random) return *study.n;
  if (study.sample == Sampling::sobol) return *study.n * (static_cast<double>(axes.size()) + 2.);
  if (study.sample == Sampling::paired) return static_cast<double>(values_of(axes.front().vary).size());
  double n = 1.;
  for (const Axis& axis : axes) n *= static_cast<double>(values_of(axis.vary).size());
  return n;
}

Sampler::Sampler(const StudyTables& study, const std::vector<Axis>& axes) : study_(study), axes_(axes) {
  for (const Axis& axis : axes) lists_.push_back(values_of(axis.vary));
  if (study.sample == Sampling::sobol)
    sobol_.emplace(*study.n, static_cast<int>(axes.size()), static_cast<std::uint64_t>(study.seed));
}

int Sampler::n_runs() const {
  return axes_.empty() ? 1 : static_cast<int>(number_of_runs(study_, axes_));
}

std::vector<Literal> Sampler::values(int run) const {
  std::vector<Literal> values(axes_.size());
  auto rest = static_cast<std::size_t>(run);
  for (std::size_t a = axes_.size(); a-- > 0;) {
    if (sobol_) {
      values[a] = value_at(axes_[a], sobol_->probability(run, static_cast<int>(a)));
    } else if (study_.sample == Sampling::random) {
      values[a] = drawn_value(axes_[a], static_cast<std::uint64_t>(study_.seed), run);
    } else if (study_.sample == Sampling::paired) {
      values[a] = lists_[a][rest];
    } else {
      values[a] = lists_[a][rest % lists_[a].size()];
      rest /= lists_[a].size();
    }
  }
  return values;
}

int Sampler::point(int run) const {
  return sobol_ ? sobol_->point(run) : 0;
}

std::string Sampler::matrix(int run) const {
  if (!sobol_) return "";
  const int matrix = sobol_->matrix(run);
  return matrix == 0 ? "A" : matrix == 1 ? "B" : axes_[static_cast<std::size_t>(matrix - 2)].key;
}

}  // namespace upbead

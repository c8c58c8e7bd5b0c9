#include "reliability/system_form.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <iterator>
#include <numeric>
#include <openturns/OT.hxx>

#include "reliability/chance.h"

namespace upbead {

namespace {

double dot_of(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

bool all_found(const std::vector<DesignPointSearch>& events, const std::vector<std::size_t>& set) {
  return std::all_of(set.begin(), set.end(), [&](std::size_t i) { return events[i].point.has_value(); });
}

/// R is singular where limit states are equal, or more than there are variables: a millionth less between all of them
/// makes it positive, and moves beta by less than 1e-3.
constexpr double nearly_one = 1. - 1e-6;

/// That all events of a set fail: Phi_n(-beta; R).
double intersection(const std::vector<DesignPointSearch>& events, const std::vector<std::size_t>& set) {
  if (set.size() == 1) return boost::math::cdf(boost::math::normal(), -events[set[0]].point->index);
  OT::CorrelationMatrix R(set.size());
  OT::Point beta(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) {
    const DesignPoint& a = *events[set[i]].point;
    beta[i] = -a.index;
    for (std::size_t k = 0; k < i; ++k) R(i, k) = nearly_one * dot_of(a.alpha, events[set[k]].point->alpha);
  }
  return OT::Normal(OT::Point(set.size()), OT::Point(set.size(), 1.), R).computeCDF(beta);
}

constexpr std::size_t most_sets = 10;

/// Hildreth's (1957) steps for the least |u| with alpha_i . u >= beta_i.
std::vector<double> nearest_point(const std::vector<DesignPointSearch>& events, const std::vector<std::size_t>& set) {
  std::vector<double> u(events[set[0]].point->u.size(), 0.), weights(set.size(), 0.);
  for (int step = 0; step < 1000; ++step)
    for (std::size_t i = 0; i < set.size(); ++i) {
      const DesignPoint& event = *events[set[i]].point;
      const double weight = std::max(0., weights[i] + event.index - dot_of(event.alpha, u));
      for (std::size_t k = 0; k < u.size(); ++k) u[k] += (weight - weights[i]) * event.alpha[k];
      weights[i] = weight;
    }
  return u;
}

}  // namespace

MethodAnswer by_system_form(const std::vector<DesignPointSearch>& events, const CutSets& sets) {
  MethodAnswer answer{"form", {}, {}, {}, 0., ""};
  if (sets.size() > most_sets) answer.why_not = "the fault tree has more than ten sets of events that fail it";
  for (const auto& set : sets)
    if (!all_found(events, set)) answer.why_not = "one of its limit states has no design point";
  if (!answer.why_not.empty()) return answer;
  double p = 0.;
  for (unsigned long some = 1; some < (1UL << sets.size()); ++some) {
    std::vector<std::size_t> all;
    bool odd = false;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (!(some >> i & 1UL)) continue;
      odd = !odd;
      std::vector<std::size_t> both;
      std::set_union(all.begin(), all.end(), sets[i].begin(), sets[i].end(), std::back_inserter(both));
      all = both;
    }
    p += (odd ? 1. : -1.) * intersection(events, all);
  }
  answer.index = index_of(p);
  if (answer.index)
    answer.probability = p;
  else
    answer.why_not = "its sum of probabilities is not between 0 and 1";
  return answer;
}

std::vector<DesignPoint> design_points(const std::vector<DesignPointSearch>& events, const CutSets& sets) {
  std::vector<DesignPoint> points;
  for (const auto& set : sets) {
    if (!all_found(events, set)) continue;
    if (set.size() == 1) {
      points.push_back(*events[set[0]].point);
      continue;
    }
    DesignPoint point;
    point.u = nearest_point(events, set);
    point.index = std::sqrt(dot_of(point.u, point.u));
    point.alpha = point.u;
    for (double& part : point.alpha) part /= std::max(point.index, 1e-12);
    points.push_back(point);
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const DesignPoint& a, const DesignPoint& b) { return a.index < b.index; });
  return points;
}

}  // namespace upbead

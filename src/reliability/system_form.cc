#include "reliability/system_form.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <openturns/OT.hxx>

#include "base/text.h"
#include "reliability/chance.h"
#include "reliability/fault_tree.h"
#include "reliability/union_form.h"

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

/// That all events of a set fail: Phi_n(-beta; R), which is between 0 and its least probable event, to round-off.
double intersection(const std::vector<DesignPointSearch>& events, const std::vector<std::size_t>& set) {
  double least = 1.;
  for (const std::size_t i : set)
    least = std::min(least, boost::math::cdf(boost::math::normal(), -events[i].point->index));
  if (set.size() == 1) return least;
  OT::CorrelationMatrix R(set.size());
  OT::Point beta(set.size());
  for (std::size_t i = 0; i < set.size(); ++i) {
    const DesignPoint& a = *events[set[i]].point;
    beta[i] = -a.index;
    for (std::size_t k = 0; k < i; ++k) R(i, k) = nearly_one * dot_of(a.alpha, events[set[k]].point->alpha);
  }
  const double p = OT::Normal(OT::Point(set.size()), OT::Point(set.size(), 1.), R).computeCDF(beta);
  return std::clamp(p, 0., least);
}

/// What a probability lies between.
struct Bounds {
  double low = 0., high = 1.;
};

/// Ditlevsen (1979), Narrow reliability bounds for structural systems, J. Struct. Mech. 7(4), 453-472, of sets in the
/// order of their probability; and at least that of the most probable set.
Bounds bounds_of(const std::vector<DesignPointSearch>& events, const CutSets& sets) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < sets.size(); ++i) order.emplace_back(intersection(events, sets[i]), i);
  std::sort(order.rbegin(), order.rend());
  Bounds bounds{0., 0.};
  for (std::size_t i = 0; i < order.size(); ++i) {
    double sum = 0., largest = 0.;
    for (std::size_t k = 0; k < i; ++k) {
      const double both =
          std::min(order[i].first, intersection(events, united(sets[order[i].second], sets[order[k].second])));
      sum += both;
      largest = std::max(largest, both);
    }
    bounds.low += std::max(order[i].first - sum, 0.);
    bounds.high += order[i].first - largest;
  }
  bounds.high = std::min(bounds.high, 1.);
  return bounds;
}

double by_inclusion_and_exclusion(const std::vector<DesignPointSearch>& events, const CutSets& sets) {
  double p = 0.;
  for (unsigned long some = 1; some < (1UL << sets.size()); ++some) {
    std::vector<std::size_t> all;
    bool odd = false;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (!(some >> i & 1UL)) continue;
      odd = !odd;
      all = united(all, sets[i]);
    }
    p += (odd ? 1. : -1.) * intersection(events, all);
  }
  return p;
}

bool in_series(const CutSets& sets) {
  return std::all_of(sets.begin(), sets.end(), [](const auto& set) { return set.size() == 1; });
}

double probability_in_series(const std::vector<DesignPointSearch>& events, const CutSets& sets) {
  std::vector<DesignPoint> points;
  for (const auto& set : sets) points.push_back(*events[set[0]].point);
  return probability_of_any(points);
}

constexpr std::size_t most_sets = 10;
constexpr double told_from = 1e-3;  // of a probability: less is round-off of Phi_n

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

/// Of a system whose probability is 1 to round-off, as it fails where one of its sets does, and a set where its last
/// event does.
double index_of_certain(const std::vector<DesignPointSearch>& events, const CutSets& sets) {
  double index = HUGE_VAL;
  for (const auto& set : sets) {
    double last = -HUGE_VAL;
    for (const std::size_t i : set) last = std::max(last, events[i].point->index);
    index = std::min(index, last);
  }
  return index;
}

}  // namespace

MethodAnswer by_system_form(const std::vector<DesignPointSearch>& events, const CutSets& sets) {
  MethodAnswer answer{"form", {}, {}, {}, 0., ""};
  const bool series = in_series(sets);
  if (!series && sets.size() > most_sets)
    answer.why_not = "the fault tree has more than ten sets of events that fail it";
  for (const auto& set : sets)
    if (!all_found(events, set)) answer.why_not = "one of its limit states has no design point";
  if (!answer.why_not.empty()) return answer;
  const Bounds bounds = series ? Bounds() : bounds_of(events, sets);
  const double sum = series ? probability_in_series(events, sets) : by_inclusion_and_exclusion(events, sets);
  const double p = std::clamp(sum, bounds.low, std::max(bounds.low, bounds.high));
  answer.index = p >= 1. ? index_of_certain(events, sets) : index_of(p);
  if (answer.index)
    answer.probability = p;
  else
    answer.why_not = "its sum of probabilities is not between 0 and 1";
  if (answer.index && std::abs(sum - p) > told_from * p)
    answer.why_not = "bounded: by inclusion and exclusion " + significant(sum, 4) +
                     ", which is not between Ditlevsen's " + significant(bounds.low, 4) + " and " +
                     significant(bounds.high, 4);
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

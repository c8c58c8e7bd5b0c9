#include "dynamics/trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <string>

#include "dynamics/step_interior.h"
#include "upbead/dynamics/modal_response.h"

namespace upbead {

namespace {

using Eigen::Index;

constexpr auto n_inside = static_cast<Index>(inside_places.size());

Series columns(const Series& like, std::size_t n) {
  const auto size = static_cast<Index>(n);
  return {std::vector<double>(n), Eigen::MatrixXd(like.reading.rows(), size), Eigen::MatrixXd(like.load.rows(), size)};
}

void copy_column(const Series& from, Index i, Series& to, Index j) {
  to.reading.col(j) = from.reading.col(i).head(to.reading.rows());
  to.load.col(j) = from.load.col(i);
}

/// Lagrange's weights of inside_places and the end of the step, at the place s.
std::array<double, n_inside + 1> weights(double s) {
  std::array<double, n_inside + 1> node{}, weight{};
  std::copy(inside_places.begin(), inside_places.end(), node.begin());
  node.back() = 1.;
  for (std::size_t j = 0; j < node.size(); ++j) {
    weight[j] = 1.;
    for (std::size_t i = 0; i < node.size(); ++i)
      if (i != j) weight[j] *= (s - node[i]) / (node[j] - node[i]);
  }
  return weight;
}

/// The same loads, known at more times.
SampledLoads refined(const SampledLoads& loads, const std::vector<double>& more) {
  SampledLoads fine;
  std::merge(loads.time.begin(), loads.time.end(), more.begin(), more.end(), std::back_inserter(fine.time));
  fine.time.erase(std::unique(fine.time.begin(), fine.time.end()), fine.time.end());
  const auto n = static_cast<Index>(fine.time.size()) - 1;
  fine.begin.resize(loads.begin.rows(), n);
  fine.end.resize(loads.begin.rows(), n);
  std::size_t step = 0;
  for (Index i = 0; i < n; ++i) {
    const double begin = fine.time[static_cast<std::size_t>(i)], end = fine.time[static_cast<std::size_t>(i) + 1];
    if (begin >= loads.time[step + 1]) ++step;
    const double start = loads.time[step], h = loads.time[step + 1] - start;
    const auto from = loads.begin.col(static_cast<Index>(step)), to = loads.end.col(static_cast<Index>(step));
    fine.begin.col(i) = from + (begin - start) / h * (to - from);
    fine.end.col(i) = from + (end - start) / h * (to - from);
  }
  return fine;
}

/// The largest value of each of these readings; not less than a millionth of the largest of its unit, which may be
/// round-off.
Eigen::VectorXd largest(const System& system, const Eigen::MatrixXd& values, const std::vector<Index>& readings) {
  Eigen::VectorXd own(static_cast<Index>(readings.size()));
  std::map<std::string, double> of_unit;
  const auto unit = [&](std::size_t i) { return system.readings[static_cast<std::size_t>(readings[i])].unit; };
  for (std::size_t i = 0; i < readings.size(); ++i) {
    own[static_cast<Index>(i)] = values.row(readings[i]).cwiseAbs().maxCoeff();
    of_unit[unit(i)] = std::max(of_unit[unit(i)], own[static_cast<Index>(i)]);
  }
  for (std::size_t i = 0; i < readings.size(); ++i) {
    double& value = own[static_cast<Index>(i)];
    value = std::max(value, 1e-6 * of_unit[unit(i)]);
    if (value == 0.) value = 1.;
  }
  return own;
}

/// Times at the quarters of the equal parts of each step, without the ends of the steps.
std::vector<double> quarters(const std::vector<double>& ends, const std::vector<int>& parts) {
  std::vector<double> times;
  for (std::size_t n = 0; n < parts.size(); ++n)
    for (int j = 1; j < 4 * parts[n]; ++j) times.push_back(ends[n] + j * (ends[n + 1] - ends[n]) / (4. * parts[n]));
  return times;
}

/// Largest distance of a course at quarters from the chords of its parts.
double off_chords(const Eigen::MatrixXd& course) {
  double off = 0.;
  for (Index j = 0; j + 4 < course.cols(); j += 4)
    for (int i = 1; i < 4; ++i) {
      const double s = 0.25 * i;
      const auto chord = (1. - s) * course.col(j) + s * course.col(j + 4);
      off = std::max(off, (course.col(j + i) - chord).cwiseAbs().maxCoeff());
    }
  return off;
}

/// Leaves so many of the parts out that at most `most` remain, and each step has one. Returns whether it was needed.
bool limit(std::size_t most, std::vector<int>& parts) {
  double all = 0.;
  for (const int n : parts) all += n;
  const auto n_steps = static_cast<double>(parts.size()), room = static_cast<double>(most);
  if (all <= room) return false;
  const double share = std::max(0., room - n_steps) / (all - n_steps);
  for (int& n : parts) n = 1 + static_cast<int>((n - 1) * share);
  return true;
}

/// The ends of the steps, those of their parts (s), and one time right after each jump.
std::vector<double> row_times(const std::vector<double>& ends, const std::vector<int>& parts,
                              const std::vector<int>& jumps, double near) {
  std::vector<double> times{ends.front()};
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const double begin = ends[n], h = ends[n + 1] - begin;
    if (jumps[n] > 0) times.push_back(begin + std::min(0.5 * h / parts[n], std::max(1e-6 * h, 3. * near)));
    for (int j = 1; j < parts[n]; ++j) times.push_back(begin + j * h / parts[n]);
    times.push_back(ends[n + 1]);
  }
  return times;
}

}  // namespace

Trajectory::Trajectory(const System& system, const Response& response, const ModalModel* model)
    : system_(system), response_(response), model_(model), loads_(load_histories(system)) {
  feedthrough_.setZero(response.ends.reading.rows(), static_cast<Index>(loads_.size()));
  for (Index i = 0; i < feedthrough_.rows(); ++i) {
    const std::vector<double>& of_reading = system.readings[static_cast<std::size_t>(i)].feedthrough;
    std::copy(of_reading.begin(), of_reading.end(), feedthrough_.row(i).begin());
  }
}

Series Trajectory::inside(const std::vector<double>& times) const {
  const Series &ends = response_.ends, &within = response_.inside;
  Series series = columns(ends, times.size());
  series.time = times;
  Eigen::VectorXd load(static_cast<Index>(loads_.size()));
  for (std::size_t c = 0; c < times.size(); ++c) {
    const auto column = static_cast<Index>(c);
    const auto after = std::lower_bound(ends.time.begin(), ends.time.end(), times[c]);
    const Index right = after - ends.time.begin(), left = right - 1;
    const double begin = *(after - 1), h = *after - begin, place = (times[c] - begin) / h;
    if (is_straight()) {
      series.reading.col(column) = (1. - place) * ends.reading.col(left) + place * ends.reading.col(right);
      series.load.col(column) = (1. - place) * ends.load.col(left) + place * ends.load.col(right);
      continue;
    }
    const auto weight = weights(place);
    const Eigen::Map<const Eigen::Matrix<double, n_inside, 1>> inner(weight.data());
    load = within.load.middleCols(n_inside * left, n_inside) * inner + weight.back() * ends.load.col(right);
    for (std::size_t k = 0; k < loads_.size(); ++k)
      series.load(static_cast<Index>(k), column) = loads_[k](times[c], begin + 0.5 * h);
    series.reading.col(column) = within.reading.middleCols(n_inside * left, n_inside) * inner +
                                 weight.back() * ends.reading.col(right) +
                                 feedthrough_ * (series.load.col(column) - load);
  }
  return series;
}

Series Trajectory::modal(const std::vector<double>& times) const {
  const Series all = respond(*model_, refined(sample(loads_, response_.ends.time), times));
  Series series = columns(response_.ends, times.size());
  series.time = times;
  std::size_t next = 0;
  for (std::size_t i = 0; i < all.time.size() && next < times.size(); ++i)
    if (all.time[i] == times[next]) copy_column(all, static_cast<Index>(i), series, static_cast<Index>(next++));
  return series;
}

Series Trajectory::at(const std::vector<double>& times) const {
  const Series& ends = response_.ends;
  const auto next_end = [&](double time) {
    return std::lower_bound(ends.time.begin(), ends.time.end(), time - near());
  };
  std::vector<double> reached, others;
  for (const double time : times) {
    const auto end = next_end(time);
    if (end == ends.time.end()) break;
    reached.push_back(time);
    if (std::abs(*end - time) > near()) others.push_back(time);
  }
  const Series between = others.empty() ? columns(ends, 0) : model_ ? modal(others) : inside(others);
  Series series = columns(ends, reached.size());
  series.time = reached;
  std::size_t next = 0;
  for (std::size_t c = 0; c < reached.size(); ++c) {
    if (next < others.size() && others[next] == reached[c])
      copy_column(between, static_cast<Index>(next++), series, static_cast<Index>(c));
    else
      copy_column(ends, next_end(reached[c]) - ends.time.begin(), series, static_cast<Index>(c));
  }
  return series;
}

/// The readings at the begin of each step, after the loads have jumped.
Eigen::MatrixXd Trajectory::at_begins() const {
  const Series& ends = response_.ends;
  const Index n = ends.reading.cols() - 1;
  if (model_ == nullptr) return response_.inside.reading(Eigen::all, Eigen::seqN(0, n, n_inside));
  return ends.reading.leftCols(n) +
         model_->feedthrough.topRows(ends.reading.rows()) * (sample(loads_, ends.time).begin - ends.load.leftCols(n));
}

Rows Trajectory::rows(const std::vector<Index>& readings, double tolerance, std::size_t most) const {
  const std::vector<double>& ends = response_.ends.time;
  const std::size_t n_steps = ends.size() - 1;
  if (is_straight() || readings.empty() || ends.size() >= most) return {ends};
  const Eigen::VectorXd scale = largest(system_, response_.ends.reading, readings).cwiseInverse();
  const auto scaled = [&](const Eigen::MatrixXd& values) -> Eigen::MatrixXd {
    return scale.asDiagonal() * values(readings, Eigen::all);
  };
  const Eigen::MatrixXd at_ends = scaled(response_.ends.reading), begins = scaled(at_begins());
  std::vector<int> jumps(n_steps);  // 1: there is a row after the jump
  for (Index n = 0; n < begins.cols(); ++n)
    jumps[static_cast<std::size_t>(n)] = (begins.col(n) - at_ends.col(n)).cwiseAbs().maxCoeff() > tolerance ? 1 : 0;
  const auto n_jumps = static_cast<std::size_t>(std::count(jumps.begin(), jumps.end(), 1));
  std::vector<int> parts(n_steps, 1);
  Rows rows;
  constexpr int most_rounds = 6;
  bool is_full = false;
  for (int round = 1;; ++round) {
    const Eigen::MatrixXd within = scaled(at(quarters(ends, parts)).reading);
    rows.error = 0.;
    Index first = 0;
    for (std::size_t i = 0; i < n_steps; ++i) {
      const auto n = static_cast<Index>(i), inner = static_cast<Index>(4 * parts[i] - 1);
      Eigen::MatrixXd course(within.rows(), inner + 2);
      course << begins.col(n), within.middleCols(first, inner), at_ends.col(n + 1);
      first += inner;
      const double off = off_chords(course);
      rows.error = std::max(rows.error, off);
      if (off > tolerance && !is_full && round < most_rounds)
        parts[i] = static_cast<int>(std::ceil(parts[i] * std::sqrt(1.1 * off / tolerance)));
    }
    if (rows.error <= tolerance || is_full || round == most_rounds) break;
    is_full = limit(most - std::min(most, 1 + n_jumps), parts);
  }
  rows.time = row_times(ends, parts, jumps, near());
  return rows;
}

}  // namespace upbead

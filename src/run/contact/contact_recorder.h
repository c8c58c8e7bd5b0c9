// What the nodes of an interface do while they are marched.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "dynamics/contact.h"
#include "upbead/dynamics/march.h"
#include "upbead/output/sliding_summary.h"

namespace upbead {

/// Records every step of a march; system and scheme must outlive it.
class ContactRecorder : public MarchObserver {
 public:
  ContactRecorder(const System& system, const Scheme& scheme) : system_(system), scheme_(scheme) {}
  void see(const State& state, int, int) override {
    const int n = system_.interface->n_nodes();
    const auto append = [](std::vector<double>& list, const Eigen::Ref<const Vector>& values) {
      list.insert(list.end(), values.begin(), values.end());
    };
    const InterfaceForces& forces = scheme_.contact()->forces;
    history_.time.push_back(state.time);
    append(history_.slip, state.x.segment(system_.first_slip(), n));
    append(history_.opening, state.x.segment(system_.first_opening(), n));
    append(history_.shear_force, forces.shear);
    append(history_.normal_force, forces.normal);
    closing_.push_back({-state.v[system_.first_opening()], -state.v[state.v.size() - 1]});
    if (system_.interface->gap) see_gap(scheme_.contact()->gap);
  }
  ContactHistory history() const {
    ContactHistory history = history_;
    history.position = system_.interface->position;
    history.length = system_.interface->length;
    return history;
  }
  NodeContact summary() const {
    const std::vector<double>& length = system_.interface->length;
    const std::size_t n = length.size();
    double width = 0.;
    for (const double part : length) width += part;
    const ContactReport& report = *scheme_.contact();
    NodeContact out;
    out.least_normal_force = system_.interface->normal_force.sum();
    out.dissipated = scheme_.energy().friction;
    out.slip_steps = report.slip_steps;
    out.open_steps = report.open_steps;
    out.impacts = report.impacts;
    out.fallbacks = report.fallbacks;
    for (std::size_t t = 0; t < history_.time.size(); ++t) {
      double slip = 0., contact = 0., normal = 0.;
      for (std::size_t i = t * n; i < (t + 1) * n; ++i) {
        slip += history_.slip[i] * length[i - t * n] / width;
        normal += history_.normal_force[i];
        if (history_.opening[i] == 0.) contact += length[i - t * n] / width;
        if (!out.first_slip && history_.slip[i] != 0.) out.first_slip = history_.time[t];
        if (!out.first_open && history_.opening[i] > 0.) out.first_open = history_.time[t];
      }
      out.slip = slip;
      if (std::abs(slip) > std::abs(out.largest_slip)) out.largest_slip = slip;
      out.opening_seaward = std::max(out.opening_seaward, history_.opening[t * n]);
      out.opening_landward = std::max(out.opening_landward, history_.opening[(t + 1) * n - 1]);
      out.least_contact = std::min(out.least_contact, contact);
      out.least_normal_force = std::min(out.least_normal_force, normal);
    }
    look_at_lift(out);
    const auto last = history_.slip.end() - static_cast<std::ptrdiff_t>(n);
    out.least_slip =
        *std::min_element(last, history_.slip.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    out.end_velocity = end_velocity(n);
    return out;
  }

 private:
  void see_gap(const Vector& force) {
    const std::vector<double>& x = system_.interface->position;
    double sum = 0., moment = 0.;
    for (Eigen::Index i = 0; i < force.size(); ++i) {
      sum += force[i];
      moment -= force[i] * x[static_cast<std::size_t>(i)];
    }
    history_.gap_force.push_back(sum);
    history_.gap_moment.push_back(moment);
  }
  /// How high nodes lift, and how they come down. The speed of an end that closes is that of the time before.
  void look_at_lift(NodeContact& out) const {
    const Vector& at_rest = system_.interface->normal_force;
    const Eigen::Map<const Eigen::ArrayXd> length(system_.interface->length.data(), at_rest.size());
    const Eigen::Map<const Eigen::ArrayXXd> opening(history_.opening.data(), at_rest.size(),
                                                    static_cast<Eigen::Index>(history_.time.size()));
    for (Eigen::Index t = 1; t < opening.cols(); ++t) {
      const double time = history_.time[static_cast<std::size_t>(t)];
      out.lift_energy = std::max(out.lift_energy, at_rest.dot(opening.col(t).matrix()));
      if ((opening.col(t) > 0.).any())
        out.last_closing.reset();
      else if ((opening.col(t - 1) > 0.).any())
        out.last_closing = time;
      for (std::size_t end = 0; end < 2; ++end) {
        const Eigen::Index i = end == 0 ? 0 : at_rest.size() - 1;
        const double speed = closing_[static_cast<std::size_t>(t) - 1][end];
        if (!(opening(i, t - 1) > 0.) || opening(i, t) > 0. || !(speed > out.closing_speed)) continue;
        out.closing_speed = speed;
        out.closing_time = time;
      }
    }
    out.open_in_end = (opening.rightCols(1) > 0.).select(length, 0.).sum() / length.sum();
    if (!history_.gap_force.empty())
      out.gap_force = *std::max_element(history_.gap_force.begin(), history_.gap_force.end());
  }
  /// Zero where a node rests in the last step, and where not all nodes go the same way.
  double end_velocity(std::size_t n) const {
    const std::size_t steps = history_.time.size();
    if (steps < 2) return 0.;
    const double *now = &history_.slip[(steps - 1) * n], *before = now - n;
    double least = now[0] - before[0];
    for (std::size_t i = 1; i < n; ++i) {
      const double moved = now[i] - before[i];
      if (moved * least <= 0.) return 0.;
      if (std::abs(moved) < std::abs(least)) least = moved;
    }
    return least / (history_.time[steps - 1] - history_.time[steps - 2]);
  }

  const System& system_;
  const Scheme& scheme_;
  ContactHistory history_;
  std::vector<std::array<double, 2>> closing_;  ///< speed at which the ends come down (m/s)
};

}  // namespace upbead

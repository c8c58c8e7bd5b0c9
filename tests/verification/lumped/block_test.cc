// Claim: the event-exact integration of a block on friction, and the closed forms of its sliding distance, are
// right under the triangular pulse of Shimosako and Takahashi (1994).
// Source: tests/reference/ref7_sliding.json, part A; its numbers have 9 digits, so half a unit of the ninth (5e-9
// relative) is the limit there. For 1e-10 the same formulas are evaluated here from velocities and times, in long
// double.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "record.h"
#include "reference.h"
#include "upbead/sliding/pulse.h"

namespace upbead::test {
namespace block_test {

struct Motion {
  double distance = 0., peak_velocity = 0., stop = 0.;
};

struct Entry {
  double mass, resistance;
  TriangularPulse pulse;
};

Entry entry(const Json& row) {
  return {row.at("W").get<double>() / row.at("g").get<double>(),
          row.at("mu").get<double>() * row.at("Wp").get<double>(),
          {row.at("Fm"), row.at("t0")}};
}

/// By hand: T = time from the start to the pulse's peak. The block speeds up for 2 T until F_S falls to R again, and
/// gains the velocity V; it then stops within the pulse, or afterwards under R alone.
Motion by_hand(const Entry& e) {
  const long double F = e.pulse.peak, R = e.resistance, m = e.mass, duration = e.pulse.duration;
  const long double T = duration * (F - R) / (2 * F), V = (F - R) * T / m;
  const long double slope = 2 * F / duration, falling = R / slope;  // R - F_S = slope t after F_S = R, for `falling`
  const long double after = duration - falling, brake = std::sqrt(2 * m * V / slope);
  if (brake <= falling) {
    const long double S = V * T + V * brake * 2 / 3;
    return {static_cast<double>(S), static_cast<double>(V), static_cast<double>(after + brake)};
  }
  const long double left = V - slope * falling * falling / (2 * m), glide = m * left / R;
  const long double S = V * T + V * falling - slope * falling * falling * falling / (6 * m) + left * glide / 2;
  return {static_cast<double>(S), static_cast<double>(V), static_cast<double>(duration + glide)};
}

Motion by_events(const Entry& e) {
  const Sliding found = slide(e.mass, history(e.pulse), e.resistance);
  EXPECT_EQ(found.slips.size(), 1u);
  return {found.residual, found.slips.at(0).peak_velocity, found.slips.at(0).stop};
}

double difference(const Motion& a, const Motion& b) {
  return largest_error({a.distance / b.distance, a.peak_velocity / b.peak_velocity, a.stop / b.stop}, {1., 1., 1.}, 1.);
}

TEST(Block, SlidesUnderTheTriangularPulse) {
  Record record("block");
  double to_table = 0., to_hand = 0., closed = 0., equation_7 = 0.;
  Curve curve{"residual slip, tau_0 = 0.2 s", "peak F_S / R", "S (m)", "eqs. (4) and (6)", {}, {}, {}};
  const Json all = reference("ref7_sliding");
  ASSERT_EQ(all.at("shimosako").size(), 15u);
  for (const Json& row : all.at("shimosako")) {
    const Entry e = entry(row);
    const Motion found = by_events(e), hand = by_hand(e), table{row.at("S_exact"), row.at("v_max"), row.at("t_stop")};
    to_table = std::max(to_table, difference(found, table));
    to_hand = std::max(to_hand, difference(found, hand));
    closed = std::max(closed, std::abs(sliding_distance_exact(e.mass, e.resistance, e.pulse) / hand.distance - 1.));
    const double paper = sliding_distance_paper(e.mass, e.resistance, e.pulse);
    equation_7 = std::max(equation_7, std::abs(paper / row.at("S_eq7").get<double>() - 1.));
    if (row.at("t0") != 0.2) continue;
    curve.abscissa.push_back(row.at("Fm_over_R"));
    curve.exact.push_back(table.distance);
    curve.computed.push_back(found.distance);
  }
  record.at_most("15 pulses, event-exact block: slip, peak velocity and time of stop, relative to the formula", to_hand,
                 1e-10);
  record.at_most("15 pulses, event-exact block: slip, peak velocity and time of stop, relative to the table's 9 digits",
                 to_table, 5e-9);
  record.at_most("15 pulses, closed form of eqs. (4) and (6): slip, relative", closed, 1e-10);
  record.at_most("15 pulses, eq. (7): slip, relative to the table's 9 digits", equation_7, 5e-9);
  record.curve(curve);
}

}  // namespace block_test
}  // namespace upbead::test

// Claims: marched by SDIRK4, the force of compressible water on a wall with a given acceleration is exact, and so are
// motion and support force of a wall on spring and dashpot under a triangular force, with compressible and with
// incompressible water in front of it.
// Source: tests/reference/ref6_water.json, `step_acceleration` and `coupled`: Laplace inversion, checked by convolution
// with J0 and by Volterra's equation; with incompressible water the oscillator with the added mass.
// Limit: 0.5 % of the largest value of each history.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reservoir.h"
#include "upbead/dynamics/time_grid.h"

namespace upbead::test {
namespace transient_test {

Response marched(const System& system, double end, double step) {
  SchemeOptions options;
  options.account_energy = false;
  const auto scheme = make_scheme(system, options);
  return march(system, *scheme, make_time_grid(kinks(system), end, step));
}

std::vector<double> read(const System& system, const Response& response, const std::string& reading,
                         const std::vector<double>& at) {
  return sampled(response.ends.time, response.ends.reading.row(system.reading(reading)), at);
}

/// Velocity under the acceleration triangle(1, duration).
TimeFunction velocity_under_triangle(double duration) {
  return {{0., 0.5 * duration, duration},
          {[](double) { return 0.; }, [=](double t) { return t * t / duration; },
           [=](double t) { return 0.5 * duration - (duration - t) * (duration - t) / duration; },
           [=](double) { return 0.5 * duration; }}};
}

/// Long enough that no reflection arrives from its end until `end` (s). Cells are square: if they grow to twice their
/// length, the remaining force of the water after a pulse of 10 ms is wrong by 2 %.
ReservoirShape endless(const Json& entry, double end) {
  ReservoirShape shape;
  shape.depth = entry.at("h");
  shape.cells = 10;
  shape.length = 0.5 * entry.at("c").get<double>() * end;
  shape.far = PressureCondition::absorbing;
  return shape;
}

std::string milliseconds(double seconds) {
  return std::to_string(std::lround(1e3 * seconds)) + " ms";
}

TEST(MovedWall, MeetsTheForceOfCompressibleWater) {
  Record record("water_transient");
  const Json entries = reference("ref6_water").at("step_acceleration");
  for (const Json& entry : entries) {
    const std::vector<double> times = entry.at("t");
    const double duration = entry.at("td");
    const Reservoir reservoir(endless(entry, times.back()), compressible_water(entry));
    const System water = reservoir.water(velocity_under_triangle(duration));
    const Response response = marched(water, times.back(), 2.5e-4);
    const std::vector<double> force = read(water, response, "force", times);
    const std::string title = "triangular acceleration of " + milliseconds(duration);
    record.at_most(title + ": force on the wall at 20 times, over the largest",
                   largest_error(force, entry.at("F_over_unit_acc")), 5e-3);
    record.curve({"force on an accelerated wall, compressible water", "time (s)", "force over unit acceleration (kg/m)",
                  title, times, entry.at("F_over_unit_acc"), force});
  }
}

/// One model of water in one entry: displacement, force in the support and force of the water.
void compare(Record& record, const Json& entry, const std::string& model) {
  const Json& table = entry.at(model);
  const std::vector<double> times = entry.at("t");
  const bool compressible = model == "compressible", finite = entry.contains("L");
  ReservoirShape shape = endless(entry, compressible ? times.back() : 0.);
  if (finite || !compressible) {
    shape.length = entry.value("L", 6. * shape.depth);
    shape.far = PressureCondition::sealed;
  }
  const Reservoir reservoir(shape, compressible ? compressible_water(entry) : incompressible_water(entry));
  const System system = reservoir.with_wall(entry.at("m"), entry.at("cd"), entry.at("k"), triangle(1., entry.at("td")));
  const double step = std::min(1e-3, entry.at("td").get<double>() / 40.);
  const Response response = marched(system, times.back(), step);
  std::vector<double> of_water = read(system, response, "force", times);
  for (double& force : of_water) force = -force;  // the table has the force of the wall on the water
  const std::string title = model + ", " + milliseconds(entry.at("td")) + (entry.at("cd") > 0. ? ", damped" : "") +
                            (finite ? ", closed at 2 h" : "");
  const std::vector<double> support = read(system, response, "support", times);
  record.at_most(title + ": displacement at 30 times, over the largest",
                 largest_error(read(system, response, "displacement", times), table.at("x")), 5e-3);
  record.at_most(title + ": k x + c_d x' at 30 times, over the largest", largest_error(support, table.at("FT")), 5e-3);
  record.at_most(title + ": force of the water at 30 times, over the largest",
                 largest_error(of_water, table.at("Fhyd")), 5e-3);
  if (entry.at("td") == 0.05)
    record.curve({"wall on a spring, " + model + " water", "time (s)", "force on spring and dashpot (N/m)", title,
                  times, table.at("FT"), support});
}

TEST(WallOnSpring, MovesWithCompressibleWater) {
  Record record("water_transient");
  const Json entries = reference("ref6_water").at("coupled");
  compare(record, entries.front(), "compressible");
}

TEST(WallOnSpring, MovesWithCompressibleWaterAtLength) {
  Record record("water_transient");
  const Json entries = reference("ref6_water").at("coupled");
  for (std::size_t i = 1; i < entries.size(); ++i) compare(record, entries[i], "compressible");
}

TEST(WallOnSpring, MovesWithIncompressibleWater) {
  Record record("water_transient");
  const Json entries = reference("ref6_water").at("coupled");
  for (const Json& entry : entries) compare(record, entry, "incompressible");
}

}  // namespace transient_test
}  // namespace upbead::test

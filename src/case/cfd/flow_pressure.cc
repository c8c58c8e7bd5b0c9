// Pressures at points of a record become pressures along a line, in excess of still water.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "base/numbers.h"
#include "base/text.h"
#include "case/cfd/flow_meaning.h"

namespace upbead {

namespace {

using Q = FlowQuantity;

bool is_less_weight(Q quantity) {
  return quantity == Q::pressure_less_weight || quantity == Q::kinematic_less_weight;
}

bool is_kinematic(Q quantity) {
  return quantity == Q::kinematic || quantity == Q::kinematic_less_weight;
}

/// Whether a field has a name that OpenFOAM uses for something else than a pressure.
bool is_no_pressure(const std::string& field) {
  static const std::array<const char*, 9> names{"U", "T", "k", "epsilon", "omega", "nut", "nuTilda", "rho", "phi"};
  return field.rfind("alpha", 0) == 0 || std::find(names.begin(), names.end(), field) != names.end();
}

/// The quantity at the points. A unit in the file says which it is; the name of a field contradicts some quantities.
std::optional<Q> ask_quantity(const FlowPoints& points, const FlowKeys& source, FlowQuestions& questions) {
  if (points.unit == "Pa") {
    if (source.quantity && *source.quantity != Q::pressure)
      questions.object("quantity", "the record's pressures are in Pa, with the weight of the water", "remove it");
    return Q::pressure;
  }
  if (is_no_pressure(points.field)) {
    questions.object("from", "the record's field is called '" + points.field + "', which is no pressure",
                     "name a record of p or p_rgh");
    return {};
  }
  questions.need(source.quantity.has_value(), "quantity", "the record does not say what '" + points.field + "' is",
                 "add quantity = \"p\" (Pa, with the weight of the water), \"p_rgh\" (Pa, without), \"p/rho\" or "
                 "\"p_rgh/rho\" (m2/s2, of incompressible solvers)");
  if (!source.quantity) return {};
  const bool named_less = points.field == "p_rgh", named = points.field == "p";
  if ((named_less && !is_less_weight(*source.quantity)) || (named && is_less_weight(*source.quantity)) ||
      *source.quantity == Q::hydrostatic)
    questions.object("quantity", "the record's field is called '" + points.field + "', which is another quantity",
                     named_less ? "give \"p_rgh\" or \"p_rgh/rho\"" : "give \"p\" or \"p/rho\", or another file");
  return source.quantity;
}

void ask_weight(const FlowKeys& source, Q quantity, FlowQuestions& questions) {
  const bool kinematic = is_kinematic(quantity), less = is_less_weight(quantity);
  questions.need(source.flow_density.has_value() || !(kinematic || less || source.still_level), "flow_density",
                 kinematic ? "a pressure over the density becomes one by the density of the CFD run's water"
                           : "the weight of the water needs the density of the CFD run's water",
                 "add flow_density = ... (kg/m3)");
  questions.need(source.datum.has_value() || !less, "datum",
                 "p_rgh becomes p by the height where both are one, and the record does not say it",
                 "add datum = ... (m), along up in its axes: hRef of the run, 0 where there is none");
  if (source.still_time && source.still_level)
    questions.object("still_level", "both 'still_time' and 'still_level' are given", "keep one of them");
  if (source.still_force)
    questions.object("still_force", "'still_force' belongs to forces, and the record holds pressures",
                     "give still_time or still_level");
  questions.need(source.still_time || source.still_level, "still_time",
                 "the load is the excess over still water, which the record's pressures hold",
                 "add still_time = [from, to] (s), in which its water is still, or still_level = ... (m), y of it");
}

/// Points along a line in the scene, in their order; points at one place across the width count as one.
struct Line {
  bool over_x = false;
  std::vector<std::vector<std::size_t>> members;  ///< by ascending place
  std::vector<double> place;
};

std::array<double, 2> extent(const std::vector<std::array<double, 2>>& at, std::size_t d) {
  std::array<double, 2> ends{infinity, -infinity};
  for (const auto& point : at) ends = {std::min(ends[0], point[d]), std::max(ends[1], point[d])};
  return ends;
}

Line line_of(const std::vector<std::array<double, 2>>& at, FlowQuestions& questions) {
  const auto [left, right] = extent(at, 0);
  const auto [low, high] = extent(at, 1);
  Line line;
  line.over_x = right - left > high - low;
  const std::size_t d = line.over_x ? 0 : 1;
  const double same = 1e-6 * std::max(right - left, high - low);
  std::vector<std::size_t> order(at.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at[a][d] < at[b][d]; });
  for (const std::size_t i : order) {
    if (!line.place.empty() && at[i][d] - line.place.back() <= same) {
      const std::size_t other = line.members.back().front();
      if (std::abs(at[i][1 - d] - at[other][1 - d]) > std::max(same, 1e-3 * (high - low))) {
        questions.object("from",
                         "two of its points are at " + std::string(line.over_x ? "x" : "y") + " = " +
                             significant(at[i][d], 6) + " m, but not at one place: they are no line",
                         "sample front, base and rear apart, a load each");
        return line;
      }
      line.members.back().push_back(i);
      continue;
    }
    line.members.push_back({i});
    line.place.push_back(at[i][d]);
  }
  if (line.place.size() < 2)
    questions.object("from", "fewer than two places of points give no pressure along a line",
                     "give a record with more points, or use a load of kind \"pressure\" with its history");
  return line;
}

/// The edges of faces from their centres c, which ascend. An edge e and the centre beyond it give the next edge, 2 c
/// - e. The first edge is the one with which the sizes of neighbours differ least, in the sum of squares.
std::vector<double> edges_of(const std::vector<double>& centre) {
  const std::size_t n = centre.size();
  std::vector<double> zero{0.};  // edges if the first is at 0; with the first at e_0, edge i is zero[i] + (-1)^i e_0
  for (std::size_t i = 0; i < n; ++i) zero.push_back(2. * centre[i] - zero[i]);
  double above = 0., below = 0.;
  for (std::size_t i = 1; i < n; ++i) {  // size_i - size_(i-1) = e_(i+1) - 2 e_i + e_(i-1) = a + 4 (-1)^(i+1) e_0
    const double a = zero[i + 1] - 2. * zero[i] + zero[i - 1], b = i % 2 == 0 ? -4. : 4.;
    above -= a * b;
    below += b * b;
  }
  const double first = n > 1 ? above / below : centre[0];
  std::vector<double> edges;
  for (std::size_t i = 0; i <= n; ++i) edges.push_back(zero[i] + (i % 2 == 0 ? first : -first));
  return edges;
}

/// Pressure of each place over time (Pa), including the weight of the water.
std::vector<std::vector<double>> pressures_of(const FlowPoints& points, const FlowKeys& source, Q quantity,
                                              const FlowFrame& frame, const Line& line, double gravity) {
  const double factor = is_kinematic(quantity) ? *source.flow_density : 1.;
  std::vector<std::vector<double>> pressure;
  for (const auto& members : line.members) {
    std::vector<double> p(points.rows.count(), 0.);
    for (const std::size_t i : members) {
      const double weight = is_less_weight(quantity)
                                ? *source.flow_density * gravity * (dot(frame.up, points.at[i]) - *source.datum)
                                : 0.;
      for (std::size_t t = 0; t < p.size(); ++t) {
        const double value = points.rows.at(t, i);
        double part = std::isnan(value) ? 0. : factor * value;
        if (is_less_weight(quantity)) part = std::max(part - weight, 0.);  // in air p_rgh is nearly zero
        p[t] += part / static_cast<double>(members.size());
      }
    }
    pressure.push_back(std::move(p));
  }
  return pressure;
}

/// Subtracts still water from each pressure: its mean over `rows`, or the hydrostatic pressure of the still level.
void take_off_still(const FlowKeys& source, double gravity, const std::vector<std::size_t>& rows, const Line& line,
                    const std::vector<std::array<double, 2>>& at, std::vector<std::vector<double>>& pressure) {
  for (std::size_t k = 0; k < pressure.size(); ++k) {
    const double height = at[line.members[k].front()][1];
    const double still = source.still_level
                             ? *source.flow_density * gravity * std::max(*source.still_level - height, 0.)
                             : mean_of(pressure[k], rows);
    for (double& p : pressure[k]) p -= still;
  }
}

/// The pressures of a line as a row of transducers. The row of faces reaches to their outer edges; beyond other
/// points it goes on as the case says.
Gauges row_of(const FlowPoints& points, const FlowContext& context, const Line& line,
              const std::vector<std::vector<double>>& pressure) {
  Gauges row;
  row.over_x = line.over_x;
  row.time = points.rows.time;
  row.place = line.place;
  row.pressure = pressure;
  for (const auto& members : line.members) row.name.push_back(points.name[members.front()]);
  row.beyond = context.beyond;
  if (!points.are_faces) {
    if (points.are_vertices) row.beyond = {Beyond::none, Beyond::none};
    return row;
  }
  const std::vector<double> edges = edges_of(line.place);
  row.beyond = {Beyond::none, Beyond::none};
  row.place.insert(row.place.begin(), edges.front());
  row.place.push_back(edges.back());
  row.name.insert(row.name.begin(), "first_edge");
  row.name.emplace_back("last_edge");
  row.pressure.insert(row.pressure.begin(), pressure.front());
  row.pressure.push_back(pressure.back());
  return row;
}

void cut_row(Gauges& row, std::size_t first, double start) {
  const auto n = static_cast<std::ptrdiff_t>(first);
  row.time.erase(row.time.begin(), row.time.begin() + n);
  for (double& time : row.time) time -= start;
  for (std::vector<double>& p : row.pressure) p.erase(p.begin(), p.begin() + n);
}

double interpolated(const std::vector<double>& time, const std::vector<double>& value, double t) {
  const auto next = std::lower_bound(time.begin(), time.end(), t);
  if (next == time.begin()) return value.front();
  const auto i = static_cast<std::size_t>(next - time.begin());
  return value[i - 1] + (value[i] - value[i - 1]) * (t - time[i - 1]) / (time[i] - time[i - 1]);
}

/// The sum of pressures over their line. Points whose pressure stays constant beyond the ends count half a spacing
/// more at either end, as cells would.
std::vector<double> sum_of(const Gauges& row) {
  const std::size_t n = row.count();
  const double before = row.beyond[0] == Beyond::constant ? 0.5 * (row.place[1] - row.place[0]) : 0.;
  const double after = row.beyond[1] == Beyond::constant ? 0.5 * (row.place[n - 1] - row.place[n - 2]) : 0.;
  return resultant(row, row.place.front() - before, row.place.back() + after).force;
}

/// Compares the sum of pressures with the record of forces, both with still water, at the times that both have.
void compare(const FlowKeys& source, const FlowContext& context, const FlowFrame& frame, const Gauges& whole,
             FlowLoad& load) {
  FlowQuestions questions(context);
  questions.need(source.thickness.has_value(), "thickness",
                 "the newtons of 'against' are of the thickness that was computed, and it does not give that",
                 "add thickness = ... (m), the cells' extent across");
  const Place place = context.document->place(context.path + ".against");
  const std::string path = (std::filesystem::path(context.base) / source.against).lexically_normal().string();
  const FlowRecord record = read_flow(path, "", place);
  if (!record.forces) questions.object("against", "'against' holds no forces", "name forces on the same wall");
  if (whole.over_x) questions.object("against", "a landward force is compared on a wall alone", "remove against");
  questions.answer();
  std::vector<double> force;
  for (const Triple& f : record.forces->force) force.push_back(dot(f, frame.landward) / *source.thickness);
  const std::vector<double>& time = record.forces->time;
  const std::vector<double> sum = sum_of(whole);
  double most = 0., size = 0., when = 0.;
  for (std::size_t t = 0; t < sum.size(); ++t) {
    if (whole.time[t] < time.front() || whole.time[t] > time.back()) continue;
    const double other = interpolated(time, force, whole.time[t]), error = std::abs(sum[t] - other);
    size = std::max(size, std::abs(other));
    if (error > most) {
      most = error;
      when = whole.time[t];
    }
  }
  if (size == 0.) questions.object("against", "'against' has no time in common with the record", "remove it");
  questions.answer();
  load.files.insert(load.files.end(), record.files.begin(), record.files.end());
  load.difference = most / size;
  load.told.push_back("the sum of the pressures and the forces of " + source.against + " differ by " +
                      percent(*load.difference) + " of the largest at most, at t = " + significant(when, 4) + " s");
  constexpr double tolerable = 0.02;
  if (*load.difference > tolerable)
    load.warnings.push_back(
        {"flow_forces_differ", *load.difference, tolerable, "1", "'" + context.path + "': " + load.told.back(),
         "look whether points are too sparse, the patches not the same, or thickness or axes wrong"});
}

void tell_points(const FlowPoints& points, const Line& line, Q quantity, FlowLoad& load) {
  const Gauges& row = *load.pressure;
  load.told.push_back(std::to_string(line.place.size()) + (points.are_faces ? " faces" : " points") + " over " +
                      (line.over_x ? "x" : "y") + " from " + significant(row.place.front(), 6) + " to " +
                      significant(row.place.back(), 6) + " m" +
                      (points.are_faces ? ", their edges by their centres" : ""));
  if (const std::size_t wide = points.at.size() - line.place.size(); wide > 0)
    load.told.push_back(std::to_string(wide) + " further points across the width: means, as if all were as wide");
  if (is_less_weight(quantity))
    load.told.emplace_back(
        "p_rgh counts as p in water without air, and as zero where that is negative; p itself is better where water "
        "and air mix");
}

/// By how much the largest force may be too small. Where air was in still water, p lies between p_rgh minus the
/// weight of water and p_rgh, as any share of air may be there at the peak.
void bound_air(const FlowPoints& points, const FlowKeys& source, const FlowFrame& frame, double gravity,
               const Line& line, const std::vector<std::vector<double>>& pressure,
               const std::vector<std::size_t>& still, const std::string& path, FlowLoad& load) {
  const auto row =
      std::lower_bound(points.rows.time.begin(), points.rows.time.end(), load.peak_time + source.flow_start - 1e-9);
  const auto t = static_cast<std::size_t>(row - points.rows.time.begin());
  Gauges more = *load.pressure;
  for (std::vector<double>& p : more.pressure) p.assign(p.size(), 0.);
  const std::size_t shift = points.are_faces ? 1 : 0;
  for (std::size_t k = 0; k < line.place.size(); ++k) {
    const double height = dot(frame.up, points.at[line.members[k].front()]);
    const bool dry = source.still_level ? load.at[line.members[k].front()][1] > *source.still_level
                                        : mean_of(pressure[k], still) <= 0.;
    if (dry && pressure[k][t] > 0.)
      more.pressure[k + shift][0] = *source.flow_density * gravity * (height - *source.datum);
  }
  if (shift == 1) more.pressure.back()[0] = more.pressure[more.count() - 2][0];
  const double share = resultant(more, more.place.front(), more.place.back()).force[0] / std::abs(load.peak_force);
  constexpr double tolerable = 0.02;
  if (load.peak_force != 0. && share > tolerable)
    load.warnings.push_back({"flow_p_rgh", share, tolerable, "1",
                             "'" + path + "': the largest force by p_rgh may be up to " + percent(share) +
                                 " too small: where still water left air, water with any share of air may stand, and "
                                 "p_rgh does not tell its weight",
                             "write p in the CFD run"});
}

void require_datum_below(const FlowPoints& points, const FlowKeys& source, const FlowFrame& frame,
                         FlowQuestions& questions) {
  for (const Triple& at : points.at)
    if (dot(frame.up, at) <= *source.datum) {
      questions.object("datum",
                       "a point at " + significant(dot(frame.up, at), 6) +
                           " m is not above the datum: p_rgh does not show when it falls dry",
                       "write p in the CFD run");
      return;
    }
}

}  // namespace

void understand_points(const FlowRecord& record, const FlowContext& context, FlowLoad& load) {
  const FlowKeys& source = load.source;
  const FlowPoints& points = *record.points;
  FlowQuestions questions(context);
  const FlowFrame frame = frame_of(source, true, questions);
  const std::optional<Q> quantity = ask_quantity(points, source, questions);
  if (quantity) ask_weight(source, *quantity, questions);
  if (source.vertical) questions.object("vertical", "'vertical' belongs to forces", "remove it");
  if (!points.are_faces && !points.are_vertices)
    for (std::size_t side = 0; side < 2; ++side)
      questions.need(context.beyond_given[side], side == 0 ? "to_base" : "to_crest",
                     std::string("it is not said how the pressure goes on beyond the ") +
                         (side == 0 ? "first" : "last") + " point",
                     "add it: \"constant\" or \"none\"");
  if (!source.blank_is_zero &&
      std::any_of(points.rows.value.begin(), points.rows.value.end(), [](double value) { return std::isnan(value); }))
    questions.ask("blank_is_zero", "some cells are blank",
                  "add blank_is_zero = true where such a point is dry, or complete the record");
  const std::vector<std::size_t> still = still_rows(points.rows.time, source, questions);
  const std::size_t first = first_row(points.rows.time, source, questions);
  questions.answer();
  if (is_less_weight(*quantity)) require_datum_below(points, source, frame, questions);
  for (const Triple& at : points.at) load.at.push_back(frame.in_scene(at));
  const Line line = line_of(load.at, questions);
  questions.answer();
  std::vector<std::vector<double>> pressure = pressures_of(points, source, *quantity, frame, line, context.gravity);
  if (!source.against.empty()) compare(source, context, frame, row_of(points, context, line, pressure), load);
  const Gauges whole = row_of(points, context, line, pressure);
  const std::vector<std::vector<double>> with_still = pressure;
  take_off_still(source, context.gravity, still, line, load.at, pressure);
  load.pressure = row_of(points, context, line, pressure);
  cut_row(*load.pressure, first, source.flow_start);
  tell_points(points, line, *quantity, load);
  const Gauges& row = *load.pressure;
  const Resultant sum = resultant(row, row.place.front(), row.place.back());
  const std::size_t t = index_of_largest(sum.force);
  load.peak_force = sum.force[t];
  load.peak_time = row.time[t];
  if (load.peak_force != 0. && !row.over_x) load.peak_arm = sum.moment[t] / load.peak_force - row.place.front();
  const std::vector<double> all = resultant(whole, whole.place.front(), whole.place.back()).force;
  load.still_force = still.empty() ? 0. : mean_of(all, still);
  if (is_less_weight(*quantity))
    bound_air(points, source, frame, context.gravity, line, with_still, still, context.path, load);
}

FlowLoad understand(const FlowRecord& record, const FlowKeys& source, const FlowContext& context) {
  FlowLoad load;
  load.source = source;
  load.layout = record.layout;
  load.files = record.files;
  load.told = record.notes;
  if (record.forces)
    understand_forces(record, context, load);
  else if (record.points)
    understand_points(record, context, load);
  else
    understand_level(record, context, load);
  return load;
}

std::string text_of(const std::string& name, const FlowLoad& load) {
  std::string text = "flow        " + name + ": " + load.layout + "; largest " + with_unit(load.peak_force, "N/m") +
                     " over still water at " + significant(load.peak_time, 4) + " s";
  if (load.peak_arm) text += ", arm " + significant(*load.peak_arm, 4) + " m";
  text += "\n";
  for (const std::string& sentence : load.told) text += "            " + sentence + "\n";
  return text;
}

}  // namespace upbead

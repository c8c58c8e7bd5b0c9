#include "findings/histories.h"

#include <algorithm>
#include <map>
#include <optional>

#include "base/text.h"
#include "fem/caisson/readings.h"
#include "fem/compile.h"
#include "findings/effective_base.h"
#include "findings/section_outlines.h"
#include "findings/topics.h"
#include "run/derived.h"

namespace upbead {

namespace {

/// Readings along the bottom, by time and node.
std::vector<Dataset> base_tables(const Simulation& simulation, const Series& series) {
  if (!simulation.compiled()->caisson || !simulation.scene().base_stress) return {};
  std::vector<double> x, length;
  for (const InterfaceNode& node : interface_nodes(*simulation.space())) {
    x.push_back(node.position);
    length.push_back(node.length);
  }
  std::vector<Dataset> list{
      {"base/position", "m", "x of the nodes of the caisson's bottom", x},
      {"base/length", "m", "length that each node stands for: a stress times it is a force", length}};
  std::map<std::string, Dataset> tables;
  const std::size_t n = series.time.size();
  for (std::size_t i = 0; i < simulation.system().readings.size(); ++i) {
    const Reading& reading = simulation.system().readings[i];
    if (reading.name.group != base_group) continue;
    const std::string& what = reading.name.quantity;
    Dataset& table = tables[what];
    if (table.name.empty())
      table = {"base/" + what, reading.unit, reading.description + ", by time and node", {}, x.size()};
    table.values.resize(n * x.size(), 0.);
    for (std::size_t t = 0; t < n; ++t)
      table.values[t * x.size() + static_cast<std::size_t>(reading.name.node)] =
          series.reading(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(t));
  }
  for (auto& table : tables) list.push_back(std::move(table.second));
  return list;
}

/// Length of the bottom that is open, by time.
std::vector<double> opened_width(const ContactHistory& contact) {
  const std::size_t n = contact.length.size();
  std::vector<double> width(contact.time.size(), 0.);
  for (std::size_t t = 0; t < width.size(); ++t)
    for (std::size_t i = 0; i < n; ++i)
      if (contact.opening[t * n + i] > 0.) width[t] += contact.length[i];
  return width;
}

/// Slip, opening and forces at the nodes of the caisson's bottom, at the times of /history/time.
std::vector<Dataset> node_tables(const std::optional<ContactSolution>& solved) {
  if (!solved || !solved->history) return {};
  const std::optional<ContactHistory>& contact = solved->history;
  const std::size_t n = contact->position.size();
  const std::string nodes = " by time and node of the caisson's bottom";
  std::vector<Dataset> list{
      {"history/interface/opened_width", "m", "length of the bottom that has parted from the ground",
       opened_width(*contact)},
      {"interface/position", "m", "x of the nodes of the caisson's bottom", contact->position},
      {"interface/length", "m", "length that each node stands for: a force over it is a stress", contact->length},
      {"interface/slip", "m", "slip, landward," + nodes, contact->slip, n},
      {"interface/opening", "m", "opening," + nodes, contact->opening, n},
      {"interface/shear_force", "N/m", "shear force on the ground, landward," + nodes, contact->shear_force, n},
      {"interface/normal_force", "N/m", "effective normal force," + nodes, contact->normal_force, n}};
  if (!contact->gap_force.empty())
    list.push_back({"history/interface/gap_force", "N/m", "uplift that the sea in gaps adds to a prescribed one",
                    contact->gap_force});
  return list;
}

/// Histories of the caisson that slips as a whole, at their own times.
std::vector<Dataset> coupled_tables(const std::optional<SlidingSummary>& sliding) {
  if (!sliding || !sliding->coupled || !sliding->coupled->history) return {};
  const std::optional<CoupledHistoryTable>& coupled = sliding->coupled->history;
  return {{"coupled/time", "s", "time", coupled->time},
          {"coupled/shear_force", "N/m", "F_T of the caisson that slips as a whole", coupled->shear_force},
          {"coupled/normal_force", "N/m", "N' that its friction acts on", coupled->normal_force},
          {"coupled/slip", "m", "its slip s over the mound, landward", coupled->slip},
          {"coupled/slip_velocity", "m/s", "s'", coupled->velocity},
          {"coupled/displacement_x", "m", "x_G, the slip included, landward", coupled->displacement}};
}

/// The factor of circles over time, and the slices of the one that governs.
std::vector<Dataset> circle_tables(const std::optional<SlipCircles>& circles) {
  if (!circles || !circles->governs) return {};
  const auto& [x, width, base, surface, weight, pressure] = circles->slices;
  Dataset factor{"circle/factor", "1",
                 "least F of the circles found at rest and in motion, each held; no number where nothing drives one",
                 circles->course.factor};
  factor.may_lack = true;
  return {{"circle/time", "s", "time", circles->course.time},
          std::move(factor),
          {"circle/x", "m", "middles of its slices", x},
          {"circle/width", "m", "their widths", width},
          {"circle/base", "m", "y of their bases", base},
          {"circle/surface", "m", "y of the surface above", surface},
          {"circle/weight", "Pa", "w + q of each slice, over its width", weight},
          {"circle/pressure", "Pa", "excess pore pressure at its base, at the moment that governs", pressure}};
}

constexpr std::size_t most_rows = 20'000;

/// What decides on the rows: stresses at nodes, which are singular at the edges of the base, do not.
std::vector<Eigen::Index> not_of_base(const System& system) {
  std::vector<Eigen::Index> list;
  for (std::size_t i = 0; i < system.readings.size(); ++i)
    if (system.readings[i].name.group != base_group) list.push_back(static_cast<Eigen::Index>(i));
  return list;
}

std::string told(const HistoryRows& rows, double tolerance) {
  if (rows.error < 0.) return "; the ends of the steps";
  const std::string error = percent(rows.error) + " of the largest value of each reading";
  if (rows.error <= tolerance) return "; straight lines between the rows err by at most " + error;
  return "; as there are no more rows than " + std::to_string(most_rows) +
         ", straight lines between them err by up to " + error;
}

/// From 0 to the end at intervals of [output] every.
std::vector<double> equal_times(const Scene& scene) {
  std::vector<double> times;
  const double end = scene.time.end;
  for (int i = 0; i * *scene.output_every <= end * (1. + 1e-8); ++i)
    times.push_back(std::min(i * *scene.output_every, end));
  return times;
}

}  // namespace

Trajectory trajectory_of(const Solution& solution) {
  return {solution.simulation->system(), solution.response, solution.model ? &*solution.model : nullptr};
}

HistoryRows find_history(const Evidence& e) {
  const Trajectory trajectory = trajectory_of(e.solution);
  const Rows rows = trajectory.rows(not_of_base(e.simulation.system()), whole_tolerance(e.simulation), most_rows);
  return {trajectory.at(rows.time), rows.error};
}

std::vector<Dataset> histories(const Simulation& simulation, const Series& series,
                               const std::optional<ContactSolution>& contact) {
  const System& system = simulation.system();
  std::vector<Dataset> list{{"time", "s", "time", series.time}};
  for (std::size_t i = 0; i < system.readings.size(); ++i) {
    const Reading& reading = system.readings[i];
    if (reading.name.group == base_group) continue;
    const auto row = series.reading.row(static_cast<Eigen::Index>(i));
    list.push_back(
        {reading.name.text(), reading.unit, reading.description, std::vector<double>(row.begin(), row.end())});
  }
  if (const std::optional<EffectiveBase> base = effective_base(simulation, series, contact))
    for (Dataset& history : base_histories(*base)) list.push_back(std::move(history));
  return list;
}

std::string times_csv(const Run& run) {
  const std::vector<double>& times = run.simulation->scene().output_times;
  const std::vector<Dataset> list = histories(*run.simulation, trajectory_of(run).at(times), run.contact);
  std::string text;
  for (const Dataset& column : list)
    text += (text.empty() ? "" : ",") + csv_cell(column.name + (column.unit == "1" ? "" : " (" + column.unit + ")"));
  for (std::size_t row = 0; row < list.front().values.size(); ++row) {
    text += "\n";
    for (const Dataset& column : list)
      text += (&column == &list.front() ? "" : ",") + significant(column.values[row], 10);
  }
  return text + "\n";
}

std::vector<Dataset> names_of_histories(const Simulation& simulation) {
  const System& system = simulation.system();
  const auto none = [](std::size_t n) { return Eigen::MatrixXd(static_cast<Eigen::Index>(n), 0); };
  return histories(simulation, {{}, none(system.readings.size()), none(system.loads.size())});
}

namespace {

/// Course of the residual pore pressure of a storm.
std::vector<Dataset> cycle_tables(const std::optional<CyclesSummary>& cycles) {
  if (!cycles) return {};
  return {{"cycles/time", "s", "time from the beginning of the storm, calm included", cycles->history_time},
          {"cycles/largest_ratio", "1", "largest residual pore pressure over the effective stress at rest then",
           cycles->history_ratio}};
}

}  // namespace

std::vector<Dataset> tables(const Run& run) {
  const Scene& scene = run.simulation->scene();
  const Trajectory trajectory = trajectory_of(run);
  std::vector<Dataset> all;
  const auto add = [&](const std::string& folder, const Series& series, const std::string& of_rows) {
    for (Dataset& history : histories(*run.simulation, series, run.contact)) {
      if (history.name == "time") history.description += of_rows;
      history.name = folder + history.name;
      all.push_back(std::move(history));
    }
  };
  add("history/", run.history.series, told(run.history, whole_tolerance(*run.simulation)));
  if (!scene.output_times.empty()) add("at_times/", trajectory.at(scene.output_times), "");
  if (scene.output_every) add("dense/", trajectory.at(equal_times(scene)), "");
  for (auto part : {base_tables(*run.simulation, run.history.series), node_tables(run.contact),
                    coupled_tables(run.summary.sliding), circle_tables(run.summary.circles),
                    cycle_tables(run.summary.cycles), section_outlines(*run.simulation->mesh())})
    for (Dataset& table : part) all.push_back(std::move(table));
  return all;
}

}  // namespace upbead

// Forces and water levels of a record become a force per metre in excess of still water, with its moment.
#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "case/cfd/flow_meaning.h"

namespace upbead {

namespace {

constexpr double small_vertical = 0.01;  ///< share of the landward force; friction on a wall is smaller

double largest(const std::vector<double>& values) {
  return values.empty() ? 0. : std::abs(values[index_of_largest(values)]);
}

void subtract(std::vector<double>& values, double number) {
  for (double& value : values) value -= number;
}

/// The force of still water must be given in one way only.
void ask_still(const FlowKeys& source, bool moments, FlowQuestions& questions) {
  if (source.still_time && source.still_force)
    questions.object("still_force", "both 'still_time' and 'still_force' are given", "keep one of them");
  if (source.still_level)
    questions.object("still_level", "'still_level' belongs to pressures, and the record holds forces",
                     "give still_time or still_force");
  questions.need(source.still_time || source.still_force, "still_time",
                 "the load is the excess over still water, which the record's force holds",
                 "add still_time = [from, to] (s), in which its water is still, or still_force = ... (N/m; 0 where the "
                 "record is the excess already)");
  if (moments && source.still_force && *source.still_force != 0.)
    questions.object("still_force", "a number takes the still water off the force, but not off its moment",
                     "give still_time = [from, to] (s) instead");
}

/// Converts N to N/m; moments are about the axis across.
FlowHistory per_metre(const FlowForces& forces, const FlowFrame& frame, double thickness) {
  FlowHistory history;
  history.time = forces.time;
  for (const Triple& force : forces.force) {
    history.landward.push_back(dot(force, frame.landward) / thickness);
    history.up.push_back(dot(force, frame.up) / thickness);
  }
  for (const Triple& moment : forces.moment) history.moment.push_back(dot(moment, frame.across) / thickness);
  if (forces.centre) history.centre = frame.in_scene(*forces.centre);
  return history;
}

void take_off_still(const FlowKeys& source, const std::vector<std::size_t>& rows, FlowLoad& load,
                    FlowHistory& history) {
  load.still_force = source.still_force.value_or(mean_of(history.landward, rows));
  subtract(history.landward, load.still_force);
  if (rows.empty()) return;
  subtract(history.up, mean_of(history.up, rows));
  if (!history.moment.empty()) subtract(history.moment, mean_of(history.moment, rows));
}

/// Drops the rows before the run's t = 0, and makes the times those of the run.
void cut_to_run(FlowHistory& history, std::size_t first, double start) {
  for (std::vector<double>* values : {&history.time, &history.landward, &history.up, &history.moment})
    if (!values->empty()) values->erase(values->begin(), values->begin() + static_cast<std::ptrdiff_t>(first));
  for (double& time : history.time) time -= start;
}

void tell_peak(FlowLoad& load, const FlowHistory& history) {
  const std::size_t t = index_of_largest(history.landward);
  load.peak_force = history.landward[t];
  load.peak_time = history.time[t];
  if (!history.moment.empty() && load.peak_force != 0.) load.peak_arm = history.moment[t] / load.peak_force;
}

/// The record's moment is of all its forces. Without a vertical force F_v its arm would be a = (M + F_v b)/F_h, and b,
/// how far behind the centre F_v acts, is in no record: da/db = F_v/F_h.
void warn_of_moment(const FlowHistory& history, double share, const FlowContext& context, FlowLoad& load) {
  const std::size_t t = index_of_largest(history.landward);
  const double metres = std::abs(history.up[t] / history.landward[t]);
  load.warnings.push_back(
      {"flow_vertical_moment", share, small_vertical, "1",
       "'" + context.path + "': the vertical force, " + percent(share) +
           " of the landward one, is left out, but not its moment, which the record does not tell apart: the arm at "
           "the peak" +
           (load.peak_arm ? ", " + significant(*load.peak_arm, 4) + " m," : "") + " is wrong by " +
           significant(metres) +
           " m for each metre that it acts behind or before the centre of the moments, and "
           "overturning and heel with it",
       "write forces of the wall's patch alone, or give region and vertical = \"apply\""});
}

/// What is done with the vertical force where it is more than friction.
void treat_vertical(const FlowContext& context, FlowQuestions& questions, FlowHistory& history, FlowLoad& load) {
  const FlowKeys& source = load.source;
  const double vertical = largest(history.up), landward = largest(history.landward);
  if (vertical > small_vertical * landward && source.up) {
    const std::string share = percent(vertical / landward) + " of the landward force is vertical at most";
    questions.need(source.vertical.has_value(), "vertical",
                   share + ": the patch may hold base, crest or rear of the caisson",
                   "add vertical = \"leave_out\", or \"apply\" on a rigid region");
    load.told.push_back(share + (source.vertical == FlowVertical::apply ? ", and is applied" : ", and is left out"));
    if (source.vertical == FlowVertical::leave_out && !history.moment.empty() && landward > 0.)
      warn_of_moment(history, vertical / landward, context, load);
  }
  if (source.vertical == FlowVertical::apply && (!context.on_region || !source.up))
    questions.object("vertical", "a vertical force is applied on a rigid region alone, and only where up is given",
                     "give region = \"caisson\" in place of the boundary, or vertical = \"leave_out\"");
  questions.answer();
  if (source.vertical != FlowVertical::apply) history.up.assign(history.time.size(), 0.);
}

}  // namespace

void understand_forces(const FlowRecord& record, const FlowContext& context, FlowLoad& load) {
  const FlowKeys& source = load.source;
  const FlowForces& forces = *record.forces;
  FlowQuestions questions(context);
  const bool moments = !forces.moment.empty();
  const FlowFrame frame = frame_of(source, moments, questions);
  if (moments && !forces.centre)
    questions.object("from", "the record has moments, but its head does not say about which point: no '# CofR'",
                     "give the file whole, or without its moments");
  questions.need(source.thickness.has_value(), "thickness",
                 "the record's newtons are of the thickness that was computed, and it does not give that",
                 "add thickness = ... (m), the cells' extent across; 1 where they are of one metre");
  if (source.quantity)
    questions.object("quantity", "'quantity' belongs to pressures, and the record holds forces", "remove it");
  ask_still(source, moments, questions);
  const std::vector<std::size_t> still = still_rows(forces.time, source, questions);
  const std::size_t first = first_row(forces.time, source, questions);
  questions.answer();
  FlowHistory history = per_metre(forces, frame, *source.thickness);
  const std::size_t at = index_of_largest(history.landward);
  take_off_still(source, still, load, history);
  cut_to_run(history, first, source.flow_start);
  tell_peak(load, history);
  const std::string over = " over a thickness of " + significant(*source.thickness, 6) + " m along " +
                           axis_name(moments || source.up ? frame.across : Triple{});
  const double newtons = dot(forces.force[at], frame.landward);
  load.told.push_back("largest force landward " + with_unit(newtons, "N") +
                      (source.up ? over : " over a thickness of " + significant(*source.thickness, 6) + " m") + ": " +
                      with_unit(newtons / *source.thickness, "N/m") + ", still water " +
                      with_unit(load.still_force, "N/m"));
  treat_vertical(context, questions, history, load);
  if (!moments) load.told.emplace_back("the record has no moments: the arm is that of the load's shape");
  load.force = std::move(history);
}

void understand_level(const FlowRecord& record, const FlowContext& context, FlowLoad& load) {
  const FlowKeys& source = load.source;
  const FlowLevel& level = *record.level;
  FlowQuestions questions(context);
  questions.need(source.quantity == FlowQuantity::hydrostatic, "quantity",
                 "the record has the level of the water, no pressure",
                 "write quantity = \"hydrostatic\" where rho g times the depth is good enough: impacts are not in it");
  questions.need(source.flow_density.has_value(), "flow_density", "the record does not say the density of its water",
                 "add flow_density = ... (kg/m3)");
  questions.need(source.origin.has_value(), "origin", "the record does not say where its datum is in the scene",
                 "add origin = [x, y] (m): y of the datum of its levels");
  for (const char* key : {"still_time", "still_force", "still_level"})
    if (questions.given(key))
      questions.object(key, std::string("'") + key + "' does not belong to a level: INPUT tells that of still water",
                       "remove it");
  const std::size_t first = first_row(level.time, source, questions);
  questions.answer();
  const double weight = *source.flow_density * context.gravity, bed = level.level[0] - level.depth[0];
  const double still = level.still - bed;
  if (!(still >= 0.)) questions.object("from", "the bed lies above still water", "give the level of a place in water");
  questions.answer();
  FlowHistory history;
  history.time = level.time;
  for (const double depth : level.depth) {
    history.landward.push_back(weight / 2. * (depth * depth - still * still));
    history.moment.push_back(weight / 6. * (depth * depth * depth - still * still * still));
    history.up.push_back(0.);
  }
  history.centre = {(*source.origin)[0], (*source.origin)[1] + bed};
  load.still_force = weight / 2. * still * still;
  cut_to_run(history, first, source.flow_start);
  tell_peak(load, history);
  load.top = (*source.origin)[1] + *std::max_element(level.level.begin(), level.level.end());
  load.told.push_back("the pressure is taken as hydrostatic below the level, from the bed at y = " +
                      significant(history.centre[1], 6) + " m up");
  load.force = std::move(history);
}

}  // namespace upbead

#include "case/cfd/flow_frame.h"

#include <algorithm>

#include "base/text.h"

namespace upbead {

namespace {

Triple unit_vector(FlowAxis axis) {
  Triple vector{};
  const auto number = static_cast<std::size_t>(axis);
  vector[number / 2] = number % 2 == 0 ? 1. : -1.;
  return vector;
}

const char* const axes_text = "\"x\", \"-x\", \"y\", \"-y\", \"z\" or \"-z\"";

}  // namespace

double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<double, 2> FlowFrame::in_scene(const Triple& at) const {
  return {dot(landward, at) + origin[0], dot(up, at) + origin[1]};
}

std::string axis_name(const Triple& axis) {
  for (std::size_t d = 0; d < 3; ++d)
    if (axis[d] != 0.) return std::string(1, "xyz"[d]);
  return "";
}

bool FlowQuestions::given(const std::string& key) const {
  return context_.document->find(context_.path.empty() ? key : context_.path + "." + key) != nullptr;
}

void FlowQuestions::ask(const std::string& key, const std::string& why, const std::string& cure) {
  object(key, why + ": '" + key + "' is missing", cure);
}

void FlowQuestions::object(const std::string& key, const std::string& what, const std::string& cure) {
  mistakes_.add(context_.document->place(context_.path.empty() ? key : context_.path + "." + key), what, cure);
}

FlowFrame frame_of(const FlowKeys& source, bool places, FlowQuestions& questions) {
  FlowFrame frame;
  questions.need(source.landward.has_value(), "landward", "the record does not say which of its axes points landward",
                 std::string("add landward = ") + axes_text);
  if (source.landward) frame.landward = unit_vector(*source.landward);
  if (places) {
    questions.need(source.up.has_value(), "up", "the record does not say which of its axes points up",
                   std::string("add up = ") + axes_text + "; OpenFOAM: usually \"z\", of plane runs \"y\"");
    questions.need(source.origin.has_value(), "origin",
                   "the record does not say where the origin of its axes is in the scene", "add origin = [x, y] (m)");
  }
  if (source.up) frame.up = unit_vector(*source.up);
  if (source.origin) frame.origin = *source.origin;
  if (source.up && source.landward && dot(frame.up, frame.landward) != 0.)
    questions.object("up", "up and landward are one axis", "give two axes that are perpendicular");
  const Triple &u = frame.up, &l = frame.landward;
  frame.across = {u[1] * l[2] - u[2] * l[1], u[2] * l[0] - u[0] * l[2], u[0] * l[1] - u[1] * l[0]};
  return frame;
}

std::vector<std::size_t> still_rows(const std::vector<double>& time, const FlowKeys& source, FlowQuestions& questions) {
  std::vector<std::size_t> rows;
  if (!source.still_time) return rows;
  const auto [from, to] = *source.still_time;
  for (std::size_t row = 0; row < time.size(); ++row)
    if (time[row] >= from && time[row] <= to) rows.push_back(row);
  if (rows.empty())
    questions.object("still_time",
                     "the record has no row from " + significant(from) + " to " + significant(to) +
                         " s; it reaches from " + significant(time.front(), 6) + " to " + significant(time.back(), 6) +
                         " s",
                     "give times of the record, [from, to]");
  return rows;
}

double mean_of(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  double sum = 0.;
  for (const std::size_t row : rows) sum += values[row];
  return rows.empty() ? 0. : sum / static_cast<double>(rows.size());
}

std::size_t first_row(const std::vector<double>& time, const FlowKeys& source, FlowQuestions& questions) {
  const auto first = std::lower_bound(time.begin(), time.end(), source.flow_start);
  if (time.end() - first < 2)
    questions.object("flow_start",
                     "the record is over before the run begins: it reaches from " + significant(time.front(), 6) +
                         " to " + significant(time.back(), 6) + " s",
                     "give an earlier flow_start");
  return static_cast<std::size_t>(first - time.begin());
}

}  // namespace upbead

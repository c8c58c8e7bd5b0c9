#include "case/cfd/flow_scene.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "case/cfd/flow_keys.h"
#include "case/cfd/flow_pieces.h"
#include "model/record.h"
#include "upbead/output/summary.h"

namespace upbead {

void give_history(const FlowHistory& history, const std::vector<double>& force, double end, Load& load) {
  if (load.factor == 0. || std::all_of(force.begin(), force.end(), [](double f) { return f == 0.; })) {
    load.history = TimeFunction();
    load.duration.reset();
    return;
  }
  load.history = scaled(piecewise_linear(history.time, force), load.factor);
  load.duration = sampled_duration(history.time, force, end);
}

FlowPieces pieces_of(const FlowHistory& history, double low, double high) {
  FlowPieces pieces;
  for (std::size_t t = 0; t < history.time.size(); ++t) {
    const double above = (history.moment[t] - history.landward[t] * (low - history.centre[1])) / (high - low);
    pieces.high.push_back(above);
    pieces.low.push_back(history.landward[t] - above);
  }
  return pieces;
}

namespace {

/// Adds the record's force to a rigid body as forces at two points: the record's centre of moments, and one above it.
void add_on_region(const std::string& name, const Load& load, const FlowLoad& flow, Scene& scene) {
  const FlowHistory& history = *flow.force;
  const double foot = history.centre[1], height = std::max(std::abs(flow.peak_arm.value_or(1.)), 1e-3);
  const FlowPieces pieces = pieces_of(history, foot, foot + height);
  const auto add = [&](const std::string& piece, double y, const std::array<double, 2>& direction,
                       const std::vector<double>& force) {
    Load one = load;
    one.at = {history.centre[0], y};
    one.direction = direction;
    one.transducer = piece;
    give_history(history, force, scene.time.end, one);
    scene.loads[name + "." + piece] = one;
  };
  add("low", foot, {1., 0.}, pieces.low);
  add("high", foot + height, {1., 0.}, pieces.high);
  if (flow.source.vertical == FlowVertical::apply) add("up", foot, {0., 1.}, history.up);
}

Record record_of_flow(const std::string& name, const FlowHistory& history) {
  return {name, history.time, history.landward};
}

}  // namespace

void add_flow_force(const std::string& name, const Load& load, const FlowLoad& flow, Scene& scene) {
  if (flow.force->moment.empty()) {
    Load& one = scene.loads[name] = load;
    one.direction = {1., 0.};
    give_history(*flow.force, flow.force->landward, scene.time.end, one);
    return;
  }
  if (!load.region.empty()) {
    add_on_region(name, load, flow, scene);
    return;
  }
  for (const char* piece : {"low", "high"}) {
    Load& one = scene.loads[name + "." + piece] = load;
    one.direction = {1., 0.};
    one.transducer = piece;
    one.history = TimeFunction();
  }
}

NumberedWarnings flow_warnings(const Case& input) {
  NumberedWarnings list;
  for (const auto& [name, flow] : input.flows) {
    append(list, flow.flow->warnings);
    if (!flow.flow->force || flow.load.factor == 0.) continue;
    append(list, record_warnings(record_of_flow("loads." + name, *flow.flow->force)));
  }
  return list;
}

std::vector<FlowSummary> flow_summaries(const Case& input) {
  std::vector<FlowSummary> list;
  for (const auto& [name, by] : input.flows) {
    const FlowLoad& flow = *by.flow;
    FlowSummary s;
    s.name = name;
    s.layout = flow.layout;
    s.files = static_cast<int>(flow.files.size());
    const std::vector<double>& time = flow.force ? flow.force->time : flow.pressure->time;
    s.samples = static_cast<int>(time.size());
    s.begin = time.front();
    s.end = time.back();
    s.thickness = flow.source.thickness;
    s.peak_force = by.load.factor * flow.peak_force;
    s.peak_force_time = flow.peak_time;
    s.arm = flow.peak_arm;
    s.still_force = flow.still_force;
    s.difference = flow.difference;
    s.told = flow.told;
    list.push_back(std::move(s));
  }
  return list;
}

std::string describe(const std::vector<FlowSummary>& flows) {
  std::string text;
  for (const FlowSummary& s : flows) {
    text += "flow        " + s.name + ": " + s.layout + "; " + std::to_string(s.samples) + " samples from " +
            significant(s.begin, 5) + " to " + significant(s.end, 5) + " s; largest " + with_unit(s.peak_force, "N/m") +
            " over still water at " + significant(s.peak_force_time, 4) + " s";
    if (s.arm) text += ", arm " + significant(*s.arm, 4) + " m";
    text += "\n";
    for (const std::string& sentence : s.told) text += "            " + sentence + "\n";
  }
  return text;
}

}  // namespace upbead

#include "case/cfd/flow_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/numbers.h"
#include "case/case_checks.h"
#include "case/case_schema.h"
#include "case/cfd/flow_keys.h"
#include "case/cfd/flow_pieces.h"
#include "case/cfd/flow_record.h"
#include "case/records/gauge_load.h"
#include "model/record.h"

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

/// A force at a point of a rigid body, or a piece of one.
Load piece_of(const Load& load, const std::string& piece, const std::array<double, 2>& direction) {
  Load one = load;
  one.direction = direction;
  one.transducer = piece;
  return one;
}

/// The record's force on a rigid body as forces at two points: the record's centre of moments, and one above it.
void add_on_region(const FlowLoad& flow, double end, FlowCase& source) {
  const FlowHistory& history = *flow.force;
  const double foot = history.centre[1], height = std::max(std::abs(flow.peak_arm.value_or(1.)), 1e-3);
  const FlowPieces pieces = pieces_of(history, foot, foot + height);
  const auto add = [&](const std::string& piece, double y, const std::array<double, 2>& direction,
                       const std::vector<double>& force) {
    Load& one = source.made[source.name + "." + piece] = piece_of(source.load, piece, direction);
    one.at = {history.centre[0], y};
    give_history(history, force, end, one);
  };
  add("low", foot, {1., 0.}, pieces.low);
  add("high", foot + height, {1., 0.}, pieces.high);
  if (flow.source.vertical == FlowVertical::apply) add("up", foot, {0., 1.}, history.up);
}

/// A force with moments on a boundary becomes two pieces, whose histories are set once the mesh is known.
void add_force(const FlowLoad& flow, double end, FlowCase& source) {
  if (flow.force->moment.empty()) {
    Load& one = source.made[source.name] = piece_of(source.load, "", {1., 0.});
    give_history(*flow.force, flow.force->landward, end, one);
  } else if (!source.load.region.empty()) {
    add_on_region(flow, end, source);
  } else {
    for (const char* piece : {"low", "high"})
      source.made[source.name + "." + piece] = piece_of(source.load, piece, {1., 0.});
  }
}

bool is_by_flow(const LoadTable& table) {
  return !table.from.empty();
}

/// Which keys are missing is only known once the record is read.
void check_flow(const LoadCheck& check) {
  const LoadTable& load = check.load;
  check.refuse({"pulse", "history", "wave", "gauges", "heights", "ends", "gauge_unit", "zero", "record_start",
                "sampling_rate", "load_cell", "direction", "at"},
               "a record of CFD", "from");
  if (load.kind != LoadKind::force && load.kind != LoadKind::pressures)
    check.wrong.add("kind", "a record of CFD is a force or pressures", "write kind = \"force\" or \"pressures\"");
  if (load.kind == LoadKind::pressures && check.wrong.given("shape"))
    check.wrong.add("shape", "'shape' does not belong to pressures at points", "remove shape");
  if (load.to_first == Beyond::to_zero || load.to_last == Beyond::to_zero)
    check.wrong.add(load.to_first == Beyond::to_zero ? "to_base" : "to_crest",
                    "'to_zero' is not known of a record of CFD", "write \"constant\" or \"none\"");
}

/// The record, understood as the keys say.
FlowLoad understood(const GivenLoad& given) {
  const LoadTable& table = given.table;
  const Document& document = given.problem.document;
  FlowContext context{given.path, &document, given.problem.scene.gravity};
  context.on_region = !table.region.empty();
  context.beyond = {table.to_first, table.to_last};
  context.beyond_given = {document.find(given.path + ".to_base") != nullptr,
                          document.find(given.path + ".to_crest") != nullptr};
  context.base = std::filesystem::path(document.path()).parent_path().string();
  const FlowRecord record = read_flow(given.problem.resolve(table.from), table.file, given.place("from"));
  const bool points = record.points.has_value(), says_points = table.kind == LoadKind::pressures;
  if (points != says_points)
    throw InputError(given.place("kind"),
                     std::string("the record holds ") + (points ? "pressures" : "forces") + ": " + record.layout,
                     std::string("write kind = ") + (points ? "\"pressures\"" : "\"force\""));
  FlowLoad flow = understand(record, table, context);
  if (flow.force && !flow.force->moment.empty() && !table.shape.empty())
    throw InputError(given.place("shape"), "the record's moments tell where its force acts", "remove shape");
  return flow;
}

std::shared_ptr<LoadSource> read_flow_load(const GivenLoad& given) {
  const auto source = std::make_shared<FlowCase>();
  begin(given, *source);
  FlowLoad& flow = source->flow = understood(given);
  for (const std::string& file : flow.files) source->files.push_back({file, given.place("from")});
  source->warnings = flow.warnings;
  if (flow.pressure) {
    source->gauges = flow.pressure;
    source->made = gauge_loads(given.name, source->load, *flow.pressure, given.end());
    if (source->acts())
      source->action = action_of(source->title, "record_start", flow.pressure->time, flow.pressure->pressure);
    return source;
  }
  add_force(flow, given.end(), *source);
  if (!source->acts()) return source;
  const FlowHistory& force = *flow.force;
  append(source->warnings, record_warnings({source->title, force.time, force.landward, given.end()}));
  source->action = action_of(source->title, "flow_start", force.time, {force.landward, force.up});
  return source;
}

}  // namespace

LoadWay by_flow() {
  return {is_by_flow,
          [](TableSchema<LoadTable>& table) { add_flow_keys<LoadTable>(table, is_by_flow); },
          check_flow,
          read_flow_load,
          {&LoadTable::from, &LoadTable::against}};
}

std::vector<FlowSummary> flow_summaries(const Case& input) {
  std::vector<FlowSummary> list;
  for (const FlowCase* source : sources_of_type<FlowCase>(input)) {
    const FlowLoad& flow = source->flow;
    FlowSummary s;
    s.name = source->name;
    s.layout = flow.layout;
    s.files = static_cast<int>(flow.files.size());
    const std::vector<double>& time = flow.force ? flow.force->time : flow.pressure->time;
    s.samples = static_cast<int>(time.size());
    s.begin = time.front();
    s.end = time.back();
    s.thickness = flow.source.thickness;
    s.peak_force = source->load.factor * flow.peak_force;
    s.peak_force_time = flow.peak_time;
    s.arm = flow.peak_arm;
    s.still_force = flow.still_force;
    s.difference = flow.difference;
    s.told = flow.told;
    list.push_back(std::move(s));
  }
  return list;
}

OutputSchema<FlowSummary> flow_outputs() {
  using F = FlowSummary;
  return OutputSchema<F>()
      .key("layout", &F::layout, "", "what was read")
      .key("files", &F::files, "", "how many")
      .key("samples", &F::samples, "", "how many")
      .key("begin", &F::begin, "s", "of the record, in the run's time")
      .key("end", &F::end, "s", "of the record, in the run's time")
      .key("thickness", &F::thickness, "m",
           "length of breakwater that its forces belong to; null where it holds pressures")
      .key("peak_force", &F::peak_force, "N/m",
           "largest force over still water, landward; of pressures their sum along the line of points")
      .key("peak_force_time", &F::peak_force_time, "s", "when")
      .key("arm", &F::arm, "m",
           "height of the largest force above the centre of moments, or above the lowest end of the points; null "
           "without either")
      .key("still_force", &F::still_force, "N/m", "force of still water, which was subtracted")
      .key("difference", &F::difference, "",
           "largest difference of the sum of the pressures and the forces of `against`, over the largest force; null "
           "without `against`")
      .key("told", &F::told, "", "how the files were understood, in sentences");
}

}  // namespace upbead

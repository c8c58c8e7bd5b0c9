#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "case/cfd/flow_keys.h"
#include "case/cfd/flow_record.h"
#include "cli/command.h"
#include "output/result_file.h"

namespace upbead {

namespace {

using Json = nlohmann::ordered_json;

/// The keys of a load `from`, given as options and not in a case.
struct ReadKeys : FlowKeys {
  double gravity = 9.81;
  Beyond to_first = Beyond::constant, to_last = Beyond::constant;
};

struct ReadOptions {
  std::string path, out;
  bool json = false;
  std::vector<std::string> keys;
};

TableSchema<ReadKeys> read_schema() {
  static const std::vector<std::pair<std::string, Beyond>> words{{"constant", Beyond::constant},
                                                                 {"none", Beyond::none}};
  TableSchema<ReadKeys> table;
  table.key("from", &ReadKeys::from, "", "folder or file");
  add_flow_keys<ReadKeys>(table, [](const ReadKeys&) { return true; });
  table.key("gravity", &ReadKeys::gravity, "m/s2", "acceleration of gravity", above(0.));
  table.choice("to_base", &ReadKeys::to_first, words, "pressure beyond the first point");
  table.choice("to_crest", &ReadKeys::to_last, words, "pressure beyond the last point");
  return table;
}

/// The record as the keys turn it into a load: per metre, in excess of still water, in the scene's axes.
std::vector<FlowColumn> columns_of(const FlowLoad& load) {
  if (load.pressure) {
    std::vector<FlowColumn> columns{{"time", "s", load.pressure->time}};
    for (std::size_t i = 0; i < load.pressure->count(); ++i)
      columns.push_back({load.pressure->name[i], "Pa", load.pressure->pressure[i]});
    return columns;
  }
  std::vector<FlowColumn> columns{{"time", "s", load.force->time}, {"force", "N/m", load.force->landward}};
  if (!load.force->moment.empty()) columns.push_back({"moment", "N m/m", load.force->moment});
  if (load.source.vertical == FlowVertical::apply) columns.push_back({"force_up", "N/m", load.force->up});
  return columns;
}

Json optional_number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const FlowLoad& load) {
  Json json{{"peak_force", load.peak_force},
            {"peak_force_time", load.peak_time},
            {"arm", optional_number(load.peak_arm)},
            {"still_force", load.still_force},
            {"difference", optional_number(load.difference)},
            {"told", load.told}};
  if (load.force && !load.force->moment.empty()) json["centre"] = load.force->centre;
  if (load.pressure) {
    json["along"] = load.pressure->over_x ? "x" : "y";
    json["place"] = load.pressure->place;
  }
  return json;
}

Json json_of(const FlowRecord& record) {
  Json json{{"path", record.path},          {"layout", record.layout},        {"files", record.files},
            {"rows", record.time().size()}, {"begin", record.time().front()}, {"end", record.time().back()},
            {"notes", record.notes}};
  if (record.forces && record.forces->centre) json["centre"] = *record.forces->centre;
  if (record.points) json["points"] = {{"field", record.points->field}, {"at", record.points->at}};
  if (record.level) json["still_level"] = record.level->still;
  return json;
}

/// Writes a record in the form that the program itself reads: /time and one dataset for each column, with units; or
/// CSV.
void write_columns(const std::string& path, const std::vector<FlowColumn>& columns) {
  std::string text;
  if (std::filesystem::path(path).extension() == ".h5") {
    std::vector<Dataset> datasets;
    for (const FlowColumn& column : columns)
      datasets.push_back({column.name, column.unit, "", column.value, 1, "", true});
    text = dataset_file("record of a CFD program", datasets);
  } else {
    for (std::size_t c = 0; c < columns.size(); ++c)
      text += (c == 0 ? "" : ",") + columns[c].name + (columns[c].unit.empty() ? "" : " (" + columns[c].unit + ")");
    for (std::size_t row = 0; row < columns[0].value.size(); ++row) {
      text += "\n";
      for (std::size_t c = 0; c < columns.size(); ++c) text += (c == 0 ? "" : ",") + number_text(columns[c].value[row]);
    }
    text += "\n";
  }
  write_whole(path, text);
}

int read(const ReadOptions& options) {
  const Document document(options.keys);
  ReadKeys keys;
  Diagnostics report;
  read_schema().read(document.root(), "", keys, report);
  report.throw_if_any();
  const FlowRecord record = read_flow(options.path, keys.file, {});
  std::vector<FlowColumn> columns = columns_of(record);
  Json json = json_of(record);
  std::string text = text_of(record);
  const bool only_file = options.keys.size() == 1 && !keys.file.empty();
  if (!options.keys.empty() && !only_file) {
    FlowContext context{"", &document, keys.gravity};
    context.on_region = keys.vertical == FlowVertical::apply;
    context.beyond = {keys.to_first, keys.to_last};
    context.beyond_given = {document.find("to_base") != nullptr, document.find("to_crest") != nullptr};
    const FlowLoad load = understand(record, keys, context);
    columns = columns_of(load);
    json["load"] = json_of(load);
    text += text_of("as a load", load);
  }
  if (!options.out.empty()) {
    std::vector<InputFile> inputs;
    for (const std::string& file : record.files) inputs.push_back({file, {}});
    const std::filesystem::path out(options.out);
    require_inputs_kept(out.parent_path().empty() ? "." : out.parent_path().string(), {out.filename().string()},
                        inputs);
    write_columns(options.out, columns);
    text += "written     " + options.out + "\n";
  }
  std::cout << (options.json ? json.dump(2) + "\n" : text);
  return 0;
}

const char* const read_footer =
    R"(Prints what a file or folder of OpenFOAM (forces, probes, raw patches), DualSPHysics, Proteus or SWASH holds, in its
own axes and units. With keys of a load `from` (docs/cfd.md), what it is as a load: per metre, over still water, landward.
What the record does not say is asked for.

Examples:
  upbead read postProcessing/wallForce
  upbead read postProcessing/wallProbes --set file=p --out probes.csv
  upbead read postProcessing/wallForce --set landward=x --set up=z --set 'origin=[0, 0]' \
      --set thickness=0.1 --set 'still_time=[0, 0.3]' --out force.h5)";

}  // namespace

Command read_command() {
  const auto options = std::make_shared<ReadOptions>();
  Command command{"read", "print what the output of a CFD program holds, and write it as a table"};
  command.options = {{"PATH", &options->path, "the folder or the file", "", true},
                     {"--json", &options->json, "print what was understood as JSON on stdout and nothing else"},
                     {"--out", &options->out, "write the columns, as CSV or HDF5 (.h5)", "FILE"},
                     {"--set", &options->keys, "a key of a load `from`; may be given many times", "KEY=VALUE"}};
  command.footer = read_footer;
  command.work = [options] { return read(*options); };
  return command;
}

}  // namespace upbead

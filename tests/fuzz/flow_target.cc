// Data read from the output of a CFD program have ascending times and finite numbers, and so have the loads made of
// them.
#include <cmath>
#include <filesystem>

#include "case/cfd/flow_keys.h"
#include "case/cfd/flow_record.h"
#include "target.h"

namespace upbead::fuzz {

namespace {

void check_record(const FlowRecord& record) {
  const std::vector<double>& time = record.time();
  require(!time.empty(), "a record has a row");
  for (std::size_t i = 0; i < time.size(); ++i) {
    require(std::isfinite(time[i]), "times are finite");
    require(i == 0 || time[i] > time[i - 1], "times ascend");
  }
  for (const FlowColumn& column : columns_of(record)) {
    require(column.value.size() == time.size(), "columns are as long as the times");
    for (const double value : column.value)
      require(std::isfinite(value) || (record.points && std::isnan(value)), "numbers are finite, or cells blank");
  }
}

void check_load(const FlowLoad& load) {
  require(std::isfinite(load.peak_force), "the largest force is finite");
  if (load.force)
    for (const double force : load.force->landward) require(std::isfinite(force), "forces are finite");
  if (load.pressure)
    for (const auto& pressure : load.pressure->pressure)
      for (const double p : pressure) require(std::isfinite(p), "pressures are finite");
}

void check(const std::string& path, const std::string& file) {
  FlowRecord record;
  if (!read_or_refuse([&] { check_record(record = read_flow(path, file, {"case.toml", 1, 1})); })) return;
  FlowKeys source;
  source.landward = FlowAxis::plus_x;
  source.up = FlowAxis::plus_z;
  source.origin = {0., 0.};
  source.blank_is_zero = true;
  source.flow_start = record.time().front();
  source.still_time = {record.time().front(), record.time().front()};
  if (record.forces) {
    source.thickness = 0.1;
    source.vertical = FlowVertical::leave_out;
  } else {
    source.quantity = record.level ? FlowQuantity::hydrostatic : FlowQuantity::pressure;
    source.flow_density = 1000.;
    if (record.level) source.still_time.reset();
  }
  const Document document;
  FlowContext context{"", &document};
  context.beyond_given = {true, true};
  read_or_refuse([&] { check_load(understand(record, source, context)); });
}

/// A folder with that file in the folders of two times.
std::string at_two_times(const std::string& name, std::string_view bytes) {
  namespace fs = std::filesystem;
  const fs::path first(memory_file(name, bytes)), folder = first.parent_path() / fs::path(name).stem();
  for (const char* time : {"0.1", "0.2"}) {
    fs::create_directories(folder / time);
    fs::copy_file(first, folder / time / name, fs::copy_options::overwrite_existing);
  }
  return folder.string();
}

}  // namespace

void try_flow(std::string_view bytes) {
  const char which = bytes.empty() ? 'c' : bytes.front();
  if (!bytes.empty()) bytes.remove_prefix(1);
  switch (which) {
    case 'f':
      check(memory_file("forces.dat", bytes), "");
      break;
    case 'e':
      check(memory_file("force.dat", bytes), "");
      break;
    case 'p':
      check(memory_file("p", bytes), "");
      break;
    case 'r':
      check(at_two_times("p_wall.raw", bytes), "");
      break;
    case 'x':
      check(at_two_times("front.xy", bytes), "");
      break;
    case 'd':
      check(memory_file("height.dat", bytes), "");
      break;
    case 's':
      memory_file("INPUT", bytes.substr(0, bytes.size() / 2));
      check(memory_file("wall.tbl", bytes.substr(bytes.size() / 2)), "");
      break;
    default:
      check(memory_file("table.csv", bytes), "");
  }
}

}  // namespace upbead::fuzz

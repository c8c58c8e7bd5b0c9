#include "case/cfd/flow_keys.h"
#include "case/records/load_records.h"
#include "case_schema.h"
#include "model/words.h"

namespace upbead {

namespace {

bool has_rise(const Pulse& pulse) {
  return pulse.shape == PulseShape::triangle || pulse.shape == PulseShape::church_roof ||
         pulse.shape == PulseShape::step;
}

bool has_direction(const LoadTable& load) {
  return load.from.empty() && (load.kind == LoadKind::force || load.kind == LoadKind::traction ||
                               load.kind == LoadKind::body_force || is_motion(load.kind));
}

bool is_by_flow(const LoadTable& load) {
  return !load.from.empty();
}

bool is_by_wave(const LoadTable& load) {
  return load.kind == LoadKind::wave;
}

bool is_by_train(const LoadTable& load) {
  return load.kind == LoadKind::train;
}

bool is_along_points(const LoadTable& load) {
  return load.kind == LoadKind::pressures;
}

bool is_by_gauges(const LoadTable& load) {
  return is_along_points(load) && load.from.empty();
}

bool is_at_a_point(const LoadTable& load) {
  return !load.region.empty() && load.from.empty() && !is_on_volume(load.kind);
}

bool is_on_boundary(const LoadTable& load) {
  return !is_on_volume(load.kind) && (load.region.empty() || !load.boundary.empty());
}

TableSchema<Pulse> pulse_schema() {
  TableSchema<Pulse> table;
  table.choice("shape", &Pulse::shape, pulse_shape_words).required().doc("shape of the history");
  table.key("peak", &Pulse::peak)
      .unit("N/m or Pa")
      .required()
      .doc("largest value, in the unit of the load's kind; of a harmonic its amplitude");
  table.key("rise", &Pulse::rise)
      .unit("s")
      .range(at_least(0.))
      .fallback("half the duration; of a step 0")
      .doc("time from start to peak")
      .when("shape", has_rise, "in a triangle, a church_roof and a step");
  table.key("duration", &Pulse::duration)
      .unit("s")
      .range(above(0.))
      .doc("duration; of a church_roof that of its impulsive part; of triangle, half_sine and church_roof");
  table.key("start", &Pulse::start).unit("s").range(at_least(0.)).doc("time of the start; zero before");
  table.key("plateau", &Pulse::plateau)
      .range(between(0., 1.))
      .doc("value of the slow part over the peak; of a church_roof");
  table.key("plateau_duration", &Pulse::plateau_duration)
      .unit("s")
      .range(above(0.))
      .doc("time from start until the slow part has gone; of a church_roof");
  table.key("frequency", &Pulse::frequency).unit("Hz").range(above(0.)).doc("frequency; of a harmonic");
  return table;
}

void add_place_keys(TableSchema<LoadTable>& table) {
  table.key("boundary", &LoadTable::boundary).doc("name of the curve that the load acts on; or region");
  table.key("region", &LoadTable::region)
      .doc("name of the rigid region that a force acts on, or of any region for a load on its volume; or boundary");
  table.key("from", &LoadTable::from)
      .doc(
          "folder or file that a CFD program wrote (OpenFOAM, DualSPHysics, Proteus, SWASH: docs/cfd.md); or pulse, or "
          "history");
}

void add_vector_keys(TableSchema<LoadTable>& table) {
  table.key("at", &LoadTable::at)
      .unit("m")
      .required()
      .doc("point of attack (x, y)")
      .when("region", is_at_a_point, "for a force on a region");
  table.key("direction", &LoadTable::direction)
      .doc("direction (x, y); multiplies the history and is not normalised")
      .when("kind", has_direction, "for forces, tractions, motions and body forces");
}

}  // namespace

TableSchema<LoadTable> load_schema() {
  TableSchema<LoadTable> table;
  add_place_keys(table);
  table.choice("kind", &LoadTable::kind, load_kind_words)
      .doc(
          "what the history means; force: resultant (N/m); traction: Pa; pressure: Pa, total normal stress = -value, "
          "and pore pressure = value where the boundary is open; normal: Pa, pressing on the skeleton alone; "
          "pressures: "
          "by transducers (gauges), Pa; wave: of Goda's formulas, by [.wave] and [section]; train: of regular waves "
          "along the curve, by [.train], Pa; displacement (m), velocity (m/s), acceleration (m/s2): how a fixed or "
          "roller boundary moves, or, where it is absorbing, how the rock's outcrop would, of which half arrives from "
          "below; on the volume of a region: body_force (N/m3), source (1/s: volume of water that enters the pores, "
          "over "
          "volume and time), gravity (m/s2, downward on skeleton and water together, history its acceleration, with "
          "neither boundary nor region everywhere: pressures and stresses are then those with weight)");
  add_vector_keys(table);
  table.key("shape", &LoadTable::shape)
      .unit_of_first("m")
      .fallback("uniform")
      .doc("pairs of height y (m) and relative intensity; linear in between, zero beyond the ends")
      .when("region", is_on_boundary, "on a boundary");
  table.key("over_x", &LoadTable::over_x)
      .doc("true: the pairs of shape, and the heights of transducers, are places x, not heights y, as along a bed")
      .when("region", is_on_boundary, "on a boundary");
  table.key("along_curve", &LoadTable::along_curve)
      .doc("true: the pairs of shape are lengths along the curve (m), from its seaward end, not heights")
      .when("region", is_on_boundary, "on a boundary");
  table.table("pulse", &LoadTable::pulse, pulse_schema()).doc("An idealised history; or history.");
  table.key("history", &LoadTable::history_file)
      .doc("path of a CSV file with a header line, then time (s) and value; linear in between; or pulse");
  table.table("wave", &LoadTable::wave, wave_load_schema())
      .doc(
          "A wave, with exactly one of height and deep_water_height; its pressure over the height of the wall is "
          "Goda's.")
      .when("kind", is_by_wave, "where kind = \"wave\"");
  table.table("train", &LoadTable::train, wave_train_schema())
      .doc("Regular waves along the curve, such as a seabed; the pressure acts as that of kind = \"pressure\".")
      .when("kind", is_by_train, "where kind = \"train\"");
  add_gauge_keys<LoadTable>(table, wall_words, is_by_gauges, "where kind = \"pressures\"", is_along_points);
  add_flow_keys<LoadTable>(table, is_by_flow);
  table.key("measured_on_wall", &LoadTable::measured_on_wall)
      .doc("true: measured on the moving wall, so the modelled water does not push back on this boundary")
      .when("region", is_on_boundary, "on a boundary");
  table.key("factor", &LoadTable::factor).doc("multiplies the history; 0 switches the load off");
  return table;
}

}  // namespace upbead

#include "case/load_source.h"
#include "case_schema.h"
#include "model/words.h"

namespace upbead {

namespace {

bool is_at_a_point(const LoadTable& load) {
  return !load.region.empty() && load.from.empty() && !is_on_volume(load.kind);
}

bool is_on_boundary(const LoadTable& load) {
  return !is_on_volume(load.kind) && (load.region.empty() || !load.boundary.empty());
}

void add_place_keys(TableSchema<LoadTable>& table) {
  table.key("boundary", &LoadTable::boundary, "", "name of the curve that the load acts on; or region");
  table.key("region", &LoadTable::region, "",
            "name of the rigid region that a force acts on, or of any region for a load on its volume; or boundary");
  table.key("from", &LoadTable::from, "",
            "folder or file that a CFD program wrote (OpenFOAM, DualSPHysics, Proteus, SWASH: docs/cfd.md); or pulse, "
            "or history");
}

void add_vector_keys(TableSchema<LoadTable>& table) {
  table.key("at", &LoadTable::at, "m", "point of attack (x, y)")
      .required()
      .when("region", is_at_a_point, "for a force on a region");
  table.key("direction", &LoadTable::direction, "", "direction (x, y); multiplies the history and is not normalised")
      .when("kind", has_own_direction, "for forces, tractions, motions and body forces");
}

}  // namespace

TableSchema<LoadTable> load_schema() {
  TableSchema<LoadTable> table;
  add_place_keys(table);
  table.choice(
      "kind", &LoadTable::kind, load_kind_words,
      "what the history means; force: resultant (N/m); traction: Pa; pressure: Pa, total normal stress = -value, and "
      "pore pressure = value where the boundary is open; normal: Pa, pressing on the skeleton alone; pressures: by "
      "transducers (gauges), Pa; wave: of Goda's formulas, by [.wave] and [section]; train: of regular waves along the "
      "curve, by [.train], Pa; displacement (m), velocity (m/s), acceleration (m/s2): how a fixed or roller boundary "
      "moves, or, where it is absorbing, how the rock's outcrop would, of which half arrives from below; on the volume "
      "of a region: body_force (N/m3), source (1/s: volume of water that enters the pores, over volume and time), "
      "gravity (m/s2, downward on skeleton and water together, history its acceleration, with neither boundary nor "
      "region everywhere: pressures and stresses are then those with weight)");
  add_vector_keys(table);
  table
      .key("shape", &LoadTable::shape, "",
           "pairs of height y (m) and relative intensity; linear in between, zero beyond the ends")
      .unit_of_first("m")
      .fallback("uniform")
      .when("region", is_on_boundary, "on a boundary");
  table
      .key("over_x", &LoadTable::over_x, "",
           "true: the pairs of shape, and the heights of transducers, are places x, not heights y, as along a bed")
      .when("region", is_on_boundary, "on a boundary");
  table
      .key("along_curve", &LoadTable::along_curve, "",
           "true: the pairs of shape are lengths along the curve (m), from its seaward end, not heights")
      .when("region", is_on_boundary, "on a boundary");
  for (const LoadWay& way : load_ways()) way.declare(table);
  table
      .key("measured_on_wall", &LoadTable::measured_on_wall, "",
           "true: measured on the moving wall, so the modelled water does not push back on this boundary")
      .when("region", is_on_boundary, "on a boundary");
  table.key("factor", &LoadTable::factor, "", "multiplies the history; 0 switches the load off");
  return table;
}

}  // namespace upbead

#include <algorithm>

#include "case/case_schema.h"
#include "design/design_tables.h"
#include "input/report_table.h"

namespace upbead {

namespace {

/// Keys of a table of a case that a design does not read.
template <class T, class U>
std::vector<std::string> left_to(const TableSchema<T>& of_case, const TableSchema<U>& of_design) {
  std::vector<std::string> left;
  const std::vector<std::string> own = of_design.names();
  for (const std::string& name : of_case.names())
    if (std::find(own.begin(), own.end(), name) == own.end()) left.push_back(name);
  return left;
}

TableSchema<Water> sea_water_schema() {
  TableSchema<Water> table;
  table.key("density", &Water::density, "kg/m3", "density of the sea water", from_to(1., 1e4));
  table.elsewhere(left_to(fluid_schema(), table));
  return table;
}

TableSchema<ElasticBase> ground_schema() {
  TableSchema<ElasticBase> table;
  table
      .key("stiffness", &ElasticBase::stiffness, "N/m2", "horizontal stiffness of the ground under the caisson",
           from_to(1., 1e15))
      .required();
  table.key("mass", &ElasticBase::mass, "kg/m", "mass of the ground that sways with the bottom", from_to(0., 1e12));
  table.key("damping", &ElasticBase::damping, "N s/m2", "damping of the ground; needs a mass", from_to(0., 1e15));
  return table;
}

void declare_measured(TableSchema<WaveTable>& table) {
  table
      .key("force", &WaveTable::force, "N/m", "peak of the wave force P; measured or computed, for sliding",
           from_to(1., 1e12))
      .fallback("by Goda's formula with alpha_I, an effective sliding force");
  table
      .key("shear_to_force_ratio", &WaveTable::shear_to_force_ratio, "",
           "peak of F_T over the peak of P; only with force, as alpha_I already holds it", from_to(0.001, 10.))
      .fallback("1 with force");
  table.key("uplift", &WaveTable::uplift, "N/m", "uplift U when F_T is largest; only with force", from_to(0., 1e12))
      .fallback("by Goda's formula");
  table.key("pulse_duration", &WaveTable::pulse_duration, "s",
            "duration of that P as a symmetric triangle, to which [ground] answers; only with force and [ground]",
            from_to(1e-4, 1e3));
}

TableSchema<WaveTable> wave_schema() {
  TableSchema<WaveTable> table;
  declare_wave(table);
  declare_measured(table);
  return table;
}

}  // namespace

TableSchema<DesignTables> design_schema() {
  TableSchema<DesignTables> table;
  table.key("title", &DesignTables::title, "", "title of the design");
  table.key("gravity", &DesignTables::gravity, "m/s2", "acceleration of gravity", from_to(0.1, 100.));
  table.key("levels", &DesignTables::levels, "m",
            "water levels by name, above that of the section; for `waves`, which checks every wave at each and names "
            "the one that governs",
            from_to(-1e4, 1e4));
  table.table("fluid", &DesignTables::water, sea_water_schema()).doc("Sea water.");
  table.table("section", &DesignTables::section, section_schema())
      .required()
      .doc("The breakwater's cross-section, per metre of its length.");
  table.table("duration", &DesignTables::duration, duration_schema())
      .doc("How long the shear force lasts: tau_0 = k(alpha*) tau_0F, eqs. (8)-(11).");
  table.table("combined", &DesignTables::combined, combined_schema())
      .doc("What the sources at hand do not settle of the model of Shimosako and Takahashi (1998).");
  table.table("ground", &DesignTables::ground, ground_schema())
      .doc("The ground's sway, lumped, for waves with a pulse_duration: F_T and S of a caisson that swings and slips.");
  table.tables("waves", &DesignTables::waves, wave_schema())
      .doc("Any number of waves by name, each with exactly one of height and deep_water_height.");
  add_expected_tables(table);
  table.table("calibration", &DesignTables::calibration, calibration_schema())
      .doc("For `calibrate`: waves and mounds, every value with every other, and reduced models.");
  table.table("reliability", &DesignTables::reliability, reliability_schema())
      .doc("For `reliability`: probabilities of failure in one wave, whose numbers are random.");
  table.table("report", &DesignTables::report, report_table()).doc(report_table_doc);
  table.elsewhere(left_to(case_schema(), table));
  return table;
}

}  // namespace upbead

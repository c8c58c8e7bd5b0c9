#include "case/records/gauge_load.h"
#include "case_schema.h"
#include "model/words.h"

namespace upbead {

namespace {

bool is_prescribed(const UpliftTable& uplift) {
  return uplift.kind == UpliftKind::prescribed;
}

/// An uplift of kind "wave" is prescribed, too.
bool has_course(const UpliftTable& uplift) {
  return uplift.kind != UpliftKind::computed;
}

TableSchema<UpliftTable> uplift_schema() {
  TableSchema<UpliftTable> table;
  table
      .choice("kind", &UpliftTable::kind, uplift_kind_words,
              "where the uplift comes from; prescribed: peak, history or gauges; computed: the pore pressure on the "
              "bottom; wave: U = p_u B/2 of the load by a wave")
      .required();
  table.key("peak", &UpliftTable::peak, "N/m", "largest uplift U; or history", at_least(0.))
      .when("kind", is_prescribed, "where the uplift is prescribed");
  table
      .choice("shape", &UpliftTable::course, uplift_course_words,
              "course of U in time; held: proportional to P up to the largest P, then at its peak, the safe side where "
              "F_T comes after P; in_phase: proportional to P while that is landward")
      .when("kind", has_course, "where the uplift is prescribed");
  table
      .choice("distribution", &UpliftTable::distribution, uplift_distribution_words,
              "pressure over the base of a peak or history; triangle: largest at the seaward edge, zero at the heel; "
              "uniform: the same everywhere")
      .when("kind", is_prescribed, "where the uplift is prescribed");
  table.key("lag", &UpliftTable::lag, "s", "time by which U comes after P", at_least(0.))
      .when("kind", has_course, "where the uplift is prescribed");
  table
      .key("history", &UpliftTable::history_file, "",
           "path of a CSV file with a header line, then time (s) and U (N/m); or peak, or gauges")
      .when("kind", is_prescribed, "where the uplift is prescribed");
  add_column_key(table);
  add_gauge_keys<UpliftTable>(table, bottom_words, is_prescribed, "where the uplift is prescribed", is_prescribed);
  return table;
}

TableSchema<SlidingWave> wave_schema() {
  TableSchema<SlidingWave> table;
  table.key("height", &SlidingWave::height, "m", "wave height H", above(0.)).required();
  table.key("depth", &SlidingWave::depth, "m", "water depth h at the wall", above(0.)).required();
  table.key("period", &SlidingWave::period, "s", "wave period T", above(0.)).required();
  table
      .key("alpha_star", &SlidingWave::alpha_star, "",
           "pressure coefficient alpha* = max(alpha_I, alpha_2), as upbead waves gives it", from_to(0., 2.))
      .required();
  return table;
}

}  // namespace

TableSchema<SlidingTable> sliding_schema() {
  TableSchema<SlidingTable> table;
  table.key("friction", &SlidingTable::own_friction, "", "friction coefficient mu of the bottom", above(0.))
      .fallback("that of the contact or of [section], else 0.6");
  table
      .key("submerged_weight", &SlidingTable::own_submerged_weight, "N/m", "weight W' of the caisson in still water",
           above(0.))
      .formerly("buoyant_weight")
      .fallback("that of [section]; required without");
  table
      .key("weight", &SlidingTable::weight, "N/m", "weight W of the caisson in air, with its fill; to check the mass",
           above(0.))
      .fallback("mass x g of the caisson");
  table.key("drag", &SlidingTable::drag, "N s/m2", "drag force F_D over the sliding velocity; the paper neglects it",
            at_least(0.));
  table.table("uplift", &SlidingTable::uplift_table, uplift_schema())
      .doc("What the wave takes off the weight; nothing without this table.");
  table.table("wave", &SlidingTable::wave, wave_schema())
      .doc(
          "The wave, for tau_0 of eqs. (8)-(11) and the paper's S_CAL, eq. (7); that of the load by a wave, where "
          "there is one.");
  return table;
}

}  // namespace upbead

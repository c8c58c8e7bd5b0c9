#include "design_tables.h"

namespace upbead {

namespace {

const std::vector<std::pair<std::string, ExtremeKind>> extreme_words{{"weibull", ExtremeKind::weibull},
                                                                     {"gumbel", ExtremeKind::gumbel}};
const std::vector<std::pair<std::string, TideKind>> tide_words{{"sinusoidal", TideKind::sinusoidal},
                                                               {"uniform", TideKind::uniform}};

void declare_heights(TableSchema<StormsTable>& table) {
  table.choice("distribution", &StormsTable::kind, extreme_words)
      .doc("distribution of H_0', the equivalent deep-water significant height of a storm");
  table.key("location", &StormsTable::location).unit("m").range(from_to(0., 100.)).required().doc("location of H_0'");
  table.key("scale", &StormsTable::scale).unit("m").range(from_to(1e-6, 100.)).required().doc("scale of H_0'");
  table.key("shape", &StormsTable::shape)
      .range(from_to(0.2, 100.))
      .doc("shape of H_0'")
      .when(
          "distribution", [](const StormsTable& s) { return s.kind == ExtremeKind::weibull; }, "in weibull");
}

void declare_storms(TableSchema<StormsTable>& table) {
  table.key("per_year", &StormsTable::per_year).range(from_to(1e-6, 1e4)).doc("mean number of storms in a year");
  table.key("poisson", &StormsTable::poisson).doc("true: their number is random, after Poisson");
  table.key("duration", &StormsTable::duration).unit("s").range(from_to(1., 1e7)).doc("duration of a storm");
  table.key("period", &StormsTable::period)
      .unit("s")
      .range(from_to(0.01, 1e4))
      .doc("significant wave period T of all storms; or steepness");
  table.key("steepness", &StormsTable::steepness)
      .range(from_to(1e-4, 0.2))
      .doc("steepness H_0'/L_0, from which T follows; or period");
  table.key("angle", &StormsTable::angle)
      .unit("deg")
      .range(from_to_below(0., 90.))
      .doc("angle beta between the waves and the wall's normal; already turned by 15 deg towards it");
}

}  // namespace

TableSchema<StormsTable> storms_schema() {
  TableSchema<StormsTable> table;
  declare_heights(table);
  declare_storms(table);
  table.key("tide_low", &StormsTable::tide_low)
      .unit("m")
      .range(from_to(-100., 100.))
      .doc("low water above still water");
  table.key("tide_high", &StormsTable::tide_high)
      .unit("m")
      .range(from_to(-100., 100.))
      .doc("high water above still water");
  table.choice("tide", &StormsTable::tide, tide_words)
      .doc("level that a storm meets; sinusoidal: any phase of a sine between the two; uniform: any level");
  table.key("highest", &StormsTable::highest)
      .range(from_to(0.01, 10.))
      .fallback("no cut")
      .doc("largest height of a wave over H_1/3; higher ones are set aside");
  return table;
}

}  // namespace upbead

// Checks across the keys of a design, and of the files that it names, for `expected`.
#pragma once

#include "design.h"
#include "upbead/expected/life.h"

namespace upbead {

void check_expected(const DesignTables& tables, const Document& document, Diagnostics& report);

/// Goda's P with alpha_I is refused as a force for a reduced model.
void check_impact(const DesignTables& tables, const Document& document, Diagnostics& report);

/// Reads the reduced model of the table at the dotted path; it must be that of the section's caisson.
void check_model(const std::string& path, const DynamicsTable& table, const Section& section, const Water& water,
                 const Document& document, Diagnostics& report);

/// A scatter by its name, and the mean where it gives none.
struct NamedScatter {
  const char* name;
  std::optional<Scatter> ScatterTables::*table;
  std::optional<Distribution> Uncertainties::*distribution;
  double mean;
};
const std::vector<NamedScatter>& named_scatters();

/// Sound tables as distributions.
Uncertainties uncertainties(const ScatterTables& tables);

}  // namespace upbead

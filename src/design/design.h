// A design: the file that a person wrote, read and checked.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"
#include "design_tables.h"
#include "upbead/base/numbered_warning.h"
#include "upbead/case/case.h"
#include "upbead/expected/life.h"
#include "upbead/input/document.h"
#include "upbead/waves/goda.h"

namespace upbead {

struct Design {
  DesignTables tables;
  Document document;             ///< the file as written, for places
  std::string stem;              ///< name of the file without folder and ending
  NumberedWarnings implausible;  ///< numbers whose unit was probably mistaken

  /// A path of the design (relative to its file) as seen from the working folder.
  std::string resolve(const std::string& path) const;
};

/// Reports what is wrong across the keys of a design.
using DesignCheck = void (*)(const DesignTables& tables, const Document& document, Diagnostics& report);

/// Reads a design with overrides KEY=VALUE; checks the section, the waves, and what `further` checks. Throws InputError
/// with every mistake.
Design read_design(const std::string& path, const std::vector<std::string>& overrides,
                   const std::vector<DesignCheck>& further = {});

/// The design as TOML with every default written out, and with paths relative to `output_folder`, where it can be run
/// unchanged.
std::string effective_design(const Design& design, const std::string& output_folder,
                             const std::vector<std::string>& without = {});

/// One file that is a case and a design, both given as TOML like that; the design's `without` what a case has.
std::string effective_file(const Case& problem, const Design& design, const std::string& output_folder);

/// Every key of the design file as Markdown.
std::string design_reference();

/// The same keys as JSON Schema (draft 4), with which editors complete and check a design file.
std::string design_json_schema();

/// The design itself and the files that it names, each with the key that names it.
std::vector<InputFile> input_files(const Design& design);

/// Checks what `expected` needs: the tables, the record of sea states, the reduced model.
void check_expected(const DesignTables& tables, const Document& document, Diagnostics& report);

/// Refuses P of Goda's formula with alpha_I as a force on a reduced model.
void check_impact(const DesignTables& tables, const Document& document, Diagnostics& report);

/// Reads the reduced model of the table at the dotted path, and checks that its caisson is the section's.
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

/// Warnings implausible of what is random: a mean far from a factor of 1, or from the design's number; a deviation
/// above the mean; a cut that takes away more than half; a rise of still water out of the section; a sea without high
/// waves.
NumberedWarnings implausible_distributions(const DesignTables& tables);

/// Tables without mistakes as distributions.
Uncertainties uncertainties(const ScatterTables& tables);

/// Checks what `calibrate` needs: the tables, and the models that they name.
void check_calibration(const DesignTables& tables, const Document& document, Diagnostics& report);

}  // namespace upbead

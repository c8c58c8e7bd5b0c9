// A design: the file that a person wrote, read and checked.
#pragma once

#include <string>
#include <vector>

#include "design_tables.h"
#include "upbead/input/document.h"
#include "upbead/waves/goda.h"

namespace upbead {

struct Design {
  DesignTables tables;
  Document document;  ///< what was written, for places
  std::string stem;   ///< the file's name without folder and ending

  /// A path of the design (relative to its file) as seen from the working folder.
  std::string resolve(const std::string& path) const;
};

/// Reports what is wrong across the keys of a design.
using DesignCheck = void (*)(const DesignTables& tables, const Document& document, Diagnostics& report);

/// Reads a design with overrides KEY=VALUE; checks the section, the waves, and what `further` checks. Throws InputError
/// with every mistake.
Design read_design(const std::string& path, const std::vector<std::string>& overrides,
                   const std::vector<DesignCheck>& further = {});

/// The design as TOML with every default spelled out, and with paths as seen from `output_folder`: it runs as it is
/// there.
std::string effective_design(const Design& design, const std::string& output_folder);

/// The wave of a sound table, with heights by random breaking where only that of deep water is given.
DesignWave design_wave(const WaveTable& wave, const Section& section, const Water& water);

/// The design as TOML with every default spelled out, and with paths as seen from `output_folder`. Throws InputError
/// with every mistake in the section and its waves.
std::string effective_design(const std::string& path, const std::vector<std::string>& overrides = {},
                             const std::string& output_folder = ".");

/// Every key of the design file as Markdown.
std::string design_reference();

}  // namespace upbead

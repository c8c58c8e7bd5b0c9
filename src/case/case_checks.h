// Checks across the keys of a case.
#pragma once

#include "case_schema.h"
#include "upbead/input/document.h"

namespace upbead {

/// Reports what is wrong with a table. Where some of its keys were refused already, only missing keys are reported.
class TableDiagnostics {
 public:
  TableDiagnostics(std::string path, const Document& document, Diagnostics& report);
  bool given(const std::string& key) const { return document_.find(path_ + "." + key) != nullptr; }
  void add(const std::string& key, const std::string& what, const std::string& cure) const;
  /// Adds what is wrong with the part of a scene that this table, or the table `below` it, has filled.
  void add(const Diagnostics& part, const std::string& below = "") const;

 private:
  std::string path_;
  const Document& document_;
  Diagnostics& report_;
  bool sound_;
};

/// A table [loads.NAME] whose mistakes are looked for, and what has been read beside it.
struct LoadCheck {
  const std::string& path;
  const LoadTable& load;
  const CaseTables& tables;
  const Document& document;
  Diagnostics& report;
  TableDiagnostics wrong;

  void exactly_one(const std::string& a, const std::string& b) const;
  /// Reports each of the keys that is given: it does not belong to `what`.
  void refuse(const std::vector<std::string>& keys, const std::string& what, const std::string& or_else) const;
};

void check_mesh(const CaseTables& tables, const Document& document, Diagnostics& report);
void check_regions(const CaseTables& tables, const Document& document, Diagnostics& report);
void check_loads(const CaseTables& tables, const Document& document, Diagnostics& report);
void check_time(const CaseTables& tables, const Document& document, Diagnostics& report);
void check_section(const CaseTables& tables, const Document& document, Diagnostics& report);
void check_sliding(const CaseTables& tables, const Document& document, Diagnostics& report);
void check_cycles(const CaseTables& tables, const Document& document, Diagnostics& report);
/// Times in [output].
void check_output(const CaseTables& tables, const Document& document, Diagnostics& report);
void check_probes(const CaseTables& tables, const Document& document, Diagnostics& report);

}  // namespace upbead

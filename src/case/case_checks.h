// Checks across the keys of a case.
#pragma once

#include "case_schema.h"
#include "upbead/input/document.h"

namespace upbead {

/// Reports what is wrong with a table. Where some of its keys were refused already, only what is missing is news.
class Objections {
 public:
  Objections(std::string path, const Document& document, InputReport& report);
  void add(const Objection& objection) const;

 private:
  std::string path_;
  const Document& document_;
  InputReport& report_;
  bool sound_;
};

void check_mesh(const CaseTables& tables, const Document& document, InputReport& report);
void check_regions(const CaseTables& tables, const Document& document, InputReport& report);
void check_loads(const CaseTables& tables, const Document& document, InputReport& report);
void check_time(const CaseTables& tables, const Document& document, InputReport& report);
void check_sliding(const CaseTables& tables, const Document& document, InputReport& report);
void check_probes(const CaseTables& tables, const Document& document, InputReport& report);

}  // namespace upbead

// Checks across the keys of a case.
#pragma once

#include "case_schema.h"
#include "upbead/input/document.h"

namespace upbead {

/// Reports what is wrong with a table. Where some of its keys were refused already, only what is missing is news.
class Objections {
 public:
  Objections(std::string path, const Document& document, Reading& reading);
  void add(const Objection& objection) const;

 private:
  std::string path_;
  const Document& document_;
  Reading& reading_;
  bool sound_;
};

void check_mesh(const CaseTables& tables, const Document& document, Reading& reading);
void check_regions(const CaseTables& tables, const Document& document, Reading& reading);
void check_loads(const CaseTables& tables, const Document& document, Reading& reading);
void check_time(const CaseTables& tables, const Document& document, Reading& reading);
void check_probes(const CaseTables& tables, const Document& document, Reading& reading);

}  // namespace upbead

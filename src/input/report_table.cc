#include "input/report_table.h"

namespace upbead {

const char* const report_table_doc = "What the author says in the [report](report.md); it changes no number.";

TableSchema<ReportHead> report_table() {
  TableSchema<ReportHead> table;
  table.key("project", &ReportHead::project, "", "project");
  table.key("client", &ReportHead::client, "", "client");
  table.key("author", &ReportHead::author, "", "author, who answers for the numbers");
  table.key("revision", &ReportHead::revision, "", "revision, such as \"B, 2026-05-04\"");
  table.key("question", &ReportHead::question, "", "what the client asked, a sentence");
  table.key("text", &ReportHead::text, "", "the author's own words, in Markdown; \"\"\" \"\"\" for several lines");
  table.key("logo", &ReportHead::logo, "", "path of a picture for the head: PNG, JPEG or SVG");
  const std::vector<std::pair<std::string, ReportLanguage>> languages{{"en", ReportLanguage::english},
                                                                      {"ja", ReportLanguage::japanese}};
  table.choice("language", &ReportHead::language, languages, "language of the report; ja: Japanese");
  return table;
}

}  // namespace upbead

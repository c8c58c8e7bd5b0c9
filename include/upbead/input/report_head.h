// What the author of a case, a study or a design says in its report: the table [report] of every such file.
#pragma once

#include <optional>
#include <string>

namespace upbead {

enum class ReportLanguage { english, japanese };

/// "" where it is not told. The program reads none of it; the report does.
struct ReportHead {
  std::string project, client, author, revision;
  std::string question, text;              ///< what was asked, and what the author has to say, in Markdown
  std::string logo;                        ///< a picture, relative to the file
  std::optional<ReportLanguage> language;  ///< none: English
};

}  // namespace upbead

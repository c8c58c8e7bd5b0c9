// The table [report] of a case, a study or a design: what its author writes in the report.
#pragma once

#include <optional>
#include <string>

namespace upbead {

enum class ReportLanguage { english, japanese };

/// "" where it is not given. Only the report uses it; no computation does.
struct ReportHead {
  std::string project, client, author, revision;
  std::string question, text;              ///< what was asked, and what the author has to say, in Markdown
  std::string logo;                        ///< a picture, relative to the file
  std::optional<ReportLanguage> language;  ///< none: English
};

}  // namespace upbead

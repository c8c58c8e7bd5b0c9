#include "cli/warning_lines.h"

namespace upbead {

std::string describe(const NumberedWarnings& warnings) {
  std::string text;
  for (const NumberedWarning& warning : warnings) text += "warning: " + warning.name + ": " + warning.text + "\n";
  return text;
}

}  // namespace upbead

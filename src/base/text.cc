#include "base/text.h"

#include <cctype>
#include <cmath>
#include <sstream>

namespace upbead {

std::string significant(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

double without_round_off(double value, double peak) {
  return std::abs(value) < 1e-9 * std::abs(peak) ? 0. : value;
}

std::string with_unit(double value, const std::string& unit, double peak) {
  value = without_round_off(value, peak);
  const double size = std::abs(value);
  if (size >= 1e6) return significant(value / 1e6, 4) + " M" + unit;
  if (size >= 1e3) return significant(value / 1e3, 4) + " k" + unit;
  if (unit == "m" && size > 0. && size < 0.1) return significant(value * 1e3, 4) + " m" + unit;
  return significant(value, 4) + " " + unit;
}

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

}  // namespace upbead

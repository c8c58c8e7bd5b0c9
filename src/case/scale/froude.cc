#include <cctype>
#include <map>
#include <sstream>
#include <stdexcept>

#include "case/scale.h"

namespace upbead {

namespace {

/// With lengths times L, and accelerations and densities times 1: s = L^(1/2), kg = L^3, N = kg m/s2, Pa = N/m2.
const std::map<std::string, double> exponents{{"m", 1.},    {"s", 0.5},  {"kg", 3.},      {"N", 3.}, {"Pa", 1.},
                                              {"Hz", -0.5}, {"rad", 0.}, {"degrees", 0.}, {"1", 0.}};

/// "m2" has twice the exponent of "m".
double exponent_of(const std::string& symbol, const std::string& unit) {
  std::size_t letters = symbol.size();
  while (letters > 1 && std::isdigit(static_cast<unsigned char>(symbol[letters - 1])) != 0) --letters;
  const auto found = exponents.find(symbol.substr(0, letters));
  if (found == exponents.end()) throw std::invalid_argument("no scale is known for the unit '" + unit + "'");
  return found->second * (letters < symbol.size() ? std::stoi(symbol.substr(letters)) : 1);
}

}  // namespace

double froude_exponent(const std::string& unit) {
  if (unit.empty() || unit == "-") return 0.;
  double sum = 0., sign = 1.;
  std::string spaced;
  for (const char c : unit) spaced += c == '/' ? std::string(" / ") : std::string(1, c);
  std::istringstream symbols(spaced);
  for (std::string symbol; symbols >> symbol;) {
    if (symbol == "/")
      sign = -1.;
    else
      sum += sign * exponent_of(symbol, unit);
  }
  return sum;
}

}  // namespace upbead

#include "upbead/base/text.h"

#include <sstream>

namespace upbead {

std::string significant(double value, int digits) {
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

}  // namespace upbead

#include "response/slip_law.h"

#include "base/numbers.h"
#include "fem/reading_names.h"

namespace upbead {

SlipLaw slip_law(const ReducedSystem& system, double friction, UpliftKind uplift,
                 const std::vector<std::string>& outputs) {
  SlipLaw law{friction, {{index_of(system.reading_label, reading::normal_force), 1.}}, {}};
  if (uplift == UpliftKind::computed)
    law.normal_force.emplace_back(index_of(system.reading_label, reading::uplift), -1.);
  for (const std::string& name : outputs) law.readings.push_back(index_of(system.reading_label, name));
  return law;
}

}  // namespace upbead

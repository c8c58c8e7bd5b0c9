#include "response/slip_law.h"

#include "fem/reading_names.h"

namespace upbead {

SlipLaw slip_law(const ReducedSystem& system, double friction, SlipUplift uplift,
                 const std::vector<std::string>& wanted) {
  SlipLaw law{friction, {{index_of(system.reading_label, reading::normal_force), 1.}}, {}};
  if (uplift == SlipUplift::computed)
    law.normal_force.emplace_back(index_of(system.reading_label, reading::uplift), -1.);
  for (const std::string& name : wanted) law.readings.push_back(index_of(system.reading_label, name));
  return law;
}

}  // namespace upbead

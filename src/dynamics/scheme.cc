#include "upbead/dynamics/scheme.h"

#include "generalised_alpha.h"
#include "sdirk4.h"

namespace upbead {

std::unique_ptr<Scheme> make_scheme(const System& system, const SchemeOptions& options) {
  if (options.kind == SchemeKind::sdirk4) return std::make_unique<detail::Sdirk4>(system, options);
  return std::make_unique<detail::GeneralisedAlpha>(system, options);
}

}  // namespace upbead

// Roots of functions of one variable.
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <utility>

namespace upbead {

/// The last bracket of a root of f, whose signs at `from` and `to` differ: to `bits` bits, by 100 evaluations at
/// most.
template <class Function>
std::pair<double, double> root_bracket(const Function& f, double from, double to, int bits) {
  boost::uintmax_t most = 100;
  return boost::math::tools::toms748_solve(f, from, to, boost::math::tools::eps_tolerance<double>(bits), most);
}

}  // namespace upbead

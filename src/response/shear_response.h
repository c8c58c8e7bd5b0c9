// The results of a march for a coastal engineer: peaks of the wave force and of F_T, found inside the steps.
#pragma once

#include <optional>

#include "fem/compile.h"
#include "upbead/base/error.h"
#include "upbead/base/history.h"
#include "upbead/dynamics/march.h"
#include "upbead/response/findings.h"

namespace upbead {

/// The forces at the caisson's bottom over time, from which sliding is computed: changes from still water. The first
/// two are straight between times that also lie inside steps, with two equal times where a force jumps; the last two
/// have only the ends of the steps.
struct BaseHistory {
  History shear_force;   ///< F_T, landward (N/m)
  History force;         ///< P, landward (N/m)
  History normal_force;  ///< change of the total normal force, compression positive (N/m)
  History uplift;        ///< integral of the excess pore pressure over the bottom (N/m)
};

/// Needs a scene with a caisson. F_T inside the steps is that of read_shear_response; without inertia only the ends
/// of the steps are used.
BaseHistory read_base_history(const CompiledScene& compiled, const Response& response, bool inertia);

/// The horizontal load P(t) on the caisson, all loads together.
TimeFunction force_on_caisson(const CompiledScene& compiled);

/// Needs a scene with a caisson. Between the ends of a step F_T = P + P_water - m x_G'', with x_G by the quintic
/// Hermite polynomial through x_G, x_G' and x_G'' = (P + P_water - F_T)/m at both ends (schemes of order 4), or with
/// x_G'' linear between them (of order 2); without inertia the ends of the steps alone.
ShearResponse read_shear_response(const CompiledScene& compiled, const Response& response, bool inertia);

/// Largest difference of both routes to F_T, relative to the largest |F_T|, or, where F_T vanishes by symmetry or
/// between loads, to a millionth of the largest of |P| at any time, the change of the normal force, the uplift, and the
/// moment over the bottom's width. Needs a scene with a caisson.
double reaction_mismatch(const CompiledScene& compiled, const Response& response);

/// Two numbers that must be equal differ.
struct Mismatch {
  std::string what;
  double value = 0.;      ///< relative
  double tolerable = 0.;  ///< what round-off explains in most scenes
  double error = 0.;      ///< error that may follow, relative to the largest values
  bool bearable = false;  ///< whether the result is still useful if its error is reported
};

class Imbalance : public NumericsError {
 public:
  explicit Imbalance(Mismatch mismatch);
  const Mismatch& mismatch() const { return mismatch_; }

 private:
  Mismatch mismatch_;
};

/// Throws Imbalance where both routes to F_T differ by more than 1e-7 (see reaction_mismatch), or the work and the sum
/// of all energies by more than 1e-6; NumericsError where more energy is stored than 1.1 times the largest work.
void require_balance(double routes, const EnergyAccount& energy, double tolerable_routes = 1e-7);

/// The same for the energy of a scene without a caisson, marched until `end` (s). Loads whose work is only round-off,
/// as of a pressure on incompressible water, have nothing to balance: that is work below 1e-10 of what they would do
/// on K alone. A mismatch below that is bearable: motions larger than its root are no round-off.
void require_balance(const EnergyAccount& energy, const System& system, double end);

}  // namespace upbead

// A time scheme: advances the state of a System step by step.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "upbead/dynamics/energy.h"
#include "upbead/system/system.h"

namespace upbead {

struct ContactReport;
struct YieldingReport;

/// A state, and the load values f_k that belong to it.
struct LoadedState {
  State state;
  std::vector<double> load;
};

/// What a scheme carries from step to step, without the state and what it can compute again.
struct SchemeMemory {
  LoadedState balanced;
  std::vector<double> end_load;
  /// Of generalised-alpha: |f_k| so far. Of soil that yields: its internal state after the last step, and the start
  /// values of its solves. Else empty.
  std::vector<double> history;
  double last_step = 0.;  ///< of generalised-alpha (s); 0 before the first
  EnergyAccount energy;
};

/// Advances M x'' + C x' + K x = sum_k b_k f_k(t) by single steps. A load is evaluated by the smooth piece that holds
/// the middle of the step, so steps should end at the kinks of the loads. Keeps factorised matrices of the latest step
/// sizes. The System must outlive the scheme. One thread at a time.
class Scheme {
 public:
  virtual ~Scheme() = default;

  /// As in the case file: "sdirk4", "generalised_alpha"; "contact", "yielding", "yielding, contact".
  virtual std::string name() const = 0;
  /// Order of convergence of x and x' in the step.
  virtual int order() const = 0;
  virtual int solves_per_step() const = 0;

  /// Begins a history: empties the account of energy (what `state` stores counts as work done).
  virtual void start(const State& state) = 0;
  /// Advances `state` from state.time to state.time + h (s). Throws NumericsError where the effective matrix is
  /// singular or the system is not well posed.
  virtual void advance(State& state, double h) = 0;

  /// Takes one step of h (s) instead of several shorter ones, where these are needed only for an event (such as a slip)
  /// that does not happen in it. Returns false and changes nothing where the event would happen. `state` is as in
  /// advance(), which can continue from it.
  virtual bool leap(State& /*state*/, double /*h*/) { return false; }

  /// Load values at the end of the last step, by that step's smooth piece; zero after start().
  virtual const std::vector<double>& end_load() const = 0;
  /// The values of the last step at which M a + C v + K x = sum_k b_k f_k holds to round-off: the end of the step for
  /// SDIRK; x, v, load at alpha_f and a at alpha_m for generalised-alpha. A reading that relies on the equation of
  /// motion (a reaction) must be taken there.
  virtual const LoadedState& balanced() const = 0;
  /// Account of energy since start(); all zero where it is switched off.
  virtual const EnergyAccount& energy() const = 0;
  virtual bool accounts_energy() const = 0;
  /// What an internal force adds to each reading at the end of the last step; null: nothing.
  virtual const Vector* added_to_readings() const { return nullptr; }
  /// What the next step needs beside the state. A scheme that recalls it continues as the one that gave it, to the last
  /// bit. Throws std::invalid_argument where the scheme follows contact.
  virtual SchemeMemory memory() const = 0;
  virtual void recall(const SchemeMemory& memory) = 0;
  /// What a contact law did since start(); null where the scheme has no contact law and keeps interfaces bonded.
  virtual const ContactReport* contact() const { return nullptr; }
  /// What it cost to solve soil that yields since start(); null where nothing may yield.
  virtual const YieldingReport* yielding() const { return nullptr; }

  /// Linear solves and factorisations since the scheme was made.
  virtual int n_solves() const = 0;
  virtual int n_factorisations() const = 0;
  /// Wall time of the factorisations (s).
  virtual double factorise_seconds() const = 0;
};

enum class SchemeKind {
  sdirk4,             ///< L-stable SDIRK of order 4, 5 stages (Hairer & Wanner, Solving ODEs II, table IV.6.5)
  generalised_alpha,  ///< Chung & Hulbert (1993), second order
};

struct SchemeOptions {
  SchemeKind kind = SchemeKind::sdirk4;
  double rho_inf = 0.9;        ///< generalised-alpha: spectral radius at infinite frequency, in [0, 1]
  bool account_energy = true;  ///< takes products, no solves: 20 % more time with SDIRK, 50 % with alpha
  /// Refine each solution by its residual, for scenes in which forces cancel: then every row has a small residual
  /// (Skeel, Math. Comp. 35 (1980) 817). It costs a second solve. Not for a divided system.
  bool refined = false;
};

/// The scheme of that kind for a system. Throws std::invalid_argument where rho_inf lies outside [0, 1].
std::unique_ptr<Scheme> make_scheme(const System& system, const SchemeOptions& options = {});

}  // namespace upbead

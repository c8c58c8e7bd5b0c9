// The table [sliding]: what holds the caisson on its mound, and what relieves its weight.
#pragma once

#include <optional>

#include "upbead/base/time_function.h"

namespace upbead {

enum class UpliftKind {
  prescribed,  ///< given by the user, from a measurement or a formula
  computed,    ///< the scene's own excess pore pressure on the bottom
};

/// How a prescribed uplift without a history of its own runs in time.
enum class UpliftCourse {
  in_phase,  ///< proportional to P(t) while that is landward
  held,      ///< so up to the largest P, and from then on at its peak: on the safe side where F_T comes after P
};

struct UpliftChoice {
  UpliftKind kind = UpliftKind::prescribed;
  std::optional<double> peak;  ///< prescribed, without a history (N/m)
  UpliftCourse course = UpliftCourse::in_phase;
  double lag = 0.;       ///< by which U comes after P (s)
  TimeFunction history;  ///< prescribed, without a peak: U(t) (N/m)
};

/// The wave that tau_0 of Shimosako and Takahashi (1994), eqs. (8)-(11), is asked of.
struct SlidingWave {
  double height = 0.;      ///< H (m)
  double depth = 0.;       ///< h (m)
  double period = 0.;      ///< T (s)
  double alpha_star = 0.;  ///< max(alpha_I, alpha_2)
};

struct SlidingChoice {
  double friction = 0.6;         ///< mu
  double buoyant_weight = 0.;    ///< W', in still water (N/m)
  std::optional<double> weight;  ///< W, in air with fill (N/m); none: mass x g of the caisson
  double drag = 0.;              ///< F_D over velocity, eq. (2) (N s/m2)
  std::optional<UpliftChoice> uplift;
  std::optional<SlidingWave> wave;
};

}  // namespace upbead

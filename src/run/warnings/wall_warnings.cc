#include "base/text.h"
#include "response/far_echo.h"
#include "scene_warnings.h"

namespace upbead {

namespace {

/// Times of the echo until it is felt, by widths of the caisson: what comes from far is spread. docs/warnings.md.
double delay(double widths) {
  return widths > 5. ? 1.2 : 1.;
}

std::string cure(const FarEcho& echo, double end, double peak_in_echo) {
  const std::string from = significant(echo.time()) + " s on";
  const std::string hit = peak_in_echo > 0. ? ", its peak at " + significant(peak_in_echo) + " s with it" : "";
  return ": from " + from + " F_T(t) holds its echo" + hit + "; move it to " + significant(0.5 * echo.speed * end) +
         " m" + (echo.absorbing ? " (saturated ground absorbs little)" : ", or end the run before");
}

}  // namespace

NumberedWarnings wall_warnings(const Simulation& simulation, const std::optional<double>& peak_time) {
  const double end = simulation.scene.time.end;
  const std::optional<double> time = passing_time(simulation);
  if (!time || !simulation.compiled->caisson) return {};
  const std::optional<FarEcho> echo = first_echo(simulation.scene, *simulation.space);
  if (!echo || echo->time() * delay(echo->distance / simulation.compiled->caisson->bottom_width) >= end) return {};
  const bool is_fast = shortest_duration(simulation.scene) < echo->time();
  if (!is_fast && echo->distance >= simulation.compiled->caisson->bottom_width) return {};
  const double peak_in_echo = peak_time && *peak_time > echo->time() ? *peak_time : 0.;
  return {{"walls_too_near", echo->time(), end, "s",
           "the side '" + echo->side + "' is " + significant(echo->distance) + " m away, shear waves of " +
               significant(echo->speed) + " m/s are back after " + significant(echo->time()) +
               " s, before the end at " + significant(end) + " s" + cure(*echo, end, peak_in_echo)}};
}

}  // namespace upbead

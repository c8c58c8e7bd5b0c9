#include <algorithm>
#include <map>

#include "base/text.h"
#include "response/drained_skin.h"
#include "response/step_choice.h"
#include "scene_warnings.h"

namespace upbead {

namespace {

/// A pulse builds up the pressure beside the face as a jump within this share of its duration would.
constexpr double share_of_pulse = 1. / 6.;
/// Beside the face so many cells are wrong: the first one, and a little of the next.
constexpr double reach = 1.2;

double distance(const dealii::Point<dim>& point, const DrainedFace& face) {
  const auto along = face.last - face.first;
  const double share = std::clamp(((point - face.first) * along) / along.norm_square(), 0., 1.);
  return point.distance(face.first + share * along);
}

/// Whether a point lies on the soil's side.
bool is_inside(const dealii::Point<dim>& point, const DrainedFace& face) {
  return (point - face.first) * (face.inside - face.first) >= 0.;
}

/// Name of a probe in the soil, within reach of the face; "fields" where there are fields; else "".
std::string onlooker(const Scene& scene, const DrainedFace& face) {
  if (scene.fields_every) return "fields";
  for (const auto& [name, probe] : scene.probes)
    if (is_inside({probe.at[0], probe.at[1]}, face) && distance({probe.at[0], probe.at[1]}, face) < reach * face.cell)
      return "probe '" + name + "'";
  return "";
}

/// Within which the loads change (s): a share of their duration, or the step at a jump.
double build_up(const Scene& scene) {
  const double duration = shortest_duration(scene);
  const double jump = duration > 0. ? 0. : step_of_loads(scene, 4).largest_step;
  return std::max(share_of_pulse * duration, scene.time.step.value_or(jump));
}

}  // namespace

NumberedWarnings skin_warnings(const Simulation& simulation) {
  const Scene& scene = simulation.scene;
  if (scene.probes.empty() && !scene.fields_every) return {};
  const int degree = simulation.space->degree() - 1;
  const double time = build_up(scene);
  if (!(time > 0.) || time > scene.time.end) return {};
  std::map<std::string, NumberedWarning> worst;  // by soil
  for (const DrainedFace& face : drained_faces(scene, *simulation.mesh)) {
    const double limit = smallest_time(face, degree);
    if (time >= limit) continue;
    const std::string who = onlooker(scene, face);
    if (who.empty() || (worst.count(face.region) && limit <= worst[face.region].limit)) continue;
    const std::string formula = degree == 1 ? "h^2/(6 c_v)" : "h^2/(40 c_v)";
    worst[face.region] = {
        "smallest_step", time, limit, "s",
        who + ": where '" + face.region + "' drains into '" + face.into + "' its pressure builds up within " +
            significant(time) + " s, less than " + formula + " = " + significant(limit) + " s of its cells of " +
            significant(face.cell, 2) + " m: it overshoots by up to " +
            significant(100. * overshoot(face, degree, time), 2) +
            " % from cell to cell there; take cells half as high there, or mesh.degree = 3; F_T does not feel it"};
  }
  NumberedWarnings list;
  for (const auto& [soil, warning] : worst) list.push_back(warning);
  return list;
}

}  // namespace upbead

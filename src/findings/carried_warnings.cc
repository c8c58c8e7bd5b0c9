#include "findings/carried_warnings.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "model/plane_waves.h"
#include "response/carried_pulse.h"
#include "response/ground_waves.h"
#include "response/time_choice.h"

namespace upbead {

namespace {

constexpr double largest_error = 0.05;
/// Stresses inside a cell have larger errors than at its nodes; measured on columns: docs/warnings.md.
constexpr double inside_cells = 1.3;

/// A wave of a load on its way to a probe or to fields.
struct Carried {
  std::string name;
  WaveLaw law;
  double duration = 0.;  ///< s
  WaveCells cells;
  double least = 0., most = 0.;  ///< m
  bool may_raise = false;        ///< whether u of degree 2 may be raised to 3
  double error() const { return inside_cells * carried_error(law, duration, cells, least, most); }
};

/// The region's constants; G is the mean over its cells.
Material mean_material(const Simulation& simulation, const std::string& region) {
  Material m;
  double sum = 0., area = 0.;
  for (const auto& cell : simulation.mesh()->triangulation.active_cell_iterators()) {
    if (simulation.mesh()->surface_of(cell) != region) continue;
    m = simulation.space()->material(cell);
    sum += m.G * area_of(cell);
    area += area_of(cell);
  }
  static_cast<ElasticLaw&>(m) = m.with_shear_modulus(sum / area);
  return m;
}

double duration_of(const Load& load) {
  Scene alone;
  alone.loads["load"] = load;
  return shortest_duration(alone);
}

/// The steps of the march; none where a reduced model is used.
WaveSteps steps_of(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const TimeScheme scheme = choose_scheme(scene, *simulation.compiled()).scheme;
  if (scheme == TimeScheme::reduced) return {};
  const int order = scheme == TimeScheme::generalised_alpha ? 2 : 4;
  return {scene.time.step.value_or(step_of_loads(scene, order).largest_step), order};
}

Carried carried(const Simulation& simulation, const LoadedGround& ground, const std::string& name, const WaveLaw& law,
                int degree) {
  Carried wave{name, law, duration_of(simulation.scene().loads.at(ground.load)), {ground.cell, degree, {}}};
  wave.cells.steps = steps_of(simulation);
  wave.may_raise = simulation.space()->degree() == 2;
  wave.least = std::max(ground.nearest, ground.cell);
  const double way = ground.is_plane ? carried_speed(law, wave.duration, wave.cells) * simulation.scene().time.end : 0.;
  wave.most = std::max({wave.least, ground.farthest, way});
  return wave;
}

/// The largest value, from `high` down to a 64th of it, with error(value) <= `most`, found to a tenth; 0 where there
/// is none.
double largest_value(double high, const std::function<double(double)>& error, double most) {
  double low = high / 64.;
  if (!(error(low) <= most)) return 0.;
  if (error(high) <= most) return high;
  while (high / low > 1.1) {
    const double middle = std::sqrt(low * high);
    (error(middle) <= most ? low : high) = middle;
  }
  return low;
}

/// Cures for the user, each by itself, and the step to be used with any of them.
class Cure {
 public:
  explicit Cure(const Carried& wave) : wave_(wave), step_(wave.cells.steps.size) {
    Carried timeless = wave;
    timeless.cells.steps.size = 0.;
    if (timeless.error() <= share * largest_error) {
      take(timeless, "");
      return;
    }
    if (const double size = finer(timeless); size > 0.)
      take(with_size(timeless, size), "cells of at most " + significant(size, 2) + " m along the wave's way");
    if (Carried raised = timeless;
        wave.may_raise && ++raised.cells.degree > 0 && raised.error() <= share * largest_error)
      take(raised, "mesh.degree = 3");
    if (const double duration = slower(timeless); duration > 0.)
      take(with_duration(timeless, duration),
           "a rise of the load of at least " + significant(0.5 * duration, 2) + " s");
  }

  std::string text() const {
    std::string text;
    for (const std::string& way : ways_) text += (text.empty() ? "" : ", or ") + way;
    const bool shorter = step_ < wave_.cells.steps.size;
    if (shorter)
      text += (text.empty() ? "" : ", and ") + std::string("time.step of at most ") + significant(step_, 2) + " s";
    return text.empty() ? "give the soil damping, or the load a rise" : "give " + text;
  }

 private:
  static constexpr double share = 0.7;  ///< of the allowed error for the cells; steps have the rest

  static Carried with_size(Carried wave, double size) {
    wave.cells.size = size;
    return wave;
  }
  static Carried with_duration(Carried wave, double duration) {
    wave.duration = duration;
    return wave;
  }
  static double finer(const Carried& wave) {
    return largest_value(
        wave.cells.size, [&](double size) { return with_size(wave, size).error(); }, share * largest_error);
  }
  /// The shortest duration from 2 to 128 crossings of a cell.
  static double slower(const Carried& wave) {
    const double longest = 128. * wave.cells.size / carried_speed(wave.law, 0., wave.cells);
    const auto error = [&](double inverse) { return with_duration(wave, 1. / inverse).error(); };
    const double inverse = largest_value(64. / longest, error, share * largest_error);
    return inverse > 0. ? 1. / inverse : 0.;
  }

  void take(Carried wave, const std::string& way) {
    if (!way.empty()) ways_.push_back(way);
    if (wave_.cells.steps.size == 0.) return;
    wave.cells.steps = wave_.cells.steps;
    const auto error = [&](double step) {
      wave.cells.steps.size = step;
      return wave.error();
    };
    if (const double step = largest_value(wave_.cells.steps.size, error, largest_error); step > 0.)
      step_ = std::min(step_, step);
  }

  Carried wave_;
  double step_;
  std::vector<std::string> ways_;
};

std::string load_text(const LoadedGround& ground, double duration) {
  return "load '" + ground.load + "' " +
         (duration > 0. ? "rises within " + significant(0.5 * duration) + " s" : "jumps") + " on the ground: ";
}

std::string error_text(const LoadedGround& ground, const Carried& wave, double error) {
  return "stresses, pressures and velocities of " + ground.onlooker + " may err by " +
         (error > 0.5 ? "half or more" : "about " + std::to_string(std::lround(100. * error)) + " %") +
         " of what the load makes there" + (wave.duration > 0. ? "" : ", most at the wave's front, and ring behind it");
}

NumberedWarnings warnings_of(const std::string& name, const LoadedGround& ground, const Carried& wave) {
  if (!std::isfinite(wave.duration)) return {};
  const double error = wave.error(), speed = carried_speed(wave.law, wave.duration, wave.cells);
  if (error <= largest_error) return {};
  const double steps = wave.cells.steps.size;
  return {{name, error, largest_error, "1",
           load_text(ground, wave.duration) + wave.name + " in '" + ground.region + "' (" + significant(speed, 3) +
               " m/s) passes a cell of " + significant(ground.cell, 2) + " m in " +
               significant(ground.cell / speed, 2) + " s" +
               (steps > 0. ? ", steps are of " + significant(steps, 2) + " s" : "") + ", and " +
               error_text(ground, wave, error),
           Cure(wave).text()}};
}

Flow flow_of(const Region& region) {
  return region.kind == RegionKind::porous ? region.flow : Flow::drained;
}

/// With the drag of the direction in which less flows: waves along it are the shorter ones.
Material slower_way(Material m) {
  m.b /= std::min(1., m.vertical_flow);
  return m;
}

void keep_worst(const NumberedWarnings& more, NumberedWarnings& list) {
  for (const NumberedWarning& warning : more)
    if (list.empty() || warning.value > list.front().value) list = {warning};
}

}  // namespace

NumberedWarnings ring_warnings(const Simulation& simulation) {
  NumberedWarnings worst;
  if (!simulation.scene().time.inertia) return worst;
  const int degree = simulation.space()->degree();
  for (const LoadedGround& ground : loaded_grounds(simulation.scene(), *simulation.mesh())) {
    const Material m = slower_way(mean_material(simulation, ground.region));
    const Flow flow = flow_of(simulation.scene().regions.at(ground.region));
    const auto ask = [&](const std::string& name, std::complex<double> PlaneWaves::*wave) {
      const WaveLaw law = [&m, flow, wave](std::complex<double> s) { return plane_waves(m, flow, s).*wave; };
      keep_worst(warnings_of("stress_rings", ground, carried(simulation, ground, name, law, degree)), worst);
    };
    if (ground.pushes) ask("its compression wave", &PlaneWaves::fast);
    if (ground.shears) ask("its shear wave", &PlaneWaves::shear);
  }
  return worst;
}

NumberedWarnings slow_wave_warnings(const Simulation& simulation) {
  NumberedWarnings worst;
  if (!simulation.scene().time.inertia) return worst;
  const int degree = simulation.space()->degree() - 1;
  for (const LoadedGround& ground : loaded_grounds(simulation.scene(), *simulation.mesh())) {
    if (flow_of(simulation.scene().regions.at(ground.region)) != Flow::inertial || !ground.pushes) continue;
    const Material m = slower_way(mean_material(simulation, ground.region));
    const WaveLaw law = [&m](std::complex<double> s) { return plane_waves(m, Flow::inertial, s).slow; };
    keep_worst(warnings_of("slow_wave_unresolved", ground,
                           carried(simulation, ground, "the slow wave of its water", law, degree)),
               worst);
  }
  return worst;
}

}  // namespace upbead

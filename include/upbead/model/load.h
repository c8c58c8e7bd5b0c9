// Loads: where they act, how they are distributed, their histories.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "upbead/base/error.h"
#include "upbead/base/time_function.h"

namespace upbead {

enum class PulseShape { triangle, step, half_sine, church_roof, harmonic };

/// An idealised history; zero before `start`. With t from `start`, D = duration:
///   triangle     0 -> peak over `rise` -> 0 at D
///   step         0 -> peak over `rise`, then peak for good
///   half_sine    peak sin(pi t / D) until D
///   church_roof  0 -> peak over `rise` -> plateau * peak at D -> 0 at plateau_duration, all linear: the sum of an
///                impulsive triangle of (1 - plateau) * peak, over at D, and a slow part that rises to plateau * peak
///                within `rise`, keeps it until D and falls to zero at plateau_duration
///   harmonic     peak sin(2 pi frequency t) for good
/// rise = 0 or D makes a jump. Which members a shape needs: diagnose(pulse).
struct Pulse {
  PulseShape shape = PulseShape::triangle;
  double peak = 0.;                ///< largest value (N/m or Pa; amplitude of a harmonic)
  std::optional<double> rise;      ///< s; triangle, church_roof (default duration/2); step: its ramp (default 0)
  std::optional<double> duration;  ///< s; triangle, half_sine, church_roof (its impulsive part)
  double start = 0.;               ///< s
  std::optional<double> plateau;   ///< church_roof: slow part over peak
  std::optional<double> plateau_duration;  ///< church_roof: s, from start to the end of the slow part
  std::optional<double> frequency;         ///< harmonic: Hz
};

/// Everything that is missing, unneeded or contradictory in a pulse.
Diagnostics diagnose(const Pulse& pulse);

/// The history of a pulse that diagnose() accepts.
TimeFunction time_function(const Pulse& pulse);
/// From start to peak (s), as given or by default.
double rise_of(const Pulse& pulse);
/// Load::duration of a pulse: set where the kinks of its history do not show it.
std::optional<double> duration(const Pulse& pulse);

enum class LoadKind {
  force,         ///< resultant (N/m) in `direction`
  traction,      ///< Pa in `direction`
  normal,        ///< Pa on the skeleton alone: traction = -value times the outward normal, none on pore water
  pressure,      ///< Pa: total normal stress = -value, and pore pressure = value where the boundary is open
  pressures,     ///< of a case only: by transducers (gauges.h), each of which becomes a pressure in the scene
  wave,          ///< of a case only: by Goda's formulas, which become a force with a shape in the scene
  train,         ///< of a case only: by regular waves along a curve, which become two pressures in the scene
  displacement,  ///< m, motion of a boundary in `direction`; the scene's history is its velocity (m/s)
  velocity,      ///< m/s, likewise
  acceleration,  ///< m/s2, likewise
  body_force,    ///< N/m3 in `direction` on the volume of a region
  gravity,       ///< m/s2: acceleration of gravity downward on skeleton and water of a region, or of all
  source,        ///< 1/s: volume of water that enters a region's pores, over volume and time
};

/// Whether a load is the motion of a boundary. Where the boundary is held, this motion is prescribed. Where it absorbs
/// waves, the load is the motion of the outcrop, half of which arrives: Joyner and Chen, Bull. Seismol. Soc. Am. 65
/// (1975) 1315.
bool is_motion(LoadKind kind);
/// Whether a load acts on the volume of regions.
bool is_on_volume(LoadKind kind);
/// SI unit of a load's history as written in the case.
const char* unit_of(LoadKind kind);

/// The intensity cos(2 pi (x - origin)/length) along a curve.
struct Cosine {
  double length = 0.;  ///< m
  double origin = 0.;  ///< x of a crest (m)
};

/// One table [loads.NAME].
struct Load {
  std::string boundary;              ///< curve on which it acts; or
  std::string region;                ///< a rigid region, at
  std::array<double, 2> at{0., 0.};  ///< this point (m); or any region, on whose volume it acts
  LoadKind kind = LoadKind::force;
  std::array<double, 2> direction{1., 0.};
  std::vector<std::array<double, 2>> shape;   ///< (height y, relative intensity), linear between; empty: uniform
  bool over_x = false;                        ///< the shape runs over x, as along a bed
  bool along_curve = false;                   ///< the shape runs over the length along the curve, from its seaward end
  std::vector<std::array<double, 2>> course;  ///< the curve's points (x, y) from that end, set when the mesh is known
  std::optional<Cosine> cosine;               ///< instead of a shape
  std::string transducer;                     ///< whose pressure it is: named "LOAD.transducer"; else empty
  bool measured_on_wall = false;              ///< the history already contains the sea's pressure on the moving wall
  double factor = 1.;                         ///< multiplies the history; 0 switches the load off
  TimeFunction history;                       ///< with the factor
  /// Shortest time in which the history rises and falls (s); none: it follows from the kinks, see shortest_duration.
  std::optional<double> duration;
};

/// Load::duration of a measured history, (time, value) pairs linear in between, in a run until `end` (s): twice its
/// peak over its steepest slope, which is the duration of a symmetric triangle; 0 where it jumps at an end by more than
/// a twentieth of its peak. It does not depend on the sampling, as the kinks do.
double sampled_duration(const std::vector<double>& time, const std::vector<double>& value, double end);

/// Relative intensity where the shape's coordinate is `at`: linear between the pairs of `shape`, zero beyond its ends,
/// 1 where it is empty.
double intensity(const Load& load, double at);
/// The same at a point of the curve.
double intensity(const Load& load, double x, double y);
/// The coordinate of a load's shape at a point of its curve: height y, x, or the length along the curve (m).
double shape_coordinate(const Load& load, double x, double y);

}  // namespace upbead

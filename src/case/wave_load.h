// A load by a wave: Goda's pressure over the height of the wall, his uplift, and a course in time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/formula_checks.h"
#include "case/formula_wave.h"
#include "case/load_source.h"
#include "case/standing_load.h"
#include "input/values.h"
#include "model/words.h"
#include "upbead/model/scene.h"
#include "upbead/output/summary.h"
#include "upbead/sliding/pulse.h"

namespace upbead {

class Simulation;
struct Mesh;

/// How the force of a wave runs in time.
enum class WaveCourse {
  church_roof,  ///< an impulsive triangle beside half a standing wave: impact_wave() of expected/dynamic_law.h
  triangle,     ///< of tau_0 = k(alpha*) tau_0F, Shimosako and Takahashi (1994)
  sine,         ///< half a sine of T/2
  combined,     ///< that triangle beside half a standing wave, Shimosako and Takahashi (1998)
  standing,     ///< a standing wave of finite height, crest and trough: standing_load.h
};
extern const Words<WaveCourse> wave_course_words;

/// The table [loads.NAME.wave] as written.
struct WaveLoadTable : WaveGiven {
  WaveCourse course = WaveCourse::church_roof;
  ImpactForce force = ImpactForce::goda_with_alpha_I;
  ImpactAssumptions impact;        ///< of a church roof
  int number = 1;                  ///< of equal waves in a row, each a period after the one before
  std::vector<std::string> mound;  ///< curves in front of the wall, on whose pore water the wave presses, too
};

TableSchema<WaveLoadTable> wave_load_schema();

/// A load of kind "wave", which begins at t = 0. Its resultant P is peak() times a course that is 1 at its largest.
struct WaveLoad : LoadSource {
  WaveLoadTable table;
  Section section;
  DurationFactor k;        ///< of the pulse
  CombinedModel combined;  ///< of S with the standing wave besides the pulse
  DesignWave wave;
  double wavelength = 0.;                  ///< L (m)
  WavePressure pressure;                   ///< by Goda's formulas, with alpha*
  std::optional<TriangularPulse> pulse;    ///< for the courses triangle and combined
  std::optional<ImpactWave> impact;        ///< for the course church_roof
  std::optional<BreakingImpact> breaking;  ///< of an impact by PROVERBS
  std::shared_ptr<const StandingLoad>
      standing;                    ///< for the course standing, whose pressure has another profile at each time
  double standing_force = 0.;      ///< of the slow part: gamma P_1 (N/m)
  TimeFunction history;            ///< P(t) (N/m), without the factor
  std::optional<double> duration;  ///< Load::duration
  double end = 0.;                 ///< when the course is over (s)
  NumberedWarnings outside;        ///< where the formulas do not hold

  double peak() const;
};

/// The load of a table and a section without mistakes. Throws NumericsError where there is no standing wave of that
/// height.
std::shared_ptr<WaveLoad> wave_load(const WaveLoadTable& table, const Section& section, const Water& water,
                                    const DurationFactor& k = {});

/// The pressures of a standing wave as a row on a wall whose still water is at the height `still` (m).
Gauges row_on_wall(const StandingLoad& standing, double still);

/// The loads by waves that are not switched off, by name.
std::vector<const WaveLoad*> acting_waves(const Case& input);

/// Goda's profile over the height y, p over p_1: linear between bottom, still water and the lower of crest and eta*
/// above it. `bottom`: y of the wall's foot (m).
std::vector<Pair> pressure_profile(const WaveLoad& wave, double bottom);

/// The course along x of the pressure on mound and bed, over that at the wall's foot at `wall`: a standing wave's cos(2
/// pi x/L) from there to `seaward` (m), and nothing landward of it.
std::vector<Pair> profile_on_mound(const WaveLoad& wave, double wall, double seaward);

/// The scene with the profiles of its waves on the walls of the mesh. Throws InputError, at keys of the case, where
/// [section] contradicts the mesh or the scene's water.
Scene with_profiles(const Case& input, const Mesh& mesh);

/// Throws InputError where a wave's P or M_P on the meshed caisson is not that of Goda's formulas, or where B or W is
/// not the caisson's.
void check_waves(const Case& input, const Simulation& simulation);

/// Warnings centroid_differs, berm_differs, uplift_left_out and uplift_differs: a wave's section or uplift is not that
/// of the run.
NumberedWarnings wave_mesh_warnings(const Case& input, const Simulation& simulation);

std::vector<WaveLoadSummary> wave_summaries(const Case& input);
OutputSchema<WaveLoadSummary> wave_load_outputs();

/// The checks of these loads by formulas, which stand beside those of the solved scene.
Checks formula_checks(const std::vector<WaveLoadSummary>& waves, const Limits& limits);

}  // namespace upbead

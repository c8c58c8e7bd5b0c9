// Loads by an idealised history: [loads.NAME.pulse].
#include <algorithm>
#include <cmath>
#include <string>

#include "case/case_checks.h"
#include "case/case_schema.h"
#include "case/load_source.h"
#include "model/motion.h"
#include "model/quantities.h"
#include "model/words.h"

namespace upbead {

namespace {

constexpr int most_pulses = 1000;

bool has_rise(const Pulse& pulse) {
  return pulse.shape == PulseShape::triangle || pulse.shape == PulseShape::church_roof ||
         pulse.shape == PulseShape::step;
}

TableSchema<PulseTable> pulse_schema() {
  TableSchema<PulseTable> table;
  table.choice("shape", &Pulse::shape, pulse_shape_words, "shape of the history").required();
  table
      .key("peak", &Pulse::peak, "N/m or Pa",
           "largest value, in the unit of the load's kind; of a harmonic its amplitude")
      .required();
  table.key("rise", &Pulse::rise, "s", "time from start to peak", at_least(0.))
      .fallback("half the duration; of a step 0")
      .when("shape", has_rise, "in a triangle, a church_roof and a step");
  table.key("duration", &Pulse::duration, "s",
            "duration; of a church_roof that of its impulsive part; of triangle, half_sine and church_roof", above(0.));
  table.key("start", &Pulse::start, "s", "time of the start; zero before", at_least(0.));
  table.key("plateau", &Pulse::plateau, "", "value of the slow part over the peak; of a church_roof", between(0., 1.));
  table.key("plateau_duration", &Pulse::plateau_duration, "s",
            "time from start until the slow part has gone; of a church_roof", above(0.));
  table.key("frequency", &Pulse::frequency, "Hz", "frequency; of a harmonic", above(0.));
  table.key("number", &PulseTable::number, "", "of equal pulses in a row: ground and slip remember those before",
            from_to(1, most_pulses));
  table.key("period", &PulseTable::period, "s", "from one pulse to the next; at least as long as a pulse", above(0.))
      .fallback("none: there is one pulse");
  return table;
}

/// How long a pulse acts (s).
double length_of(const Pulse& pulse) {
  const double slow = pulse.shape == PulseShape::church_roof ? pulse.plateau_duration.value_or(0.) : 0.;
  return std::max(pulse.duration.value_or(0.), slow);
}

void check_pulses(const LoadCheck& check) {
  if (!check.load.pulse || (check.load.pulse->number == 1 && !check.load.pulse->period)) return;
  const PulseTable& pulse = *check.load.pulse;
  const auto wrong = [&](const char* key, const std::string& what, const std::string& cure) {
    check.wrong.add(std::string("pulse.") + key, what, cure);
  };
  if (pulse.shape == PulseShape::harmonic || pulse.shape == PulseShape::step)
    wrong("number", "a pulse of that shape does not end, so that none can follow",
          "write a shape that ends: triangle, half_sine or church_roof");
  else if (is_motion(check.load.kind))
    wrong("number", "a motion may leave the boundary elsewhere, from where no equal one follows",
          "give its history as a file");
  else if (!pulse.period)
    wrong("period", "'period' is missing, which number > 1 needs", "add period, from one pulse to the next (s)");
  else if (*pulse.period < length_of(pulse))
    wrong("period",
          "period = " + number_text(*pulse.period) + " s is shorter than a pulse, " + number_text(length_of(pulse)) +
              " s",
          "give at least that");
}

/// Warning implausible: a pulse of acceleration that is weak in m/s2 and strong in g, as of a record without a unit. A
/// power of ten is a unit load, and a factor below 1 weakens a motion on purpose.
NumberedWarnings warnings_of_weak_motion(const GivenLoad& given, double own_peak) {
  constexpr double largest_in_g = 1.;
  const double peak = std::abs(own_peak) * std::max(std::abs(given.table.factor), 1.);
  if (given.table.kind != LoadKind::acceleration || !(peak > 0.) || peak >= largest_in_g ||
      is_unit_load(std::abs(own_peak)))
    return {};
  return {{"implausible", peak, largest_in_g, "m/s2",
           "loads." + given.name + ".pulse.peak = " + significant(own_peak, 4) +
               " is taken in m/s2: in g it would be " + significant(9.81 * peak, 4) + " m/s2",
           "give the peak in m/s2; a motion as weak as that by peak = 1 and the load's factor", true}};
}

std::shared_ptr<LoadSource> read_pulse(const GivenLoad& given) {
  const auto source = begun(given);
  const PulseTable& pulse = *given.table.pulse;
  Load load = given.table;
  load.history = is_motion(load.kind) ? velocity(load.kind, pulse) : time_function(pulse);
  if (pulse.number > 1) load.history = repeated(load.history, pulse.number, *pulse.period);
  load.duration = is_motion(load.kind) ? motion_duration(load.kind, pulse) : duration(pulse);
  const Load& made = source->made[given.name] = with_factor(load);
  if (source->acts()) append(source->warnings, warnings_of_weak_motion(given, pulse.peak));
  const bool harmonic = pulse.shape == PulseShape::harmonic;
  if (source->acts())
    source->action =
        action_of(source->title, "load_cut", "pulse.start", made.history, harmonic ? made.duration : std::nullopt);
  return source;
}

}  // namespace

LoadWay by_pulse() {
  return {[](const LoadTable& table) { return table.pulse.has_value(); },
          [](TableSchema<LoadTable>& table) {
            table.table("pulse", &LoadTable::pulse, pulse_schema()).doc("An idealised history; or history.");
          },
          [](const LoadCheck& check) {
            check.exactly_one("pulse", "history");
            check_pulses(check);
          },
          read_pulse};
}

}  // namespace upbead

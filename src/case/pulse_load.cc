// Loads by an idealised history: [loads.NAME.pulse].
#include "case/case_checks.h"
#include "case/case_schema.h"
#include "case/load_source.h"
#include "model/motion.h"
#include "model/words.h"

namespace upbead {

namespace {

bool has_rise(const Pulse& pulse) {
  return pulse.shape == PulseShape::triangle || pulse.shape == PulseShape::church_roof ||
         pulse.shape == PulseShape::step;
}

TableSchema<Pulse> pulse_schema() {
  TableSchema<Pulse> table;
  table.choice("shape", &Pulse::shape, pulse_shape_words, "shape of the history").required();
  table
      .key("peak", &Pulse::peak, "N/m or Pa",
           "largest value, in the unit of the load's kind; of a harmonic its amplitude")
      .required();
  table.key("rise", &Pulse::rise, "s", "time from start to peak")
      .range(at_least(0.))
      .fallback("half the duration; of a step 0")
      .when("shape", has_rise, "in a triangle, a church_roof and a step");
  table
      .key("duration", &Pulse::duration, "s",
           "duration; of a church_roof that of its impulsive part; of triangle, half_sine and church_roof")
      .range(above(0.));
  table.key("start", &Pulse::start, "s", "time of the start; zero before").range(at_least(0.));
  table.key("plateau", &Pulse::plateau, "", "value of the slow part over the peak; of a church_roof")
      .range(between(0., 1.));
  table
      .key("plateau_duration", &Pulse::plateau_duration, "s",
           "time from start until the slow part has gone; of a church_roof")
      .range(above(0.));
  table.key("frequency", &Pulse::frequency, "Hz", "frequency; of a harmonic").range(above(0.));
  return table;
}

std::shared_ptr<LoadSource> read_pulse(const GivenLoad& given) {
  const auto source = begun(given);
  const Pulse& pulse = *given.table.pulse;
  Load load = given.table;
  load.history = is_motion(load.kind) ? velocity(load.kind, pulse) : time_function(pulse);
  load.duration = is_motion(load.kind) ? motion_duration(load.kind, pulse) : duration(pulse);
  const Load& made = source->made[given.name] = with_factor(load);
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
          [](const LoadCheck& check) { check.exactly_one("pulse", "history"); }, read_pulse};
}

}  // namespace upbead

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
  table.choice("shape", &Pulse::shape, pulse_shape_words).required().doc("shape of the history");
  table.key("peak", &Pulse::peak)
      .unit("N/m or Pa")
      .required()
      .doc("largest value, in the unit of the load's kind; of a harmonic its amplitude");
  table.key("rise", &Pulse::rise)
      .unit("s")
      .range(at_least(0.))
      .fallback("half the duration; of a step 0")
      .doc("time from start to peak")
      .when("shape", has_rise, "in a triangle, a church_roof and a step");
  table.key("duration", &Pulse::duration)
      .unit("s")
      .range(above(0.))
      .doc("duration; of a church_roof that of its impulsive part; of triangle, half_sine and church_roof");
  table.key("start", &Pulse::start).unit("s").range(at_least(0.)).doc("time of the start; zero before");
  table.key("plateau", &Pulse::plateau)
      .range(between(0., 1.))
      .doc("value of the slow part over the peak; of a church_roof");
  table.key("plateau_duration", &Pulse::plateau_duration)
      .unit("s")
      .range(above(0.))
      .doc("time from start until the slow part has gone; of a church_roof");
  table.key("frequency", &Pulse::frequency).unit("Hz").range(above(0.)).doc("frequency; of a harmonic");
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

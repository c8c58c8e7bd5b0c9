#include "case/wave_train.h"

#include <cmath>

#include "base/numbers.h"
#include "base/text.h"
#include "model/words.h"
#include "upbead/waves/wave_heights.h"

namespace upbead {

namespace {

const Words<TrainCourse> train_course_words{
    {"landward", TrainCourse::landward}, {"seaward", TrainCourse::seaward}, {"stands", TrainCourse::stands}};

/// The function growing(t) times wave(t), which starts from rest at t = 0.
TimeFunction grown(double growth, const std::function<double(double)>& wave) {
  const auto none = [](double) { return 0.; };
  if (growth <= 0.) return TimeFunction({0.}, {none, wave});
  const auto growing = [growth, wave](double t) { return std::pow(std::sin(0.5 * pi * t / growth), 2) * wave(t); };
  return TimeFunction({0., growth}, {none, growing, wave});
}

}  // namespace

TableSchema<WaveTrain> wave_train_schema() {
  TableSchema<WaveTrain> table;
  table.key("amplitude", &WaveTrain::amplitude)
      .unit("Pa")
      .range(above(0.))
      .doc("amplitude of the pressure on the curve; or height and depth");
  table.key("height", &WaveTrain::height).unit("m").range(above(0.)).doc("height of the waves, crest over trough");
  table.key("depth", &WaveTrain::depth).unit("m").range(above(0.)).doc("depth of the water over the curve");
  table.key("period", &WaveTrain::period).unit("s").range(above(0.)).required().doc("period");
  table.key("length", &WaveTrain::length)
      .unit("m")
      .range(above(0.))
      .fallback("by period and depth, linear waves")
      .doc("length of the waves");
  table.choice("course", &WaveTrain::course, train_course_words)
      .doc("landward and seaward: they run that way; stands: a standing wave, whose amplitude is that of an antinode");
  table.key("crest", &WaveTrain::crest).unit("m").doc("x of a crest at t = 0; of a standing wave x of an antinode");
  table.key("growth", &WaveTrain::growth)
      .unit("s")
      .range(at_least(0.))
      .fallback("one period")
      .doc("time in which the waves grow from rest; 0: they jump to their full height");
  return table;
}

Diagnostics diagnose(const WaveTrain& train) {
  Diagnostics list;
  if (train.amplitude && train.height)
    list.add(at_key("height"), "both 'amplitude' and 'height' are given", "keep one of them");
  if (!train.amplitude && !train.height)
    list.add(at_key("amplitude"), "neither 'amplitude' nor 'height' is given",
             "add amplitude (Pa), or height and depth");
  if (!train.depth && train.height)
    list.add(at_key("depth"), "'depth' is missing, which 'height' needs", "add depth (m)");
  if (!train.depth && !train.length && !train.height)
    list.add(at_key("length"), "neither 'length' nor 'depth' is given, one of which sets the length of the waves",
             "add length (m) or depth (m)");
  return list;
}

void add_train_loads(const std::string& name, const TrainLoad& by_train, double density, double gravity, Scene& scene) {
  const WaveTrain& train = by_train.train;
  const double omega = 2. * pi / train.period;
  const double length = train.length ? *train.length : wavelength(train.period, *train.depth, gravity);
  const double a = train.amplitude
                       ? *train.amplitude
                       : 0.5 * density * gravity * *train.height / std::cosh(2. * pi / length * *train.depth);
  const double growth = train.growth.value_or(train.period), factor = by_train.load.factor;
  const auto add = [&](const std::string& part, double origin, const std::function<double(double)>& wave) {
    Load load = by_train.load;
    load.kind = LoadKind::pressure;
    load.cosine = Cosine{length, origin};
    load.transducer = part;
    if (factor != 0.) {
      load.history = grown(growth, wave);
      load.duration = 0.5 * train.period;
    }
    scene.loads[name + "." + part] = load;
  };
  add("cosine", train.crest, [a = a * factor, omega](double t) { return a * std::cos(omega * t); });
  if (train.course == TrainCourse::stands) return;
  const double sign = train.course == TrainCourse::landward ? 1. : -1.;
  add("sine", train.crest + 0.25 * length,
      [a = sign * a * factor, omega](double t) { return a * std::sin(omega * t); });
}

}  // namespace upbead

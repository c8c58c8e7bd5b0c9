#include "case/wave_train.h"

#include <cmath>

#include "base/numbers.h"
#include "case/case_checks.h"
#include "case/case_schema.h"
#include "case/load_source.h"
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
  table.key("amplitude", &WaveTrain::amplitude, "Pa", "amplitude of the pressure on the curve; or height and depth",
            above(0.));
  table.key("height", &WaveTrain::height, "m", "height of the waves, crest over trough", above(0.));
  table.key("depth", &WaveTrain::depth, "m", "depth of the water over the curve", above(0.));
  table.key("period", &WaveTrain::period, "s", "period", above(0.)).required();
  table.key("length", &WaveTrain::length, "m", "length of the waves", above(0.))
      .fallback("by period and depth, linear waves");
  table.choice(
      "course", &WaveTrain::course, train_course_words,
      "landward and seaward: they run that way; stands: a standing wave, whose amplitude is that of an antinode");
  table.key("crest", &WaveTrain::crest, "m", "x of a crest at t = 0; of a standing wave x of an antinode");
  table
      .key("growth", &WaveTrain::growth, "s",
           "time in which the waves grow from rest; 0: they jump to their full height", at_least(0.))
      .fallback("one period");
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

std::map<std::string, Load> train_loads(const std::string& name, const Load& load, const WaveTrain& train,
                                        double density, double gravity) {
  std::map<std::string, Load> loads;
  const double omega = 2. * pi / train.period;
  const double length = train.length ? *train.length : wavelength(train.period, *train.depth, gravity);
  const double a = train.amplitude
                       ? *train.amplitude
                       : 0.5 * density * gravity * *train.height / std::cosh(2. * pi / length * *train.depth);
  const double growth = train.growth.value_or(train.period), factor = load.factor;
  const auto add = [&](const std::string& part, double origin, const std::function<double(double)>& wave) {
    Load& one = loads[name + "." + part] = load;
    one.kind = LoadKind::pressure;
    one.cosine = Cosine{length, origin};
    one.transducer = part;
    if (factor == 0.) return;
    one.history = grown(growth, wave);
    one.duration = 0.5 * train.period;
  };
  add("cosine", train.crest, [a = a * factor, omega](double t) { return a * std::cos(omega * t); });
  if (train.course == TrainCourse::stands) return loads;
  const double sign = train.course == TrainCourse::landward ? 1. : -1.;
  add("sine", train.crest + 0.25 * length,
      [a = sign * a * factor, omega](double t) { return a * std::sin(omega * t); });
  return loads;
}

namespace {

bool is_by_train(const LoadTable& table) {
  return table.kind == LoadKind::train && table.from.empty();
}

void check_train(const LoadCheck& check) {
  check.refuse({"pulse", "history", "shape", "region"}, "a train of waves", "write kind = \"pressure\"");
  if (!check.load.train)
    check.wrong.add("train", "'train' is missing, which kind = \"train\" needs",
                    "add train = { height = ..., depth = ..., period = ... }");
  else
    check.wrong.add(diagnose(*check.load.train), "train.");
}

std::shared_ptr<LoadSource> read_train(const GivenLoad& given) {
  const auto source = begun(given);
  const Scene& scene = given.problem.scene;
  const WaveTrain& train = *given.table.train;
  source->made = train_loads(given.name, source->load, train, scene.fluid.density, scene.gravity);
  if (source->acts())
    source->action = action_of(source->title, "load_cut", "growth", source->made.at(given.name + ".cosine").history,
                               0.5 * train.period);
  return source;
}

}  // namespace

LoadWay by_train() {
  return {
      is_by_train,
      [](TableSchema<LoadTable>& table) {
        table.table("train", &LoadTable::train, wave_train_schema())
            .doc("Regular waves along the curve, such as a seabed; the pressure acts as that of kind = \"pressure\".")
            .when(
                "kind", [](const LoadTable& load) { return load.kind == LoadKind::train; }, "where kind = \"train\"");
      },
      check_train, read_train};
}

}  // namespace upbead

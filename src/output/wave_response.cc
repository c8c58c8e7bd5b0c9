#include "output/wave_response.h"

#include <algorithm>
#include <limits>

#include "hdf5_image.h"
#include "output/checks.h"
#include "output/contact_outputs.h"
#include "output/output_schema.h"

namespace upbead {

namespace {

/// A wave, and its name in the summary.
struct NamedWave {
  std::string name;
  const WaveResponse* wave;
};

/// All that goes into the summary of `respond`.
struct Answers {
  const ReducedModelFile* model;
  std::string path;
  std::map<std::string, double> soil;
  std::vector<NamedWave> waves;
  RespondTiming timing;
  NumberedWarnings warnings;
  std::string why_void, not_judged;
};

OutputSchema<CoupledWave> coupled_wave_outputs() {
  using C = CoupledWave;
  return OutputSchema<C>()
      .key("largest", &C::largest, "m", "slip of largest magnitude on the way, landward")
      .key("slips", &C::slips, "", "number of slips")
      .key("dissipated", &C::dissipated, "J/m", "taken by friction")
      .key("lifted_time", &C::lifted_time, "s", "time in which N' would have been negative");
}

OutputSchema<CircleInWave> circle_in_wave_outputs() {
  using C = CircleInWave;
  return OutputSchema<C>()
      .key("factor", &C::factor, "",
           "least F by Bishop's simplified method, of the model's [circles](circles.md); 0 where the resultant leaves "
           "the base, so that no width bears it")
      .key("time", &C::time, "s", "when")
      .reason("slips", &C::slips, "`landward` or `seaward`; null where the resultant leaves the base, as the next five")
      .reason("by", &C::by, "pore pressure: `still` water's, or that `computed`")
      .key("centre[]", &C::centre, "m", "of the circle")
      .key("radius", &C::radius, "m", "of the circle")
      .key("from", &C::from, "m", "x where it meets the surface on the left")
      .key("to", &C::to, "m", "and on the right")
      .key("force", &C::force, "N/m", "N' of the base then")
      .key("shear", &C::shear, "N/m", "F_T then")
      .key("moment", &C::moment, "N m/m", "M' then, about the middle of the base");
}

OutputSchema<PeaksOfShear> peaks_outputs() {
  using P = PeaksOfShear;
  return OutputSchema<P>()
      .key("peak_shear", &P::peak_shear, "N/m", "largest F_T, landward")
      .key("peak_shear_time", &P::peak_shear_time, "s", "time of the largest F_T")
      .key("peak_shear_seaward", &P::peak_shear_seaward, "N/m", "least F_T");
}

/// The keys of a wave; the datasets of responses.h5 take unit and meaning from here.
const OutputSchema<WaveResponse>& wave_outputs() {
  using W = WaveResponse;
  const auto slip = [](const W& w) { return w.coupled ? std::optional(w.coupled->sliding) : std::nullopt; };
  static const auto schema =
      OutputSchema<W>()
          .key("peak_force", &W::peak_force, "N/m", "largest P, landward")
          .key("peak_force_seaward", &W::peak_force_seaward, "N/m", "least P: the largest seaward one is negative")
          .key("peak_shear", &W::peak_shear, "N/m", "largest F_T, landward")
          .key("peak_shear_time", &W::peak_shear_time, "s", "time of the largest F_T")
          .key("peak_shear_seaward", &W::peak_shear_seaward, "N/m", "least F_T: the largest seaward one is negative")
          .key("ratio", &W::ratio, "",
               "peak F_T / peak P, both seaward where the largest |P| is; null where P = 0 throughout")
          .key("beyond_band", &W::beyond_band, "",
               "part of F_T from frequencies beyond the model's highest, over the largest |F_T|")
          .key("error_estimate", &W::error_estimate, "",
               "bound of the error of F_T by the reduced model, over the largest |F_T|; null where the model's file "
               "holds no `/nested`, which a warning says")
          .key("sliding", &W::sliding, "m",
               "S, sliding distance when the caisson has come to rest, landward; null where not asked for")
          .key("peak_heel_pressure", &W::peak_heel_pressure, "Pa",
               "largest pressure of the landward edge of the base, stress varying linearly over the width in contact; "
               "null where the "
               "resultant leaves the base, or the model's file does not contain W'")
          .key("peak_toe_pressure", &W::peak_toe_pressure, "Pa", "the same of the seaward edge; null likewise")
          .key("least_overturning_margin", &W::least_overturning_margin, "",
               "least margin against overturning; null where nothing overturns, or the file does not contain W'")
          .key("least_sliding_factor", &W::least_sliding_factor, "",
               "least mu N'/F_T while F_T acts landward; null where it never does, where S is not asked for, or the "
               "file does not contain W'")
          .key("least_sliding_factor_seaward", &W::least_sliding_factor_seaward, "", "the same seaward; null likewise")
          .object("circle", &W::circle, circle_in_wave_outputs(),
                  "the least safe slip circle under the caisson; null where the model has none")
          .key("sliding_coupled", slip, "m",
               "S where the caisson slides as a rigid block on the moving ground, landward; null where not asked for, "
               "and where the model cannot compute it")
          .reason("why_not_coupled", &W::why_not_coupled, "the reason, where it is this wave's; else null")
          .object("coupled", &W::coupled, coupled_wave_outputs(), "of that slip; null with it")
          .object(
              "response", &W::response, peaks_outputs(),
              "of a caisson that may slip and lift node by node; left out where the model has no such, and where it "
              "could not be answered")
          .or_left_out()
          .object("contact", &W::contact, contact_outputs(),
                  "[slip and uplift node by node](contact.md), as a run tells it; left out where the model has no such")
          .or_left_out()
          .reason("why_not_contact", &W::why_not_contact,
                  "why slip and uplift of this wave could not be computed; left out where they were")
          .or_left_out();
  return schema;
}

OutputSchema<Answers> model_outputs() {
  using A = Answers;
  using M = ReducedModelFile;
  return OutputSchema<A>()
      .key("title", inner(&A::model, &M::title), "", "that of its case")
      .key("file", &A::path, "", "its path")
      .key("error", inner(&A::model, &M::error), "", "of the history of F_T over its peak")
      .key("tolerance", inner(&A::model, &M::tolerance), "", "that was asked for, relative")
      .key("highest_frequency", inner(&A::model, &M::highest_frequency), "Hz", "up to which it has been checked")
      .key("soil.KEY", &A::soil, "",
           "value of each key that a [model of soils](soils.md) varies; only with such a model")
      .or_left_out();
}

OutputSchema<NamedWave> named_wave_outputs() {
  return OutputSchema<NamedWave>()
      .key("name", &NamedWave::name, "", "of the file, with `[i]` counted from 0 where it holds several")
      .keys_of(&NamedWave::wave, wave_outputs());
}

const OutputSchema<Answers>& answers_outputs() {
  using A = Answers;
  using T = RespondTiming;
  const auto timing = OutputSchema<T>()
                          .key("read", &T::read, "s", "reading")
                          .key("respond", &T::respond, "s", "answering")
                          .key("write", &T::write, "s", "writing")
                          .key("total", &T::total, "s", "since the start of the program");
  const auto per_second = [](const A& a) {
    const auto n = static_cast<double>(a.waves.size());
    return a.timing.respond > 0. ? std::optional(n / a.timing.respond) : std::nullopt;
  };
  static const auto schema = OutputSchema<A>()
                                 .program()
                                 .object(
                                     "model", [](const A& a) { return &a; }, model_outputs(), "the reduced model")
                                 .list("waves[]", &A::waves, named_wave_outputs(), "each wave")
                                 .list("warnings[]", &A::warnings, warning_outputs(),
                                       "[what may be wrong](warnings.md#reduced-models) though nothing failed")
                                 .reason("why_void", &A::why_void,
                                         "the warnings under which no verdict may be drawn; null where there is none")
                                 .reason("not_judged", &A::not_judged,
                                         "what a run judges beside slip circles and no number of a wave tells; null "
                                         "where the model has no circles")
                                 .object("timing", &A::timing, timing, "wall times")
                                 .key("histories_per_second", per_second, "1/s", "waves over `timing.respond`")
                                 .versions();
  return schema;
}

/// Datasets that are written only where the first wave has the number; in all other datasets null becomes 0.
bool may_be_absent(const OutputRow& row) {
  return row.path == "error_estimate" || row.path == "sliding";
}

/// Datasets in which NaN stands for a number that a wave does not have.
bool is_of_ground(const OutputRow& row) {
  return row.path.rfind("least_sliding_factor", 0) == 0 || row.path.rfind("circle.", 0) == 0;
}
bool is_of_contact(const OutputRow& row) {
  return row.path.rfind("contact.", 0) == 0 || row.path.rfind("response.", 0) == 0;
}
bool is_of_slip(const OutputRow& row) {
  return row.path == "sliding_coupled" || row.path == "least_overturning_margin" ||
         row.path.find("_pressure") != std::string::npos || row.path.rfind("coupled.", 0) == 0;
}

/// Writes one number for each wave: "coupled.slips" of the summary becomes the dataset coupled_slips.
void write_column(detail::Hdf5Image& image, const std::string& group, const std::vector<Json>& waves,
                  const OutputRow& row) {
  std::string path = "/" + row.path;
  const bool of_slip = is_of_slip(row) || is_of_ground(row) || is_of_contact(row);
  const double none = of_slip ? std::numeric_limits<double>::quiet_NaN() : 0.;
  std::replace(path.begin(), path.end(), '.', '/');
  const Json::json_pointer at(path);
  std::vector<double> values;
  for (const Json& wave : waves) {
    const bool told = wave.contains(at) && !wave.at(at).is_null();
    values.push_back(told ? wave.at(at).get<double>() : none);
  }
  std::replace(path.begin() + 1, path.end(), '/', '_');
  const std::size_t absent = row.meaning.find("; null");
  const detail::Label label{row.unit.empty() ? "1" : row.unit,
                            row.meaning.substr(0, absent) + (row.path == "ratio" ? "; 0 where P = 0 throughout" : "")};
  if (of_slip)
    image.numbers_or_none(group + path, values, label);
  else
    image.numbers(group + path, {values.size()}, values.data(), label);
}

void write_histories(detail::Hdf5Image& image, const WaveResponses& file) {
  const std::string group = "/" + file.name + "/";
  const std::vector<hsize_t> shape{file.waves.size(), file.time.size()};
  image.numbers(group + "time", {file.time.size()}, file.time.data(), {"s", "time"});
  image.numbers(group + "force", shape, file.force.data(), {"N/m", "P, horizontal load on the caisson, landward"});
  image.numbers(group + "shear_force", shape, file.shear_force.data(),
                {"N/m", "F_T, shear force at the caisson's bottom, landward on the ground"});
}

/// The histories of a wave that were asked for, with their times and errors.
void add_histories(const WaveResponses& file, std::size_t w, Json& json) {
  if (file.histories.empty()) return;
  json["time"] = file.time;
  const auto row = static_cast<Eigen::Index>(w);
  for (const WaveHistory& history : file.histories) {
    const auto values = history.value.row(row);
    json["histories"][history.label.name] = std::vector<double>(values.begin(), values.end());
    json["history_errors"][history.label.name] = history.error.size() > 0 ? Json(history.error[row]) : Json();
  }
}

}  // namespace

std::string WaveResponses::wave_name(std::size_t wave) const {
  return waves.size() == 1 ? name : name + "[" + std::to_string(wave) + "]";
}

std::string response_file(const AnsweredModel& of, const std::vector<WaveResponses>& files) {
  detail::Hdf5Image image(of.model.title);
  if (!of.soil.empty()) image.attribute("/", "soil", Json(of.soil).dump());
  for (const WaveResponses& file : files) {
    write_histories(image, file);
    std::vector<Json> waves;
    for (const WaveResponse& wave : file.waves) waves.push_back(wave_outputs().to_json(wave));
    const bool slips = std::any_of(file.waves.begin(), file.waves.end(), [](const WaveResponse& wave) {
      return wave.coupled || !wave.why_not_coupled.empty();
    });
    const bool has_circles =
        std::any_of(file.waves.begin(), file.waves.end(), [](const WaveResponse& wave) { return !!wave.circle; });
    const bool has_contact = !!of.model.contact;
    for (const OutputRow& row : wave_outputs().rows()) {
      const bool absent = is_of_contact(row)  ? !has_contact
                          : is_of_ground(row) ? !has_circles
                          : is_of_slip(row)   ? !slips
                                              : may_be_absent(row) && waves.front().at(row.path).is_null();
      if (row.is_number && !absent) write_column(image, "/" + file.name, waves, row);
    }
  }
  return image.bytes();
}

std::vector<OutputRow> rows_of_respond() {
  return answers_outputs().rows();
}

std::string to_json(const WaveResponse& wave) {
  return wave_outputs().text(wave);
}

std::string soil_line(const AnsweredModel& of, const std::vector<WaveResponses>& files,
                      const NumberedWarnings& warnings) {
  static const OutputSchema<NamedWave> outputs = named_wave_outputs();
  Json line{{"soil", of.soil}, {"error", of.model.error}, {"waves", Json::array()}};
  for (const WaveResponses& file : files)
    for (std::size_t w = 0; w < file.waves.size(); ++w) {
      Json wave = outputs.to_json({file.wave_name(w), &file.waves[w]});
      add_histories(file, w, wave);
      line["waves"].push_back(std::move(wave));
    }
  line["warnings"] = warnings_json(warnings);
  if (const std::string why = verdict_of({}, warnings).why_void; !why.empty()) line["why_void"] = why;
  return json_text(line, one_line);
}

std::string soil_line(const std::optional<std::map<std::string, double>>& soil, const std::string& why) {
  return json_text({{"soil", soil ? Json(*soil) : Json()}, {"why", why}}, one_line);
}

Json to_json(const AnsweredModel& of, const std::vector<WaveResponses>& files, const RespondTiming& timing,
             const NumberedWarnings& warnings) {
  Answers answers{&of.model, of.path, of.soil, {}, timing, warnings, verdict_of({}, warnings).why_void, {}};
  if (of.model.circles)
    answers.not_judged =
        "slip on a plane below the caisson, strength at the peak, momentary liquefaction, what cycles leave: 'upbead "
        "run' judges them";
  for (const WaveResponses& file : files)
    for (std::size_t w = 0; w < file.waves.size(); ++w) answers.waves.push_back({file.wave_name(w), &file.waves[w]});
  return answers_outputs().to_json(answers);
}

}  // namespace upbead

// Claim: waves that run along a level seabed, as a case loads it, have the exact amplitudes of pore pressure,
// stresses and displacement in the middle of a stretch of four wavelengths, landward, seaward and standing. Source:
// tests/reference/ref3_wave_seabed.json, as of waves_test.cc. A wave p e^{i(omega t - k x)} is the sum of two
// standing waves of the tables, shifted by a quarter of the wavelength and of the period. Limit: 1 % of each field's
// largest amplitude: 0.5 % as in waves_test.cc, and another 0.5 % for the ends of the stretch.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "case/wave_train.h"
#include "record.h"
#include "tensor_mesh.h"
#include "wave_seabed.h"

namespace upbead::test {
namespace train_test {

using Profile = std::vector<Complex>;

std::unique_ptr<Mesh> stretch(const WaveSeabed& seabed) {
  const double far = 2. * seabed.wavelength, z = seabed.thickness, small = 1e-9 * z;
  const auto curve = [=](const dealii::Point<dim>& at) -> std::string {
    if (at[1] > -small) return "bed";
    if (at[1] < small - z) return "base";
    return std::abs(at[0]) > far - small ? "sides" : "";
  };
  const auto from = [&](double side) {
    return graded_lines(side, -0.5 * z, 4e-4 * seabed.wavelength, 1.5, std::min(0.03 * seabed.wavelength, z / 25.));
  };
  return tensor_mesh(
      even_lines(-far, far, 64), joined(from(-z), from(0.)), [](const auto&) { return "soil"; }, curve);
}

Scene bed_of(const WaveSeabed& seabed, TrainCourse course) {
  Scene scene;
  scene.fluid = seabed.fluid;
  scene.time.inertia = seabed.inertia;
  scene.mesh.degree = 3;
  scene.regions["soil"] = seabed.soil;
  scene.boundaries["bed"].pressure = PressureCondition::open;
  scene.boundaries["base"] = {DisplacementCondition::fixed, PressureCondition::sealed};
  scene.boundaries["sides"] = {DisplacementCondition::roller, PressureCondition::sealed};
  Load load;
  load.boundary = "bed";
  WaveTrain train;
  train.amplitude = 1.;
  train.length = seabed.wavelength;
  train.period = 2. * std::acos(-1.) / seabed.omega;
  train.course = course;
  scene.loads = train_loads("sea", load, train, 1000., 9.81);
  for (std::size_t i = 0; i < seabed.depths.size(); ++i) {
    scene.probes["c" + std::to_string(i)].at = {0., -seabed.depths[i]};
    scene.probes["q" + std::to_string(i)].at = {0.25 * seabed.wavelength, -seabed.depths[i]};
  }
  return scene;
}

/// Amplitudes below x = 0 and below a quarter of a wavelength landward. The histories are cosines and sines of omega
/// t.
struct Found {
  Profile pressure, stress, pressure_beside, settlement;
};

Found respond(const WaveSeabed& seabed, TrainCourse course) {
  const auto mesh = stretch(seabed);
  const Compiled compiled(bed_of(seabed, course), *mesh);
  const System& system = compiled.system;
  const FrequencyResponse response(system, seabed.omega);
  const Complex sine = course == TrainCourse::landward ? Complex(0., -1.) : Complex(0., 1.);
  std::vector<Complex> load;
  for (const SystemLoad& part : system.loads) load.push_back(part.name.find("sine") == 4 ? sine : Complex(1.));
  const ComplexVector x = response(load);
  const auto read = [&](char where, const char* quantity) {
    Profile over_depth;
    for (std::size_t i = 0; i < seabed.depths.size(); ++i) {
      const int k = system.reading("probes/" + (where + std::to_string(i)) + "/" + quantity);
      over_depth.push_back(response.read(system.readings[static_cast<std::size_t>(k)], x, load));
    }
    return over_depth;
  };
  return {read('c', "pressure"), read('c', "effective_stress_yy"), read('q', "pressure"), read('c', "displacement_y")};
}

double apart(const Profile& found, const Profile& exact, Complex turned) {
  double worst = 0., largest = 0.;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    worst = std::max(worst, std::abs(found[i] - turned * exact[i]));
    largest = std::max(largest, std::abs(exact[i]));
  }
  return worst / largest;
}

void compare_with_exact(std::initializer_list<TrainCourse> courses) {
  Record record("seabed");
  const Json all = reference("ref3_wave_seabed");
  for (const Json& entry : all.at("cases")) {
    if (entry.at("case").at("H") != 30.) continue;
    const WaveSeabed seabed = wave_seabed(entry, "upB");
    const Json& table = entry.at("models").at("upB");
    Profile p, settled;
    std::vector<double> stress = table.at("abs_seff_zz");
    for (std::size_t i = 0; i < seabed.depths.size(); ++i) {
      p.push_back(std::polar(table.at("abs_p").at(i).get<double>(), table.at("arg_p").at(i).get<double>()));
      settled.emplace_back(table.at("uz_re").at(i).get<double>(), table.at("uz_im").at(i).get<double>());
    }
    for (const TrainCourse course : courses) {
      const Found found = respond(seabed, course);
      const Complex beside = course == TrainCourse::landward  ? Complex(0., -1.)
                             : course == TrainCourse::seaward ? Complex(0., 1.)
                                                              : Complex(0.);
      std::vector<double> size;
      for (const Complex& s : found.stress) size.push_back(std::abs(s));
      const double error = std::max({apart(found.pressure, p, 1.), apart(found.pressure_beside, p, beside),
                                     apart(found.settlement, settled, -1.),
                                     largest_error(size, stress, *std::max_element(stress.begin(), stress.end()))});
      const char* name = course == TrainCourse::landward  ? "running landward"
                         : course == TrainCourse::seaward ? "running seaward"
                                                          : "standing";
      record.at_most(std::string("level bed under waves ") + name + ", saturation " +
                         std::to_string(entry.at("case").at("Sr").get<double>()).substr(0, 5) +
                         ", k = " + std::to_string(entry.at("case").at("mat").at("k").get<double>()).substr(0, 6) +
                         " m/s: worst of p at two places, effective stress and settlement",
                     error, 1e-2);
    }
  }
}

TEST(WaveTrainOnSeabed, RunsLandwardAsExact) {
  compare_with_exact({TrainCourse::landward});
}

TEST(WaveTrainOnSeabed, RunsSeawardAndStandsAsExactAtLength) {
  compare_with_exact({TrainCourse::seaward, TrainCourse::stands});
}

}  // namespace train_test
}  // namespace upbead::test

// Claim: a seabed under waves has the exact amplitudes of pore pressure, effective stress, shear stress and
// displacement, quasi-static and with inertia, from long waves on sand with and without air and on rubble to
// short-period pressure patterns close to resonance, by the frequency response of the same M, C and K as in a march.
// Source: tests/reference/ref3_wave_seabed.json (exact exponentials): Hsu and Jeng (1994) for a layer, Madsen (1978)
// and Yamamoto et al. (1978) for a half-space, and the same with inertia. The program does not have its model upA
// (the solid's acceleration in Darcy's law).
// Limit: 0.5 % of each field's largest amplitude over the depth; pressure and displacement as complex numbers,
// stresses by their amplitudes, as in the table.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "record.h"
#include "wave_seabed.h"

namespace upbead::test {
namespace waves_test {

using Profile = std::vector<Complex>;

/// Coarse cells for degree 3, fine ones for degree 2.
SeabedMesh mesh_for(const WaveSeabed& seabed, int degree) {
  const double wave = seabed.wavelength, H = seabed.thickness;
  if (degree == 3) return {3, 8, 4e-4 * wave, 1.5, std::min(0.03 * wave, H / 25.)};
  return {2, 32, 4e-4 * wave, 1.2, std::min(0.01 * wave, H / 50.)};
}

std::vector<double> amplitudes(const Profile& field) {
  std::vector<double> out;
  for (const Complex& value : field) out.push_back(std::abs(value));
  return out;
}

/// Largest difference over the largest amplitude.
double error(const Profile& found, const Profile& exact) {
  Profile difference;
  for (std::size_t i = 0; i < exact.size(); ++i) difference.push_back(found[i] - exact[i]);
  const auto by_size = amplitudes(difference), size = amplitudes(exact);
  const double largest = *std::max_element(size.begin(), size.end());
  return largest_error(by_size, std::vector<double>(size.size(), 0.), largest);
}

Profile polar(const Json& amplitude, const Json& phase) {
  Profile out;
  for (std::size_t i = 0; i < amplitude.size(); ++i)
    out.push_back(std::polar(amplitude[i].get<double>(), phase[i].get<double>()));
  return out;
}

Profile cartesian(const Json& re, const Json& im) {
  Profile out;
  for (std::size_t i = 0; i < re.size(); ++i) out.emplace_back(re[i].get<double>(), im[i].get<double>());
  return out;
}

/// The largest error of all fields.
double error(const SeabedResponse& found, const Json& table) {
  return std::max({error(found.pressure, polar(table.at("abs_p"), table.at("arg_p"))),
                   largest_error(amplitudes(found.effective_stress), table.at("abs_seff_zz")),
                   largest_error(amplitudes(found.shear_stress), table.at("abs_sxz")),
                   error(found.horizontal, cartesian(table.at("ux_re"), table.at("ux_im"))),
                   error(found.vertical, cartesian(table.at("uz_re"), table.at("uz_im")))});
}

std::string title(const Json& entry) {
  const Json& input = entry.at("case");
  const auto number = [](const Json& value) { return value.get<double>(); };
  std::ostringstream out;
  if (input.at("H").is_null())
    out << "half-space";
  else
    out << "layer of " << number(input.at("H")) << " m";
  out << ", k = " << number(input.at("mat").at("k")) << " m/s, saturation " << number(input.at("Sr")) << ", wave of "
      << std::lround(number(entry.at("wavelength"))) << " m and " << number(input.at("T")) << " s";
  return out.str();
}

const char* const what = ": worst of p, stresses and displacements, each relative to its largest amplitude over depth";

/// Pressure and effective stress over the depth: long waves on 30 m of sand, impulsive patterns.
void draw(Record& record, const Json& entry, const SeabedResponse& found, const Json& table,
          const std::vector<double>& depths) {
  const Json& input = entry.at("case");
  const auto curve = [&](const char* panel, const char* y, const Profile& field, const char* exact) {
    record.curve({panel, "depth (m)", y, title(entry), depths, table.at(exact), amplitudes(field)});
  };
  if (input.at("T") == 12.5 && input.at("H") == 30.) {
    curve("long waves on a layer of sand: pressure", "|p| / p0", found.pressure, "abs_p");
    curve("long waves on a layer of sand: effective stress", "|s'zz| / p0", found.effective_stress, "abs_seff_zz");
  }
  if (input.at("T") == 0.2) curve("impulsive patterns, 40 m long: pressure", "|p| / p0", found.pressure, "abs_p");
}

void compare(const std::string& model, const std::string& model_title) {
  Record record("seabed");
  const Json all = reference("ref3_wave_seabed");
  ASSERT_EQ(all.at("cases").size(), 11u);
  for (const Json& entry : all.at("cases")) {
    const WaveSeabed seabed = wave_seabed(entry, model);
    const SeabedResponse found = respond(seabed, mesh_for(seabed, 3));
    const Json& table = entry.at("models").at(model);
    record.at_most(title(entry) + ", " + model_title + what, error(found, table), 5e-3);
    if (model == "full") draw(record, entry, found, table, seabed.depths);
  }
}

TEST(WaveSeabed, QuasiStatic) {
  compare("qs", "quasi-static");
}

TEST(WaveSeabed, DarcyFlowWithInertia) {
  compare("upB", "Darcy flow with inertia");
}

TEST(WaveSeabed, FullBiotEquationsAtLength) {
  compare("full", "full Biot equations");
}

TEST(WaveSeabed, QuasiStaticByElementsOfDegree2) {
  Record record("seabed");
  const Json all = reference("ref3_wave_seabed");
  for (const Json& entry : all.at("cases")) {
    if (entry.at("case").at("H") != 30.) continue;
    const WaveSeabed seabed = wave_seabed(entry, "qs");
    record.at_most(title(entry) + ", quasi-static, elements of degree 2" + what,
                   error(respond(seabed, mesh_for(seabed, 2)), entry.at("models").at("qs")), 5e-3);
  }
}

/// A layer of water so thin (kh = 1e-4) that the pressure on its level is that on the mudline: the pressure of the
/// modelled water then acts on skeleton and pores like a load on the mudline.
TEST(WaveSeabed, UnderModelledWaterAtLength) {
  Record record("seabed");
  const Json all = reference("ref3_wave_seabed");
  for (const Json& entry : all.at("cases"))
    for (const char* model : {"upB", "full"}) {
      WaveSeabed seabed = wave_seabed(entry, model);
      seabed.water = 1e-4 * seabed.wavelength / (2. * std::acos(-1.));
      record.at_most(title(entry) + ", " + model + ", under a layer of water" + what,
                     error(respond(seabed, mesh_for(seabed, 3)), entry.at("models").at(model)), 5e-3);
    }
}

/// Yamamoto et al. (1978): in a saturated half-space with incompressible water p = e^{-kz} and, in size, both the
/// effective stress and the shear stress are k z e^{-kz}, whatever the permeability.
TEST(WaveSeabed, YamamotosHalfSpace) {
  Record record("seabed");
  const Json all = reference("ref3_wave_seabed");
  for (const Json& entry : all.at("cases")) {
    if (!entry.at("case").at("H").is_null()) continue;
    WaveSeabed seabed = wave_seabed(entry, "qs");
    seabed.fluid.bulk_modulus = std::numeric_limits<double>::infinity();
    const SeabedResponse found = respond(seabed, mesh_for(seabed, 3));
    Profile pressure;
    std::vector<double> stress;
    for (const double z : seabed.depths) {
      const double kz = 2. * std::acos(-1.) / seabed.wavelength * z;
      pressure.push_back(std::exp(-kz));
      stress.push_back(kz * std::exp(-kz));
    }
    const double worst =
        std::max({error(found.pressure, pressure), largest_error(amplitudes(found.effective_stress), stress),
                  largest_error(amplitudes(found.shear_stress), stress)});
    record.at_most(
        "half-space, incompressible water, quasi-static (Yamamoto's closed form): p, effective and shear "
        "stress, each of its largest amplitude over the depth",
        worst, 5e-3);
  }
}

}  // namespace waves_test
}  // namespace upbead::test

// Claim: a model of soils is read from its file as it was made, and a file that is none is refused with all mistakes.
#include "output/soil_model_file.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <array>
#include <functional>
#include <utility>

#include "sample_model.h"
#include "sample_soils.h"

namespace upbead::test {

namespace soil_model_file_test {

const std::string again = "; make it again with 'upbead reduce --soils'";

std::string refusal(const std::string& path) {
  return refusal_by([](const std::string& file) { read_soil_model_file(file); }, path);
}

std::string refusal_after(const std::function<void(SoilModelFile&)>& change) {
  SoilModelFile model = two_soils();
  change(model);
  const TemporaryFile file(soil_model_file(model));
  return refusal(file.path());
}

TEST(SoilModelFile, ComesBack) {
  const SoilModelFile made = two_soils();
  const TemporaryFile file(soil_model_file(made));
  const SoilModelFile read = read_soil_model_file(file.path());
  EXPECT_EQ(soil_model_file(read), soil_model_file(made));
  ASSERT_EQ(read.box.size(), 2U);
  EXPECT_EQ(read.box[1].key, made.box[1].key);
  EXPECT_TRUE(read.box[0].logarithmic);
  EXPECT_EQ(read.regions_text, made.regions_text);
  EXPECT_EQ(read.frame.modes.pole, made.frame.modes.pole);
  EXPECT_EQ(read.family.names[1].text(), "probes/A/pressure");
  EXPECT_EQ(read.family.training.end, made.family.training.end);
  const std::vector<double> factors{3e7, 2e-5};
  const ReducedSystem a = read.family.reduced.at(factors), b = made.family.reduced.at(factors);
  EXPECT_EQ(a.M, b.M);
  EXPECT_EQ(a.C, b.C);
  EXPECT_EQ(a.K, b.K);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.acceleration, b.acceleration);
}

TEST(SoilModelFile, KeepsAFamilyThatSlips) {
  SoilModelFile made = two_soils();
  EXPECT_FALSE(read_soil_model_file(TemporaryFile(soil_model_file(made)).path()).family.reduced.slips());
  made.family.reduced.slip_loads = made.family.reduced.slip_readings = 1;
  for (Eigen::MatrixXd* loads : {&made.family.training.begin, &made.family.training.end}) *loads = loads->row(0).eval();
  const SoilModelFile read = read_soil_model_file(TemporaryFile(soil_model_file(made)).path());
  EXPECT_TRUE(read.family.reduced.slips());
  EXPECT_EQ(soil_model_file(read), soil_model_file(made));
  EXPECT_EQ(slipping_names(read.family).loads.size(), 2U);
  ASSERT_EQ(bonded_names(read.family).loads.size(), 1U);
  EXPECT_EQ(bonded_names(read.family).loads[0].name, "impact");
  EXPECT_EQ(bonded_names(read.family).readings.size(), 2U);
}

TEST(SoilModelFile, RefusesASlipWithoutCoordinate) {
  EXPECT_EQ(refusal_after([](SoilModelFile& m) {
              m.family.reduced.slip_loads = 2;
              m.family.reduced.slip_readings = 1;
            }),
            "m: /family has 2 loads and 1 readings of a slip, of 2 and 3" + again);
}

TEST(SoilModelFile, OfAFamilyAloneComesBackForWhatItWasMadeFor) {
  SoilFamilyFile made = two_soils().family;
  made.phi = {{3, 7}, Vector::Constant(2, 1e3), Eigen::Vector2d(0.6, 0.8), {2}};
  const TemporaryFile file(soil_family_file(made, "study 1"));
  EXPECT_FALSE(read_soil_family_file(file.path(), "study 2"));
  const auto read = read_soil_family_file(file.path(), "study 1");
  ASSERT_TRUE(read);
  EXPECT_EQ(soil_family_file(*read, "study 1"), soil_family_file(made, "study 1"));
  EXPECT_EQ(read->phi.vectors, made.phi.vectors);
  made.phi.coordinate = {0};
  EXPECT_THROW(read_soil_family_file(TemporaryFile(soil_family_file(made, "")).path(), ""), InputError)
      << "a displacement";
}

TEST(SoilModelFile, IsToldFromAReducedModel) {
  EXPECT_TRUE(
      std::holds_alternative<SoilModelFile>(read_any_model_file(TemporaryFile(soil_model_file(two_soils())).path())));
  const TemporaryFile reduced(model_file(oscillator()));
  EXPECT_TRUE(std::holds_alternative<ReducedModelFile>(read_any_model_file(reduced.path())));
  EXPECT_EQ(refusal(reduced.path()),
            "m: an HDF5 file, but no model of soils; give a model made by 'upbead reduce --soils'");
}

TEST(SoilModelFile, TellsAllMistakesOfTheBoxAtOnce) {
  EXPECT_EQ(refusal_after([](SoilModelFile& m) {
              std::swap(m.box[0].low, m.box[0].high);
              m.box[1].key = m.box[0].key;
            }),
            "m: /box goes from 1e+08 to 1e+07 in 'regions.sand.shear_modulus'" + again +
                "\nm: /box/key names 'regions.sand.shear_modulus' twice" + again);
}

TEST(SoilModelFile, RefusesAPartThatMakesEnergy) {
  EXPECT_EQ(refusal_after([](SoilModelFile& m) { m.family.reduced.parts[0].K *= -1.; }),
            "m: /family/part0 has a negative strain energy (K)" + again);
  EXPECT_EQ(refusal_after([](SoilModelFile& m) { m.family.reduced.parts[1].C *= -1.; }),
            "m: /family/part1 brings energy in (C)" + again);
  EXPECT_EQ(refusal_after([](SoilModelFile& m) { m.family.reduced.fixed.M *= -1.; }),
            "m: /family: the soil of point 0 has a negative kinetic energy (M)" + again);
}

TEST(SoilModelFile, DoesNotWriteWhatIsNotSymmetric) {
  SoilModelFile model = two_soils();
  model.family.reduced.fixed.C(0, 2) += 1e3;
  EXPECT_THROW(soil_model_file(model), std::logic_error);
}

TEST(SoilModelFile, RefusesTermsCoordinatesAndTimesThatDoNotFit) {
  EXPECT_EQ(refusal_after([](SoilModelFile& m) { m.family.terms[1] = m.family.terms[0]; }),
            "m: /family/term_region names a term twice: 'G' of 'sand'" + again);
  EXPECT_EQ(refusal_after([](SoilModelFile& m) { m.family.reduced.n_kept = 9; }),
            "m: /family keeps 9 coordinates, of which 0 are prescribed, of 3" + again);
  EXPECT_EQ(refusal_after([](SoilModelFile& m) { m.family.training.time[2] = 0.01; }),
            "m: /family/time does not ascend" + again);
  EXPECT_EQ(refusal_after([](SoilModelFile& m) { m.family.tolerance = 0.; }),
            "m: the attribute 'tolerance' of /family is 0" + again);
}

TEST(SoilModelFile, TakesNoMemoryForWhatIsNotThere) {
  const TemporaryFile file(soil_model_file(two_soils()));
  const hid_t id = H5Fopen(file.path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  for (const auto& [path, columns] : {std::pair("/family/is_phi", 0), std::pair("/family/load", 2)}) {
    H5Ldelete(id, path, H5P_DEFAULT);
    const std::array<hsize_t, 2> shape{200000, static_cast<hsize_t>(columns)};
    const hid_t space = H5Screate_simple(columns == 0 ? 1 : 2, shape.data(), nullptr);
    const hid_t data = H5Dcreate2(id, path, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const std::vector<double> zeros(400000);
    H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros.data());
    H5Dclose(data);
    H5Sclose(space);
  }
  H5Fclose(id);
  EXPECT_NE(refusal(file.path()).find("m: /family/is_phi has 200000 coordinates, more than 4000" + again),
            std::string::npos);
}

}  // namespace soil_model_file_test
}  // namespace upbead::test

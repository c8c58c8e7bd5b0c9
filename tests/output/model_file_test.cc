// Claim: a reduced model is read from its file bit by bit, and a file that is no complete model is refused with the
// missing part.
#include "upbead/output/model_file.h"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>
#include <limits>

#include "sample_model.h"

namespace upbead::test {

namespace model_file_test {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The messages without the path of the file.
std::string refusal(const std::string& path) {
  return refusal_by([](const std::string& file) { read_model_file(file); }, path);
}

/// The messages about the sample model after `damage` to its file.
std::string refusal_after(const std::function<void(hid_t)>& damage) {
  const TemporaryFile file(model_file(oscillator()));
  const hid_t id = H5Fopen(file.path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  damage(id);
  H5Fclose(id);
  return refusal(file.path());
}

void put(hid_t file, const char* dataset, double value) {
  const hid_t data = H5Dopen2(file, dataset, H5P_DEFAULT);
  const std::vector<double> values(static_cast<std::size_t>(H5Dget_storage_size(data)) / sizeof(double), value);
  H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(data);
}

/// Replaces a dataset by a list of `n` numbers, with values only if `written`.
void replace(hid_t file, const char* dataset, hsize_t n, bool written) {
  H5Ldelete(file, dataset, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(1, &n, nullptr);
  const hid_t data = H5Dcreate2(file, dataset, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const std::vector<double> values(written ? n : 0);
  if (written) H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(data);
  H5Sclose(space);
}

void put_attribute(hid_t file, const char* path, const char* name, double value) {
  const hid_t object = H5Oopen(file, path, H5P_DEFAULT), attribute = H5Aopen(object, name, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value);
  H5Aclose(attribute);
  H5Oclose(object);
}

TEST(ModelFile, ComesBackBitByBit) {
  const ReducedModelFile made = oscillator();
  const TemporaryFile file(model_file(made));
  const ReducedModelFile read = read_model_file(file.path());
  EXPECT_EQ(read.modes.pole, made.modes.pole);
  EXPECT_EQ(read.modes.load, made.modes.load);
  EXPECT_EQ(read.modes.reading, made.modes.reading);
  EXPECT_EQ(read.modes.feedthrough, made.modes.feedthrough);
  EXPECT_EQ(read.modes.impulse, made.modes.impulse);
  EXPECT_EQ(read.modes.load_name, made.modes.load_name);
  ASSERT_EQ(read.modes.reading_label.size(), 3U);
  EXPECT_EQ(read.modes.reading_label[2].description, "x_G");
  ASSERT_EQ(read.loads.size(), 2U);
  EXPECT_EQ(read.loads[1].unit, "N/m");
  EXPECT_EQ(read.loads[1].peak, 4e5);
  EXPECT_EQ(read.case_text, made.case_text);
  EXPECT_EQ(read.error_march, made.error_march);
  EXPECT_EQ(read.caisson_mass, made.caisson_mass);
  EXPECT_EQ(read.unknowns, made.unknowns);
  EXPECT_EQ(model_file(read), model_file(made));
}

TEST(ModelFile, KeepsTheWarningsOfItsScene) {
  ReducedModelFile made = oscillator();
  EXPECT_TRUE(read_model_file(TemporaryFile(model_file(made)).path()).warnings.empty());
  made.warnings = {{"harbour_level", 13., 15., "m", "still water", "give both levels", true},
                   {"mesh_too_coarse", std::numeric_limits<double>::infinity(), 4., "1", "cells", "", false}};
  const TemporaryFile file(model_file(made));
  const NumberedWarnings read = read_model_file(file.path()).warnings;
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].name, "harbour_level");
  EXPECT_EQ(read[0].value, 13.);
  EXPECT_EQ(read[0].limit, 15.);
  EXPECT_EQ(read[0].unit, "m");
  EXPECT_EQ(read[0].text(), made.warnings[0].text());
  EXPECT_TRUE(read[0].voids);
  EXPECT_FALSE(read[1].voids);
  EXPECT_EQ(read[1].text(), "cells");
}

TEST(ModelFile, KeepsWhatHoldsTheCaisson) {
  ReducedModelFile made = oscillator();
  EXPECT_FALSE(read_model_file(TemporaryFile(model_file(made)).path()).sliding);
  made.sliding = ModelSliding{0.6, 4.3e6, 1e4, "held", 0.25, 0.02};
  const TemporaryFile file(model_file(made));
  const ReducedModelFile read = read_model_file(file.path());
  ASSERT_TRUE(read.sliding);
  EXPECT_EQ(read.sliding->submerged_weight, 4.3e6);
  EXPECT_EQ(read.sliding->uplift, "held");
  EXPECT_EQ(model_file(read), model_file(made));
}

TEST(ModelFile, KeepsMomentsOfLoadsWhereAllAreKnown) {
  ReducedModelFile made = oscillator();
  EXPECT_FALSE(read_model_file(TemporaryFile(model_file(made)).path()).loads[0].moment);
  made.loads[0].moment = 8.;
  made.loads[1].moment = -3.5;
  const ReducedModelFile read = read_model_file(TemporaryFile(model_file(made)).path());
  EXPECT_EQ(read.loads[0].moment, 8.);
  EXPECT_EQ(read.loads[1].moment, -3.5);
}

TEST(ModelFile, KeepsStillWaterAtTwoLevelsInAFormatOfItsOwn) {
  ReducedModelFile made = oscillator();
  made.sliding = ModelSliding{0.6, 4.3e6, 1e4, "held", 0.25, 0.02};
  made.base = ModelBase{20., 4.3e6, 1e6, 0.5};
  made.still = StillWater{257e3, 1.1e6, 303e3};
  const TemporaryFile file(model_file(made));
  const ReducedModelFile read = read_model_file(file.path());
  ASSERT_TRUE(read.still && read.sliding && read.base);
  EXPECT_EQ(read.still->weight, 303e3);
  EXPECT_EQ(read.sliding->push, 257e3);  // W' has dW' already
  EXPECT_EQ(read.sliding->submerged_weight, 4.3e6);
  EXPECT_EQ(read.base->push, 257e3);
  EXPECT_EQ(read.base->push_moment, 1.1e6);
  EXPECT_EQ(model_file(read), model_file(made));
}

TEST(ModelFile, KeepsASlip) {
  ReducedModelFile made = oscillator();
  EXPECT_FALSE(read_model_file(TemporaryFile(model_file(made)).path()).slip);
  made.slip = slipping_oscillator();
  made.slip->system.is_phi[1] = true;
  for (Eigen::MatrixXd* matrix : {&made.slip->system.M, &made.slip->system.C, &made.slip->system.K})
    (*matrix)(1, 1) *= -1.;  // as in the rows of phi
  made.slip->system.prescribed[1] = 0;
  made.slip->system.n_prescribed = 1;
  const TemporaryFile file(model_file(made));
  const ReducedModelFile read = read_model_file(file.path());
  ASSERT_TRUE(read.slip);
  const ReducedSystem &found = read.slip->system, &system = made.slip->system;
  EXPECT_EQ(found.M, system.M);
  EXPECT_EQ(found.C, system.C);
  EXPECT_EQ(found.K, system.K);
  EXPECT_EQ(found.load, system.load);
  EXPECT_EQ(found.position, system.position);
  EXPECT_EQ(found.velocity, system.velocity);
  EXPECT_EQ(found.is_phi, system.is_phi);
  EXPECT_EQ(found.prescribed, system.prescribed);
  EXPECT_EQ(found.n_prescribed, 1);
  EXPECT_EQ(found.load_name, system.load_name);
  EXPECT_EQ(found.reading_label[2].name, "interface/slip_velocity");
  EXPECT_EQ(read.slip->glued_error, 0.002);
  EXPECT_EQ(model_file(read), model_file(made));
}

/// The messages about a model whose slip was changed before the file was written, so that the checksum is right.
std::string refusal_of_slip(const std::function<void(ReducedSystem&)>& change) {
  ReducedModelFile model = oscillator();
  model.slip = slipping_oscillator();
  change(model.slip->system);
  const TemporaryFile file(model_file(model));
  return refusal(file.path());
}

TEST(ModelFile, TellsWhatIsWrongWithASlip) {
  const std::string again = "; make it again with 'upbead reduce'";
  EXPECT_EQ(refusal_of_slip([](ReducedSystem&) {}), "");
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.prescribed[0] = 2; }), "m: /slip/prescribed holds 2" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.M.conservativeResize(2, 1); }),
            "m: /slip/M has the shape 2 x 1, not 2 x 2" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.load_name[2] = "F"; }),
            "m: /slip/load_name does not end with 'interface/friction'" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.reading_label[1].name = "s"; }),
            "m: /slip/readings/name does not name 'interface/slip'" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.reading_label[0].name = "N"; }),
            "m: /slip/readings/name does not name 'normal_force'" + again);
}

TEST(ModelFile, KeepsTheLargerModelsThatTellErrors) {
  ReducedModelFile made = oscillator();
  EXPECT_FALSE(read_model_file(TemporaryFile(model_file(made)).path()).nested) << "as files of older versions";
  made.nested = nested_oscillators(1.01, 1.02);
  const TemporaryFile file(model_file(made));
  const ReducedModelFile read = read_model_file(file.path());
  ASSERT_TRUE(read.nested);
  EXPECT_EQ(read.nested->middle.reading, made.nested->middle.reading);
  EXPECT_EQ(read.nested->reference.pole, made.nested->reference.pole);
  EXPECT_EQ(read.nested->reference.reading_label[0].name, "shear_force");
  EXPECT_EQ(read.nested->solves, 30);
  EXPECT_EQ(model_file(read), model_file(made));
  made.nested->middle.pole[1] = 1.;
  const TemporaryFile wrong(model_file(made));
  EXPECT_EQ(refusal(wrong.path()),
            "m: /nested/middle: mode 1 grows: Re of its pole is 1 1/s, and must not be above 0; make it again with "
            "'upbead reduce'");
}

TEST(ModelFile, NeedsNeitherModesNorAMarch) {
  ReducedModelFile made = oscillator();
  made.modes.pole.resize(0);
  made.modes.load.resize(0, 2);
  made.modes.reading.resize(3, 0);
  made.error_march.reset();
  const TemporaryFile file(model_file(made));
  EXPECT_EQ(read_model_file(file.path()).modes.n_modes(), 0);
  EXPECT_EQ(read_model_file(file.path()).error_march, std::nullopt);
}

TEST(ModelFile, IsNotWrittenWithNumbersThatAreNotFinite) {
  ReducedModelFile wrong_mode = oscillator(), wrong_error = oscillator();
  wrong_mode.modes.reading(1, 0) = not_a_number;
  wrong_error.error = std::numeric_limits<double>::infinity();
  EXPECT_THROW(model_file(wrong_mode), NumericsError);
  EXPECT_THROW(model_file(wrong_error), NumericsError);
}

TEST(ModelFile, RefusesOtherFiles) {
  EXPECT_EQ(refusal("/no/where.h5"), "cannot read '/no/where.h5'; check the path and the rights");
  const TemporaryFile text("time,P\n0,0\n");
  EXPECT_EQ(refusal(text.path()), "m: no HDF5 file; give a model made by 'upbead reduce'");
  const std::string whole = model_file(oscillator());
  const TemporaryFile half(whole.substr(0, whole.size() / 2));
  EXPECT_EQ(refusal(half.path()),
            "m: an HDF5 file that is not whole, or that another program writes to; wait until it has been written, or "
            "make it again");
}

TEST(ModelFile, RefusesOtherKindsAndVersions) {
  EXPECT_EQ(refusal_after([](hid_t file) { H5Adelete(file, "kind"); }),
            "m: an HDF5 file, but no reduced model; give a model made by 'upbead reduce'");
  EXPECT_EQ(
      refusal_after([](hid_t file) { put_attribute(file, "/", "format_version", 3.); }),
      "m: a reduced model in format 3; this program reads formats 1 and 2; make it again with 'upbead reduce' of the "
      "same version");
}

TEST(ModelFile, TellsEveryPartThatIsWrong) {
  const std::string again = "; make it again with 'upbead reduce'";
  EXPECT_EQ(refusal_after([](hid_t file) {
              H5Ldelete(file, "/modes/load", H5P_DEFAULT);
              H5Ldelete(file, "/readings/unit", H5P_DEFAULT);
              put(file, "/modes/impulse", not_a_number);
              H5Adelete_by_name(file, "/validity", "tolerance", H5P_DEFAULT);
              put_attribute(file, "/validity", "highest_frequency", 0.);
              put_attribute(file, "/case", "end", -1.);
            }),
            "m: the attribute 'end' of /case is -1" + again + "\nm: /readings/unit is missing, or holds no texts" +
                again + "\nm: /modes/load is missing, or cannot be read as numbers" + again +
                "\nm: /modes/impulse holds a number that is not finite" + again +
                "\nm: the attribute 'highest_frequency' of /validity is 0" + again +
                "\nm: the attribute 'tolerance' of /validity is missing" + again);
}

TEST(ModelFile, TellsShapesThatDoNotAgree) {
  ReducedModelFile model = oscillator();
  model.modes.impulse.setZero(3, 1);
  model.loads.pop_back();
  const TemporaryFile file(model_file(model));
  const std::string again = "; make it again with 'upbead reduce'";
  EXPECT_EQ(refusal(file.path()), "m: /modes/load has the shape 2 x 2 x 2, not 2 x 1 x 2" + again +
                                      "\nm: /modes/feedthrough has the shape 3 x 2, not 3 x 1" + again);
}

TEST(ModelFile, TakesNoMemoryForWhatIsNotThere) {
  const std::string again = "; make it again with 'upbead reduce'";
  EXPECT_EQ(refusal_after([](hid_t file) { replace(file, "/loads/peak", hsize_t{1} << 40, false); }),
            "m: /loads/peak is missing, or cannot be read as numbers" + again);
  // the length of one part determines the size of others
  ReducedModelFile model = oscillator();
  model.slip = slipping_oscillator();
  const TemporaryFile file(model_file(model));
  const hid_t id = H5Fopen(file.path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  replace(id, "/slip/is_phi", 200000, true);
  H5Fclose(id);
  EXPECT_EQ(refusal(file.path()), "m: /slip/M has the shape 2 x 2, not 200000 x 200000" + again);
}

TEST(ModelFile, RefusesNumbersThatNoQuantityCanBe) {
  EXPECT_EQ(refusal_after([](hid_t file) { put(file, "/modes/impulse", 1e200); }),
            "m: /modes/impulse holds a number that is larger than any quantity in SI units; make it again with "
            "'upbead reduce'");
}

TEST(ModelFile, RefusesWhatWasChangedBehindItsBack) {
  const std::string changed =
      "m: its checksum does not fit: numbers or texts were changed after 'upbead reduce' had written them; make it "
      "again "
      "with 'upbead reduce'";
  EXPECT_EQ(refusal_after([](hid_t file) { put(file, "/modes/feedthrough", -0.25); }), changed);
  EXPECT_EQ(refusal_after([](hid_t file) { put_attribute(file, "/case", "end", 2.5); }), changed);
  EXPECT_EQ(refusal_after([](hid_t file) {
              H5Lmove(file, "/modes/feedthrough", file, "/kept", H5P_DEFAULT, H5P_DEFAULT);
              H5Lmove(file, "/modes/impulse", file, "/modes/feedthrough", H5P_DEFAULT, H5P_DEFAULT);
              H5Lmove(file, "/kept", file, "/modes/impulse", H5P_DEFAULT, H5P_DEFAULT);
            }),
            changed);
  EXPECT_EQ(refusal_after([](hid_t) {}), "");
}

TEST(ModelFile, TakesAFileWithoutAChecksumAsOlderVersionsWroteThem) {
  EXPECT_EQ(refusal_after([](hid_t file) { H5Adelete(file, "checksum"); }), "");
  EXPECT_EQ(refusal_after([](hid_t file) {
              H5Adelete(file, "checksum");
              put(file, "/loads/peak", -1.);
            }),
            "m: /loads/peak holds -1; make it again with 'upbead reduce'\nm: /loads/peak holds -1; make it again with "
            "'upbead reduce'");
}

TEST(ModelFile, RefusesASlipThatMakesEnergy) {
  const std::string again = "; make it again with 'upbead reduce'";
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.M *= -1.; }),
            "m: /slip/M is not that of a kinetic energy: not symmetric, or negative" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.C *= -1.; }), "m: /slip/C brings energy in" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.K *= -1.; }),
            "m: /slip/K is not that of a strain energy: not symmetric, or negative" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.K(0, 1) *= 1.01; }),
            "m: /slip/K is not that of a strain energy: not symmetric, or negative" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.n_prescribed = 1; }),
            "m: /slip/prescribed does not fit its n_prescribed, 1" + again);
  EXPECT_EQ(refusal_of_slip([](ReducedSystem& s) { s.prescribed[0] = 1; }),
            "m: /slip/prescribed does not fit its n_prescribed, 0" + again);
}

TEST(ModelFile, RefusesAModeThatGrows) {
  ReducedModelFile model = oscillator();
  model.modes.pole[1] = {0.1, 200.};
  const TemporaryFile file(model_file(model));
  EXPECT_EQ(refusal(file.path()),
            "m: mode 1 grows: Re of its pole is 0.1 1/s, and must not be above 0; make it again with 'upbead reduce'");
}

}  // namespace model_file_test
}  // namespace upbead::test

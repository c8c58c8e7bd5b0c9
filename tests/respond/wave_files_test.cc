// Claim: waves are read from CSV and HDF5 in all usual forms; a wave that does not fit the model is reported with
// file, line and name.
#include "respond/wave_files.h"

#include <hdf5.h>

#include <cmath>

#include "good_case.h"
#include "upbead/base/error.h"

namespace upbead::test {

namespace wave_files_test {

struct Dataset {
  std::string name;
  std::vector<hsize_t> shape;
  std::vector<double> values;
};

void write_hdf5(const std::string& path, const std::vector<Dataset>& datasets) {
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  for (const Dataset& set : datasets) {
    const hid_t space = H5Screate_simple(static_cast<int>(set.shape.size()), set.shape.data(), nullptr);
    const hid_t data = H5Dcreate2(file, set.name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, set.values.data());
    H5Dclose(data);
    H5Sclose(space);
  }
  H5Fclose(file);
}

const std::vector<std::string> two_loads{"impact", "slow"}, one_load{"impact"};

std::string refusal(const std::vector<std::string>& paths, const std::vector<std::string>& loads = two_loads) {
  try {
    read_wave_files(paths, loads);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class WaveFiles : public InFolder {
 protected:
  static std::string refusal_of_csv(const std::string& text, const std::vector<std::string>& loads = two_loads) {
    write("w.csv", text);
    return refusal({"w.csv"}, loads);
  }

  static std::string refusal_of_hdf5(const std::vector<Dataset>& datasets) {
    write_hdf5("w.h5", datasets);
    return refusal({"w.h5"});
  }
};

TEST_F(WaveFiles, CsvColumnsAreLoadsByName) {
  write("w.csv", "t,slow,impact\n0.5,1,2\n0.75,3,4\n");
  const WaveFile file = read_wave_files({"w.csv"}, two_loads).front();
  EXPECT_EQ(file.name, "w");
  EXPECT_EQ(file.time, (std::vector<double>{0.5, 0.75}));
  ASSERT_EQ(file.n_waves(), 1);
  EXPECT_EQ(file.value, (WaveSamples(2, 2) << 2., 4., 1., 3.).finished());
}

TEST_F(WaveFiles, LoadsThatAreNotGivenAreZero) {
  write("w.csv", "t,slow\n0,1\n1,2\n");
  EXPECT_EQ(read_wave_files({"w.csv"}, two_loads).front().value, (WaveSamples(2, 2) << 0., 0., 1., 2.).finished());
}

TEST_F(WaveFiles, TheOnlyLoadNeedsNoName) {
  write("w.csv", "t,whatever\n0,1\n1,2\n");
  EXPECT_EQ(read_wave_files({"w.csv"}, one_load).front().value, (WaveSamples(1, 2) << 1., 2.).finished());
}

TEST_F(WaveFiles, Hdf5HoldsManyWaves) {
  write_hdf5("w.h5", {{"time", {2}, {0., 1.}}, {"impact", {3, 2}, {1., 2., 3., 4., 5., 6.}}, {"slow", {2}, {7., 8.}}});
  const WaveFile file = read_wave_files({"w.h5"}, two_loads).front();
  ASSERT_EQ(file.n_waves(), 3);
  EXPECT_EQ(WaveSamples(file.wave(1)), (WaveSamples(2, 2) << 3., 4., 7., 8.).finished());
  EXPECT_EQ(WaveSamples(file.wave(2)), (WaveSamples(2, 2) << 5., 6., 7., 8.).finished());
}

TEST_F(WaveFiles, UnitsOfTheHeaderCount) {
  write("w.csv", "Part;Time [ms];slow [kPa];impact [kN/m]\n0;0;1;2\n1;250;3;4\n");
  const WaveFile file = read_wave_files({"w.csv"}, two_loads, {"N/m", "Pa"}).front();
  EXPECT_EQ(file.time, (std::vector<double>{0., 0.25}));
  EXPECT_EQ(file.value, (WaveSamples(2, 2) << 2e3, 4e3, 1e3, 3e3).finished());
  ASSERT_EQ(file.notes.left_out.size(), 1U);
  EXPECT_EQ(file.notes.left_out[0].what, "column 'Part' of w.csv");
  EXPECT_EQ(refusal_of_csv("t,slow (mm)\n0,1\n1,2\n"),
            "w.csv:1:1: the unit 'mm' of column 'slow' is none of the load, N/m or Pa; write one of N/m, kN/m, MN/m, "
            "N/cm, N/mm, gf/cm, kgf/cm, kgf/m, tf/m");
}

/// Two waves of a triangle, of which rows, or the signal of one, are lost.
TEST_F(WaveFiles, WhatIsLostIsTold) {
  std::vector<double> time, one, both;
  for (int i = 0; i < 100; ++i) {
    if (i > 40 && i < 60) continue;
    time.push_back(0.01 * i);
    one.push_back(std::max(0., 1. - std::abs(0.01 * i - 0.45) / 0.3));
  }
  for (int wave = 0; wave < 2; ++wave) both.insert(both.end(), one.begin(), one.end());
  write_hdf5("w.h5", {{"time", {time.size()}, time}, {"impact", {2, time.size()}, both}});
  const NumberedWarnings list = read_wave_files({"w.h5"}, one_load).front().notes.warnings;
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list.front().name, "record_gap");
  EXPECT_NE(list.front().what.find("1 more of its waves"), std::string::npos) << list.front().what;
  std::string rows = "t,impact\n";
  for (int i = 0; i < 100; ++i)
    rows += std::to_string(0.01 * i) + "," +
            std::to_string(i > 35 && i < 45 ? 0. : std::max(0., 1. - std::abs(0.01 * i - 0.45) / 0.3)) + "\n";
  write("d.csv", rows);
  EXPECT_EQ(read_wave_files({"d.csv"}, one_load).front().notes.warnings.front().name, "record_dropout");
}

/// As of a history of a run: one that begins in the middle, is clipped, or stops at its peak while the answer goes on.
TEST_F(WaveFiles, RecordsAreLookedAtAsThoseOfARun) {
  const auto told = [](double from, double to, double most) {
    std::string rows = "t,impact\n";
    for (int i = 0; i * 0.005 < to - from; ++i)
      rows += std::to_string(0.005 * i) + "," +
              std::to_string(std::min(most, std::max(0., std::sin(3. * (from + 0.005 * i - 0.2))))) + "\n";
    write("w.csv", rows);
    std::vector<std::string> names;
    const WaveFile file = read_wave_files({"w.csv"}, two_loads, {}, 4.).front();
    for (const NumberedWarning& warning : file.notes.warnings)
      if (warning.voids) names.push_back(warning.name);
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(told(0., 1.3, 2.), Names());
  EXPECT_EQ(told(0.7, 1.3, 2.), Names{"record_begun"});
  EXPECT_EQ(told(0., 1.3, 0.9), Names{"record_saturated"});
  EXPECT_EQ(told(0., 0.72, 2.), Names{"record_cut"});
}

TEST_F(WaveFiles, EqualNamesAreNumbered) {
  std::filesystem::create_directory("a");
  for (const char* path : {"w.csv", "a/w.csv", "v.csv"}) write(path, "t,p\n0,1\n1,2\n");
  const std::vector<WaveFile> files = read_wave_files({"w.csv", "a/w.csv", "v.csv", "w.csv"}, one_load);
  std::vector<std::string> names;
  for (const WaveFile& file : files) names.push_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"w", "w-2", "v", "w-3"}));
}

TEST_F(WaveFiles, TellsWrongColumns) {
  EXPECT_EQ(refusal_of_csv("t,impct\n0,1\n1,2\n"),
            "w.csv:1:1: column 'impct' is no load of the model; did you mean 'impact'? the model's loads are: impact, "
            "slow");
  EXPECT_EQ(refusal_of_csv("t,p\n0,1\n1,2\n"),
            "w.csv:1:1: column 'p' is no load of the model; the model's loads are: impact, slow");
  EXPECT_EQ(refusal_of_csv("t,a,b\n0,1,2\n1,2,3\n", one_load),
            "w.csv:1:1: column 'a' is no load of the model; the model's loads are: impact\n"
            "w.csv:1:1: column 'b' is no load of the model; the model's loads are: impact");
  EXPECT_EQ(refusal_of_csv("t,slow,slow\n0,1,2\n1,2,3\n"),
            "w.csv:1:1: two columns are called 'slow'; give each load once");
  EXPECT_EQ(refusal_of_csv("impact,slow\n0,1\n1,2\n"),
            "w.csv:1:1: the first column is the load 'impact', not the time; begin with a column of times (s)");
  EXPECT_EQ(refusal_of_csv("t\n0\n1\n"), "w.csv:1:1: a wave without a load; give a time (s) and a load in every row");
}

TEST_F(WaveFiles, TellsWrongTimes) {
  EXPECT_EQ(refusal_of_csv("t,slow\n0,1\n"), "w.csv:2:1: a wave of one time; give two times or more");
  EXPECT_EQ(refusal_of_csv("t,slow\n-0.1,1\n0,1\n"),
            "w.csv:2:1: the wave starts at t = -0.1 s, before the response; let it start at 0 or later");
  EXPECT_EQ(refusal_of_csv("t,slow\n0,1\n\n0.2,1\n0.2,1\n"),
            "w.csv:5:1: t = 0.2 s does not follow t = 0.2 s; let the times ascend strictly");
  EXPECT_EQ(refusal_of_hdf5({{"time", {3}, {0., 2., 1.}}, {"slow", {3}, {0., 0., 0.}}}),
            "w.h5: /time[2]: t = 1 s does not follow t = 2 s; let the times ascend strictly");
}

TEST_F(WaveFiles, TellsWrongDatasets) {
  const Dataset time{"time", {2}, {0., 1.}};
  EXPECT_EQ(refusal_of_hdf5({{"slow", {2}, {0., 1.}}}), "w.h5: no dataset /time with one time (s) a sample; add it");
  EXPECT_EQ(refusal_of_hdf5({time}),
            "w.h5: a file without a load; add a dataset named like a load of the model: impact, slow");
  EXPECT_EQ(refusal_of_hdf5({time, {"Slow", {2}, {0., 1.}}, {"impact", {3}, {0., 1., 2.}}}),
            "w.h5: dataset 'Slow' is no load of the model; did you mean 'slow'? the model's loads are: impact, slow\n"
            "w.h5: /impact has the shape 3; give it the length of /time, 2, or waves x that length");
  EXPECT_EQ(refusal_of_hdf5({time, {"impact", {1, 2}, {0., 1.}}, {"slow", {2, 2}, {0., 1., 2., 3.}}}),
            "w.h5: /slow has 2 waves, /impact has 1; give every load of the file as many waves");
  EXPECT_EQ(refusal_of_hdf5({time, {"impact", {2}, {0., INFINITY}}}),
            "w.h5: /impact holds a number that is not finite; give finite numbers");
  EXPECT_EQ(refusal_of_hdf5({time, {"impact", {2}, {0., -1e300}}}),
            "w.h5: /impact holds a number that is larger than any quantity in SI units; give finite numbers");
}

TEST_F(WaveFiles, TellsTheMistakesOfAllFiles) {
  write("empty.csv", "");
  write("text.h5", "hello");
  EXPECT_EQ(refusal({"empty.csv", "none.csv", "none.h5", "text.h5"}),
            "empty.csv: an empty file; write a header line and rows of numbers\n"
            "cannot read 'none.csv'; check the path and the rights\n"
            "cannot read 'none.h5'; check the path and the rights\n"
            "text.h5: no HDF5 file; give a file with the datasets time and impact or slow");
}

}  // namespace wave_files_test
}  // namespace upbead::test

// Claim: results.h5 holds its histories with unit and description, and never a number that is not finite.
#include "output/result_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "output/hdf5_reader.h"
#include "sample_model.h"

namespace upbead::test {
namespace result_file_test {

TEST(ResultFile, HoldsHistories) {
  const TemporaryFile file(
      dataset_file("title", {{"history/time", "s", "time", {0., 1.}}, {"history/caisson/x", "m", "x_G", {0., 0.1}}}));
  const Hdf5Reader reader(file.path(), "a result");
  EXPECT_EQ(reader.text_attribute("/", "title"), "title");
  EXPECT_EQ(reader.text_attribute("/", "program").value_or("").substr(0, 7), "upbead ");
  EXPECT_EQ(reader.numbers("/history/time")->values, (std::vector<double>{0., 1.}));
  EXPECT_EQ(reader.numbers("/history/caisson/x")->values, (std::vector<double>{0., 0.1}));
  EXPECT_EQ(reader.text_attribute("/history/caisson/x", "unit"), "m");
  EXPECT_EQ(reader.text_attribute("/history/caisson/x", "description"), "x_G");
}

TEST(ResultFile, RefusesWhatIsNotFinite) {
  try {
    dataset_file("title", {{"history/force", "N/m", "P", {0., std::numeric_limits<double>::quiet_NaN()}}});
    FAIL() << "written";
  } catch (const NumericsError& error) {
    EXPECT_STREQ(error.what(), "'/history/force' holds a number that is not finite; nothing was written");
  }
}

}  // namespace result_file_test
}  // namespace upbead::test

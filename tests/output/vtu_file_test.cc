// Claims: an array in a VTU file follows VTK's format and is complete, whether it is smaller or larger than a block;
// numbers are read back to the last bit; the file declares the offset of each array.
#include "output/vtu_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <regex>
#include <sstream>

namespace upbead::test {
namespace vtu_file_test {

constexpr std::size_t block = std::size_t{1} << 20;  // bytes

std::uint32_t size_at(const std::string& bytes, std::size_t index) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + index * sizeof number, sizeof number);
  return number;
}

/// Reads an array according to the format, by zlib; `used`: number of bytes that belong to it.
std::string inflated(const std::string& bytes, std::size_t* used = nullptr) {
  const std::size_t n = size_at(bytes, 0), size = size_at(bytes, 1), last = size_at(bytes, 2);
  std::size_t place = (3 + n) * sizeof(std::uint32_t);
  std::string values;
  for (std::size_t i = 0; i < n; ++i) {
    std::string whole(i + 1 == n && last > 0 ? last : size, '\0');
    auto length = static_cast<uLongf>(whole.size());
    const auto* data = reinterpret_cast<const Bytef*>(bytes.data() + place);
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(whole.data()), &length, data, size_at(bytes, 3 + i)), Z_OK);
    EXPECT_EQ(length, whole.size());
    values += whole;
    place += size_at(bytes, 3 + i);
  }
  if (used) *used = place;
  return values;
}

std::vector<float> numbers(std::size_t n) {
  std::vector<float> values;
  for (std::size_t i = 0; i < n; ++i) values.push_back(i % 3 == 2 ? 0.F : static_cast<float>(std::sin(i * i * 0.1)));
  return values;
}

TEST(VtuFile, ArraysComeBackWhole) {
  for (const std::size_t n :
       {std::size_t{0}, std::size_t{1}, std::size_t{1000}, block / 4 - 1, block / 4, block / 4 + 1, 3 * block / 4}) {
    const std::vector<float> values = numbers(n);
    const Packing packing = n % 2 == 0 ? Packing::of_fields : Packing::of_grid;
    const VtuArray array = vtu_array("u", 1, values, packing);
    EXPECT_EQ(array.type, "Float32");
    std::size_t used = 0;
    const std::string found = inflated(array.bytes, &used);
    EXPECT_EQ(used, array.bytes.size());
    ASSERT_EQ(found.size(), n * sizeof(float));
    EXPECT_EQ(std::memcmp(found.data(), values.data(), found.size()), 0) << n;
  }
  EXPECT_LT(vtu_array("u", 1, std::vector<float>(block), Packing::of_fields).bytes.size(), block / 50)
      << "zeros take no room";
}

TEST(VtuFile, DeclaresWhereArraysLie) {
  const VtuGrid grid{
      4,
      1,
      vtu_array("points", 3, std::vector<float>{0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F},
                Packing::of_grid),
      vtu_array("connectivity", 1, std::vector<int>{0, 1, 2, 3}, Packing::of_grid),
      vtu_array("offsets", 1, std::vector<int>{4}, Packing::of_grid),
      vtu_array("types", 1, std::vector<unsigned char>{9}, Packing::of_grid)};
  const std::vector<float> p{1.F, 2.F, 3.F, 4.F};
  std::ostringstream out;
  write_vtu(out, grid, {vtu_array("p_(Pa)", 1, p, Packing::of_fields)});
  const std::string text = out.str(), mark = "<AppendedData encoding=\"raw\">\n_";
  const std::string appended = text.substr(text.find(mark) + mark.size());
  std::smatch found;
  ASSERT_TRUE(std::regex_search(text, found,
                                std::regex("Float32\" Name=\"p_\\(Pa\\)\" NumberOfComponents=\"1\" "
                                           "format=\"appended\" offset=\"([0-9]+)\"")));
  const std::string values = inflated(appended.substr(std::stoul(found[1])));
  ASSERT_EQ(values.size(), p.size() * sizeof(float));
  EXPECT_EQ(std::memcmp(values.data(), p.data(), values.size()), 0);
  EXPECT_NE(text.find("NumberOfPoints=\"4\" NumberOfCells=\"1\""), std::string::npos);
}

TEST(VtuFile, NamesTheRegionsOfCells) {
  const VtuArray none = vtu_array("points", 3, std::vector<float>{}, Packing::of_grid);
  const std::vector<int> regions{1, 0, 1};
  const VtuGrid grid{0, 3, none, none, none, none, vtu_array("region", 1, regions, Packing::of_grid), {"sand", "a<b"}};
  std::ostringstream out;
  write_vtu(out, grid, {});
  const std::string text = out.str();
  std::smatch found;
  ASSERT_TRUE(std::regex_search(
      text, found, std::regex("<CellData>\n<DataArray type=\"Int32\" Name=\"region\"[^>]*offset=\"([0-9]+)\"")));
  const std::string mark = "<AppendedData encoding=\"raw\">\n_";
  const std::string values = inflated(text.substr(text.find(mark) + mark.size() + std::stoul(found[1])));
  ASSERT_EQ(values.size(), regions.size() * sizeof(int));
  EXPECT_EQ(std::memcmp(values.data(), regions.data(), values.size()), 0);
  EXPECT_NE(text.find("Name=\"region_names\" NumberOfTuples=\"2\" format=\"ascii\">\n"
                      "115 97 110 100 0\n97 60 98 0\n</DataArray>"),
            std::string::npos);
}

/// Coordinates of a survey need more digits than single precision has.
TEST(VtuFile, KeepsPointsInDoublePrecision) {
  const std::vector<double> values{441871.65, 6329700.75, 441871.7};
  const VtuArray array = vtu_array("points", 3, values, Packing::of_grid);
  EXPECT_EQ(array.type, "Float64");
  const std::string found = inflated(array.bytes);
  ASSERT_EQ(found.size(), values.size() * sizeof(double));
  EXPECT_EQ(std::memcmp(found.data(), values.data(), found.size()), 0);
}

}  // namespace vtu_file_test
}  // namespace upbead::test

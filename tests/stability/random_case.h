// Random case files over the whole range of physics.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace upbead::test {

/// A case file, and the values drawn for it by name, as texts of a table.
struct RandomCase {
  std::string toml;
  std::vector<std::pair<std::string, std::string>> facts;
};

/// The case with that number of the stream `seed`; `section_geo` is the path of section.geo as the case names it.
///
/// Numbers are log-uniform, with each end taken by 7 %: k 1e-10 to 1e3 m/s, G 1e4 to 1e11 Pa with a contrast of up to
/// 1e6, K_f 1e5 Pa to infinity, nu 0 to 0.4999, steps 1e-7 to 10 s, pulses from 1 ms or a part of the computed time
/// to static, water 0.1 to 50 m deep, cells bent and up to 100 times as long as high; every kind of region, flow,
/// boundary, load and scheme. A few cases contradict themselves: the program must report that.
RandomCase random_case(std::uint64_t seed, std::uint64_t number, const std::string& section_geo);

}  // namespace upbead::test

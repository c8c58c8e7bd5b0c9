// Forces of OpenFOAM with rows cut, heads at any row, with or without a porous part: they are refused, or give exactly
// the numbers of their rows. What nothing is wrong with is read whole.
#include <array>
#include <map>

#include "bytes.h"
#include "case/cfd/flow_record.h"
#include "target.h"

namespace upbead::fuzz {

namespace {

using Numbers = std::array<double, 6>;  ///< force and moment

/// Writes forces.dat, and keeps what its rows say.
class ForcesText {
 public:
  explicit ForcesText(std::string_view input) : bytes_(input) {
    n_parts_ = bytes_.one_in(2) ? 3 : 2;
    add_head();
    for (int n = 1 + bytes_.below(20); n > 0; --n) {
      const int choice = bytes_.below(16);
      if (choice == 0) add_head();
      if (choice == 1) add_bad_head();
      if (choice == 2) text += "# a comment\n";
      if (choice == 3) time_ -= 2.5, flawed = true;
      add_row(choice == 4);
    }
  }

  std::string text;
  std::map<double, Numbers> rows;
  bool flawed = false;  ///< something is wrong, so that it may be refused

 private:
  static std::string parts(int n) { return n == 3 ? "pressure viscous porous" : "pressure viscous"; }

  void add_head() { add_head(n_parts_, "(1 2 3)"); }
  void add_head(int n_parts, const std::string& centre) {
    text += "# Forces\n# CofR : " + centre + "\n# Time forces(" + parts(n_parts) + ") moment(" + parts(n_parts) + ")\n";
  }

  /// Another head, or one that lacks a line.
  void add_bad_head() {
    flawed = true;
    const int choice = bytes_.below(4);
    if (choice == 0) add_head(5 - n_parts_, "(1 2 3)");
    if (choice == 1) add_head(n_parts_, "(1 2 4)");
    if (choice == 2) text += "# Time forces(" + parts(n_parts_) + ") moment(" + parts(n_parts_) + ")\n";
    if (choice == 3) text += "# CofR : (1 2 3)\n";
  }

  void add_row(bool cut) {
    time_ += 1.;
    std::string line = std::to_string(time_);
    Numbers sums{};
    for (std::size_t of = 0; of < 2; ++of) {
      line += " (";
      for (int part = 0; part < n_parts_; ++part) {
        line += part == 0 ? "(" : " (";
        for (std::size_t i = 0; i < 3; ++i) {
          const int number = bytes_.below(200) - 100;
          sums[3 * of + i] += number;
          line += (i == 0 ? "" : " ") + std::to_string(number);
        }
        line += ")";
      }
      line += ")";
    }
    rows[time_] = sums;
    if (cut) {
      flawed = true;
      line.resize(static_cast<std::size_t>(bytes_.below(256)) % line.size());
    }
    text += line + "\n";
  }

  Bytes bytes_;
  int n_parts_ = 2;
  double time_ = 0.;
};

void check(const FlowRecord& record, const ForcesText& file) {
  require(record.forces && record.forces->force.size() == record.time().size() &&
              record.forces->moment.size() == record.time().size(),
          "forces and moments at every time");
  for (std::size_t i = 0; i < record.time().size(); ++i) {
    const auto row = file.rows.find(record.time()[i]);
    require(row != file.rows.end(), "every time is that of a row");
    const auto &force = record.forces->force[i], &moment = record.forces->moment[i];
    require(row->second == Numbers{force[0], force[1], force[2], moment[0], moment[1], moment[2]},
            "the numbers are those of the row");
  }
}

}  // namespace

void try_forces(std::string_view input) {
  const ForcesText file(input);
  const std::string path = memory_file("forces.dat", file.text);
  FlowRecord record;
  const bool accepted = read_or_refuse([&] { record = read_flow(path, "", {"case.toml", 1, 1}); });
  if (accepted) check(record, file);
  if (!file.flawed) require(accepted && record.time().size() == file.rows.size(), "a sound file is read whole");
}

}  // namespace upbead::fuzz

// Fields of a run at the times that the case asks for.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "output/fields.h"
#include "upbead/run/simulation.h"

namespace upbead {

class FieldOutput : public MarchObserver {
 public:
  /// Nothing is written where the case asks for none, and then `folder` may be null. It must outlive this.
  FieldOutput(const std::optional<double>& every, const OutputFolder* folder) : every_(every), folder_(folder) {}

  /// Of the scene that will be marched, which must outlive this.
  MarchObserver* begin(const Simulation& simulation);
  /// Writes where it is time.
  void see(const State& state, int step, int n_steps) override;
  void finish() const;
  double seconds() const { return seconds_; }  ///< that writing has taken

  /// Times (s) and names, relative to the folder, of the files so far.
  std::vector<std::pair<double, std::string>> written() const;
  /// Takes files over from another folder, as if they had been written here.
  void take_over(const std::string& from, const std::vector<std::pair<double, std::string>>& written);
  /// Lays the files so far that are not there yet into another folder.
  void lay_into(const std::string& other) const;

 private:
  std::optional<double> every_;
  std::optional<FieldWriter> writer_;
  std::vector<std::pair<double, std::string>> taken_over_;
  const OutputFolder* folder_;
  double seconds_ = 0.;
};

}  // namespace upbead

#include "schedule.h"

#include <algorithm>
#include <tuple>

namespace upbead {

namespace {

/// How alike runs are: those that are equal in `mesh` share a mesh, in `solved` a solution.
struct Likeness {
  int case_index;
  std::vector<Setting> mesh, solved;
  int run;

  bool operator<(const Likeness& other) const {
    return std::tie(case_index, mesh, solved, run) < std::tie(other.case_index, other.mesh, other.solved, other.run);
  }
};

Likeness likeness_of(const StudyRun& run, int number) {
  Likeness likeness{run.case_index, {}, {}, number};
  for (const Setting& setting : run.settings) {
    if (setting.first.rfind("mesh", 0) == 0)
      likeness.mesh.push_back(setting);
    else if (setting.first.rfind("sliding", 0) != 0)
      likeness.solved.push_back(setting);
  }
  return likeness;
}

}  // namespace

std::vector<std::vector<int>> schedule(const Study& study, const Results& results) {
  std::vector<Likeness> places;
  for (std::size_t i = 0; i < study.runs.size(); ++i)
    if (!results[i]) places.push_back(likeness_of(study.runs[i], static_cast<int>(i)));
  std::sort(places.begin(), places.end());
  std::vector<std::vector<int>> pieces;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool alike = i > 0 && std::tie(places[i].case_index, places[i].mesh, places[i].solved) ==
                                    std::tie(places[i - 1].case_index, places[i - 1].mesh, places[i - 1].solved);
    if (!alike) pieces.emplace_back();
    pieces.back().push_back(places[i].run);
  }
  return pieces;
}

}  // namespace upbead

// Families of soils that the runs of a study share: one model for many runs that differ in their soils.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/soil_model_file.h"
#include "study/study.h"
#include "upbead/case/case.h"
#include "upbead/run/simulation.h"

namespace upbead {

/// Fewer different soils than these cost less when each is solved: docs/soils.md.
constexpr std::size_t least_soils = 24;

/// Whether a dotted key is one of a region.
bool is_of_region(const std::string& key);

/// Numbers of runs that one model may answer: of one case, with the same settings but for those of soils, loads,
/// sliding and limits, and of at least least_soils different soils; none where the study does not share soils.
std::vector<std::vector<int>> soil_groups(const Study& study);

/// Makes the families of such groups as far as they have runs among `pieces`, and writes them into the study's folder:
/// journal/soils-GROUP.h5, or journal/soils-GROUP.txt with the reason where there can be none. To be called before
/// any process asks for members. A family or reason that is there already is kept, so that a study that goes on where
/// it stopped has the same; processes that make one at once make equal ones, as it follows from the study alone.
/// `progress`: 0 to 1. Throws InputError where the folder cannot be written to.
void make_soil_families(const Study& study, const std::vector<std::vector<int>>& pieces, const std::string& folder,
                        bool trusts_scripts, const std::function<void(double)>& progress);

/// A family as that function has left it.
struct SoilFamilyRead {
  std::optional<SoilFamilyFile> family;
  std::string why_not;    ///< why there is none
  bool was_tried = true;  ///< false: its files are missing, damaged or of another study
};
SoilFamilyRead read_soil_family(const Study& study, std::size_t group, const std::string& folder);

/// The first run of the group, to which all others are compared, with all cells. `mesh`: null where it is to be read.
Simulation first_of_soils(const Study& study, const std::vector<int>& group, const std::shared_ptr<const Mesh>& mesh);

}  // namespace upbead

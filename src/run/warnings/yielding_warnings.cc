#include "run/warnings/yielding_warnings.h"

#include "base/text.h"

namespace upbead {

namespace {

/// Beyond this strain the geometry of the small-strain equations errs by as much as results may, some percent.
constexpr double large_strain = 0.05;
/// slip_line: strain of a cell over that of the cells beside it, a choice; a smooth strain reaches 2 or 3 on coarse
/// cells. least_strain: below a tenth of a percent no result depends on one cell.
constexpr double slip_line = 3., least_strain = 1e-3;

std::string where(const PeakStrain& peak) {
  return "at " + place_text(peak.at);
}

}  // namespace

NumberedWarnings yielding_warnings(const Summary& summary) {
  NumberedWarnings list;
  if (!summary.nonlinear) return list;
  const PeakStrain& peak = summary.nonlinear->peak_strain;
  if (peak.value > large_strain)
    list.push_back(
        {"large_strain", peak.value, large_strain, "1",
         "the soil shears by " + significant(100. * peak.value) + " % " + where(peak) +
             ": the equations assume small strains and undeformed ground, so that residual displacements may err by "
             "about that percentage, and a slope or base that fails may seem to hold or move too far"});
  if (peak.value > least_strain && peak.over_neighbours && *peak.over_neighbours > slip_line)
    list.push_back(
        {"slip_line", *peak.over_neighbours, slip_line, "1",
         "the cell " + where(peak) + " shears by " + significant(100. * peak.value) + " %, " +
             significant(*peak.over_neighbours) +
             " times as much as those beside it: the soil slides along a line as narrow as the cells, and this strain "
             "depends on their size; run with mesh.refine = 1 and see whether the numbers that you need change"});
  return list;
}

}  // namespace upbead

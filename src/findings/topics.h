// What findings ask of each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "findings/finding.h"
#include "upbead/sliding/base_pressure.h"

namespace upbead {

/// The caisson that slips as a whole, or why its slip is not known.
struct SlipAsWhole {
  std::optional<CoupledSummary> coupled;
  std::string why_not;
  bool failed = false;  ///< whether the numerics failed; false: the scene does not allow it
};

/// F_T, P and the motion of the caisson; none without one.
std::optional<ShearResponse> find_shear(const Solution& solution);
/// The factor by which the strength may fall at rest, where the scene asks for it, and where its soil has no rest.
std::optional<SafetySummary> find_safety(const Solution& solution);
/// The bonded caisson, whose F_T the formulas of sliding take, also where friction was followed node by node.
const Solution& bonded_of(const Evidence& e);
/// S by formulas on F_T(t), without its error; none without [sliding].
std::optional<SlidingSummary> find_slid(const Evidence& e);
SlipAsWhole find_slip_as_whole(const Evidence& e);
/// All readings in the rows of /history.
HistoryRows find_history(const Evidence& e);
/// The effective load of the caisson on the ground in these rows; none where W' is not known.
std::optional<EffectiveBase> find_effective_base(const Evidence& e);
std::optional<ResidualSummary> find_residual(const Evidence& e);
std::optional<ContactSummary> find_contact(const Evidence& e);
/// Why the ground cannot be at rest; "" where it can, or where that is not known.
std::string find_why_void(const Evidence& e);

/// F_T in the rows of /history.
std::vector<double> shear_of(const Evidence& e);
/// Slip circles under the caisson, and why there are none.
std::optional<SlipCircles> find_circles(const Evidence& e);
std::string find_why_no_circles(const Evidence& e);

/// S by friction node by node.
DesignSliding design_by_nodes(const ContactSummary& contact);
/// Whether the response is that of a caisson whose friction was followed node by node; else it is bonded.
bool is_solved_with_friction(const Summary& summary);
/// For assumptions of checks: how the uplift is taken.
std::string about_uplift(const Scene& scene);
/// Whether a boundary's motion drives the scene: then F_T goes both ways without a trough, and nothing of it acts at
/// rest.
bool is_shaken(const Scene& scene);

/// Of a factor by strength reduction that is at least its limit, 'limits.KEY'. Warnings strength_missing: soil without
/// a strength cannot fail in it; coarse_factor: it exceeds the limit by no more than what coarse cells may add.
NumberedWarnings reduction_warnings(const Simulation& simulation, const std::string& key,
                                    const std::optional<double>& factor, const std::optional<double>& limit);

/// Warnings slip_line: the largest strain of a cell is several times that of the cells beside it, as where soil slides
/// along a line as narrow as the cells; large_strain: strains are no longer small.
NumberedWarnings yielding_warnings(const Summary& summary);

/// Keys that other summaries have, too.
OutputSchema<LoadOnCaisson> load_outputs();
OutputSchema<Skipped> skipped_outputs();

}  // namespace upbead

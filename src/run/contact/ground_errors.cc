#include "run/contact/ground_errors.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Of S and of the peak, in which two models may agree by chance, at least this share of the largest difference of F_T
/// at any time is told.
constexpr double least_share = 0.25;
constexpr double unfelt = 1e-6;  ///< m: less than that nobody measures, and of a slip that small no share need be met

}  // namespace

/// The largest difference of each reading at the times that both answers have: all but where one of them leapt.
Eigen::VectorXd differences(const Series& fine, const Series& coarse) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(fine.reading.rows());
  std::size_t j = 0, shared = 0;
  for (std::size_t i = 0; i < fine.time.size(); ++i) {
    while (j + 1 < coarse.time.size() && coarse.time[j] < fine.time[i] - 1e-9) ++j;
    if (std::abs(coarse.time[j] - fine.time[i]) > 1e-9) continue;
    ++shared;
    largest = largest.cwiseMax(
        (fine.reading.col(static_cast<Eigen::Index>(i)) - coarse.reading.col(static_cast<Eigen::Index>(j))).cwiseAbs());
  }
  if (2 * shared < fine.time.size()) throw NumericsError("nested models of the ground were marched at other times");
  return largest;
}

ContactGround ground_errors(const OfGround& fine, const OfGround& coarse, double apart) {
  const Eigen::RowVectorXd &F = fine.shear, &before = coarse.shear;
  const double peak = std::max(std::abs(F.maxCoeff() - before.maxCoeff()), std::abs(F.minCoeff() - before.minCoeff()));
  const double largest = F.cwiseAbs().maxCoeff(), history = largest > 0. ? apart / largest : 0.;
  const double slip = std::abs(fine.contact.largest_slip);
  ContactGround ground;
  ground.slip = std::max({margin_of_ground * std::abs(fine.contact.slip - coarse.contact.slip),
                          least_share * history * slip, of_patch * slip});
  ground.peak_shear = largest > 0. ? std::max(margin_of_ground * peak / largest, least_share * history) : 0.;
  ground.history = margin_of_ground * history;
  return ground;
}

bool meets(const ContactGround& error, const NodeContact& contact, double tolerance) {
  return error.peak_shear <= tolerance && error.slip <= std::max(tolerance * std::abs(contact.largest_slip), unfelt) &&
         error.history <= of_history * tolerance;
}

std::string why_ground_misses(const ContactGround& error) {
  return "nested models of the ground differ by " + significant(error.slip) + " m in S, " +
         significant(error.peak_shear) + " of the peak of F_T, and " + significant(error.history) +
         " of its largest magnitude at some time";
}

}  // namespace upbead

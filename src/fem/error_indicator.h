// Estimates the error that the size of the cells causes, from the part of a solution in each cell's highest degree.
#pragma once

#include <complex>
#include <vector>

#include "fem/unknowns.h"

namespace upbead {

/// For every active cell (row) and every solution x_j of (s_j^2 M + s_j C + K) x = b, given as a column of X over the
/// unknowns, an estimate of the square of the error of x_j in the cell's energy
///
///   |d|^2 = d_u*(K + |s|^2 M) d_u + d_W*(|s|^2 M + |s| C) d_W - d_phi*(K + |s| C + |s|^2 M) d_phi.
///
/// d_k is the part of a field that only its degree k can hold: the field less its L2 projection to degree k - 1 on
/// the cell. It is about the error that degree k - 1 would make. As the parts of smooth solutions decay like a
/// geometric series with the degree (Mavriplis 1989), the error of degree k itself is |d_k| min(1, |d_k| /
/// |d_(k-1)|). For a field of degree 1, whose mean has no gradient, the ratio of the field before it is used. Absent
/// and rigid cells have 0.
Eigen::MatrixXd cell_errors(const Scene& scene, const Space& space, const Unknowns& unknowns, const Eigen::MatrixXcd& X,
                            const std::vector<std::complex<double>>& s);

}  // namespace upbead

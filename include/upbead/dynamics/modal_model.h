// A scene as a sum of modes: what answers all waves once the scene has been solved.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

namespace upbead {

/// What a reading is called, as in Reading.
struct ReadingLabel {
  std::string name;
  std::string unit;
  std::string description;
};

/// Index of the reading of that name; throws std::out_of_range where there is none.
int index_of(const std::vector<ReadingLabel>& labels, const std::string& name);

/// Response from rest to loads f_k(t), k = 0 ... K-1, in M modes:
///
///     z_m' = pole_m z_m + sum_k load_mk f_k(t),  z_m(0) = 0
///     y_i(t) = Re sum_m reading_im z_m(t) + sum_k ( feedthrough_ik f_k(t) + impulse_ik int_0^t f_k )
///
/// All poles have Re <= 0. One of each pair of conjugate poles is kept, its row of `reading` doubled.
struct ModalModel {
  Eigen::VectorXcd pole;                    ///< M, in 1/s
  Eigen::MatrixXcd load;                    ///< M x K
  Eigen::MatrixXcd reading;                 ///< I x M
  Eigen::MatrixXd feedthrough;              ///< I x K
  Eigen::MatrixXd impulse;                  ///< I x K
  std::vector<std::string> load_name;       ///< K
  std::vector<ReadingLabel> reading_label;  ///< I

  int n_modes() const { return static_cast<int>(pole.size()); }
  int n_loads() const { return static_cast<int>(load.cols()); }
  int n_readings() const { return static_cast<int>(reading.rows()); }
  /// See index_of().
  int index(const std::string& name) const { return index_of(reading_label, name); }
  /// The model with only some of its readings, or one.
  ModalModel with_readings(const std::vector<int>& list) const;
  ModalModel with_reading(int i) const { return with_readings({i}); }
  /// Adds the load `joined` to the load `kept`, which always has the same history.
  void join_loads(int kept, int joined);
  /// H(s) = Y_i / F_k; s (1/s) is no pole, and not zero where there is an impulse term.
  std::complex<double> transfer(int i, int k, std::complex<double> s) const;
};

/// Joins the two loads of a System, with one history, that stand for a load which prescribes a pore pressure.
void join_pore_pressures(ModalModel& model);

}  // namespace upbead

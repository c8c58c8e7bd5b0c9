// Quantities that are followed in all cells and nodes of a scene during the march: strains, stresses, pressures.
#pragma once

#include <string>
#include <vector>

#include "fem/static_stage.h"
#include "fem/unknowns.h"
#include "upbead/dynamics/march.h"
#include "upbead/dynamics/reduce.h"
#include "upbead/response/findings.h"

namespace upbead {

/// Strains at the middles of some cells, as functions of the unknowns.
class MiddleStrains {
 public:
  /// `of_interest`: by active cell index; absent cells have no strains.
  MiddleStrains(const Space& space, const Unknowns& unknowns, const std::vector<bool>& of_interest);
  const std::vector<dealii::DoFHandler<dim>::active_cell_iterator>& cells() const { return cells_; }
  /// One for each of these cells.
  std::vector<PlaneStrain> at(const Vector& x) const;
  /// Cells x columns.
  struct Series {
    Eigen::MatrixXd xx, yy, xy;
  };
  /// For all columns of a StateModel's coordinates.
  Series at(const FieldBasis& basis, const Eigen::MatrixXd& coordinates) const;
  /// gamma = sqrt((e_x - e_y)^2 + (2 e_xy)^2) in each cell, the diameter of Mohr's circle. e_x - e_y is formed in the
  /// rows of the matrix: as the difference of two large sums it would carry their rounding.
  std::vector<double> shear(const Vector& x) const;
  /// The same of all columns of a StateModel's coordinates: cells x columns.
  Eigen::MatrixXd shear(const FieldBasis& basis, const Eigen::MatrixXd& coordinates) const;

 private:
  std::vector<dealii::DoFHandler<dim>::active_cell_iterator> cells_;
  SparseMatrix xx_, yy_, xy_, difference_;
};

/// Largest shear strain of each cell over all states that were seen.
class LargestStrains : public MarchObserver {
 public:
  /// `of_interest`: by active cell index; all other cells stay 0.
  LargestStrains(const Space& space, const Unknowns& unknowns, const std::vector<bool>& of_interest)
      : strains_(space, unknowns, of_interest), largest_(of_interest.size(), 0.) {}
  void see(const State& state, int step, int n_steps) override;
  /// Takes in what a reduced model answers to these loads, at all their times.
  void see(const StateModel& model, const SampledLoads& loads);
  std::vector<double> memory() const override { return largest_; }
  void recall(const std::vector<double>& memory) override { largest_ = memory; }
  /// By active cell index.
  const std::vector<double>& shear() const { return largest_; }

 private:
  MiddleStrains strains_;
  std::vector<double> largest_;
};

/// Follows the stresses of all cells of regions with a strength.
class Mobilisation : public MarchObserver {
 public:
  /// `rest`: the static state; `k0`: s'_x = K_0 s'_y of that state, where it is given. Copies what it needs.
  Mobilisation(const Space& space, const Unknowns& unknowns, const EffectiveStress& rest,
               const std::optional<double>& k0);
  void see(const State& state, int step, int n_steps) override;
  bool wants(double) const override { return false; }
  /// Evaluates the response of a reduced model to these loads, at about 16 times in `duration` (s).
  void see(const StateModel& model, const SampledLoads& loads, double duration);
  bool has_seen() const { return has_seen_; }
  std::vector<MobilisedStrength> found() const;

  std::vector<double> memory() const override;
  void recall(const std::vector<double>& memory) override;

 private:
  struct Soil {
    dealii::Point<dim> middle;
    std::size_t region = 0;
    double area = 0.;
    double middle_stress = 0., half_difference = 0., shear = 0.;  ///< at rest: s, (s'_x - s'_y)/2, tau (Pa)
    double sine = 0., apex = 0.;                                  ///< sin phi, c cos phi (Pa)
    ElasticLaw law{};
    bool counts = true;

    double mobilisation(double s, double difference, double tau) const;
  };

  void leave_out_free_surfaces();
  void take(std::size_t cell, const PlaneStrain& strain, double time);

  MiddleStrains strains_;
  std::vector<std::string> regions_;
  std::vector<Soil> cells_;
  std::vector<double> largest_, time_;  ///< by cell
  bool has_seen_ = false;
};

/// Vapour pressure of water at 20 C, absolute: 2339 Pa (Wagner and Pruss 2002, IAPWS-95), and a standard atmosphere.
constexpr double vapour_pressure = 2339., atmosphere = 101325.;

/// Where and when the water of a scene had its least absolute pressure: atmosphere + rho_f g (level - y) + excess.
/// Only water below the still water level counts: what is above it contains air.
class LeastPressure : public MarchObserver {
 public:
  /// `level`: of still water (m), from water_level(); nothing is watched where it is -infinity.
  LeastPressure(const Space& space, const Unknowns& unknowns, const Scene& scene, double level);
  bool watches() const { return !nodes_.empty(); }
  bool has_seen() const { return has_seen_; }
  void see(const State& state, int step, int n_steps) override;
  bool wants(double) const override { return false; }
  /// Evaluates the response of a reduced model to these loads, at about 16 times in `duration` (s).
  void see(const PressureModel& model, const SampledLoads& loads, double duration);
  /// The same of velocities of a basis' coordinates, a row for each of its columns, at these times.
  void see(const FieldBasis& basis, const Eigen::MatrixXd& velocities, const std::vector<double>& times);

  std::vector<double> memory() const override;
  void recall(const std::vector<double>& memory) override;

  double value() const { return least_; }  ///< Pa, absolute; negative where linear water is in tension
  double excess() const { return least_ - nodes_[node_].still; }  ///< Pa, over that at rest
  double time() const { return time_; }                           ///< s
  const dealii::Point<dim>& place() const { return nodes_[node_].at; }
  const std::string& region() const { return nodes_[node_].region; }

 private:
  struct Node {
    dealii::Point<dim> at;
    std::string region;
    double still = 0.;  ///< absolute pressure at rest (Pa)
  };

  /// Of the nodes from `first` on.
  void take(const Eigen::Ref<const Vector>& excess, double time, std::size_t first = 0);

  std::vector<Node> nodes_;
  SparseMatrix rows_;  ///< maps x' to the excess pressures of the nodes
  double least_ = 0., time_ = 0.;
  std::size_t node_ = 0;
  bool has_seen_ = false;
};

}  // namespace upbead

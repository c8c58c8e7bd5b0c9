// The seam of the program: a scene compiled into M x'' + C x' + K x = sum_k b_k f_k(t), with readings y of x, x', x''.
// What makes the system knows nothing of time marching; what marches it knows nothing of caissons.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "upbead/algebra/processes.h"
#include "upbead/algebra/sparse.h"
#include "upbead/base/time_function.h"

namespace upbead {

/// The kind of an unknown; decides its sign in the energy, and the term of the energy account for its power.
enum class Field : char {
  displacement,      ///< u of the skeleton, or a rigid body's coordinate (m, rad)
  relative_fluid,    ///< W, relative fluid displacement (m)
  pressure_impulse,  ///< phi, time integral of the pressure (Pa s); its equation is multiplied by -1
};

/// A load b f(t) on the right-hand side, or, where `prescribed` >= 0, the prescribed velocity x'_prescribed = f(t).
struct SystemLoad {
  std::string name;
  Vector vector;         ///< b, one entry per unknown; zero where the load prescribes
  TimeFunction history;  ///< f(t), starts from x = x' = 0 at t = 0
  int prescribed = -1;   ///< index of the unknown whose velocity is f(t), or -1
};

/// Entries (unknown, weight) of a sparse row.
using Row = std::vector<std::pair<int, double>>;

/// The name of a reading.
struct ReadingName {
  ReadingName() = default;
  ReadingName(const char* of) : quantity(of) {}
  ReadingName(std::string of) : quantity(std::move(of)) {}
  ReadingName(std::string whose, std::string of) : group(std::move(whose)), quantity(std::move(of)) {}
  ReadingName(std::string whose, std::string of_probe, std::string of)
      : group(std::move(whose)), probe(std::move(of_probe)), quantity(std::move(of)) {}
  ReadingName(std::string whose, int of_node, std::string of)
      : group(std::move(whose)), node(of_node), quantity(std::move(of)) {}

  std::string group;  ///< "caisson", "probes", "base", "interface"; "" of the forces on the caisson
  std::string probe;  ///< name of the probe, where there are several
  int node = -1;      ///< or the number of the node
  std::string quantity;

  /// As in files: "shear_force", "caisson/velocity_x", "probes/A/pressure", "base/3/normal_stress".
  std::string text() const;
};

/// A scalar reading y = position.x + velocity.x' + acceleration.x'' + sum_k feedthrough_k f_k(t).
struct Reading {
  ReadingName name;
  std::string unit;
  std::string description;
  Row position;
  Row velocity;
  Row acceleration;
  std::vector<double> feedthrough;  ///< one per load; empty means none
  /// Numbers and weights of the soil's nodal forces that the reading contains: an internal force adds its own values,
  /// see internal_force.h.
  Row nodal_forces{};
};

/// Readings of position, velocity or acceleration alone.
Reading position_reading(ReadingName name, std::string unit, std::string description, Row row);
Reading velocity_reading(ReadingName name, std::string unit, std::string description, Row row);
Reading acceleration_reading(ReadingName name, std::string unit, std::string description, Row row);

struct GapWater;  // dynamics/gap_water.h

/// The interface where two bodies touch and may slip and open, node by node. Its unknowns are motions of the upper body
/// relative to the lower one: slip (m, landward) of all nodes, then opening (m, apart) of all nodes. They are the last
/// unknowns of the system and count as prescribed: kept at zero, they bond the bodies; a contact law may move them.
/// With them the residual M x'' + C x' + K x - f of a row of slip is -T_i, T_i the shear force on the lower body (N/m),
/// and that of a row of opening the change of the effective normal force N_i (N/m, compression positive).
struct Interface {
  std::vector<double> position;           ///< of each node along the contact (m), ascending
  std::vector<double> length;             ///< of the contact at each node (m): force over length is stress
  Vector normal_force;                    ///< N_i at rest (N/m)
  double friction = 0.;                   ///< mu
  std::shared_ptr<const GapWater> gap{};  ///< of the sea, which enters gaps; null: they take water from the pores alone

  int n_nodes() const { return static_cast<int>(position.size()); }
};

/// A part of C that hangs on a frame which moves by r_k f_k(t): its dashpots act on velocities relative to the frame,
/// so that the system has the loads b_k = (that part) r_k.
struct FrameDashpots {
  std::vector<int> loads;  ///< their numbers
  Eigen::MatrixXd own;     ///< r_k' (that part) r_l (N s/m)
};

/// What one process holds of a system that is divided.
struct PartOfSystem {
  int n_whole = 0;          ///< unknowns of the whole system
  int n_phi_elsewhere = 0;  ///< free phi that other processes alone hold
  std::vector<int> number;  ///< in the whole, of each unknown here
  /// Unknowns for which this process counts: their numbers here and in the whole. One process counts for each.
  std::vector<std::pair<int, int>> counted;
};

/// n unknowns; the last n_prescribed of them are given by loads. M, C and K hold all n rows, are symmetric, and with
/// the rows of phi multiplied by -1: M >= 0, sym(C) >= 0, K >= 0.
struct System {
  SparseMatrix M, C, K;
  SparseMatrix radiation;  ///< the part of C that lets waves out of the mesh, for the account of energy; may be empty
  std::vector<SystemLoad> loads;
  FrameDashpots frame_damping,
      frame_radiation;  ///< of material damping, and of the radiation; for the account of energy
  std::vector<Reading> readings;
  std::vector<Field> field;        ///< one per unknown
  std::vector<IndexRange> blocks;  ///< unknowns that couple inside one cell only (W), eliminated before factorising
  int n_prescribed = 0;
  std::optional<Interface> interface;  ///< its unknowns are the last of the prescribed ones
  Sharing sharing;    ///< of the free unknowns with other processes; part.h says what is then a sum over processes
  PartOfSystem part;  ///< where it is divided

  bool is_divided() const { return sharing.processes != nullptr; }
  int size() const { return static_cast<int>(field.size()); }
  int n_free() const { return size() - n_prescribed; }
  /// With an interface: the first unknown of slip, and the first one of opening.
  int first_slip() const { return size() - 2 * interface->n_nodes(); }
  int first_opening() const { return size() - interface->n_nodes(); }
  /// Index of the reading with that name; throws std::out_of_range where there is none.
  int reading(const std::string& name) const;
};

/// x, x', x'' at a time.
struct State {
  double time = 0.;
  Vector x, v, a;
};

/// A state at rest at t = 0.
State at_rest(const System& system);

/// Value of a reading at a state, `load` holding f_k at its time.
double evaluate(const Reading& reading, const State& state, const std::vector<double>& load);

}  // namespace upbead

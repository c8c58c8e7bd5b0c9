// What `upbead reliability` finds, and its output as JSON and in brief.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "design/design.h"
#include "output/checks.h"
#include "reliability/methods.h"

namespace upbead {

/// Two methods that differ by more than this in beta disagree.
constexpr double most_spread = 0.1;

/// A probability and its beta; none where the probability is 0 or 1, or not known.
struct Chance {
  std::optional<double> probability, index;
};

/// A variable at the design point, in its own unit.
struct DesignValue {
  std::string variable, acts_on, unit;
  double characteristic = 0.;            ///< the number of the design
  double value = 0.;                     ///< at the design point
  double alpha = 0.;                     ///< component of the unit vector to u*
  double importance = 0.;                ///< alpha^2
  std::optional<double> partial_factor;  ///< value / characteristic; none where that is 0
};

/// A limit state, or a gate of the fault tree.
struct ModeAnswer {
  std::string name, meaning;
  bool is_system = false;
  std::string why_not;                 ///< it was not asked; "" where it was
  std::vector<MethodAnswer> methods;   ///< those asked for
  std::string governing;               ///< the method with the least beta; "": none has an answer
  Chance occasion, year, life;         ///< by that method
  std::optional<double> spread;        ///< largest difference of beta between two methods
  std::string disagreement;            ///< of two methods by more than 0.1 in beta; "" where they agree
  std::vector<DesignValue> point;      ///< empty where none was found
  bool by_ground = false;              ///< its design point has been asked of a reduced model
  bool by_history = false;             ///< it follows from F_T(t) of an assumed P(t)
  std::optional<double> ground_error;  ///< estimate for F_T there, over its peak; none where the ground is not asked
};

/// A demand of a code, beside what was found.
struct CodeRow {
  std::string code, what, unit;
  std::optional<double> value, target;
  bool at_least = false;  ///< the value must not fall below the target
  bool given = false;     ///< the file itself gives the target, and no assumed default does
  std::string source;     ///< of the target
  std::string why_not;    ///< there is no value
  std::optional<bool> holds() const;
};

struct ReliabilityAnswer {
  std::string wave;
  std::vector<ModeAnswer> modes;  ///< limit states, then gates of the fault tree
  std::string system;             ///< name of the mode that stands for the whole
  /// Limit states that a fault tree which the user did not give leaves out, as they cannot be asked: its probability is
  /// one at least.
  std::vector<std::string> left_out;
  std::vector<CodeRow> codes;
  NumberedWarnings variables;  ///< what is doubtful in the distributions and in the soils that they reach
  NumberedWarnings lives{};    ///< in the lives whose S is in `codes`
};

/// The mode of that name. Throws std::invalid_argument where there is none.
const ModeAnswer& mode_of(const ReliabilityAnswer& answer, const std::string& name);

/// ", without NAMES": what the system leaves out; "" where it is complete.
std::string words_of_left_out(const ReliabilityAnswer& answer);

/// Methods of one mode: chooses the one that governs, and finds disagreements; `occasions` of a year, `years` of life.
ModeAnswer judged(ModeAnswer mode, double occasions, double years);

/// Names of the limit states, as a fault tree may name them.
std::vector<std::string> limit_state_names();
/// Those by F_T, where asks_for_ground() holds.
std::vector<std::string> ground_state_names();

/// The sheets of codes. With [life], S of whole lives by Monte Carlo as in `upbead expected`, whose warnings are added.
std::vector<CodeRow> code_rows(const Design& design, ReliabilityAnswer& answer);

/// Checks what `reliability` needs: variables, methods, the wave, the fault tree, and lives where they are asked for.
void check_random(const DesignTables& tables, const Document& document, Diagnostics& report);

/// The answer of all. Throws NumericsError where Goda's formulas do not accept what the variables reach.
ReliabilityAnswer find_reliability(const Design& design);

/// The index of the life of the system against `target`, then of all other modes, then the demands of codes that the
/// file itself gives.
Checks checks_of(const Design& design, const ReliabilityAnswer& answer);
NumberedWarnings warnings_of(const Design& design, const ReliabilityAnswer& answer);
/// summary.json. Throws NumericsError where a number is not finite.
Json to_json(const Design& design, const ReliabilityAnswer& answer);
/// The keys of that JSON.
std::vector<OutputRow> rows_of_reliability();
/// Probabilities, demands of codes and the verdict, for the terminal.
std::string brief(const Design& design, const ReliabilityAnswer& answer, const Json& summary);

/// Checks and warnings of a summary.json that another process has written: those of checks_of() and warnings_of()
/// there.
Checks checks_in(const Json& summary);
NumberedWarnings warnings_in(const Json& summary);

}  // namespace upbead

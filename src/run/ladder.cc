#include "ladder.h"

#include "derived.h"

#include <limits>

#include "base/text.h"
#include "fem/compile.h"
#include "model/words.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// Refined solutions cost twice as much, and a quarter of the step four times: with it sdirk4 loses 256 times of its
/// error. More than 32 times the work nobody has asked for.
constexpr Care cares[] = {{false, 1.}, {true, 1.}, {true, 0.25}, {true, 0.0625}};

std::string reasons(const Ladder& ladder) {
  if (ladder.size() == 1) return ladder.front().refused;
  std::string text = "no way to solve this scene holds:";
  for (const LadderStep& step : ladder) text += "\n  " + step.way + ": " + step.refused;
  return text;
}

/// The best answer so far of those that do not balance.
struct Closest {
  std::optional<Run> run;
  std::string way;
  double error = std::numeric_limits<double>::infinity();

  void take(Run&& other, const std::string& name, const Mismatch& off) {
    if (!off.bearable || !(off.error < error)) return;
    run = std::move(other);
    way = name;
    error = off.error;
  }
};

/// Steps that are too many are no mistake of the case where it has not asked for them.
Run march_with(const Simulation& simulation, const SchemeChoice& choice, const Care& care,
               const MarchOptions& options) {
  try {
    return run_march(simulation, choice, options, care);
  } catch (const InputError& error) {
    if (care.part == 1.) throw;
    throw NumericsError(error.diagnostics().list().front().what);
  }
}

Way marching_way(const Simulation& simulation, const SchemeChoice& choice, const Care& care) {
  return {name_of_way(word_of(choice.scheme, time_scheme_words), care),
          [&simulation, choice, care](const MarchOptions& options) {
            return march_with(simulation, choice, care, options);
          },
          !care.refined};
}

}  // namespace

std::optional<Mismatch> imbalance(const Simulation& simulation, const Run& run) {
  const Summary& summary = run.summary;
  try {
    if (summary.response)
      require_balance(*summary.response, summary.energy.value_or(EnergyAccount()));
    else if (summary.energy)
      require_balance(*summary.energy, simulation.compiled->system, simulation.given.time.end);
  } catch (const Imbalance& found) {
    return found.mismatch();
  }
  return std::nullopt;
}

Run climb(const Simulation& simulation, const std::vector<Way>& ways, const MarchOptions& marching) {
  Ladder ladder;
  Closest closest;
  MarchOptions again = marching;
  again.checkpoints = {};
  const auto with_ladder = [&ladder](Run&& run) {
    run.summary.ladder = ladder;
    return std::move(run);
  };
  for (const Way& way : ways) {
    ladder.push_back({way.name, ""});
    try {
      Run run = way.solve(way.keeps_checkpoints ? marching : again);
      const std::optional<Mismatch> off = imbalance(simulation, run);
      if (!off) return with_ladder(std::move(run));
      ladder.back().refused = Imbalance(*off).what();
      closest.take(std::move(run), way.name, *off);
    } catch (const NumericsError& error) {
      ladder.back().refused = error.what();
    }
  }
  if (!closest.run)
    throw NumericsError(reasons(ladder) + "; nothing was written, as such an answer is not to be trusted");
  ladder.push_back({closest.way + ", the closest of these", ""});
  return with_ladder(std::move(*closest.run));
}

std::vector<Care> cares_of(const Scene& given) {
  const bool automatic = given.time.scheme == TimeScheme::automatic;
  return {std::begin(cares), automatic ? std::end(cares) : std::begin(cares) + 2};
}

std::string name_of_way(const std::string& scheme, const Care& care) {
  std::string name = scheme;
  if (care.refined) name += ", refined solutions";
  if (care.part < 1.) name += ", steps divided by " + significant(1. / care.part);
  return name;
}

std::vector<Way> ways(const Simulation& simulation, const std::function<void(double)>& reducing) {
  std::vector<Way> list;
  SchemeChoice choice = choose_scheme(simulation.scene, *simulation.compiled);
  if (choice.scheme == TimeScheme::reduced) {
    list.push_back({"reduced", [&simulation, choice, reducing](const MarchOptions&) {
                      return run_reduced(simulation, choice, reducing);
                    }});
    if (simulation.given.time.scheme == TimeScheme::reduced) return list;
    choice = {TimeScheme::sdirk4, "the reduced model was refused", {}};
  }
  for (const Care& care : cares_of(simulation.given)) list.push_back(marching_way(simulation, choice, care));
  return list;
}

std::string what_would_work(const Simulation& simulation, const std::function<void(double)>& reducing) {
  const TimeScheme refused = simulation.given.time.scheme;
  if (refused == TimeScheme::automatic) return "";
  Scene automatic = simulation.given;
  automatic.time.scheme = TimeScheme::automatic;
  const Simulation other = with_given(simulation, automatic);
  ObserverFunction progress = progress_observer(reducing);
  MarchOptions silent;
  silent.observers = {&progress};
  std::vector<Way> list;
  const SchemeChoice choice{TimeScheme::sdirk4, "another scheme was refused", {}};
  for (const Care& care : cares_of(automatic))
    if (care.part < 1. || refused != TimeScheme::sdirk4) list.push_back(marching_way(other, choice, care));
  try {
    const Run run = climb(other, list, silent);
    return "; time.scheme = \"auto\" answers this scene, by " + run.summary.ladder.back().way;
  } catch (const NumericsError&) {
    return "; nor does sdirk4 answer this scene, in steps a sixteenth as long either";
  }
}

}  // namespace upbead

#include "ladder.h"

#include <limits>

#include "upbead/base/error.h"
#include "upbead/base/text.h"
#include "upbead/model/words.h"

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
Run march_with(const Case& input, const CompiledCase& scene, const SchemeChoice& choice, const Care& care,
               const MarchOptions& options) {
  try {
    return run_march(input, scene, choice, options, care);
  } catch (const InputError& error) {
    if (care.part == 1.) throw;
    throw NumericsError(error.mistakes().front().what);
  }
}

Way marching_way(const Case& input, const CompiledCase& scene, const SchemeChoice& choice, const Care& care) {
  return {name_of_way(word_of(choice.scheme, time_scheme_words), care),
          [&input, &scene, choice, care](const MarchOptions& options) {
            return march_with(input, scene, choice, care, options);
          },
          !care.refined};
}

}  // namespace

std::optional<Mismatch> imbalance(const Case& input, const CompiledCase& scene, const Run& run) {
  const Summary& summary = run.summary;
  try {
    if (summary.response)
      require_balance(*summary.response, summary.energy.value_or(EnergyAccount()));
    else if (summary.energy)
      require_balance(*summary.energy, scene.compiled.system, input.scene.time.end);
  } catch (const Imbalance& found) {
    return found.mismatch();
  }
  return std::nullopt;
}

Run climb(const Case& input, const CompiledCase& scene, const std::vector<Way>& ways, const MarchOptions& marching) {
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
      const std::optional<Mismatch> off = imbalance(input, scene, run);
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

std::vector<Care> cares_of(const Case& input) {
  const bool automatic = input.scene.time.scheme == TimeScheme::automatic;
  return {std::begin(cares), automatic ? std::end(cares) : std::begin(cares) + 2};
}

std::string name_of_way(const std::string& scheme, const Care& care) {
  std::string name = scheme;
  if (care.refined) name += ", refined solutions";
  if (care.part < 1.) name += ", steps divided by " + significant(1. / care.part);
  return name;
}

std::vector<Way> ways(const Case& input, const CompiledCase& scene, const std::function<void(double)>& reducing) {
  std::vector<Way> list;
  SchemeChoice choice = choose_scheme(scene.scene, scene.compiled);
  if (choice.scheme == TimeScheme::reduced) {
    list.push_back({"reduced", [&input, &scene, choice, reducing](const MarchOptions&) {
                      return run_reduced(input, scene, choice, reducing);
                    }});
    if (input.scene.time.scheme == TimeScheme::reduced) return list;
    choice = {TimeScheme::sdirk4, "the reduced model was refused", {}};
  }
  for (const Care& care : cares_of(input)) list.push_back(marching_way(input, scene, choice, care));
  return list;
}

std::string what_would_work(const Case& input, const CompiledCase& scene, const std::function<void(double)>& reducing) {
  const TimeScheme refused = input.scene.time.scheme;
  if (refused == TimeScheme::automatic) return "";
  Case other = input;
  other.scene.time.scheme = TimeScheme::automatic;
  MarchOptions silent;
  silent.observer = [&reducing](const State&, int step, int n) {
    if (reducing) reducing(n > 0 ? static_cast<double>(step) / n : 1.);
  };
  std::vector<Way> list;
  const SchemeChoice choice{TimeScheme::sdirk4, "another scheme was refused", {}};
  for (const Care& care : cares_of(other))
    if (care.part < 1. || refused != TimeScheme::sdirk4) list.push_back(marching_way(other, scene, choice, care));
  try {
    const Run run = climb(other, scene, list, silent);
    return "; time.scheme = \"auto\" answers this scene, by " + run.summary.ladder.back().way;
  } catch (const NumericsError&) {
    return "; nor does sdirk4 answer this scene, in steps a sixteenth as long either";
  }
}

}  // namespace upbead

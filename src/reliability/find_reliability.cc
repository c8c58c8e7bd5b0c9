#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>

#include "base/interrupt.h"
#include "base/progress.h"
#include "model/quantities.h"
#include "reliability/answer.h"
#include "reliability/fault_tree.h"
#include "reliability/random_variables.h"
#include "reliability/section_model.h"
#include "reliability/system_form.h"
#include "upbead/base/error.h"

namespace upbead {

namespace {

/// What all modes share.
struct Work {
  const DesignTables& tables;
  std::vector<std::string> names;  ///< of the variables
  std::vector<RandomVariable> variables;
  std::shared_ptr<SectionModel> model;
  StandardSpace space;
  Sampling sampling;
  std::shared_ptr<ModelledGround> ground;  ///< null where it is not asked
};

StandardSpace space_of(const RandomVariables& random, const Document& document) {
  try {
    return StandardSpace(random);
  } catch (const std::invalid_argument& error) {
    throw InputError(document.place("reliability"), std::string("[reliability]: ") + error.what(),
                     "look at its variables and correlations");
  }
}

RandomVariables random_of(const DesignTables& tables) {
  RandomVariables random{{}, complete_variables(tables), {}};
  for (const auto& [name, variable] : tables.reliability->variables) random.names.push_back(name);
  for (const auto& [name, correlation] : tables.reliability->correlations) random.correlations.push_back(correlation);
  return random;
}

std::shared_ptr<ModelledGround> ground_of(const Design& design) {
  if (!asks_for_ground(design.tables)) return nullptr;
  const Place place = design.document.place("dynamics.model");
  return std::make_shared<ModelledGround>(design.tables, design.resolve(design.tables.dynamics->model), place);
}

AskGround asked_of(const std::shared_ptr<ModelledGround>& ground) {
  if (!ground) return nullptr;
  return [ground](const GroundWave& wave) { return ground->at(wave); };
}

/// Points whose soil the model of [dynamics] does not answer.
NumberedWarnings unanswered(const SectionModel& model) {
  if (model.n_unanswered() == 0) return {};
  return {
      {"soil_unanswered", static_cast<double>(model.n_unanswered()), 0., "1",
       std::to_string(model.n_unanswered()) +
           " points of the variables have a soil that the model of [dynamics] cannot answer, and count as failures; "
           "the first: " +
           model.why_unanswered(),
       "make the model with a narrower box, or cut the variables by low and high"}};
}

/// `ground`: its soil is complete in the design.
Work work_of(const Design& design, const std::shared_ptr<ModelledGround>& ground) {
  const DesignTables& tables = design.tables;
  const ReliabilityTable& table = *tables.reliability;
  const RandomVariables random = random_of(tables);
  return {tables,
          random.names,
          random.list,
          std::make_shared<SectionModel>(tables, asked_of(ground)),
          space_of(random, design.document),
          {static_cast<std::uint32_t>(table.seed), table.samples, table.plain_samples},
          ground};
}

bool asked(const Work& work, const std::string& method) {
  const std::vector<std::string>& list = work.tables.reliability->methods;
  return std::find(list.begin(), list.end(), method) != list.end();
}

std::vector<DesignValue> values_at(const Work& work, const DesignPoint& point) {
  const std::vector<double> x = work.space.physical(point.u);
  std::vector<DesignValue> list;
  for (std::size_t i = 0; i < x.size(); ++i) {
    DesignValue value;
    value.variable = work.names[i];
    value.acts_on = work.variables[i].acts_on;
    value.unit = is_of_soil(value.acts_on) ? work.ground->unit(value.acts_on) : unit_at(work.tables, value.acts_on);
    value.characteristic = work.model->certain()[i];
    value.value = x[i];
    value.alpha = point.alpha[i];
    value.importance = point.alpha[i] * point.alpha[i];
    if (value.characteristic != 0.) value.partial_factor = x[i] / value.characteristic;
    list.push_back(value);
  }
  return list;
}

/// What is told of a mode's design point.
void add_point(const Work& work, const DesignPoint& point, bool by_ground, ModeAnswer& mode) {
  mode.point = values_at(work, point);
  mode.by_ground = by_ground;
  if (!by_ground) return;
  const SectionPoint there = work.model->at(work.space.physical(point.u));
  if (there.ground().why_not.empty()) mode.ground_error = work.ground->error(there.wave);
}

/// A reduced model ends its own reduction by its error, so that its answers jump by far less than that; wider steps of
/// u keep that out of the differences.
Steps steps_of(const SectionLimitState& state) {
  return state.by_ground ? Steps{1e-3, 0.05} : Steps{};
}

/// Adds what sampling finds, in the order in which methods are told.
void add_samples(const Work& work, const Margin& margin, const std::vector<DesignPoint>& points, ModeAnswer& mode) {
  const std::size_t size = work.space.size();
  if (asked(work, "importance")) mode.methods.push_back(by_importance(margin, points, work.sampling));
  if (asked(work, "subset")) mode.methods.push_back(by_subset(margin, size, work.sampling));
  if (asked(work, "plain")) mode.methods.push_back(by_plain(margin, size, work.sampling));
}

Margin margin_of(const Work& work, const SectionLimitState& state) {
  return [model = work.model, space = work.space, g = state.margin](const std::vector<double>& u) {
    return g(model->at(space.physical(u)));
  };
}

ModeAnswer mode_of(const Work& work, const SectionLimitState& state, const DesignPointSearch& found) {
  ModeAnswer mode;
  mode.name = state.name;
  mode.meaning = state.meaning;
  mode.why_not = state.why_not;
  mode.by_history = state.by_ground;
  if (!state.margin) return mode;
  const Margin margin = margin_of(work, state);
  if (asked(work, "form")) mode.methods.push_back(by_form(found));
  if (asked(work, "sorm")) mode.methods.push_back(by_sorm(margin, found, steps_of(state)));
  std::vector<DesignPoint> points;
  if (found.point) points.push_back(*found.point);
  add_samples(work, margin, points, mode);
  if (found.point) add_point(work, *found.point, state.by_ground, mode);
  return mode;
}

ModeAnswer gate_of(const Work& work, const std::string& name, const FaultTree& tree,
                   const std::vector<SectionLimitState>& states, const std::vector<DesignPointSearch>& found) {
  ModeAnswer mode;
  mode.name = name;
  mode.is_system = true;
  const CutSets sets = tree.cut_sets();
  bool by_ground = false;
  std::set<std::size_t> in_tree;  // others are not asked: each may need a soil's answer
  for (const auto& set : sets) {
    in_tree.insert(set.begin(), set.end());
    std::string all;
    for (const std::size_t i : set) {
      all += (all.empty() ? "" : " and ") + states[i].name;
      by_ground = by_ground || states[i].by_ground;
      if (!states[i].margin && mode.why_not.empty()) mode.why_not = states[i].name + ": " + states[i].why_not;
    }
    mode.meaning += (mode.meaning.empty() ? "" : ", or ") + all;
  }
  mode.by_history = by_ground;
  if (!mode.why_not.empty()) return mode;
  const Margin margin = [model = work.model, space = work.space, tree, states, in_tree](const std::vector<double>& u) {
    const SectionPoint at = model->at(space.physical(u));
    std::vector<double> margins(states.size(), 1.);
    for (const std::size_t i : in_tree) margins[i] = states[i].margin(at);
    return tree.margin(margins);
  };
  const std::vector<DesignPoint> points = design_points(found, sets);
  if (asked(work, "form")) mode.methods.push_back(by_system_form(found, sets));
  add_samples(work, margin, points, mode);
  if (!points.empty()) add_point(work, points.front(), by_ground, mode);
  return mode;
}

/// A gate that has no answer fails at least as often as an event that fails it alone: told where that is more likely
/// than not in a life. `events`: answers of the limit states.
ModeAnswer bounded(ModeAnswer gate, const FaultTree& tree, const std::vector<ModeAnswer>& events) {
  if (gate.life.probability) return gate;
  const ModeAnswer* worst = nullptr;
  for (const auto& set : tree.cut_sets())
    if (const ModeAnswer& event = events[set.front()]; set.size() == 1 && event.life.probability.value_or(0.) >= 0.5)
      if (!worst || *event.occasion.index < *worst->occasion.index) worst = &event;
  if (!worst) return gate;
  gate.governing = worst->governing;
  gate.occasion = worst->occasion;
  gate.year = worst->year;
  gate.life = worst->life;
  gate.why_not = "bounded from below: it fails at least as often as " + worst->name + "; " + gate.why_not;
  return gate;
}

/// What the tree without one of the user leaves out, as it cannot be asked.
std::vector<std::string> left_out_of(const ReliabilityTable& table, const std::vector<SectionLimitState>& states) {
  std::vector<std::string> names;
  for (const SectionLimitState& state : states)
    if (table.system.empty() && !state.margin && !state.of_codes) names.push_back(state.name);
  return names;
}

/// The fault tree of the user; without one any limit state but S beyond the distances of codes.
std::map<std::string, SystemNode> gates_of(const ReliabilityTable& table,
                                           const std::vector<SectionLimitState>& states) {
  if (!table.system.empty()) return table.system;
  SystemNode any;
  any.any.emplace();
  for (const SectionLimitState& state : states)
    if (state.margin && !state.of_codes) any.any->push_back(state.name);
  return {{"system", any}};
}

/// The design with all keys of the soil.
Design on_ground(Design design, const std::shared_ptr<ModelledGround>& ground) {
  if (ground) design.tables.dynamics->soil = ground->soil();
  return design;
}

std::vector<SectionLimitState> states_of(const Work& work) {
  const SectionPoint certain = work.model->at(work.model->certain());
  std::vector<SectionLimitState> states = section_limit_states(certain, seaward_force(work.tables));
  if (work.ground) append(states, ground_states(certain, work.ground->knows_base()));
  return states;
}

/// Warning implausible: a mean that is far from the number of the model was given in another unit; others than those of
/// soils are in Design::implausible.
NumberedWarnings far_from_design(const DesignTables& tables) {
  constexpr double far = 30., near = 3.;
  NumberedWarnings list;
  for (const auto& [name, variable] : tables.reliability->variables)
    if (const double own = certain_value(tables, variable.acts_on).value_or(0.);
        is_of_soil(variable.acts_on) && variable.mean && own > 0.)
      judge("reliability.variables." + name + ".mean", variable.mean,
            {"1",
             own / far,
             own * far,
             own / near,
             own * near,
             {{"thousands", 1e3}, {"millions", 1e6}, {"percent", 1e-2}},
             "the design has another number"},
            list);
  return list;
}

ReliabilityAnswer answer_of(const Design& given) {
  const std::shared_ptr<ModelledGround> ground = ground_of(given);
  const Design design = on_ground(given, ground);
  const Work work = work_of(design, ground);
  const ReliabilityTable& table = *design.tables.reliability;
  const std::vector<SectionLimitState> states = states_of(work);
  const std::map<std::string, SystemNode> gates = gates_of(table, states);
  ReliabilityAnswer answer;
  answer.wave = random_wave(design.tables);
  answer.variables = not_positive(random_of(design.tables));
  append(answer.variables, far_from_design(design.tables));
  Progress line("sampling");
  const double all = static_cast<double>(states.size() + gates.size());
  const auto add = [&](ModeAnswer mode) {
    answer.modes.push_back(judged(std::move(mode), table.occasions_per_year, table.years));
    check_interrupt();
    line.update(static_cast<double>(answer.modes.size()) / all);
  };
  std::vector<DesignPointSearch> found;
  std::vector<std::string> names;
  for (const SectionLimitState& state : states) {
    names.push_back(state.name);
    found.push_back(state.margin ? find_design_point(margin_of(work, state), work.space.size(), steps_of(state))
                                 : DesignPointSearch{{}, state.why_not});
    add(mode_of(work, state, found.back()));
  }
  for (const auto& [name, gate] : gates) {
    const FaultTree tree(gates, name, names);
    add(gate_of(work, name, tree, states, found));
    answer.modes.back() = bounded(answer.modes.back(), tree, answer.modes);
  }
  answer.system = tops_of(gates).front();
  answer.left_out = left_out_of(table, states);
  if (!answer.left_out.empty()) answer.modes.back().meaning += words_of_left_out(answer) + ", which cannot be asked";
  append(answer.variables, unanswered(*work.model));
  if (ground) append(answer.variables, ground->warnings());
  answer.codes = code_rows(given, answer);
  return answer;
}

}  // namespace

ReliabilityAnswer find_reliability(const Design& design) {
  try {
    return answer_of(design);
  } catch (const std::invalid_argument& error) {
    throw NumericsError(std::string("a sample of the variables lies where formulas do not hold: ") + error.what() +
                        "; cut distributions by low and high, or take a narrower one");
  }
}

}  // namespace upbead

#include <stdexcept>

#include "base/text.h"
#include "reliability/answer.h"
#include "reliability/chance.h"

namespace upbead {

namespace {

Chance chance_of(double probability) {
  return {probability, index_of(probability)};
}

std::string text_of(const MethodAnswer& answer) {
  return answer.method + " " + significant(*answer.index, 4);
}

}  // namespace

const ModeAnswer& mode_of(const ReliabilityAnswer& answer, const std::string& name) {
  for (const ModeAnswer& mode : answer.modes)
    if (mode.name == name) return mode;
  throw std::invalid_argument("there is no mode " + name);
}

std::string words_of_left_out(const ReliabilityAnswer& answer) {
  return answer.left_out.empty() ? "" : ", without " + join(answer.left_out);
}

ModeAnswer judged(ModeAnswer mode, double occasions, double years) {
  const MethodAnswer *worst = nullptr, *best = nullptr;
  for (const MethodAnswer& answer : mode.methods) {
    if (!answer.index) continue;
    if (!worst || *answer.index < *worst->index) worst = &answer;
    if (!best || *answer.index > *best->index) best = &answer;
  }
  if (!worst) {
    if (mode.why_not.empty()) mode.why_not = "no method found a probability";
    return mode;
  }
  mode.governing = worst->method;
  mode.occasion = {worst->probability, worst->index};
  mode.year = chance_of(of_occasions(*worst->probability, occasions));
  mode.life = chance_of(of_occasions(*worst->probability, occasions * years));
  mode.spread = *best->index - *worst->index;
  if (*mode.spread > most_spread)
    mode.disagreement = "beta by " + text_of(*worst) + ", by " + text_of(*best) + ": both stand, and the worse governs";
  return mode;
}

std::optional<bool> CodeRow::holds() const {
  if (!value || !target) return {};
  return at_least ? *value >= *target : *value <= *target;
}

}  // namespace upbead

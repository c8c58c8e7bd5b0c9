// Soil by a law that is written once, for a number and for lanes of them: a template over the number n of points side
// by side. Law<n> has
// - State: the history of the points; visit(state, f) calls f for each part that a checkpoint keeps
// - correct, commit, stored and margin, as in SoilAt, all UPBEAD_IN_CLONES; mobilised(state, lane, change)
// - add(const Law<1>&): adds a law in the next lane; lanes without one never yield
// - joined(states): the state at rest of points in lanes, from that of each
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include "material/soil.h"

namespace upbead::detail {

UPBEAD_IN_CLONES void square_root(double of, double& root) {
  root = std::sqrt(of);
}

/// Whether a comparison, of numbers or of lanes, holds anywhere, and whether in one lane.
template <class Mask>
UPBEAD_IN_CLONES bool holds_in(const Mask& mask, int lane) {
  if constexpr (std::is_arithmetic_v<Mask>)
    return mask;
  else
    return mask[lane] != 0;
}
template <class Mask>
UPBEAD_IN_CLONES bool holds_anywhere(const Mask& mask) {
  if constexpr (std::is_arithmetic_v<Mask>) {
    return mask;
  } else {
    long long found = 0;
    for (int i = 0; i < lanes; ++i) found |= mask[i];
    return found != 0;
  }
}

template <class Law, class State, class Strain, class Stress>
UPBEAD_CLONES void correct(const Law& law, const State& state, const Strain& strain, Stress& correction) {
  law.correct(state, strain, correction);
}
template <class Law, class State, class Strain, class Number>
UPBEAD_CLONES void commit(const Law& law, State& state, const Strain& strain, Number& dissipated) {
  law.commit(state, strain, dissipated);
}
template <class Law, class State, class Strain, class Number>
UPBEAD_CLONES void stored(const Law& law, const State& state, const Strain& strain, Number& energy) {
  law.stored(state, strain, energy);
}
template <class Law, class State, class Strain, class Number>
UPBEAD_CLONES void margin(const Law& law, const State& state, const Strain& strain, Number& least) {
  law.margin(state, strain, least);
}

}  // namespace upbead::detail

namespace upbead {

template <template <int> class Law, int n>
class SoilBy : public SoilAt<n> {
 public:
  using typename SoilAt<n>::Number;
  using typename SoilAt<n>::Strain;
  using typename SoilAt<n>::Stress;
  using State = typename Law<n>::State;

  SoilBy(std::shared_ptr<const Law<n>> law, State state) : law_(std::move(law)), state_(std::move(state)) {}
  void correct(const Strain& strain, Stress& correction) const override {
    detail::correct(*law_, state_, strain, correction);
  }
  void commit(const Strain& strain, Number& dissipated) override { detail::commit(*law_, state_, strain, dissipated); }
  void stored_beside_elastic(const Strain& strain, Number& energy) const override {
    detail::stored(*law_, state_, strain, energy);
  }
  void margin(const Strain& strain, Number& least) const override { detail::margin(*law_, state_, strain, least); }
  double mobilised(int lane, const PlaneStress& change) const override { return law_->mobilised(state_, lane, change); }
  void remember(std::vector<double>& memory) const override {
    Law<n>::visit(state_, [&](const auto& part) { remember_numbers(part, memory); });
  }
  const double* recall(const double* memory) override {
    Law<n>::visit(state_, [&](auto& part) { memory = recall_numbers(memory, part); });
    return memory;
  }
  /// Not for cells whose points differ in their law.
  std::vector<std::unique_ptr<SoilPack>> in_lanes(const std::vector<SoilPoints>& cells) const override {
    std::vector<std::unique_ptr<SoilPack>> packs;
    if constexpr (n == 1) {
      auto joined = std::make_shared<Law<detail::lanes>>();
      std::vector<std::vector<const State*>> states(cells.front().size());
      for (const SoilPoints& cell : cells) {
        const SoilBy* first = nullptr;
        for (std::size_t q = 0; q < cell.size(); ++q) {
          const auto* point = dynamic_cast<const SoilBy*>(cell[q].get());
          if (!point || (first && point->law_ != first->law_)) return {};
          first = point;
          states[q].push_back(&point->state_);
        }
        joined->add(*first->law_);
      }
      for (const auto& of_point : states)
        packs.push_back(std::make_unique<SoilBy<Law, detail::lanes>>(joined, joined->joined(of_point)));
    }
    return packs;
  }
  const Law<n>& law() const { return *law_; }
  State& state() { return state_; }
  const State& state() const { return state_; }

 private:
  std::shared_ptr<const Law<n>> law_;
  State state_;
};

}  // namespace upbead

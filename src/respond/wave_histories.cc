#include "respond/wave_histories.h"

#include <algorithm>

#include "base/text.h"
#include "upbead/base/error.h"

namespace upbead {

void require_readings(const std::vector<ReadingLabel>& labels, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const ReadingLabel& label : labels) known.push_back(label.name);
  Diagnostics mistakes;
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (std::find(known.begin(), known.end(), *name) == known.end())
      mistakes.add(Place(), "the model has no reading " + in_quotes(*name), "it has " + join(known));
    if (std::find(names.begin(), name, *name) != name)
      mistakes.add(Place(), "the reading " + in_quotes(*name) + " is asked for twice", "give it once");
  }
  mistakes.throw_if_any();
}

WaveHistories::WaveHistories(const ModalModel& model, const AskedHistories& asked, const WaveGrid& grid)
    : safety_(asked.safety) {
  for (const std::string& name : asked.names) {
    std::unique_ptr<WaveReading> fewer;
    if (asked.fewer) fewer = std::make_unique<WaveReading>(one_reading(*asked.fewer, name), grid);
    const ReadingLabel& label = model.reading_label[static_cast<std::size_t>(model.index(name))];
    list_.push_back({label, WaveReading(one_reading(model, name), grid), std::move(fewer)});
  }
}

std::vector<WaveHistory> WaveHistories::empty(int n_waves, const WaveGrid& grid) const {
  std::vector<WaveHistory> histories;
  for (const Asked& asked : list_) {
    const Eigen::Index n = static_cast<Eigen::Index>(grid.time.size());
    histories.push_back({asked.label, WaveSamples(n_waves, n), {}});
    if (asked.fewer) histories.back().error = Eigen::VectorXd::Zero(n_waves);
  }
  return histories;
}

void WaveHistories::answer(const WaveSamples& loads, const WaveGrid& grid, bool ends_at_zero, int wave,
                           std::vector<WaveHistory>& out) const {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const Eigen::RowVectorXd y = list_[i].full.answer(loads, grid, ends_at_zero);
    if (!y.allFinite()) throw NumericsError("the history of '" + out[i].label.name + "' is not finite");
    out[i].value.row(wave) = y;
    const double largest = y.cwiseAbs().maxCoeff();
    if (!list_[i].fewer || largest == 0.) continue;
    const Eigen::RowVectorXd fewer = list_[i].fewer->answer(loads, grid, ends_at_zero);
    out[i].error[wave] = safety_ * (y - fewer).cwiseAbs().maxCoeff() / largest;
  }
}

}  // namespace upbead

#include "wave_checks.h"

#include <algorithm>

#include "upbead/base/suggest.h"
#include "upbead/base/text.h"

namespace upbead::detail {

std::size_t find(const Names& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

void add_unknown_load(const Place& place, const std::string& what, const std::string& name, const Names& loads,
                      Mistakes& mistakes) {
  const std::string near = nearest(name, loads), all = "the model's loads are: " + join(loads);
  mistakes.add(place, what + " '" + name + "' is no load of the model",
               near.empty() ? all : "did you mean '" + near + "'? " + all);
}

void check_times(const std::vector<double>& time, const std::function<Place(std::size_t)>& place, Mistakes& mistakes) {
  if (time.size() < 2) return mistakes.add(place(0), "a wave of one time", "give two times or more");
  if (time.front() < 0.)
    mistakes.add(place(0), "the wave starts at t = " + significant(time.front(), 6) + " s, before the response",
                 "let it start at 0 or later");
  for (std::size_t n = 1; n < time.size(); ++n)
    if (!(time[n] > time[n - 1]))
      return mistakes.add(
          place(n), "t = " + significant(time[n], 6) + " s does not follow t = " + significant(time[n - 1], 6) + " s",
          "let the times ascend strictly");
}

}  // namespace upbead::detail

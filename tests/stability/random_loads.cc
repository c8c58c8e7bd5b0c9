// Loads and their histories.
#include <algorithm>
#include <boost/math/constants/constants.hpp>

#include "case_writer.h"

namespace upbead::test {

namespace {

/// Pulses last from 1 ms, or less if the computed time is shorter, to so long that they are static.
double draw_duration(CaseDraft& draft) {
  Draw& draw = draft.draw;
  return draw.chance(0.65) ? draft.end * draw.log_uniform(0.1, 0.8) : draw.ranged(1e-3, 1e4);
}

/// Writes the pulse and returns the duration of its fastest rise (s).
double write_pulse(CaseDraft& draft, const std::string& load, double peak) {
  Draw& draw = draft.draw;
  const double duration = draw_duration(draft), at = draw.unit(), part = draw.uniform(0.15, 0.85);
  draft.toml << "[loads." << load << ".pulse]\npeak = " << number(peak)
             << "\nstart = " << number(draw.chance(0.2) ? draft.end * draw.uniform(0., 0.2) : 0.) << "\nshape = ";
  if (at < 0.45) {
    const double rise = draw.chance(0.1) ? 0. : part * duration;
    draft.toml << "\"triangle\"\nduration = " << number(duration) << "\nrise = " << number(rise) << "\n\n";
    return std::min(rise, duration - rise);
  }
  if (at < 0.65) {
    draft.toml << "\"half_sine\"\nduration = " << number(duration) << "\n\n";
    return 0.5 * duration;
  }
  if (at < 0.75) {
    draft.toml << "\"church_roof\"\nduration = " << number(duration) << "\nrise = " << number(part * duration)
               << "\nplateau = " << number(draw.uniform(0.1, 0.9))
               << "\nplateau_duration = " << number(duration * draw.log_uniform(1.5, 5.)) << "\n\n";
    return std::min(part, 1. - part) * duration;
  }
  if (at < 0.9) {
    const double rise = draw.chance(0.3) ? 0. : duration;
    draft.toml << "\"step\"\nrise = " << number(rise) << "\n\n";
    return rise;
  }
  draft.toml << "\"harmonic\"\nfrequency = " << number(1. / duration) << "\n\n";
  return 0.25 * duration;
}

/// A load without its pulse: its kind, place and size.
struct Target {
  std::string text;
  double peak = 1.;
};

std::string direction(Draw& draw) {
  const double angle = draw.uniform(0., boost::math::constants::two_pi<double>());
  return "direction = [" + number(std::cos(angle)) + ", " + number(std::sin(angle)) + "]\n";
}

/// A load on the caisson; if it may slip, a force of the order of its weight.
Target on_caisson(CaseDraft& draft) {
  Draw& draw = draft.draw;
  const double weight = 1e4 * draft.layout.caisson_area;
  const double peak = draft.friction ? weight * draw.log_uniform(0.02, 1.) : draw.log_uniform(1e2, 1e8);
  const double arm = draft.layout.middle[1] * draw.uniform(0.5, 1.5);
  if (draft.is("caisson", "rigid") && draw.chance(0.4))
    return {"region = \"caisson\"\nat = [" + number(draft.layout.middle[0]) + ", " + number(arm) + "]\n" +
                (draft.friction ? "direction = [1.0, 0.1]\n" : direction(draw)),
            peak};
  if (draw.chance(0.15)) return {"boundary = \"top\"\nkind = \"traction\"\n" + direction(draw), 1e-2 * peak};
  return {"boundary = \"front\"\nkind = \"force\"\ndirection = [1.0, 0.0]\nmeasured_on_wall = " +
              std::string(draw.chance(0.15) ? "true" : "false") + "\n",
          peak};
}

/// On a surface of the ground, or on the level of the sea.
Target on_surface(CaseDraft& draft, const LayoutCurve& curve) {
  Draw& draw = draft.draw;
  const double peak = draw.log_uniform(10., 1e6) * (draw.chance(0.3) ? -1. : 1.);
  const std::string boundary = "boundary = \"" + curve.name + "\"\n";
  if (curve.is_level || (draw.chance(0.6) && !curve.under_sea)) return {boundary + "kind = \"pressure\"\n", peak};
  return {boundary + "kind = \"traction\"\n" + direction(draw), peak};
}

bool takes_load(const CaseDraft& draft, const LayoutCurve& curve) {
  return curve.is_surface || (curve.is_level && draft.pressure.at(curve.name) == "open");
}

}  // namespace

void write_loads(CaseDraft& draft) {
  Draw& draw = draft.draw;
  std::vector<Target> targets;
  if (draft.layout.caisson) targets.push_back(on_caisson(draft));
  for (const LayoutCurve& curve : draft.layout.curves)
    if (takes_load(draft, curve) && (targets.empty() || (!draft.friction && draw.chance(0.3))))
      targets.push_back(on_surface(draft, curve));
  double rise = INFINITY;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const std::string name(1, static_cast<char>('a' + i));
    draft.toml << "[loads." << name << "]\n" << targets[i].text;
    rise = std::min(rise, write_pulse(draft, name, targets[i].peak));
  }
  draft.facts.emplace_back("loads", std::to_string(targets.size()));
  draft.facts.emplace_back("rise", number(rise));
}

}  // namespace upbead::test

#include "rupture/slices.h"

#include <algorithm>
#include <cmath>

namespace upbead {

namespace {

/// Ends of about n slices, none of which is partly under the strip or across a kink of the line.
std::vector<double> ends_of_slices(const std::optional<StripLoad>& strip, double from, double to, int n,
                                   std::vector<double> kinks) {
  if (strip) kinks.insert(kinks.end(), {strip->from, strip->to});
  std::sort(kinks.begin(), kinks.end());
  std::vector<double> corners{from};
  for (const double x : kinks)
    if (x > corners.back() && x < to) corners.push_back(x);
  corners.push_back(to);
  std::vector<double> ends{from};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double length = corners[i + 1] - corners[i];
    const int parts = std::max(1, static_cast<int>(std::lround(n * length / (to - from))));
    for (int k = 1; k <= parts; ++k) ends.push_back(corners[i] + length * k / parts);
  }
  return ends;
}

/// Adds what presses on the surface: dF = p (dy/dx, -1) dx, as its outward normal is (-dy/dx, 1).
void add_surface_pressure(Slice& slice, const GroundSection& section, double top, double p) {
  const double left = section.surface(slice.x - 0.5 * slice.width).value_or(top);
  const double right = section.surface(slice.x + 0.5 * slice.width).value_or(top);
  const double along = p * (right - left) / slice.width;
  slice.vertical += p;
  slice.horizontal += along;
  slice.horizontal_moment += along * top;
}

/// Fills in what the slice bears and what drives it; why it cannot.
NoFactor fill(Slice& slice, const GroundSection& section, const GroundLoads& loads) {
  const std::optional<GroundColumn> column = section.column(slice.x);
  if (!column || slice.base.y >= column->surface()) return NoFactor::outside;
  const double top = column->surface(), y = slice.base.y;
  const GroundSoil* soil = section.soil_at(*column, y);
  if (!soil) return column->is_whole ? NoFactor::outside : NoFactor::uncut;
  if (!soil->may_fail) return NoFactor::uncut;
  const GroundSection::Weight weight = section.weight_above(*column, y);
  slice.cohesion = soil->cohesion;
  slice.friction = soil->friction;
  slice.vertical = weight.force + weight_on(loads, slice.x);
  slice.horizontal = loads.acceleration * weight.force;
  slice.horizontal_moment = loads.acceleration * weight.moment;
  if (loads.pressure) add_surface_pressure(slice, section, top, loads.pressure(slice.x, top));
  slice.normal = slice.vertical - (loads.pressure ? loads.pressure(slice.x, y) : 0.);
  return NoFactor::none;
}

using SliceWeight = std::function<double(const Slice&)>;

/// What a slice bears at F = infinity, without its m_alpha; it does not depend on F.
struct Borne {
  double force = 0., cosine = 1., side = 0.;  ///< N/m, cos alpha, sin alpha tan phi'
};

std::vector<Borne> borne_by(const Slices& slices, const SliceWeight& weight) {
  std::vector<Borne> list;
  list.reserve(slices.list.size());
  for (const Slice& s : slices.list)
    list.push_back({std::max(s.cohesion + s.normal * s.friction, 0.) * s.width * weight(s), s.base.cosine,
                    s.base.sine * s.friction});
  return list;
}

double resistance(const std::vector<Borne>& slices, double factor) {
  double sum = 0.;
  for (const Borne& s : slices) sum += s.force / std::max(s.cosine + s.side / factor, 0.5 * least_m_alpha);
  return sum;
}

double least_m_of(const std::vector<Borne>& slices, double factor) {
  double least = 1e300;
  for (const Borne& s : slices) least = std::min(least, s.cosine + s.side / factor);
  return least;
}

/// F = resistance(F)/driving, by steps of the secant method; the first are Bishop's own, F <- resistance(F)/driving.
double fixed_factor(const std::vector<Borne>& slices, double driving) {
  double before = 1., F = resistance(slices, before) / driving, rest_before = F - before;
  for (int i = 0; i < 60; ++i) {
    if (!(F > 0.)) return 0.;
    const double rest = resistance(slices, F) / driving - F;
    if (std::abs(rest) <= 1e-10 * F) break;
    const double slope = (rest - rest_before) / (F - before);
    before = F;
    rest_before = rest;
    F = slope < -0.05 ? std::max(F - rest / slope, 0.2 * F) : F + rest;
  }
  return F;
}

}  // namespace

Slices slices_of(const GroundSection& section, const GroundLoads& loads,
                 const std::function<std::optional<BasePoint>(double x)>& line, double from, double to, int n,
                 const std::vector<double>& kinks) {
  if (loads.strip) {
    const double trifle = 1e-9 * (loads.strip->to - loads.strip->from);
    if (from > loads.strip->from + trifle || to < loads.strip->to - trifle) return {{}, NoFactor::uncut};
  }
  const std::vector<double> ends = ends_of_slices(loads.strip, from, to, n, kinks);
  Slices found;
  found.list.resize(ends.size() - 1);
  for (std::size_t i = 0; i < found.list.size(); ++i) {
    Slice& slice = found.list[i];
    slice.x = 0.5 * (ends[i] + ends[i + 1]);
    slice.width = ends[i + 1] - ends[i];
    const std::optional<BasePoint> base = line(slice.x);
    if (!base) return {{}, NoFactor::outside};
    slice.base = *base;
    if (const NoFactor why = fill(slice, section, loads); why != NoFactor::none) return {{}, why};
  }
  return found;
}

FigureSafety safety_of(const Slices& slices, double driving, const SliceWeight& weight) {
  FigureSafety found;
  found.why = slices.why;
  found.driving = driving;
  if (found.why != NoFactor::none) return found;
  if (!(driving > 0.)) {
    found.why = NoFactor::nothing_drives;
    return found;
  }
  const std::vector<Borne> borne = borne_by(slices, weight);
  const double F = fixed_factor(borne, driving);
  found.least_m = least_m_of(borne, F);
  if (found.least_m < least_m_alpha)
    found.why = NoFactor::steep;
  else
    found.factor = F;
  return found;
}

}  // namespace upbead

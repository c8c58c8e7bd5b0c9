// Conditions on the outer curves.
#include <algorithm>

#include "case_writer.h"

namespace upbead::test {

namespace {

/// Kinds of the regions behind a curve.
struct Behind {
  Behind(const CaseDraft& draft, const LayoutCurve& curve) {
    for (const std::string& name : curve.behind) {
      porous = porous || draft.is(name, "porous");
      pore_water = pore_water || draft.has_pore_water(name);
      water = water || draft.is(name, "water");
      rigid = rigid || draft.is(name, "rigid");
      caisson = caisson || name == "caisson";
    }
  }
  bool porous = false, pore_water = false, water = false, rigid = false, caisson = false;
};

std::string draw_displacement(CaseDraft& draft, const LayoutCurve& curve, const Behind& at) {
  Draw& draw = draft.draw;
  const double chance = draw.unit();
  if (draft.sane && (at.rigid || at.water || at.caisson)) return "free";
  if (curve.is_surface) return chance < 0.96 ? "free" : "roller";
  const bool can_absorb = draft.inertia && !(at.pore_water && draft.is_incompressible());
  if (chance < 0.3 && (can_absorb || !draft.sane)) return "absorbing";
  if (chance < 0.4 && draft.inertia) return "free";
  return chance < (curve.is_base ? 0.9 : 0.55) ? "fixed" : "roller";
}

std::string draw_pressure(CaseDraft& draft, const LayoutCurve& curve, const std::string& displacement) {
  Draw& draw = draft.draw;
  const double chance = draw.unit();
  const bool can_absorb = draft.inertia && !draft.is_incompressible();
  if (curve.is_level && !draft.layout.caisson) return "open";  // the only curve on which a load can act
  if (curve.is_level) return chance < 0.5 ? "open" : chance < 0.9 ? "surface_waves" : "sealed";
  if (curve.is_surface) return chance < 0.7 ? "open" : "sealed";
  const bool water = draft.is(curve.behind.front(), "water");
  if (chance < 0.25 && ((can_absorb && (displacement != "free" || water)) || !draft.sane)) return "absorbing";
  return chance < 0.75 ? "sealed" : "open";
}

}  // namespace

void write_boundaries(CaseDraft& draft) {
  for (const LayoutCurve& curve : draft.layout.curves) {
    const Behind at(draft, curve);
    draft.toml << "[boundaries." << curve.name << "]\n";
    const std::string displacement = draw_displacement(draft, curve, at);
    const std::string pressure = draw_pressure(draft, curve, displacement);
    if (displacement != "free" || !at.water) draft.toml << "displacement = \"" << displacement << "\"\n";
    if (!at.porous && !at.water) continue;
    draft.toml << "pressure = \"" << pressure << "\"\n";
    draft.pressure[curve.name] = pressure;
  }
  draft.toml << "\n";
}

}  // namespace upbead::test

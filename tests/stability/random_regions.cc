// Kinds of regions and their materials.
#include <algorithm>

#include "case_writer.h"

namespace upbead::test {

namespace {

constexpr double least_G = 1e4, largest_G = 1e11, largest_contrast = 1e6;

/// Least and largest of the values drawn for all regions.
struct Spread {
  double least = INFINITY, largest = 0.;
  void add(double value) { least = std::min(least, value), largest = std::max(largest, value); }
};

struct Spreads {
  Spread G, k, nu;
};

double draw_nu(Draw& draw) {
  const double at = draw.unit();
  if (at < 0.12) return 0.;
  if (at < 0.24) return 0.4999;
  return at < 0.5 ? 0.5 - draw.log_uniform(1e-4, 0.2) : draw.uniform(0., 0.49);
}

/// G of a region: for the first any value, for the others within a factor of 1e6 of it.
double draw_G(Draw& draw, Spread& G) {
  const double ratio = draw.ranged(1. / largest_contrast, largest_contrast);
  double value = G.largest == 0. ? draw.ranged(least_G, largest_G) : G.largest * ratio;
  if (G.largest > 0.)
    value = std::min(std::max({value, least_G, G.largest / largest_contrast}), G.least * largest_contrast);
  value = std::min(value, largest_G);
  G.add(value);
  return value;
}

void write_damping(CaseDraft& draft) {
  Draw& draw = draft.draw;
  if (!draw.chance(0.4)) return;
  const double low = draw.log_uniform(0.01, 1000.), high = low * draw.log_uniform(1.5, 100.);
  draft.toml << "damping = { ratio = " << number(draw.log_uniform(1e-3, 0.5)) << ", frequencies = [" << number(low)
             << ", " << number(high) << "] }\n";
}

void write_elastic(CaseDraft& draft, Spreads& spreads) {
  const double nu = draw_nu(draft.draw);
  spreads.nu.add(nu);
  draft.toml << "shear_modulus = " << number(draw_G(draft.draw, spreads.G)) << "\npoissons_ratio = " << number(nu)
             << "\n";
}

void write_porous(CaseDraft& draft, const std::string& name, Spreads& spreads) {
  Draw& draw = draft.draw;
  std::string flow = draw.one_of({"auto", "darcy", "inertial", "inertial", "drained"});
  if (draft.sane && !draft.inertia && flow == "inertial") flow = "darcy";
  draft.flow[name] = flow;
  write_elastic(draft, spreads);
  const double porosity = draw.chance(0.2) ? draw.one_of({0.02, 0.98}) : draw.uniform(0.1, 0.6);
  const double k = draw.ranged(1e-10, 1e3);
  spreads.k.add(k);
  draft.toml << "porosity = " << number(porosity) << "\ngrain_density = " << number(draw.uniform(1500., 4000.))
             << "\nhydraulic_conductivity = " << number(k) << "\nflow = \"" << flow
             << "\"\ntortuosity = " << number(draw.chance(0.5) ? 1. : draw.log_uniform(1., 10.)) << "\n";
  if (draw.chance(0.3)) {
    draft.toml << "biot = " << number(draw.uniform(porosity, 1.)) << "\n";
    if (draw.chance(0.7)) draft.toml << "grain_bulk_modulus = " << number(draw.log_uniform(1e8, 1e12)) << "\n";
  }
  write_damping(draft);
}

std::string draw_kind(CaseDraft& draft, const std::string& name) {
  const double at = draft.draw.unit();
  std::string kind = at < 0.76 ? "porous" : at < 0.94 ? "solid" : "rigid";
  if (kind == "rigid" && draft.sane)
    for (const auto& [a, b] : draft.layout.touching)
      if ((a == name && draft.is(b, "rigid")) || (b == name && draft.is(a, "rigid")) || b == "caisson") kind = "solid";
  return kind;
}

void write_ground(CaseDraft& draft, const std::string& name, Spreads& spreads) {
  const std::string kind = draw_kind(draft, name);
  draft.kind[name] = kind;
  draft.toml << "[regions." << name << "]\nkind = \"" << kind << "\"\n";
  const double density = draft.draw.log_uniform(300., 8000.);
  if (kind == "porous") write_porous(draft, name, spreads);
  if (kind != "porous") draft.toml << "density = " << number(density) << "\n";
  if (kind == "solid") {
    write_elastic(draft, spreads);
    draft.toml << "deformation = \"" << draft.draw.one_of({"auto", "elastic"}) << "\"\n";
    write_damping(draft);
  }
  draft.toml << "\n";
}

void write_caisson(CaseDraft& draft, Spreads& spreads) {
  Draw& draw = draft.draw;
  const bool rigid = draw.chance(0.7);
  draft.kind["caisson"] = rigid ? "rigid" : "solid";
  const bool can_slip = draft.inertia && draft.scheme != "generalised_alpha" && draft.scheme != "reduced";
  draft.friction = rigid && can_slip && draw.chance(0.25);
  draft.toml << "[regions.caisson]\nkind = \"" << draft.kind["caisson"]
             << "\"\ndensity = " << number(draw.uniform(1200., 3000.)) << "\n";
  if (!rigid) {
    write_elastic(draft, spreads);
    draft.toml << "deformation = \"" << draw.one_of({"auto", "elastic", "rigid"}) << "\"\n";
  }
  if (draft.friction)
    draft.toml << "interface = { kind = \"friction\", coefficient = " << number(draw.uniform(0.2, 1.2)) << " }\n";
  draft.toml << "\n";
}

std::string kinds_of(const CaseDraft& draft) {
  std::string text;
  for (const auto& [name, kind] : draft.kind) {
    text += text.empty() ? "" : "+";
    text += kind == "porous" ? draft.flow.at(name) : kind;
  }
  return text;
}

}  // namespace

void write_regions(CaseDraft& draft) {
  Spreads spreads;
  for (const std::string& name : draft.layout.ground) write_ground(draft, name, spreads);
  if (draft.layout.caisson) write_caisson(draft, spreads);
  for (const std::string& name : draft.layout.seas) {
    draft.kind[name] = "water";
    draft.toml << "[regions." << name << "]\nkind = \"water\"\ncompressibility = \""
               << draft.draw.one_of({"auto", "compressible", "incompressible"}) << "\"\n\n";
  }
  if (draft.friction && draft.layout.seas.empty())
    draft.toml << "[initial]\nwater_level = " << number(draft.layout.middle[1]) << "\n\n";
  const auto least = [](const Spread& s) { return s.largest > 0. ? number(s.least) : std::string(); };
  const auto largest = [](const Spread& s) { return s.least < INFINITY ? number(s.largest) : std::string(); };
  draft.facts.emplace_back("regions", kinds_of(draft));
  draft.facts.emplace_back("G_min", least(spreads.G));
  draft.facts.emplace_back("G_max", largest(spreads.G));
  draft.facts.emplace_back("k_min", least(spreads.k));
  draft.facts.emplace_back("k_max", largest(spreads.k));
  draft.facts.emplace_back("nu_max", largest(spreads.nu));
  draft.facts.emplace_back("friction", draft.friction ? "1" : "0");
}

}  // namespace upbead::test

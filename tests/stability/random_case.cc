#include "random_case.h"

#include <cstdio>

#include "case_writer.h"

namespace upbead::test {

std::string number(double value) {
  if (std::isinf(value)) return "inf";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

namespace {

void write_fluid(CaseDraft& draft) {
  Draw& draw = draft.draw;
  const bool infinite = draw.chance(0.25);
  draft.bulk_modulus = infinite ? INFINITY : draw.ranged(1e5, 1e12);
  const bool air = draft.bulk_modulus < 1e6 && draw.chance(0.5);
  draft.toml << "[fluid]\ndensity = " << (air ? "1.2" : "1030.0") << "\nbulk_modulus = " << number(draft.bulk_modulus)
             << "\n\n";
  draft.facts.emplace_back("K_f", number(draft.bulk_modulus));
}

void write_mesh(CaseDraft& draft) {
  const int degree = draft.draw.chance(0.25) ? 3 : 2;
  draft.toml << "[mesh]\n"
             << draft.layout.mesh << "degree = " << degree
             << "\nfull_domain = " << (draft.draw.chance(0.5) ? "true" : "false") << "\n\n";
  draft.facts.emplace_back("degree", std::to_string(degree));
  draft.facts.emplace_back("depth", number(draft.layout.depth));
  draft.facts.emplace_back("aspect", number(draft.layout.aspect));
}

void choose_time(CaseDraft& draft) {
  Draw& draw = draft.draw;
  draft.sane = draw.chance(0.97);
  draft.inertia = draw.chance(0.85) || (draft.sane && !draft.layout.seas.empty());
  draft.step = draw.ranged(1e-7, 10.);
  const int n = draw.whole(6, 40);
  draft.end = n * draft.step;
  const double at = draw.unit();
  draft.scheme = at < 0.4 ? "generalised_alpha" : at < 0.85 ? "sdirk4" : at < 0.93 ? "reduced" : "auto";
  const bool can_reduce = draft.inertia && draft.layout.caisson;
  if (draft.sane && draft.scheme == "reduced" && !can_reduce) draft.scheme = "sdirk4";
  draft.facts.emplace_back("step", number(draft.step));
  draft.facts.emplace_back("scheme", draft.scheme);
  draft.facts.emplace_back("inertia", draft.inertia ? "1" : "0");
}

void write_time(CaseDraft& draft) {
  draft.toml << "[time]\nend = " << number(draft.end) << "\nstep = " << number(draft.step) << "\nscheme = \""
             << draft.scheme << "\"\ninertia = " << (draft.inertia ? "true" : "false") << "\n\n";
}

void write_probes(CaseDraft& draft) {
  if (draft.layout.caisson && draft.draw.chance(0.4)) return;
  for (std::size_t i = 0; i < draft.layout.probes.size(); ++i) {
    const auto& [x, y] = draft.layout.probes[i];
    draft.toml << "[probes." << static_cast<char>('A' + i) << "]\nat = [" << number(x) << ", " << number(y) << "]\n\n";
  }
}

}  // namespace

RandomCase random_case(std::uint64_t seed, std::uint64_t scene, const std::string& section_geo) {
  Draw draw(seed, scene);
  CaseDraft draft(draw, draw.chance(0.8) ? draw_section(draw, section_geo) : draw_shipped(draw));
  draft.toml << "title = \"scene " << scene << " of seed " << seed << "\"\n\n";
  choose_time(draft);
  write_fluid(draft);
  write_mesh(draft);
  write_regions(draft);
  write_boundaries(draft);
  write_loads(draft);
  write_time(draft);
  write_probes(draft);
  return {draft.toml.str(), draft.facts};
}

}  // namespace upbead::test

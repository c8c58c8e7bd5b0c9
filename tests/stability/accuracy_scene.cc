#include "accuracy_scene.h"

#include <algorithm>
#include <sstream>

#include "case_writer.h"
#include "draw.h"

namespace upbead::test {

namespace {

struct Section {
  bool mound = true, pad = false, elastic = false, absorbing = false;
  double width = 18., height = 16., weight = 0.;  ///< of the caisson (m, m, N/m)
  double base = 6.;                               ///< height of its bottom (m)
};

struct Writer {
  Draw draw;
  std::ostringstream toml;
  std::vector<std::pair<std::string, std::string>> facts;
  Section section;

  void fact(const std::string& name, const std::string& value) { facts.emplace_back(name, value); }
};

using Values = std::vector<std::pair<std::string, double>>;

void write_parameters(Writer& w, const Values& values) {
  w.toml << "[mesh.parameters]\n";
  for (const auto& [name, value] : values) w.toml << name << " = " << number(value) << "\n";
  w.toml << "\n";
}

void write_mounded(Writer& w) {
  Draw& draw = w.draw;
  Section& s = w.section;
  s.base = draw.uniform(1., 10.);
  const double half = 0.5 * s.width;
  w.toml << "geometry = \"composite\"\n";
  write_parameters(w, {{"seabed_depth", draw.uniform(4., 15.)},
                       {"seabed_front", draw.uniform(25., 80.)},
                       {"seabed_back", draw.uniform(25., 80.)},
                       {"mound_height", s.base},
                       {"mound_crest_front", half + draw.uniform(1., 12.)},
                       {"mound_crest_back", half + draw.uniform(1., 12.)},
                       {"mound_slope", draw.uniform(1.1, 3.)},
                       {"caisson_width", s.width},
                       {"caisson_height", s.height}});
}

void write_flat(Writer& w, const std::string& section_geo) {
  Draw& draw = w.draw;
  Section& s = w.section;
  s.base = 0.;
  s.pad = draw.chance(0.4);
  w.toml << "file = \"" << section_geo << "\"\n";
  write_parameters(w, {{"left_width", draw.uniform(20., 50.)},
                       {"middle_width", s.width},
                       {"right_width", draw.uniform(20., 50.)},
                       {"lower_height", draw.uniform(3., 12.)},
                       {"upper_height", draw.log_uniform(0.5, 8.)},
                       {"wet_height", 0.6 * s.height},
                       {"dry_height", 0.4 * s.height},
                       {"columns_left", 4},
                       {"columns_middle", 3},
                       {"columns_right", 4},
                       {"rows_lower", 2},
                       {"rows_wet", 2},
                       {"pad", s.pad ? 1. : 0.}});
}

void write_soil(Writer& w, const std::string& name, double G, double k) {
  Draw& draw = w.draw;
  w.toml << "[regions." << name << "]\nkind = \"porous\"\nshear_modulus = " << number(G)
         << "\npoissons_ratio = " << number(draw.uniform(0.1, 0.45))
         << "\nporosity = " << number(draw.uniform(0.3, 0.5))
         << "\ngrain_density = 2650.0\nhydraulic_conductivity = " << number(k) << "\n";
  if (!draw.chance(0.15))
    w.toml << "damping = { ratio = " << number(draw.log_uniform(0.01, 0.1)) << ", frequencies = [1, 10] }\n";
  w.toml << "\n";
}

void write_grounds(Writer& w) {
  Draw& draw = w.draw;
  const double G = draw.log_uniform(8e6, 1.5e8), contrast = draw.log_uniform(1. / 30., 30.);
  if (w.section.mound) {
    write_soil(w, "seabed", G, draw.log_uniform(1e-5, 1e-2));
    write_soil(w, "mound", G * draw.log_uniform(0.5, 10.), draw.log_uniform(1e-2, 0.5));
    return;
  }
  write_soil(w, "lower", G, draw.log_uniform(1e-5, 1e-2));
  write_soil(w, "upper", std::clamp(G * contrast, 2e6, 1e9), draw.log_uniform(1e-5, 1e-1));
  if (w.section.pad) write_soil(w, "pad", G * draw.log_uniform(1., 10.), draw.log_uniform(1e-2, 0.5));
  w.fact("contrast", number(contrast));
}

void write_caisson(Writer& w, bool contact) {
  Draw& draw = w.draw;
  Section& s = w.section;
  const double density = draw.uniform(1900., 2300.);
  s.weight = 9.81 * density * s.width * s.height;
  w.toml << "[regions.caisson]\ndensity = " << number(density) << "\n";
  if (s.elastic)
    w.toml << "kind = \"solid\"\nyoungs_modulus = " << number(draw.log_uniform(1e9, 3e10))
           << "\npoissons_ratio = 0.2\ndeformation = \"elastic\"\n\n";
  else
    w.toml << "kind = \"rigid\"\n" << (contact ? "interface = { kind = \"friction\" }\n\n" : "\n");
}

void write_sides(Writer& w) {
  Draw& draw = w.draw;
  Section& s = w.section;
  const std::string side = draw.one_of({"roller", "roller", "fixed", "absorbing", "absorbing"});
  s.absorbing = side == "absorbing";
  w.toml << "[boundaries]\nbase = { displacement = \"fixed\", pressure = \"sealed\" }\n";
  for (const char* name : {"left", "right"})
    w.toml << name << " = { displacement = \"" << side << "\", pressure = \"sealed\" }\n";
  w.toml << "bed = { pressure = \"open\" }\n";
  if (s.mound) w.toml << "mound_surface = { pressure = \"open\" }\n";
  w.toml << "front = {}\nback = {}\ntop = {}\n\n";
  w.fact("sides", side);
}

/// Returns the duration (s).
double write_pulse(Writer& w, const std::string& load, double peak, double shortest, double longest) {
  Draw& draw = w.draw;
  const double duration = draw.log_uniform(shortest, longest), rise = draw.uniform(0.2, 0.8) * duration;
  const std::string shape = draw.one_of({"triangle", "triangle", "half_sine", "church_roof"});
  w.toml << "[loads." << load << ".pulse]\nshape = \"" << shape << "\"\npeak = " << number(peak)
         << "\nduration = " << number(duration) << "\n";
  if (shape != "half_sine") w.toml << "rise = " << number(rise) << "\n";
  if (shape == "church_roof")
    w.toml << "plateau = " << number(draw.uniform(0.2, 0.7)) << "\nplateau_duration = " << number(2. * duration)
           << "\n";
  w.toml << "\n";
  return shape == "church_roof" ? 2. * duration : duration;
}

double write_loads(Writer& w) {
  Draw& draw = w.draw;
  const Section& s = w.section;
  const double peak = 0.36 * s.weight * draw.uniform(0.8, 4.);
  const int n = draw.one_of({1, 1, 1, 2, 3});
  w.toml << "[loads.a]\nboundary = \"front\"\nkind = \"force\"\ndirection = [1.0, 0.0]\n";
  const double first = write_pulse(w, "a", peak, draw.chance(0.15) ? 0.02 : 0.05, 4.);
  const double shortest = std::max(0.05, 0.1 * first), longest = std::max(1., first);
  double last = first;
  if (n > 1) {
    w.toml << "[loads.b]\nboundary = \"" << (s.mound ? "mound_surface" : "bed") << "\"\nkind = \"pressure\"\n";
    last = std::max(last, write_pulse(w, "b", draw.uniform(0.05, 0.5) * peak / s.height, shortest, longest));
  }
  if (n > 2) {
    if (s.elastic)
      w.toml << "[loads.c]\nboundary = \"top\"\nkind = \"traction\"\ndirection = [0.6, -0.8]\n";
    else
      w.toml << "[loads.c]\nregion = \"caisson\"\nat = [" << (s.mound ? "0.0" : "40.0") << ", "
             << number(s.base + draw.uniform(0.2, 0.9) * s.height) << "]\ndirection = [1.0, -0.3]\n";
    last = std::max(last,
                    write_pulse(w, "c", draw.uniform(0.1, 0.7) * peak / (s.elastic ? s.width : 1.), shortest, longest));
  }
  w.fact("loads", std::to_string(n));
  w.fact("duration", number(first));
  return last;
}

}  // namespace

RandomCase accuracy_scene(std::uint64_t seed, std::uint64_t scene, const std::string& section_geo, double part) {
  Writer w{Draw(seed, scene), {}, {}, {}};
  Draw& draw = w.draw;
  Section& s = w.section;
  s.mound = draw.chance(0.65);
  s.elastic = draw.chance(0.25);
  s.width = draw.uniform(8., 24.);
  s.height = draw.uniform(8., 20.);
  const bool contact = !s.elastic && draw.chance(0.06);
  const double tolerance = part * draw.log_uniform(0.02, 0.08);
  const std::string of = draw.one_of({"history", "peak"});
  w.fact("mound", s.mound ? "1" : "0");
  w.fact("elastic", s.elastic ? "1" : "0");
  w.fact("contact", contact ? "1" : "0");
  w.fact("tolerance", number(tolerance));
  w.fact("of", of);
  w.toml << "title = \"accuracy " << scene << " of seed " << seed << "\"\n\n[mesh]\nrefine = \"auto\"\n";
  if (s.mound)
    write_mounded(w);
  else
    write_flat(w, section_geo);
  write_grounds(w);
  write_caisson(w, contact);
  write_sides(w);
  const double last = write_loads(w);
  w.toml << "[time]\nend = " << number(last * draw.uniform(1.1, 2.) + draw.uniform(0.1, 0.8))
         << "\n\n[accuracy]\ntolerance = " << number(tolerance) << "\nof = \"" << of
         << "\"\n\n[sliding]\nfriction = 0.6\nsubmerged_weight = " << number(0.6 * s.weight) << "\n";
  return {w.toml.str(), w.facts};
}

}  // namespace upbead::test

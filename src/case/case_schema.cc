#include "case_schema.h"

#include "case/records/measured.h"
#include "input/report_table.h"
#include "model/words.h"

namespace upbead {

namespace {

const Words<AccuracyOf> accuracy_of_words{{"peak", AccuracyOf::peak}, {"history", AccuracyOf::history}};

TableSchema<MeshChoice> mesh_schema() {
  TableSchema<MeshChoice> table;
  table.key("geometry", &MeshChoice::geometry, "", "name of a shipped geometry; or file");
  table.key("file", &MeshChoice::file, "", "path of a .geo or .msh (2.2 or 4.1) file of gmsh with named groups");
  table.key("parameters", &MeshChoice::parameters, "",
            "values of the .geo's own parameters (DefineConstant) by name; the geometry's own where not given");
  table
      .key("refine", &MeshChoice::refine, "",
           "number of uniform refinements; auto: cells are split until the error that they make in F_T is below the "
           "tolerance",
           from_to(0., 6.))
      .or_word("auto");
  table.key("degree", &MeshChoice::degree, "",
            "polynomial degree of the displacement; that of the pressure is one less; 3 where refine is auto",
            from_to(2., 3.));
  table
      .key("full_domain", &MeshChoice::full_domain, "",
           "true: solve also where no wave could come from the loads and be read of before the end")
      .formerly("keep_unreached");
  return table;
}

TableSchema<Boundary> boundary_schema() {
  TableSchema<Boundary> table;
  table.choice("displacement", &Boundary::displacement, displacement_words,
               "condition on the displacement; roller: no normal motion; absorbing: waves leave; plate: a rigid smooth "
               "plate lies on a straight side, which shifts along its normal as a whole; level: the side of level "
               "ground without end, which under a base that is shaken horizontally has no vertical motion, vertically "
               "no horizontal one, and in both directions moves as the other level side");
  table.choice("pressure", &Boundary::pressure, pressure_words,
               "condition on the water, of pores or free; open: p = 0; absorbing: waves leave; surface_waves: gravity "
               "waves on a level of free water; needed where the boundary meets water");
  table
      .key("spring", &Boundary::spring, "Pa/m", "stress per displacement along the normal and along the tangent",
           at_least(0.))
      .fallback("none");
  table
      .key("dashpot", &Boundary::dashpot, "Pa s/m",
           "stress per velocity along the normal and along the tangent; takes energy as an absorbing side does",
           at_least(0.))
      .fallback("none");
  return table;
}

TableSchema<Surcharge> surcharge_schema() {
  TableSchema<Surcharge> table;
  table.key("boundary", &Surcharge::boundary, "", "curve of the ground's surface that it lies on").required();
  table
      .key("weight", &Surcharge::weight, "Pa",
           "its weight in water per horizontal area: thickness times (1 - pores) (density - fluid.density) gravity",
           above(0.))
      .required();
  table.key("from", &Surcharge::from, "m", "x of its seaward end").fallback("the curve's end");
  table.key("to", &Surcharge::to, "m", "x of its landward end").fallback("the curve's end");
  return table;
}

TableSchema<InitialState> initial_schema() {
  TableSchema<InitialState> table;
  table.key("water_level", &InitialState::water_level, "m", "height y of still water")
      .fallback("the top of the regions of water");
  table
      .key("harbour_level", &InitialState::harbour_level, "m",
           "height y of still water behind the caisson, where water_level is that of the sea: their push, and the "
           "pressure under the base that falls from one to the other, then are in the stresses at rest, W', the "
           "margins and S")
      .fallback("one level");
  table.key("k0", &InitialState::k0, "", "ratio K_0 of horizontal to vertical effective stress", between(0., 5.))
      .fallback("from the elastic solution");
  table.choice(
      "start", &InitialState::start, rest_start_words,
      "what hysteretic soil bears of the stress at rest by its overlay; k0: that of level ground; virgin: nothing; "
      "gravity: all of it, as if it had been loaded at once. Nobody knows it: the other two are bounds");
  table.key("bounds", &InitialState::bounds, "",
            "whether hysteretic soil is solved from the other two starts, too, which takes three times as long");
  table.key("safety", &InitialState::safety, "",
            "whether it is sought by which factor c', tan phi' and tan psi' of all soils may fall before they fail at "
            "rest, under the weights alone");
  table.tables("surcharge", &InitialState::surcharge, surcharge_schema())
      .doc(
          "What lies on the ground, by name: foot-protection blocks, armour. It presses on the ground at rest "
          "(stiffness by "
          "stress, strength, forces of contact), and has no mass: waves do not shake it.");
  return table;
}

TableSchema<ConstructionStage> construction_schema() {
  TableSchema<ConstructionStage> table;
  table
      .key("order", &ConstructionStage::order, "", "place among the stages; the first is the ground as it is found",
           at_least(0.))
      .required();
  table
      .key("regions", &ConstructionStage::regions, "",
           "regions that appear in this stage, without stress, on what stands already; water is always there")
      .fallback("none");
  table
      .key("caisson_share", &ConstructionStage::caisson_share, "",
           "share of the caisson's weight in air that stands from this stage on; an empty caisson has less than 1, and "
           "a later stage fills it",
           above(0.))
      .fallback("as before; all of a new caisson");
  table.key("water_level", &ConstructionStage::water_level, "m", "height y of still water in this stage")
      .fallback("that before the waves");
  return table;
}

TableSchema<TimeChoice> time_schema() {
  TableSchema<TimeChoice> table;
  table.key("end", &TimeChoice::end, "s", "end of the computed time", above(0.))
      .fallback("when the loads and the section's answer to them are over; explain tells it");
  table.key("step", &TimeChoice::step, "s", "time step; auto: chosen from the loads and the tolerance", above(0.))
      .or_word("auto");
  table.choice("scheme", &TimeChoice::scheme, time_scheme_words,
               "how to solve in time: reduced (a sum of modes, as many as its measured error asks for) or a march");
  table.key("inertia", &TimeChoice::inertia, "", "whether inertia counts; false: quasi-static (consolidation)");
  table.key("growth", &TimeChoice::growth, "",
            "factor by which the steps of a consolidation grow every eighth step, once the loads keep their values, up "
            "to a 50th of end; 1: equal steps",
            from_to(1., 10.));
  table
      .key("stop_at_energy", &TimeChoice::stop_at_energy, "",
           "share of the largest energy; the run stops once the loads are over and the energy has fallen below it",
           between(0., 1.))
      .fallback("never before end");
  return table;
}

TableSchema<Probe> probe_schema() {
  TableSchema<Probe> table;
  table.key("at", &Probe::at, "m", "point (x, y) to read").required();
  return table;
}

TableSchema<CaseTables> accuracy_schema() {
  TableSchema<CaseTables> table;
  table.key("tolerance", &CaseTables::tolerance, "",
            "error allowed in the shear force F_T, over its largest; sets what is auto", between(0., 1.));
  table.choice("of", &CaseTables::accuracy_of, accuracy_of_words,
               "what of F_T the tolerance makes the mesh for, where refine is auto: history: F_T at every time, and so "
               "its peak; peak: that alone, on fewer cells");
  table.key(
      "estimate", &CaseTables::accuracy_estimate, "",
      "true: estimate the errors of F_T and S where refine is a number, too: solves once more on cells half as large");
  return table;
}

TableSchema<CaseTables> output_schema() {
  TableSchema<CaseTables> fields;
  fields.key("every", &CaseTables::fields_every, "s", "time between two written fields", above(0.)).required();
  TableSchema<CaseTables> table;
  table.section("fields", fields).doc("Fields of the whole mesh; none are computed or written without this table.");
  table.key("base", &CaseTables::base_stress, "",
            "true: stress and pore pressure along the caisson's bottom over time, in /base of results.h5");
  table.key(
      "periods", &CaseTables::periods, "",
      "whether natural periods of the linear ground are sought where the case is marched, too; costs a reduced model");
  table
      .key("times", &CaseTables::output_times, "s",
           "times at which all readings are written to times.csv and /at_times of results.h5, and, with fields, these "
           "are written; the steps meet them",
           above(0.))
      .fallback("none");
  table
      .key("every", &CaseTables::output_every, "s",
           "time between values of smooth histories, in /dense of results.h5; between the ends of steps as accurate as "
           "the scheme",
           above(0.))
      .fallback("only the steps' own times");
  return table;
}

}  // namespace

TableSchema<Fluid> fluid_schema() {
  TableSchema<Fluid> table;
  table.key("density", &Fluid::density, "kg/m3", "density of the water", above(0.));
  table.key("bulk_modulus", &Fluid::bulk_modulus, "Pa", "bulk modulus of the water; inf is allowed",
            above(0.).or_infinite());
  table.key("viscosity", &Fluid::viscosity, "Pa s", "dynamic viscosity of the water, for regions with a permeability",
            above(0.));
  table.key("atmospheric_pressure", &Fluid::atmospheric_pressure, "Pa",
            "pressure of the air on still water, for regions with a saturation below 1", at_least(0.));
  return table;
}

std::vector<std::string> tables_of_designs() {
  return {"levels",  "ground",   "waves",  "sea",         "storms",     "life",
          "scatter", "dynamics", "impact", "calibration", "reliability"};
}

TableSchema<CaseTables> case_schema() {
  TableSchema<CaseTables> table;
  table.key("title", &CaseTables::title, "", "title of the case");
  table.key("gravity", &CaseTables::gravity, "m/s2", "acceleration of gravity", above(0.));
  table.table("fluid", &CaseTables::fluid, fluid_schema()).doc("Pore water and sea water.");
  table.table("mesh", &CaseTables::mesh, mesh_schema()).doc("Exactly one of geometry and file is needed.");
  table.tables("regions", &CaseTables::regions, region_schema())
      .doc(
          "One table per physical surface of the mesh, by its name. The region called caisson is the one whose bottom "
          "shear is read.");
  table.tables("boundaries", &CaseTables::boundaries, boundary_schema())
      .doc("One table per physical curve of the mesh, by its name; every outer curve needs one.");
  table.tables("loads", &CaseTables::load_tables, load_schema())
      .doc(
          "Any number of loads by name, each on exactly one of boundary and region, with exactly one of pulse and "
          "history, or with a wave.");
  table.table("section", &CaseTables::section, section_schema())
      .doc("The breakwater's cross-section for loads by waves, as in a design; [sliding] takes mu and W' from it.");
  table.table("duration", &CaseTables::duration, duration_schema())
      .doc("k(alpha*) in tau_0 = k tau_0F, as in a design: of loads by waves, and of S by eq. (4) and (7).");
  table.table("combined", &CaseTables::combined, combined_schema())
      .doc("Water and uplift beside a standing wave with a pulse, as in a design: of S by formulas.");
  table.table("initial", &CaseTables::initial, initial_schema())
      .doc("The state before the waves, for soils whose stiffness depends on stress.");
  table.tables("construction", &CaseTables::construction, construction_schema())
      .doc(
          "Stages in which the section is built, by name, in their `order`; each drained. Stresses at rest are then "
          "those after the last stage, and settlement per stage is a result; without stages all weights are put on at "
          "once.");
  table.table("time", &CaseTables::time, time_schema());
  table.section("accuracy", accuracy_schema());
  table.tables("probes", &CaseTables::probes, probe_schema()).doc("Point readings by name.");
  table.tables("measured", &CaseTables::measured, measured_schema())
      .doc("Records by name that the run is compared with; drawn beside it, with their differences in the summary.");
  table.section("output", output_schema());
  table.table("sliding", &CaseTables::sliding_table, sliding_schema())
      .doc("How far the caisson slides, Shimosako and Takahashi (1994); not asked without this table.");
  table.table("cycles", &CaseTables::cycles_table, cycles_schema())
      .doc(
          "The waves of a storm, of which the loads of the case are one: residual pore pressure, settlement and tilt, "
          "where a region has a table cyclic. Not asked without this table; empty it takes the sea states of [sea].");
  table.table("limits", &CaseTables::limits, limits_schema())
      .doc("What the section is checked against; a quantity without a limit is reported, but not judged.");
  table.table("report", &CaseTables::report, report_table()).doc(report_table_doc);
  table.elsewhere(tables_of_designs());  // a case may be a design, too
  return table;
}

}  // namespace upbead

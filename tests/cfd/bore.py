#!/usr/bin/python3
"""A bore on a caisson's wall by OpenFOAM (interFoam), and the response of the breakwater to the pressures of that
flow.

usage: bore.py PROGRAM [-o FOLDER]

A column of water falls, runs over still water as a bore and hits the wall. The flow is plane, one cell thick. Its forces
(in all layouts that this OpenFOAM can write, and others made of them), probes at every cell of the wall and the sampled
patch are loads of one breakwater; the shear forces F_T must agree within 1 %."""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys

LENGTH, HEIGHT, WALL, THICK = 4.0, 1.0, 0.7, 0.25  # m: flume, its air, the wall, one cell across
CELL = 0.025
STILL, COLUMN, COLUMN_LENGTH = 0.2, 0.55, 1.0  # m
END = 2.0  # s
TOLERANCE = 0.01

HEAD = "FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"


def dictionaries():
    """{path: text} of the files of the case."""
    below, above = round(WALL / CELL), round((HEIGHT - WALL) / CELL)
    along = round(LENGTH / CELL)
    corners = [(x, y, z) for y in (0, THICK) for z in (0, WALL, HEIGHT) for x in (0, LENGTH)]
    points = " ".join(f"({x} {y} {z})" for x, y, z in corners)
    probes = " ".join(f"({LENGTH - CELL / 2} {THICK / 2} {(i + 0.5) * CELL:.6f})" for i in range(below))
    controls = f"""application interFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {END}; deltaT 0.001;
writeControl adjustableRunTime; writeInterval 1; writeFormat ascii; writePrecision 8; timePrecision 8;
adjustTimeStep yes; maxCo 0.5; maxAlphaCo 0.5; maxDeltaT 0.005;
functions {{
  forces {{ type forces; libs ("libforces.so"); patches (wall); rho rho; CofR ({LENGTH} {THICK / 2} 0);
    executeControl adjustableRunTime; executeInterval 0.01; writeControl adjustableRunTime; writeInterval 0.01; }}
  probes {{ type probes; libs ("libsampling.so"); fields (p p_rgh); probeLocations ({probes} (5 0.1 0.1));
    writeControl adjustableRunTime; writeInterval 0.01; }}
  patch {{ type surfaces; libs ("libsampling.so"); fields (p p_rgh); interpolationScheme cell; surfaceFormat raw;
    surfaces (wall {{ type patch; patches (wall); interpolate false; }} bed {{ type patch; patches (bed); interpolate false; }});
    writeControl adjustableRunTime; writeInterval 0.01; }}
}}
"""
    # corner numbers: 6 in front, 6 behind; 0 1 below, 2 3 at the wall's crest, 4 5 above
    mesh = f"""convertToMeters 1; vertices ({points});
blocks (hex (0 1 7 6 2 3 9 8) ({along} 1 {below}) simpleGrading (1 1 1) hex (2 3 9 8 4 5 11 10) ({along} 1 {above}) simpleGrading (1 1 1));
edges (); boundary (
  bed {{ type wall; faces ((0 1 7 6)); }}
  seaward {{ type wall; faces ((0 2 8 6) (2 4 10 8)); }}
  wall {{ type wall; faces ((1 3 9 7)); }}
  air {{ type patch; faces ((3 5 11 9) (4 5 11 10)); }}
  sides {{ type empty; faces ((0 1 3 2) (2 3 5 4) (6 7 9 8) (8 9 11 10)); }}
);
"""
    solids = "(bed|seaward|wall)"
    velocity = f"""dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField {{ "{solids}" {{ type noSlip; }} air {{ type pressureInletOutletVelocity; value uniform (0 0 0); }} sides {{ type empty; }} }}
"""
    pressure = f"""dimensions [1 -1 -2 0 0 0 0]; internalField uniform 0;
boundaryField {{ "{solids}" {{ type fixedFluxPressure; value uniform 0; }} air {{ type totalPressure; p0 uniform 0; }} sides {{ type empty; }} }}
"""
    water = f"""dimensions [0 0 0 0 0 0 0]; internalField uniform 0;
boundaryField {{ "{solids}" {{ type zeroGradient; }} air {{ type inletOutlet; inletValue uniform 0; value uniform 0; }} sides {{ type empty; }} }}
"""
    fields = f"""defaultFieldValues (volScalarFieldValue alpha.water 0);
regions (
  boxToCell {{ box (0 -1 0) ({LENGTH} 1 {STILL}); fieldValues (volScalarFieldValue alpha.water 1); }}
  boxToCell {{ box (0 -1 0) ({COLUMN_LENGTH} 1 {COLUMN}); fieldValues (volScalarFieldValue alpha.water 1); }}
);
"""
    schemes = """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { div(rhoPhi,U) Gauss linearUpwind grad(U); div(phi,alpha) Gauss vanLeer; div(phirb,alpha) Gauss linear;
  div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
"""
    solution = """solvers {
  "alpha.water.*" { nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1; MULESCorr yes; nLimiterIter 5; solver smoothSolver;
    smoother symGaussSeidel; tolerance 1e-8; relTol 0; }
  "pcorr.*" { solver PCG; preconditioner DIC; tolerance 1e-6; relTol 0; }
  p_rgh { solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0.01; }
  p_rghFinal { solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0; }
  "U.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-7; relTol 0; } }
PIMPLE { momentumPredictor no; nOuterCorrectors 1; nCorrectors 3; nNonOrthogonalCorrectors 0; }
"""
    phases = """phases (water air);
water { transportModel Newtonian; nu 1e-6; rho 1000; } air { transportModel Newtonian; nu 1.5e-5; rho 1.2; } sigma 0.07;
"""
    return {
        "system/controlDict": ("dictionary", controls), "system/blockMeshDict": ("dictionary", mesh),
        "system/setFieldsDict": ("dictionary", fields), "system/fvSchemes": ("dictionary", schemes),
        "system/fvSolution": ("dictionary", solution), "constant/transportProperties": ("dictionary", phases),
        "constant/turbulenceProperties": ("dictionary", "simulationType laminar;\n"),
        "constant/g": ("uniformDimensionedVectorField", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n"),
        "0/U": ("volVectorField", velocity), "0/p_rgh": ("volScalarField", pressure),
        "0/alpha.water": ("volScalarField", water),
    }


def run_flow(folder):
    """Writes and runs the case; its files are then below folder/postProcessing."""
    shutil.rmtree(folder, ignore_errors=True)
    for path, (kind, text) in dictionaries().items():
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(HEAD.format(kind=kind, name=file.name) + text)
    environment = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}
    for program in ("blockMesh", "setFields", "interFoam"):
        with open(folder / f"log.{program}", "w") as log:
            if subprocess.run([program], cwd=folder, env=environment, stdout=log, stderr=log).returncode != 0:
                sys.exit(f"{program} failed: see {folder}/log.{program}")


def rows_of(path):
    for line in path.read_text().splitlines():
        if not line.startswith("#"):
            yield [word for word in line.replace("(", " ").replace(")", " ").split()]


def other_layouts(folder):
    """The forces as other versions of OpenFOAM write them."""
    source = folder / "postProcessing/forces/0"
    forces, moments = list(rows_of(source / "force.dat")), list(rows_of(source / "moment.dat"))
    centre = f"# CofR       : ({LENGTH} {THICK / 2} 0)\n"
    vector = lambda words: "(" + " ".join(words) + ")"
    for name, parts in {"foundation": "", "foundation_porous": " porous"}.items():
        zero = " (0 0 0)" if parts else ""
        lines = [f"{f[0]} ({vector(f[4:7])} {vector(f[7:10])}{zero}) ({vector(m[4:7])} {vector(m[7:10])}{zero})"
                 for f, m in zip(forces, moments)]
        target = folder / "postProcessing" / name / "0"
        target.mkdir(parents=True, exist_ok=True)
        head = f"# Forces\n{centre}# Time       forces(pressure viscous{parts}) moments(pressure viscous{parts})\n"
        (target / "forces.dat").write_text(head + "\n".join(lines) + "\n")
    target = folder / "postProcessing/plain/0"
    target.mkdir(parents=True, exist_ok=True)
    names = "\t".join(f"{group}_{axis}" for group in ("total", "pressure", "viscous") for axis in "xyz")
    for name, rows in (("force", forces), ("moment", moments)):
        text = f"# {name.capitalize()}\n{centre}# Time\t{names}\n" + "".join("\t".join(row) + "\n" for row in rows)
        (target / f"{name}.dat").write_text(text)


def scene(flow):
    """The breakwater's case file; the wall stands on the bed of the flume, at its landward end x = 4 m."""
    common = f'boundary = "front"\nlandward = "x"\nup = "z"\norigin = [{-LENGTH - 0.3}, 0.15]\nstill_time = [0.0, 0.3]\nfactor = 0.0\n'
    loads = ""
    for name in ("forces", "foundation", "foundation_porous", "plain"):
        loads += f'[loads.{name}]\nkind = "force"\nfrom = "{flow}/postProcessing/{name}"\nthickness = {THICK}\n{common}'
    against = f'against = "{flow}/postProcessing/forces"\nthickness = {THICK}\n'
    loads += (f'[loads.patch]\nkind = "pressures"\nfrom = "{flow}/postProcessing/patch"\nfile = "p_wall.raw"\nquantity = "p"\n'
              f"{against}{common}")
    loads += (f'[loads.probes]\nkind = "pressures"\nfrom = "{flow}/postProcessing/probes"\nfile = "p"\nquantity = "p"\nwithin = {CELL}\n'
              f'to_base = "constant"\nto_crest = "constant"\n{against}{common}')
    return f"""title = "A caisson under a bore by OpenFOAM"
[fluid]
density = 1000.0
bulk_modulus = 2.2e9
[mesh]
geometry = "composite"
degree = 2
parameters = {{ seabed_depth = 0.6, seabed_front = 4, seabed_back = 4, mound_height = 0.15, mound_crest_front = 0.5, mound_crest_back = 0.5, caisson_width = 0.6, caisson_height = {WALL} }}
[regions.seabed]
kind = "porous"
shear_modulus = 6.57e6
poissons_ratio = 0.33
porosity = 0.40
grain_density = 2650.0
hydraulic_conductivity = 1e-4
[regions.mound]
kind = "porous"
shear_modulus = 10.95e6
poissons_ratio = 0.30
porosity = 0.40
grain_density = 2650.0
hydraulic_conductivity = 0.03
[regions.caisson]
kind = "rigid"
density = 2100.0
[boundaries]
base = {{ displacement = "fixed", pressure = "sealed" }}
left = {{ displacement = "roller", pressure = "sealed" }}
right = {{ displacement = "roller", pressure = "sealed" }}
bed = {{ pressure = "open" }}
mound_surface = {{ pressure = "open" }}
front = {{ displacement = "free" }}
back = {{ displacement = "free" }}
top = {{ displacement = "free" }}
{loads}[time]
end = {END}
"""


def draw(folder, picture):
    """Pressures of the flow over the height of the wall, and the force on it by `forces` and by the sum over the
    patch's faces."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    post = folder / "postProcessing"
    forces = [(float(row[0]), float(row[1]) / THICK) for row in rows_of(post / "forces/0/force.dat")]
    times = sorted((path.name for path in (post / "patch").iterdir()), key=float)
    faces = {time: sorted((float(row[2]), float(row[3])) for row in rows_of(post / f"patch/{time}/p_wall.raw")) for time in times}
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.6), constrained_layout=True)
    for time in times[:: max(1, len(times) // 8)]:
        left.plot([p / 1e3 for _, p in faces[time]], [z for z, _ in faces[time]], label=f"{float(time):.2f} s")
    left.set(xlabel="p on the wall (kPa)", ylabel="z (m)")
    left.legend(fontsize=7)
    right.plot(*zip(*forces), color="black", label="forces")
    right.plot([float(time) for time in times], [sum(p for _, p in faces[time]) * CELL for time in times], "--", label="sum of faces")
    right.set(xlabel="t (s)", ylabel="force on the wall, with still water (N/m)")
    right.legend()
    picture.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(picture, dpi=110)


def solve(program, case, load, out):
    done = subprocess.run([program, "run", case, "--json", "--out", out, "--set", f"loads.{load}.factor=1.0"], capture_output=True,
                          text=True)
    if done.returncode != 0:
        sys.exit(done.stderr)
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("-o", "--out", type=pathlib.Path, default=pathlib.Path("results/cfd"))
    parser.add_argument("--keep", action="store_true", help="do not run the flow again")
    options = parser.parse_args()
    program, folder = options.program.resolve(), options.out.resolve()
    if not (options.keep and (folder / "flow/postProcessing").is_dir()):
        run_flow(folder / "flow")
    other_layouts(folder / "flow")
    case = folder / "bore.toml"
    case.write_text(scene("flow"))
    draw(folder / "flow", folder / "bore.png")
    print(f"{'load':<20}{'peak P (N/m)':>14}{'peak F_T (N/m)':>16}{'of forces':>11}")
    first, worst = None, 0.0
    for load in ("forces", "foundation", "foundation_porous", "plain", "patch", "probes"):
        response = solve(program, case, load, folder / load)["response"]
        shear = response["peak_shear"]
        first = first or shear
        worst = max(worst, abs(shear / first - 1))
        print(f"{load:<20}{response['peak_force']:14.1f}{shear:16.1f}{shear / first:11.5f}")
    print(f"largest difference {100 * worst:.2f} %, allowed {100 * TOLERANCE:.0f} %")
    return worst > TOLERANCE


if __name__ == "__main__":
    sys.exit(main())

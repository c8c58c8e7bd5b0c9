"""A state for ParaView: the fields of a run, coloured by pore pressure, warped by displacement, at all times. If soil
yields, the colours are the share of strength that it mobilises.

    pvpython postprocess/paraview_state.py results/NAME PICTURE.png      # a picture of the last time
    pvpython postprocess/paraview_state.py results/NAME PICTURE.png pressure        # by another field of COLOURED
    UPBEAD_RESULT=results/NAME paraview --script=postprocess/paraview_state.py

or File > Load State with UPBEAD_RESULT set, or from within the folder of the run. The run needs [output] fields: the
program writes only fields.pvd and its .vtu files for ParaView, and COLOURED has all of their fields.
Tried with pvpython of ParaView 5.11 (Debian 12), not in its window.
"""

import json
import os
import sys
from pathlib import Path

try:
    from paraview import simple
except ImportError:
    sys.exit("paraview_state.py: there is no ParaView in this Python; run it by pvpython, or open it in paraview")

DISPLACEMENT, PRESSURE = "displacement_(m)", "pore_pressure_(Pa)"
MOBILISED, DISSIPATED = "mobilised_strength_(1)", "dissipated_energy_(J_m3)"
SIGNED, SIZED = "Cool to Warm", "Black-Body Radiation"  # colours of fields with two signs, and of magnitudes
COLOURED = {  # field, title, colours
    "pressure": (PRESSURE, "pore pressure (Pa)", SIGNED),
    "mobilised": (MOBILISED, "strength mobilised (1)", SIZED),
    "dissipated": (DISSIPATED, "energy taken by yielding (J/m3)", SIZED),
    "displacement": (DISPLACEMENT, "displacement (m)", SIZED),
    "velocity": ("velocity_(m_s)", "velocity (m/s)", SIZED),
    "acceleration": ("acceleration_(m_s2)", "acceleration (m/s2)", SIZED),
    "fluid": ("relative_fluid_displacement_(m)", "displacement of the water over the soil (m)", SIZED),
    "darcy": ("darcy_velocity_(m_s)", "Darcy velocity (m/s)", SIZED),
    "impulse": ("pressure_impulse_(Pa_s)", "impulse of the pore pressure (Pa s)", SIGNED),
    **{f"strain_{ij}": (f"strain_{ij}_(1)", f"strain {ij} (1)", SIGNED) for ij in ("xx", "yy", "xy")},
    **{f"stress_{ij}": (f"effective_stress_{ij}_(Pa)", f"effective stress {ij}, change (Pa)", SIGNED) for ij in ("xx", "yy", "xy", "zz")},
}
SHOWN = 0.03  # the largest displacement is drawn as this part of the section's height
SIZE, BLACK = [1600, 500], [0.0, 0.0, 0.0]


def result_folder():
    given = sys.argv[1] if len(sys.argv) > 1 else os.environ.get("UPBEAD_RESULT", ".")
    record = Path(given).resolve() / "fields.pvd"
    if not record.is_file():
        sys.exit(f"there is no '{record}'; run the case with --set 'output.fields={{ every = 0.02 }}', set UPBEAD_RESULT")
    return record


def chosen(reader):
    """The field of the colours: the second argument, else the strength if soil yields, else the pore pressure."""
    yields = MOBILISED in reader.PointData.keys()
    name = sys.argv[3] if len(sys.argv) > 3 else "mobilised" if yields else "pressure"
    if name not in COLOURED:
        sys.exit(f"there is no '{name}'; choose of {', '.join(COLOURED)}")
    if COLOURED[name][0] not in reader.PointData.keys():
        why = ": no soil yields" if name in ("mobilised", "dissipated") else ""
        sys.exit(f"the fields have no {COLOURED[name][0]}{why}")
    return COLOURED[name]


def largest(reader, times, field):
    """The largest displacement and the largest magnitude of a field over all times."""
    vector = reader.PointData[field].GetNumberOfComponents() > 1
    displacement = value = 0.0
    for time in times:
        simple.UpdatePipeline(time=time, proxy=reader)
        displacement = max(displacement, reader.PointData[DISPLACEMENT].GetRange(-1)[1])  # -1: the magnitude
        value = max(value, *map(abs, reader.PointData[field].GetRange(-1 if vector else 0)))
    return displacement, value


def exaggeration(bounds, displacement):
    return SHOWN * (bounds[3] - bounds[2]) / displacement if displacement > 0 else 1.0


def coloured(source, view, chosen, value):
    """Shows a field (the length of a vector) up to `value`, with two signs from -`value` on; its scale is below the
    section."""
    field, title, colouring = chosen
    display = simple.Show(source, view)
    simple.ColorBy(display, ("POINTS", field))
    display.Ambient, display.Diffuse = 1.0, 0.0  # the colours of the scale, without shading
    colours = simple.GetColorTransferFunction(field)
    colours.ApplyPreset(colouring, True)
    if colouring == SIZED:
        colours.InvertTransferFunction()
    colours.NanColor = [0.8, 0.8, 0.8]  # elastic soil has no strength
    colours.RescaleTransferFunction(-value if colouring == SIGNED else 0.0, value or 1.0)
    display.SetScalarBarVisibility(view, True)
    scale = simple.GetScalarBar(colours, view)
    scale.Title, scale.ComponentTitle = title, ""
    scale.Orientation, scale.WindowLocation, scale.ScalarBarLength = "Horizontal", "Lower Center", 0.4
    for name in ("Title", "Label"):
        setattr(scale, f"{name}FontSize", 14)
        setattr(scale, f"{name}Color", BLACK)


def written(text, view):
    display = simple.Show(simple.Text(Text=text), view)
    display.Color, display.FontSize = BLACK, 14
    display.WindowLocation = "Upper Center"


def void(record):
    """Why no verdict may be drawn of the run, if so."""
    summary = record.parent / "summary.json"
    why = (json.loads(summary.read_text(encoding="utf-8")).get("verdict") or {}).get("why_void") if summary.is_file() else None
    return f"\nVOID, as the warnings say: {why}" if why else ""


def look_at(view, bounds):
    """The whole section, as wide as the window."""
    view.UseColorPaletteForBackground, view.Background, view.OrientationAxesVisibility = 0, [1.0, 1.0, 1.0], 0
    view.InteractionMode, view.CameraParallelProjection = "2D", 1
    middle = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2]
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [*middle, 0.0], [*middle, 1e3], [0.0, 1.0, 0.0]
    width = max(bounds[1] - bounds[0], (bounds[3] - bounds[2]) * SIZE[0] / SIZE[1])
    view.CameraParallelScale = 0.53 * width * SIZE[1] / SIZE[0]


def main():
    record = result_folder()
    reader = simple.PVDReader(FileName=str(record))
    times = list(reader.TimestepValues)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = SIZE
    simple.UpdatePipeline(time=times[0], proxy=reader)
    colour = chosen(reader)
    displacement, value = largest(reader, times, colour[0])
    bounds = reader.GetDataInformation().GetBounds()
    warped = simple.WarpByVector(Input=reader)
    warped.Vectors = ["POINTS", DISPLACEMENT]
    warped.ScaleFactor = exaggeration(bounds, displacement)
    coloured(warped, view, colour, value)
    written(f"displacements times {warped.ScaleFactor:.3g}{void(record)}", view)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    simple.Render(view)  # the first rendering places the camera by itself
    look_at(view, bounds)
    simple.Render(view)
    if len(sys.argv) > 2:
        simple.SaveScreenshot(sys.argv[2], view, ImageResolution=SIZE)


main()

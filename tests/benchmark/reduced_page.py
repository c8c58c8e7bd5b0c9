"""Tables and figure of reduced.py."""

import matplotlib
import matplotlib.ticker

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402  (the backend must be chosen first)

SCHEMES = {"sdirk4": ("tab:blue", "s"), "generalised_alpha": ("tab:green", "^")}
VECTORS = (12, 18, 24, 30, 37, 46, 57, 71, 90)  # of the table by shift
PARTS = (24, 30, 46, 57, 90)  # of the table of times


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" + "|---:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


def whole(value):
    return "-" if value is None else f"{value:.0f}"


def best_march(at_aim):
    return min(filter(None, (at_aim["sdirk4"], at_aim["generalised_alpha"])))


def ratio(march, reduced):
    return f"{march / reduced:.1f}" if march and reduced else "-"


def solves_table(results):
    shifts = list(results[0]["at_aim"]["shifts"])
    rows = []
    for study in results:
        at = study["at_aim"]
        rows.append([study["name"], whole(at["sdirk4"]), whole(at["generalised_alpha"]),
                     f"**{whole(at['reduced'])}** ({study['shift']})", ratio(best_march(at), at["reduced"]),
                     ratio(at["generalised_alpha"], at["reduced"]), *(whole(at["shifts"][shift]) for shift in shifts)])
    return table(["scene", "`sdirk4`", "`generalised_alpha`", "reduced (shift)", "`sdirk4` / reduced",
                  "`generalised_alpha` / reduced", *(f"shift {shift}" for shift in shifts)], rows)


def chosen_table(results):
    rows = [[study["name"], f"`{made['command']}`", made["solves"], f"{made['nested_error']:.1e}",
             f"{made['history_error']:.1e}", f"{made['peak_error']:.0e}", whole(made["march"]),
             ratio(made["march"], made["solves"]), f"{made['highest_frequency']:.0f} Hz"]
            for study in results for made in study["chosen"] if made["converged"]]
    return table(["scene", "command", "solves", "error by nested models", "true error of history", "of peak",
                  "solves of a march with that error", "ratio", "checked up to"], rows)


def walls_table(results):
    rows = []
    for study in results:
        run, march, reduce = (study["commands"][kind] for kind in ("run", "march", "reduce"))
        walls = [f"{command['wall']:.2f} s" for command in (run, march, reduce)]
        solves = [command["solves"] for command in (run, march, reduce)]
        rows.append([study["name"], *walls[:2], ratio(march["wall"], run["wall"]), walls[2], *solves])
    return table(["scene", "`run`", "`run`, marched", "ratio", "`reduce`", "solves", "marched", "`reduce`"], rows)


def parts_table(study):
    parts = ("factorise", "krylov", "projection", "modes", "respond")
    rows = [[row["vectors"], row["n_modes"], *(f"{row[part]:.1f}" for part in parts)]
            for row in study["reduced"] if row["shift"] == study["shift"] and row["vectors"] in PARTS]
    solve = [row["march"] / row["solves"] for row in study["march"] if row["scheme"] == "sdirk4"]
    text = f"\nOne solve of `sdirk4` with all that belongs to it takes {sorted(solve)[len(solve) // 2]:.2f} ms.\n"
    return table(["vectors", "modes", "factorise (ms)", "solve, orthogonalise", "project", "eigenvalues", "respond"],
                 rows) + text


def shifts_table(study):
    shifts = list(dict.fromkeys(row["shift"] for row in study["reduced"]))
    cell = {(row["vectors"], row["shift"]): f"{row['history_error']:.1e} / {row['peak_error']:.0e}"
            for row in study["reduced"]}
    return table(["vectors", *(f"shift {shift}" for shift in shifts)],
                 [[n, *(cell.get((n, shift), "-") for shift in shifts)] for n in VECTORS])


def marches_table(study):
    rows = [[row["scheme"], f"td/{study['duration'] / row['step']:.0f}", row["solves"], f"{row['history_error']:.1e}",
             f"{row['peak_error']:.0e}", f"{row['march'] / 1e3:.2f} s"] for row in study["march"]]
    return table(["scheme", "step", "solves", "error of history", "of peak", "time"], rows)


def throughput_table(study):
    inner, whole_command = study["throughput"], study["respond"]
    rows = [["the recurrence alone (`BatchResponse`)", f"{inner['F_T_per_second']:.0f}"],
            ["with peak and S (`slide()`)", f"{inner['F_T_peak_and_S_per_second']:.0f}"],
            ["`upbead respond`, F_T, peaks, check of the band", f"{whole_command['shear']['per_second']:.0f}"],
            ["the same with S", f"{whole_command['sliding']['per_second']:.0f}"]]
    text = (f"\n{inner['n_modes']} modes. The whole of `respond`: read {whole_command['shear']['read']:.2f} s, respond "
            f"{whole_command['shear']['respond']:.2f} s, write {whole_command['shear']['write']:.2f} s.\n")
    return table(["one core", "histories a second"], rows) + text


def tables(results):
    parts = ["### Solves for an error of 0.3 %\n", solves_table(results), "### What the program chooses by itself\n",
             chosen_table(results), "### Whole commands\n", walls_table(results), "### Many waves\n",
             throughput_table(results[0])]
    for study in results:
        parts += [f"### {study['name']}, {study['unknowns']} unknowns\n",
                  "Error of the history / of the peak, by vectors and shift:\n", shifts_table(study),
                  f"Times at the shift {study['shift']}:\n", parts_table(study), "Marches:\n", marches_table(study)]
    return "\n".join(parts)


def draw_panel(ax, study, aim):
    for scheme, (colour, marker) in SCHEMES.items():
        rows = [row for row in study["march"] if row["scheme"] == scheme]
        ax.loglog([r["solves"] for r in rows], [r["history_error"] for r in rows], marker + "-", color=colour, ms=4,
                  lw=1.2, label="march, " + ("generalised-alpha" if scheme == "generalised_alpha" else scheme))
    other = "reduced, other shifts (1 to 2)"
    for shift in study["at_aim"]["shifts"]:
        rows = [row for row in study["reduced"] if row["shift"] == float(shift)]
        x, y = [r["solves"] for r in rows], [r["history_error"] for r in rows]
        if float(shift) == study["shift"]:
            ax.loglog(x, y, "o-", color="tab:red", ms=5, lw=2, zorder=5, label=f"reduced, shift {shift} x 2$\\pi$/td")
        else:
            ax.loglog(x, y, "-", color="tab:red", lw=0.9, alpha=0.35, label=other)
            other = None
    mark_aim(ax, study["at_aim"], aim)
    ax.set_title(study["name"])
    ax.set_xlabel("solves of the large system")
    ax.set_xlim(10, 4000)
    ax.set_ylim(1e-5, 1)
    ticks = (10, 20, 50, 100, 200, 500, 1000, 2000)
    ax.set_xticks(ticks, [str(tick) for tick in ticks])
    ax.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    ax.grid(alpha=0.3)


def mark_aim(ax, at_aim, aim):
    """Draws a line at the error AIM, the numbers of solves at which it is reached, and their ratios."""
    ax.axhline(aim, color="black", lw=0.8, ls="--")
    ax.text(3800, aim * 1.1, f"{100 * aim:g} %", ha="right", va="bottom", fontsize="small")
    colours = {"reduced": "tab:red", **{scheme: colour for scheme, (colour, _) in SCHEMES.items()}}
    for name, colour in colours.items():
        if at_aim[name]:
            ax.plot([at_aim[name]] * 2, [1e-5, aim], color=colour, lw=1, ls=":")
            ax.plot(at_aim[name], aim, "o", ms=9, mfc="none", mec=colour, mew=1.5, zorder=6)
            ax.text(at_aim[name] * 1.04, 1.3e-5, f"{at_aim[name]:.0f}", color=colour, fontsize="medium", weight="bold")
    march = best_march(at_aim)
    middle = (march * at_aim["reduced"]) ** 0.5
    ax.annotate("", (at_aim["reduced"], 3e-5), (march, 3e-5), arrowprops={"arrowstyle": "<->", "color": "black"})
    ax.text(middle, 3.3e-5, f"{march / at_aim['reduced']:.1f} times fewer", ha="center", va="bottom")


def draw(results, aim, path):
    shown = results[:2]
    figure, axes = plt.subplots(1, len(shown), figsize=(11, 5.2), sharey=True)
    for ax, study in zip(axes, shown):
        draw_panel(ax, study, aim)
    axes[0].set_ylabel("largest error of $F_T(t)$ over its peak")
    for ax in axes:
        ax.legend(fontsize="small", loc="upper right")
    figure.tight_layout()
    figure.savefig(path, dpi=110)

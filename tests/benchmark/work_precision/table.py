"""The results in Markdown."""

TARGETS = (0.01, 0.005, 0.001)
ERRORS = {"peak_error": "peak", "history_error": "history"}


def seconds(value):
    return "-" if value is None else f"{value:.2f} s"


def rows_table(study):
    """Every run; * marks runs on the front of the error of the peak, + those on the front of the error of the
    history."""
    lines = [f"### {study['title']}", "", study["against"], "",
             "| | | unknowns | solves | error of peak | error of history | whole process | front |",
             "|---|---|---:|---:|---:|---:|---:|---|"]
    for row in study["rows"]:
        marks = " ".join(ERRORS[error] for error in row["front"])
        lines.append(f"| {row['series']} | {row['label']} | {row['unknowns']} | {row['solves']} "
                     f"| {row['peak_error']:.1e} | {row['history_error']:.1e} | {seconds(row['wall'])} | {marks} |")
    lines += [""] + [f"Failed: {what}" for what in study["failed"]]
    return "\n".join(lines).rstrip() + "\n"


def equal_error_table(comparison):
    """Time at equal error of every program, and how much faster than the best peer upbead is."""
    lines = []
    for error, kind in ((error, kind) for error in ERRORS for kind in comparison[error]):
        lines += ["", f"Time at equal error of the {ERRORS[error]}, {kind}:", "",
                  "| | " + " | ".join(f"{t:.1%}" for t in TARGETS) + " |",
                  "|---|" + "---:|" * len(TARGETS)]
        for program, times in comparison[error][kind].items():
            cells = [(f"{t:.2f}" if t else "-") if program.startswith("ratio") else seconds(t) for t in times]
            lines.append(f"| {program} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def floors_table(floors):
    return "\n".join(["| a process that does nothing | |", "|---|---:|"] +
                     [f"| {name} | {wall:.3f} s |" for name, wall in floors.items()]) + "\n"


def page(results):
    parts = [rows_table(study) for study in results["studies"]]
    if "comparison" in results:
        parts += ["### Peers at equal error", equal_error_table(results["comparison"]), floors_table(results["floors"])]
    return "\n".join(parts)

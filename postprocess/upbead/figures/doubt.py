"""The mark of a figure whose numbers are void or in doubt: every figure bears it, by what it is drawn of."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import Any

from .. import told

RED, AMBER = "#b00020", "#8a5a00"


def mark(figure: Any, drawn_of: Sequence[Any]) -> None:
    """Writes above a figure what of its numbers is void and why, or which warnings doubt them; across it, where all are void."""
    summaries = told.summaries(drawn_of)
    if why := "; ".join(lines(summaries, told.void)):
        whole = all(told.is_all_void(summary) for summary in summaries)
        write(figure, f"VOID{'' if whole else ' in part'}, as the warnings say: {why}", RED)
        if whole:
            figure.text(0.5, 0.5, "VOID", color=RED, alpha=0.18, fontsize=60, rotation=25, ha="center", va="center", weight="bold")
    elif doubts := lines(summaries, names):
        write(figure, f"In doubt, as the warnings say: {'; '.join(doubts)}", AMBER)


def names(summary: Any) -> str:
    return ", ".join(dict.fromkeys(name for name, _ in told.warnings(summary)))


def lines(summaries: list[Any], text_of: Any) -> list[str]:
    """What each tells, with its title where there are several."""
    found = [(summary.get("title"), text_of(summary)) for summary in summaries]
    return list(dict.fromkeys(f"{title}: {text}" if title and len(found) > 1 else text for title, text in found if text))


def write(figure: Any, text: str, colour: str) -> None:
    wrapped = "\n".join(textwrap.wrap(text, int(14 * figure.get_figwidth())))
    figure.text(0.5, 1.01, wrapped, color=colour, fontsize=8, ha="center", va="bottom", weight="bold" if colour == RED else "normal",
                parse_math=False, bbox={"edgecolor": colour, "facecolor": "white", "boxstyle": "round,pad=0.4"})

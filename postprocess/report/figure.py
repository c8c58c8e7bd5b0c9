"""A figure of the page: a plot as a still picture and as data for the script, or a drawing."""

from report import still
from report.markup import data, join, symbol, tag


def of_plot(plot, caption, class_="plot"):
    """An HTML figure; the script replaces the still picture on screen, paper shows it."""
    told = plot.data()
    words = tag("figcaption", caption)
    return tag(
        "figure", still.draw(told, plot.name.replace("-", " ")), data(told, "plot"), words, id=plot.name, class_=class_
    )


def of_drawing(name, drawing, caption):
    return tag("figure", drawing, tag("figcaption", caption), id=name, class_="drawing")


def words(*parts):
    """Text with symbols: those parts that are wrapped in a tuple are symbols."""
    return join(symbol(part[0]) if isinstance(part, tuple) else part for part in parts)

"""A figure of the page: a plot as a still picture and as data for the script, or a drawing."""

from . import still
from .language import named
from .markup import data, tag


def of_plot(plot, caption, class_="plot"):
    """An HTML figure; on screen the script replaces the still picture, which is printed on paper."""
    told = plot.data()
    return tag(
        "figure", still.draw(told, named(plot.name.replace("-", " "))), data(told, "plot"), tag("figcaption", caption), id=plot.name, class_=class_
    )


def of_drawing(name, drawing, caption):
    return tag("figure", drawing, tag("figcaption", caption), id=name, class_="drawing")


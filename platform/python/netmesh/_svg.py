"""The barcode of a diagram as SVG, without another package: in notebooks, and of ``Diagram.save``."""
import numpy as np

ROWS = 12       # bars of a degree that are drawn, the longest
SHARE = 0.03    # of the longest, below which no bar is drawn where there are many
APART = 1.5     # how many times the next length the last one is that stands apart
FEW, END = 8, 2.5  # below the last of so few bars is a gap, too, as of this
COLOURS = ("#1f2d4a", "#d5590e", "#1aa77d", "#c21dff", "#592710", "#9180be")
WIDTH, LEFT, RIGHT, ROW = 640, 120, 150, 14


def barcode(diagram):
    """By degree the longest bars, with birth and death; in bold those that stand apart by their length."""
    values = diagram._intervals[np.isfinite(diagram._intervals)]
    low, high = (min(values.min(), 0.0), values.max()) if len(values) else (0.0, 1.0)
    high = high if high > low else low + 1.0

    def at(value):
        return LEFT + (WIDTH - LEFT - RIGHT) * min(max((value - low) / (high - low), 0.0), 1.0)

    parts, y = [], 12
    for degree in range(diagram.max_degree + 1):
        y = _group(diagram, degree, at, parts, y)
    axis = ['<path d="M%d %d H%d" stroke="#22262b"/>' % (LEFT, y, WIDTH - RIGHT)]
    for share in (0, 0.25, 0.5, 0.75, 1):
        value = low + share * (high - low)
        axis.append(_text(at(value), y + 16, "%.3g" % value, anchor="middle"))
    axis.append(_text(LEFT, y + 34, "certified ratio %.6g" % diagram.certified_ratio if diagram.certified_ratio != 1
                      else "exact"))
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d" role="img" '
            'font-family="sans-serif" font-size="11"><title>%s</title><rect width="100%%" height="100%%" '
            'fill="#ffffff"/>%s</svg>\n' % (WIDTH, y + 44, WIDTH, y + 44, _escaped(repr(diagram)[1:-1]),
                                             "".join(parts + axis)))


def _group(diagram, degree, at, parts, y):
    bars = diagram.intervals(degree)
    shown = diagram.longest(degree, ROWS) if len(bars) else bars
    lengths = shown[:, 1] - shown[:, 0]
    finite = lengths[np.isfinite(lengths)]
    if len(bars) > len(shown) and len(finite):
        shown = shown[lengths >= SHARE * finite[0]]
    colour, apart = COLOURS[degree % len(COLOURS)], count_apart(diagram.longest(degree, ROWS + 1)) if len(bars) else 0
    parts.append('<text x="8" y="%d" font-size="16" font-weight="bold" fill="%s">H%d</text>' % (y + 14, colour, degree))
    parts.append(_text(36, y + 13, "%d bar%s" % (len(bars), "" if len(bars) == 1 else "s")))
    if apart:
        parts.append(_text(8, y + 30, "%d stand%s apart" % (apart, "s" if apart == 1 else "")))
    for i, (birth, death) in enumerate(shown):
        top = y + i * ROW
        parts.append('<rect x="%.2f" y="%d" width="%.2f" height="8" fill="%s"/>'
                     % (at(birth), top + 3, max(at(death) - at(birth), 0.8), colour))
        if death == np.inf:
            parts.append('<path d="M%.2f %d l9 5 l-9 5 z" fill="%s"/>' % (at(death), top + 2, colour))
        ends = "%.4g to %s" % (birth, "\u221e" if death == np.inf else "%.4g" % death)
        parts.append(_text(WIDTH - RIGHT + 16, top + 11, ends, bold=i < apart))
    return y + max(len(shown) * ROW, 36) + 12


def count_apart(longest):
    """How many of the bars, which are the longest, stand apart: what never dies, and the others above the largest gap
    of lengths."""
    lengths = [length for length in (longest[:, 1] - longest[:, 0]).tolist() if length > 0]
    apart, largest = sum(length == np.inf for length in lengths), APART
    for i in range(apart, len(lengths) - 1):
        if lengths[i] >= largest * lengths[i + 1]:
            largest = lengths[i] / lengths[i + 1]
            apart = i + 1
    return len(lengths) if len(lengths) <= FEW and largest < END else apart


def _escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").encode(
        "ascii", "xmlcharrefreplace").decode()


def _text(x, y, words, anchor="start", bold=False):
    return '<text x="%.2f" y="%d" text-anchor="%s" fill="#22262b"%s>%s</text>' % (
        x, y, anchor, ' font-weight="bold"' if bold else "", _escaped(words))

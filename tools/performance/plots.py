"""Plots of cost against size as small SVG files, readable on light and dark pages."""

import math

WIDTH, HEIGHT = 720, 400
LEFT, RIGHT, TOP, BOTTOM = 64, 500, 44, 352  # of the area with lines
LABEL_DISTANCE = 15  # between the names of lines, at least
# Distinct for color-blind readers, too; after M. Okabe, K. Ito, "Color universal design" (2008).
COLORS = ("#1a7fc1", "#d55e00", "#009e73", "#cc79a7", "#8a7500")
STYLE = """text{font:13px sans-serif;fill:#333}.title{font-size:15px;font-weight:bold}.grid{stroke:#8884;stroke-width:1}
.line{fill:none;stroke-width:2.5}@media(prefers-color-scheme:dark){text{fill:#ddd}}"""


def number(value):
    """A number with three digits, as a person writes it."""
    if value >= 1000:
        return f"{round(value, 2 - int(math.log10(value))):,.0f}"
    return f"{value:.3g}"


class Axis:
    """Logarithmic axis over whole powers of ten, or from the least to the greatest value."""

    def __init__(self, values, begin, end, whole):
        low, high = math.log10(min(values)), math.log10(max(values))
        self.low, self.high = (math.floor(low), math.ceil(high)) if whole else (low, high)
        self.begin, self.end = begin, end

    def place(self, value):
        fraction = (math.log10(value) - self.low) / (self.high - self.low)
        return round(self.begin + fraction * (self.end - self.begin), 1)


def spread(places):
    """Moves labels apart, in order."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    result = list(places)
    for before, after in zip(order, order[1:]):
        result[after] = max(result[after], result[before] + LABEL_DISTANCE)
    return result


def plot(title, unit, lines, limit=None):
    """An SVG with one line for each series.

    lines: {name: {number of objects: time}}; limit: (name, time) of a dashed line, or None.
    """
    sizes = sorted({size for line in lines.values() for size in line})
    times = [time for line in lines.values() for time in line.values()] + ([limit[1]] if limit else [])
    x, y = Axis(sizes, LEFT, RIGHT, whole=False), Axis(times, BOTTOM, TOP, whole=True)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
             f'role="img"><title>{title}</title><style>{STYLE}</style>',
             f'<text class="title" x="{LEFT}" y="20">{title} [{unit}]</text>']
    for power in range(y.low, y.high + 1):
        place = y.place(10.0 ** power)
        parts.append(f'<path class="grid" d="M{LEFT} {place}H{RIGHT}"/>'
                     f'<text x="{LEFT - 8}" y="{place + 4}" text-anchor="end">{number(10.0 ** power)}</text>')
    for size in sizes:
        parts.append(f'<path class="grid" d="M{x.place(size)} {TOP}V{BOTTOM}"/>'
                     f'<text x="{x.place(size)}" y="{BOTTOM + 18}" text-anchor="middle">{size}</text>')
    parts.append(f'<text x="{(LEFT + RIGHT) / 2}" y="{BOTTOM + 38}" text-anchor="middle">objects</text>')
    if limit:
        place = y.place(limit[1])
        parts.append(f'<path class="line" style="stroke:#888;stroke-dasharray:6 4" d="M{LEFT} {place}H{RIGHT}"/>'
                     f'<text x="{LEFT + 6}" y="{place - 6}">{limit[0]}</text>')
    labels = spread([y.place(line[max(line)]) + 4 for line in lines.values()])
    for (name, line), color, label in zip(lines.items(), COLORS, labels):
        points = " ".join(f"{x.place(size)},{y.place(time)}" for size, time in sorted(line.items()))
        parts.append(f'<polyline class="line" style="stroke:{color}" points="{points}"/>'
                     f'<text style="fill:{color}" x="{RIGHT + 8}" y="{label}">{name}</text>')
    return "\n".join(parts + ["</svg>", ""])

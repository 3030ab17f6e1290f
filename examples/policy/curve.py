"""Draws success in new layouts against the number of demonstrations: curve.csv and curve.svg."""

import csv
import math

LEFT, RIGHT, TOP, BOTTOM = 56, 400, 40, 240  # of the plot
FIRST, LAST = 90, 366                        # where the least and the greatest number of demonstrations are
SERIES = {"state": ("told the poses", "#1a7fc1", -4), "pictures": ("from pictures", "#c1571a", 4)}
LINE = 16                                    # distance of two labels, at least
STYLE = ("text{font:13px sans-serif;fill:#333}.title{font-weight:bold}path{fill:none}"
         "@media(prefers-color-scheme:dark){text{fill:#ddd}}")


def write(folder, summaries):
    """summaries: of each brain, by its name; those of policies are SERIES_COUNT."""
    rows = [(name, each["successes"], each["runs"], *each["success_interval"]) for name, each in summaries.items()]
    with open(folder / "curve.csv", "w", newline="") as file:
        csv.writer(file).writerows([("brain", "successes", "runs", "low", "high"), *rows])
    (folder / "curve.svg").write_text(drawing(rows))


def drawing(rows):
    """The text of the picture: a curve for each kind of policy, a dashed line for each other agent."""
    curves, others = {}, []
    for name, successes, runs, *interval in rows:
        kind, _, count = name.partition("_")
        rate = successes / max(1, runs)
        if kind in SERIES and count.isdecimal():
            curves.setdefault(kind, []).append((int(count), rate, *interval))
        else:
            others.append((name, rate))
    counts = sorted({point[0] for points in curves.values() for point in points})
    parts, labels = axes(counts), []
    for name, rate in others:
        parts.append(f'<path d="M{LEFT} {height_of(rate):.1f}H{RIGHT}" stroke="#888" stroke-dasharray="5 4"/>')
        labels.append((height_of(rate), name, "#888"))
    for kind, points in curves.items():
        text, color, shift = SERIES[kind]
        at = [(place_of(count, counts) + shift, height_of(rate)) for count, rate, *_ in sorted(points)]
        parts.append(f'<path d="M{"L".join(f"{x:.1f} {y:.1f}" for x, y in at)}" stroke="{color}" stroke-width="2"/>')
        for (x, y), (_, _, low, high) in zip(at, sorted(points)):
            parts.append(f'<path d="M{x:.1f} {height_of(low):.1f}V{height_of(high):.1f}" stroke="{color}"/>'
                         f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{color}"/>')
        labels.append((at[-1][1], text, color))
    return ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 520 290" width="520" height="290" role="img">'
            f"<title>Success in new layouts</title><style>{STYLE}</style>{''.join(parts)}{''.join(beside(labels))}</svg>\n")


def axes(counts):
    parts = [f'<text x="{LEFT}" y="22" class="title">Success in new layouts</text>',
             f'<text x="{(FIRST + LAST) / 2:.0f}" y="{BOTTOM + 40}" text-anchor="middle">demonstrations</text>']
    for percent in range(0, 101, 25):
        y = height_of(percent / 100)
        parts.append(f'<path d="M{LEFT} {y:.0f}H{RIGHT}" stroke="#8884"/>'
                     f'<text x="{LEFT - 8}" y="{y + 4:.0f}" text-anchor="end">{percent} %</text>')
    return parts + [f'<text x="{place_of(count, counts):.0f}" y="{BOTTOM + 20}" text-anchor="middle">{count}</text>'
                    for count in counts]


def place_of(count, counts):
    """On a logarithmic axis."""
    span = math.log(counts[-1] / counts[0])
    return FIRST + (LAST - FIRST) * (math.log(count / counts[0]) / span if span else 0.5)


def height_of(rate):
    return BOTTOM - (BOTTOM - TOP) * rate


def beside(labels):
    """Labels to the right of what they name, from the top down, none over another one."""
    last = 0
    for y, text, color in sorted(labels):
        last = max(y, last + LINE)
        yield f'<text x="{RIGHT + 8}" y="{last + 4:.1f}" style="fill:{color}">{text}</text>'

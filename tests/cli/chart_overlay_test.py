#!/usr/bin/python3
"""Charts lie where another program plots the same numbers: matplotlib, in a frame of the same place and limits.

  chart_overlay_test.py MORULA SCENARIO

Exit codes: 0 passed, 1 failed, 77 there is no matplotlib to compare with.
"""
import os
import re
import sqlite3
import subprocess
import sys
import tempfile

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.image
    import matplotlib.pyplot
    import numpy
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

QUIET_INK = (0x5C, 0x63, 0x6B)  # colour of axes (reports/drawing/palette.h)


def strokes(svg):
    """The lines of an SVG, each with its colour and its points in pixels."""
    for tag in re.findall(r"<path [^>]*>", svg):
        colour, path = re.search(r' stroke="#([0-9a-f]{6})"', tag), re.search(r' d="([^"]*)"', tag)
        if colour and path:
            numbers = [float(word) for word in re.findall(r"-?[\d.]+", path.group(1))]
            yield tuple(bytes.fromhex(colour.group(1))), list(zip(numbers[::2], numbers[1::2]))


def grown(mask, by):
    """The mask widened by `by` pixels along rows and columns."""
    result = mask.copy()
    for dy in range(-by, by + 1):
        for dx in range(-by, by + 1):
            result |= numpy.roll(numpy.roll(mask, dy, axis=0), dx, axis=1)
    return result


def series(database, table, column):
    with sqlite3.connect(database) as db:
        key = {"cell_sample": "path", "sample": "''"}[table]
        rows = db.execute(f"select {key}, time, {column} from {table} where {column} is not null order by 1, 2").fetchall()
    lines = {}
    for path, time, value in rows:
        lines.setdefault(path, []).append((time, value))
    return lines


def compare(morula, database, folder, what, lines):
    svg, png = os.path.join(folder, "a.svg"), os.path.join(folder, "a.png")
    for file in (svg, png):
        subprocess.run([morula, "chart", database, what, "-o", file], check=True, stdout=subprocess.DEVNULL)
    with open(svg, encoding="utf-8") as text:
        found = list(strokes(text.read()))
    axes = [points for colour, points in found if colour == QUIET_INK and len(points) == 2]
    upright = [p for p in axes if p[0][0] == p[1][0]]
    level = [p for p in axes if p[0][1] == p[1][1]]
    assert len(upright) == 1 and len(level) == 1, "two axes"
    top, bottom = sorted(y for _, y in upright[0])
    left, right = sorted(x for x, _ in level[0])
    image = matplotlib.image.imread(png)[:, :, :3]
    height, width = image.shape[:2]
    times = [t for line in lines.values() for t, _ in line]
    values = [v for line in lines.values() for _, v in line]
    room = 0.04 * (max(values) - min(values))  # above and below (reports/charts/chart.cpp)
    figure = matplotlib.pyplot.figure(figsize=(width / 100, height / 100), dpi=100)
    plot = figure.add_axes([left / width, 1 - bottom / height, (right - left) / width, (bottom - top) / height])
    plot.set_xlim(min(times), max(times))
    plot.set_ylim(max(0, min(values) - room), max(values) + room)  # no measure here is below 0
    plot.axis("off")
    for line in lines.values():
        plot.plot(*zip(*line), color="black", linewidth=2.2 * 0.72, solid_capstyle="round")
    figure.canvas.draw()
    theirs = numpy.asarray(figure.canvas.buffer_rgba())[:, :, :3].min(axis=2) < 100
    paper = image[0, 0]
    ours = numpy.abs(image - paper).max(axis=2) > 0.15
    assert theirs.sum() > 100, "something is plotted"
    lost = theirs & ~grown(ours, 2)
    print(f"{what}: {theirs.sum()} pixels of theirs, {lost.sum()} farther than 2 from ours")
    assert not lost.any()
    # Conversely, each corner of our lines is a point of theirs.
    points = numpy.array([plot.transData.transform(point) for line in lines.values() for point in line])
    points[:, 1] = height - points[:, 1]
    corners = [corner for colour, line in found if len(line) >= 2 and colour != QUIET_INK and not is_grid(line)
               for corner in line]
    farthest = max(numpy.hypot(*(points - corner).T).min() for corner in corners)
    print(f"{what}: {len(corners)} corners, the farthest {farthest:.2f} pixels from a point of theirs")
    # cairo leaves out points that lie on the way between their neighbours.
    assert 0.5 * len(points) < len(corners) <= len(points) and farthest < 1.5


def is_grid(line):
    """True for a horizontal or vertical line of two points across the frame, as of ticks."""
    (x0, y0), (x1, y1) = line[0], line[-1]
    return len(line) == 2 and (x0 == x1 or (y0 == y1 and abs(x1 - x0) > 400))


def main():
    morula, scenario = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        database = os.path.join(folder, "run.db")
        subprocess.run([morula, "run", scenario, "--db", database, "--no-pictures", "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
        compare(morula, database, folder, "cell.volume", series(database, "cell_sample", "volume"))
        compare(morula, database, folder, "world.kinetic_energy", series(database, "sample", "kinetic_energy"))


main()

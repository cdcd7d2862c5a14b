#!/usr/bin/env python3
"""Writes pier.obj, beacon.obj, buoy.obj, house.obj and scenery.mtl beside itself: x forward, y to
the left, z up, metres, z = 0 at still water (of the house: its floor)."""
import math
from pathlib import Path

COLOURS = {"concrete": (0.42, 0.41, 0.38), "wood": (0.20, 0.13, 0.08), "piles": (0.10, 0.08, 0.06),
           "white": (0.78, 0.77, 0.73), "red": (0.55, 0.03, 0.02), "iron": (0.06, 0.06, 0.07),
           "glass": (0.05, 0.07, 0.08), "tiles": (0.30, 0.09, 0.05), "green": (0.02, 0.28, 0.10)}


class Obj:
    def __init__(self):
        self.vertices, self.faces = [], []

    def face(self, colour, corners):
        first = len(self.vertices) + 1
        self.vertices += corners
        self.faces.append((colour, range(first, first + len(corners))))

    def box(self, colour, low, high):
        (x0, y0, z0), (x1, y1, z1) = low, high
        c = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
        for f in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            self.face(colour, [c[i] for i in f])

    def lathe(self, colour, rings, sides=12, centre=(0.0, 0.0), closed=True):
        """Rings (radius, height) about a vertical axis, upwards."""
        def ring(r, z):
            return [(centre[0] + r * math.cos(2 * math.pi * k / sides),
                     centre[1] + r * math.sin(2 * math.pi * k / sides), z) for k in range(sides)]
        rows = [ring(*r) for r in rings]
        for low, high in zip(rows, rows[1:]):
            for k in range(sides):
                n = (k + 1) % sides
                self.face(colour, [low[k], low[n], high[n], high[k]])
        if closed:
            self.face(colour, rows[0][::-1])
            self.face(colour, rows[-1])

    def write(self, name):
        used = list(dict.fromkeys(colour for colour, _ in self.faces))
        lines = ["# written by make_scenery.py", "mtllib scenery.mtl"]
        lines += ["v " + " ".join(f"{c:.4g}" for c in v) for v in self.vertices]
        for colour in used:
            lines.append(f"usemtl {colour}")
            lines += ["f " + " ".join(map(str, f)) for c, f in self.faces if c == colour]
        (Path(__file__).parent / name).write_text("\n".join(lines) + "\n")


def pier():
    o = Obj()
    o.box("concrete", (-22, -2.2, 1.25), (22, 2.2, 1.6))
    o.box("wood", (-22, -2.3, 1.5), (22, -2.05, 1.78))
    o.box("wood", (-22, 2.05, 1.5), (22, 2.3, 1.78))
    for i in range(10):
        x = -20.25 + 4.5 * i
        for y in (-1.8, 1.8):
            o.lathe("piles", [(0.22, -8), (0.22, 1.25)], 8, (x, y), closed=False)
        o.box("wood", (x - 0.15, -2.2, 0.95), (x + 0.15, 2.2, 1.25))
    for i in range(5):
        o.lathe("iron", [(0.16, 1.6), (0.12, 1.95), (0.22, 2.0), (0.22, 2.08)], 8, (-18 + 9 * i, -1.7))
    o.lathe("iron", [(0.06, 1.6), (0.05, 5.4)], 6, (20.5, 1.5))
    o.box("white", (20.2, 1.2, 5.4), (20.8, 1.8, 5.65))
    o.box("white", (-21, 0.3, 1.6), (-16.5, 2.0, 4.0))
    o.box("tiles", (-21.3, 0.0, 4.0), (-16.2, 2.3, 4.2))
    o.box("glass", (-16.52, 0.7, 2.6), (-16.47, 1.6, 3.5))
    o.box("wood", (-19.5, 0.27, 1.6), (-18.6, 0.33, 3.6))
    o.write("pier.obj")


def beacon():
    o = Obj()
    o.lathe("concrete", [(2.6, -9), (2.2, 1.4)], 16)
    o.lathe("white", [(1.0, 1.4), (0.85, 3.4)], 16, closed=False)
    o.lathe("red", [(0.85, 3.4), (0.75, 5.0)], 16, closed=False)
    o.lathe("white", [(0.75, 5.0), (0.68, 6.6)], 16, closed=False)
    o.lathe("iron", [(1.1, 6.6), (1.1, 6.75)], 16)
    for k in range(8):
        a = math.pi * k / 4
        o.lathe("iron", [(0.03, 6.75), (0.03, 7.6)], 4, (math.cos(a), math.sin(a)), closed=False)
    o.lathe("iron", [(1.03, 7.55), (1.03, 7.62)], 16)
    o.lathe("glass", [(0.4, 6.75), (0.4, 7.7)], 12, closed=False)
    o.lathe("red", [(0.55, 7.7), (0.05, 8.3)], 12)
    o.write("beacon.obj")


def buoy():
    o = Obj()
    o.lathe("green", [(0.3, -1.3), (1.2, -0.55), (1.2, 0.45), (0.9, 0.6)], 16)
    for k in range(4):
        a = math.pi * (k + 0.5) / 2
        x, y = 0.75 * math.cos(a), 0.75 * math.sin(a)
        o.face("green", [(x, y, 0.6), (0.3 * x, 0.3 * y, 3.0), (0.2 * y + 0.3 * x, -0.2 * x + 0.3 * y, 3.0),
                         (0.2 * y + x, -0.2 * x + y, 0.6)])
    o.lathe("iron", [(0.35, 2.9), (0.35, 3.0)], 12)
    o.lathe("glass", [(0.14, 3.0), (0.14, 3.35)], 8)
    o.lathe("green", [(0.4, 3.5), (0.02, 4.3)], 12)
    o.write("buoy.obj")


def house():
    o = Obj()
    o.box("concrete", (-5.2, -3.7, -4), (5.2, 3.7, 0.3))
    o.box("red", (-5, -3.5, 0.3), (5, 3.5, 3.4))
    for x in (-5, 5):
        corners = [(x, -3.5, 3.4), (x, 3.5, 3.4), (x, 0, 5.8)]
        o.face("red", corners if x > 0 else corners[::-1])
    o.face("iron", [(-5.4, -3.9, 3.15), (5.4, -3.9, 3.15), (5.4, 0, 5.85), (-5.4, 0, 5.85)])
    o.face("iron", [(5.4, 3.9, 3.15), (-5.4, 3.9, 3.15), (-5.4, 0, 5.85), (5.4, 0, 5.85)])
    o.box("concrete", (1.5, 0.3, 4.6), (2.3, 1.1, 6.9))
    for x in (-3.6, -0.9, 1.8):
        for y in (-3.53, 3.47):
            o.box("white", (x - 0.1, y, 1.1), (x + 1.3, y + 0.06, 2.6))
            o.box("glass", (x, y - 0.03, 1.2), (x + 1.2, y + 0.09, 2.5))
    o.box("white", (4.97, -0.6, 0.3), (5.04, 0.6, 2.4))
    o.write("house.obj")


lines = ["# written by make_scenery.py: Kd is linear reflectance"]
for name, colour in COLOURS.items():
    lines += [f"newmtl {name}", "Kd " + " ".join(map(str, colour))]
(Path(__file__).parent / "scenery.mtl").write_text("\n".join(lines) + "\n")
pier()
beacon()
buoy()
house()

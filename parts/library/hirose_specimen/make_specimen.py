#!/usr/bin/env python3
"""Writes specimen.obj, the workpiece of table 4, in mm; README.md says what its places are.

Sizes are the means of the paper's coordinate measuring machine: what is best known of the true ones.
Round faces are facets of one degree whose middles, at whole degrees, lie on the true circle.
Usage: make_specimen.py > specimen.obj
"""
import math

LENGTH, WIDTH, HEIGHT = 69.9774, 59.993, 15.0034           # places 1, 2, 9
SLOT_CENTRES, SLOT_RIGHT, SLOT_LEFT = 30.0596, 10.0568, 10.0104   # places 4, 7R, 7L
BOSS_TO_SLOT, BOSS = 30.0032, 24.97                        # places 3, 10
POCKET_X, POCKET_Y, POCKET_DEPTH = 25.0146, 25.0102, 7.0206    # places 11, 12, 5
PLATFORM, PLATFORM_HEIGHT = 19.668, 4.9946                 # places 6, 8
BOSS_HEIGHT, SLOT_DEPTH = 8.0, 8.0
SLOT = (15.0, -17.0)                                       # centre of its right end
SPLIT = -5.0                                               # y between slot and pocket on the top

vertices, faces = {}, []


def vertex(x, y, z):
    return vertices.setdefault(f"{x:.7f} {y:.7f} {z:.7f}", len(vertices) + 1)


def face(*points):
    faces.append([vertex(*p) for p in points])


def level(z, *corners):
    face(*[(x, y, z) for x, y in corners])


def rectangle(z, x0, y0, x1, y1):
    level(z, (x0, y0), (x1, y0), (x1, y1), (x0, y1))


def walls(z_top, z_foot, outline, closed=True):
    """Upright faces; material lies to the left of the outline as it is walked."""
    ends = outline[1:] + outline[:1] if closed else outline[1:]
    for (x0, y0), (x1, y1) in zip(outline, ends):
        face((x0, y0, z_foot), (x1, y1, z_foot), (x1, y1, z_top), (x0, y0, z_top))


def arc(centre, radius, first, last):
    """From first to last degree, both whole and with their points on the circle."""
    corner = radius / math.cos(math.radians(0.5))
    step = 1 if last > first else -1
    at = lambda r, a: (centre[0] + r * math.cos(math.radians(a)), centre[1] + r * math.sin(math.radians(a)))
    middle = [at(corner, first + step * (i + 0.5)) for i in range(abs(last - first))]
    return [at(radius, first), *middle, at(radius, last)]


def fan(z, hub, outline):
    for a, b in zip(outline, outline[1:]):
        level(z, hub, a, b)


def top_face(x1, y1):
    left = (SLOT[0] - SLOT_CENTRES, SLOT[1])
    # Above and below the slot's straight walls, then the four corners around its round ends.
    level(0, (left[0], left[1] + SLOT_LEFT), (SLOT[0], SLOT[1] + SLOT_RIGHT), (SLOT[0], SPLIT), (left[0], SPLIT))
    level(0, (left[0], -y1), (SLOT[0], -y1), (SLOT[0], SLOT[1] - SLOT_RIGHT), (left[0], left[1] - SLOT_LEFT))
    for centre, radius, x, middle in ((SLOT, SLOT_RIGHT, x1, 0), (left, SLOT_LEFT, -x1, 180)):
        side = 1 if middle == 0 else -1
        for y, quarter in ((SPLIT, 90 * side), (-y1, -90 * side)):
            fan(0, (x, y), [(centre[0], y), *arc(centre, radius, middle + quarter, middle), (x, centre[1])])
    # Around the pocket.
    px, py = POCKET_X / 2, POCKET_Y / 2
    rectangle(0, -x1, SPLIT, -15 - px, y1)
    rectangle(0, -15 + px, SPLIT, x1, y1)
    rectangle(0, -15 - px, SPLIT, -15 + px, 13 - py)
    rectangle(0, -15 - px, 13 + py, -15 + px, y1)


def slot():
    left = (SLOT[0] - SLOT_CENTRES, SLOT[1])
    outline = [*arc(SLOT, SLOT_RIGHT, 90, -90), *arc(left, SLOT_LEFT, 270, 90)]
    walls(0, -SLOT_DEPTH, outline)
    rectangle(-SLOT_DEPTH, left[0] - 12, left[1] - 12, SLOT[0] + 12, left[1] + 12)


def main():
    x1, y1, floor = LENGTH / 2, WIDTH / 2, -HEIGHT
    top_face(x1, y1)
    walls(0, floor, [(-x1, -y1), (x1, -y1), (x1, y1), (-x1, y1)])
    slot()
    px, py = POCKET_X / 2, POCKET_Y / 2
    pocket = [(-15 - px, 13 + py), (-15 + px, 13 + py), (-15 + px, 13 - py), (-15 - px, 13 - py)]
    walls(0, -POCKET_DEPTH, pocket)
    level(-POCKET_DEPTH, *reversed(pocket))
    boss = arc((SLOT[0], SLOT[1] + BOSS_TO_SLOT), BOSS / 2, 0, 360)[1:-1]
    walls(BOSS_HEIGHT, 0, boss)
    level(BOSS_HEIGHT, *boss)
    rectangle(floor, -60, -60, 110, 60)
    base = [(-60, -60), (110, -60), (110, 60), (-60, 60)]
    walls(floor, -30, base)
    level(-30, *reversed(base))
    # The platform: its front edge is place 6, its ends lean back by 30 degrees.
    right, dx, dy = 65 + PLATFORM, 10.0, 10.0 * math.sqrt(3)
    platform = [(65, -10), (right, -10), (right + dx, -10 + dy), (65 - dx, -10 + dy)]
    walls(floor + PLATFORM_HEIGHT, floor, platform)
    level(floor + PLATFORM_HEIGHT, *platform)

    print("# Written by make_specimen.py.")
    for text in vertices:
        print("v", text)
    for corners in faces:
        print("f", *corners)


if __name__ == "__main__":
    main()

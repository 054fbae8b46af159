# SPDX-License-Identifier: GPL-3.0-or-later
"""Families of degenerate input. FAMILIES maps a name to a function that draws a trial from a random.Random.

Sizes are in the order of 1 before the last motion; radii are drawn relative to what they have to fit into. Lengths that
are meant to coincide are multiples of 1/8, and so exact.
"""
import dataclasses
import json
import math

import shapes
from shapes import add, axes_swapped, box, cross, cylinder, dot, length, moved, n_gon, rotated, scaled, sub, times


@dataclasses.dataclass
class Step:
    """One call of the program: a subcommand on meshes by file name, which writes `output`."""
    command: str
    inputs: list
    options: list
    output: str = "out.off"

    def has_radius(self):
        return any(option in ("--radius", "--blends") for option in self.options)


@dataclasses.dataclass
class Trial:
    """What a seed stands for: meshes and other files by name, and the calls on them, each on the result before it."""
    meshes: dict
    steps: list
    files: dict = dataclasses.field(default_factory=dict)


FAMILIES = {}


def family(draw):
    FAMILIES[draw.__name__.rstrip("_").replace("_", "-")] = draw
    return draw


# --- draws -----------------------------------------------------------------------------------------------------------

def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def eighths(rng, low, high):
    """A multiple of 1/8 from low to high."""
    return rng.randint(round(8 * low), round(8 * high)) / 8


def direction(rng):
    while True:
        d = tuple(rng.uniform(-1, 1) for _ in range(3))
        if 0.1 < length(d) <= 1:
            return d


def draw_radius(rng, meshes):
    """A radius between far too small and far too large for the thinnest of the bodies, mostly in between."""
    size = min(min(mesh.extents()) for mesh in meshes)
    if rng.random() < 0.05:
        return size * log_uniform(rng, 1, 20)
    if rng.random() < 0.05:
        return size * log_uniform(rng, 1e-6, 1e-3)
    return size * log_uniform(rng, 3e-3, 0.6)


def blend_options(rng, radius):
    """--radius and what goes with it."""
    options = ["--radius", "%.6g" % radius]
    if rng.random() < 0.15:
        options += ["--mode", "map"]
    if rng.random() < 0.2:
        options += ["--profile", rng.choice(["chamfer", "conic:2", "conic:0.3", "g2", "hermite"])]
    if rng.random() < 0.15:
        options += ["--chord-tolerance", "%.3g" % log_uniform(rng, 1e-3, 0.1)]
    return options


def boolean(rng, meshes, operation=None):
    """A boolean of all the meshes, mostly with a radius."""
    names = ["%s.off" % "abcdefgh"[k] for k in range(len(meshes))]
    operation = operation or rng.choice(["union", "union", "difference", "difference", "intersection"])
    options = [] if rng.random() < 0.12 else blend_options(rng, draw_radius(rng, meshes))
    if options and rng.random() < 0.3:
        options.append("--keep-going")
    return Trial(dict(zip(names, meshes)), [Step(operation, names, options)])


def shuffled(rng, meshes):
    meshes = list(meshes)
    rng.shuffle(meshes)
    return meshes


# --- operands --------------------------------------------------------------------------------------------------------

def exact_body(rng):
    """A body with corners on the grid of eighths, within about [0,2]^3, its sides along the axes for the most part."""
    a, t, h = eighths(rng, 1, 2), eighths(rng, 0.25, 0.75), eighths(rng, 0.5, 2)
    square = [(0, 0), (a, 0), (a, a), (0, a)]
    kind = rng.randrange(10)
    if kind < 3:
        body = box((0, 0, 0), (a, eighths(rng, 0.5, 2), h))
    elif kind == 3:
        body = shapes.l_bracket(a, t, h)
    elif kind == 4:
        body = shapes.u_bracket(a, min(t, a / 4), h)
    elif kind == 5:
        body = moved(shapes.t_bracket(a, t, h), (a / 2, 0, 0))
    elif kind == 6:
        hole = n_gon(0.375 * a, rng.choice([3, 4, 6, 12, 24]))
        body = moved(shapes.frame([(x - a / 2, y - a / 2) for x, y in square], hole, 0, h / 2), (a / 2, a / 2, 0))
    elif kind == 7:
        body = moved(cylinder(a / 2, 4 * rng.randint(1, 12), 0, h, rng.randrange(3)), (a / 2, a / 2, 0))
    elif kind == 8:
        body = shapes.prism([(0, 0), (a, 0), (0, a)], 0, h, "wedge")
    else:
        body = stepped_block(rng)
    return axes_swapped(body, rng.choice([(0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (1, 0, 2), (2, 1, 0)]))


def stepped_block(rng):
    """Columns of cells of different heights: no two cells meet in an edge or a corner only."""
    n = rng.randint(2, 3)
    heights = [[rng.randint(1, 3) for _ in range(n)] for _ in range(n)]
    for i in range(1, n):  # heights that rise along both axes leave no diagonal neighbours alone
        for j in range(n):
            heights[i][j] = max(heights[i][j], heights[i - 1][j])
            heights[j][i] = max(heights[j][i], heights[j][i - 1])
    full = {(i, j, k) for i in range(n) for j in range(n) for k in range(heights[i][j])}
    lines = []
    for _ in range(3):
        line = [0.0]
        while len(line) < 4:
            line.append(line[-1] + eighths(rng, 0.25, 0.75))
        lines.append(line)
    return shapes.cells(lines, full, "stepped block")


def round_body(rng):
    """A body with curved sides about the origin, of size 2."""
    kind = rng.randrange(5)
    if kind == 0:
        return shapes.sphere(1, rng.randint(1, 3))
    if kind == 1:
        return cylinder(1, rng.choice([6, 8, 16, 24, 48]), -1, 1, rng.randrange(4))
    if kind == 2:
        return shapes.torus(1, eighths(rng, 0.25, 0.5), rng.choice([12, 24, 36]), rng.choice([8, 12, 18]))
    if kind == 3:
        return shapes.cone(1, rng.choice([5, 12, 32]), 2)
    return shapes.prism(n_gon(1, rng.randint(3, 9)), -1, 1)


def round_pair(rng):
    """Two bodies in general position that meet in closed curves without corners, for the most part."""
    kind = rng.randrange(4)
    if kind == 0:
        a = box((-2, -2, -1), (2, 2, 0))
        b = any_pose(rng, round_body(rng)) if rng.random() < 0.5 else round_body(rng)
        return [a, moved(b, tuple(rng.uniform(-0.5, 0.5) for _ in range(3)))]
    a = shapes.sphere(1, rng.randint(1, 3)) if kind == 1 else cylinder(1, rng.choice([12, 24, 48]), -2, 2)
    b = any_pose(rng, scaled(cylinder(1, rng.choice([12, 24, 48]), 0, 3, 2), (0.6, 0.6, 1)))
    if kind == 3:
        b = scaled(shapes.sphere(1, rng.randint(1, 3)), rng.uniform(0.4, 0.9))
    by = tuple(rng.uniform(-0.4, 0.4) for _ in range(3))
    return [a, moved(b, add(by, (rng.choice([0, 0.8]), 0, 0)))]


def any_body(rng):
    if rng.random() < 0.5:
        return exact_body(rng)
    return moved(round_body(rng), (1, 1, 1))


def any_pose(rng, mesh):
    return rotated(mesh, direction(rng), rng.uniform(0, 2 * math.pi))


def coplanar_pair(rng):
    """Two bodies with sides in common planes, exactly."""
    if rng.random() < 0.5:
        return flush_pair(rng)
    a, b = exact_body(rng), exact_body(rng)
    if rng.random() < 0.15:
        b = a
    choice = rng.randrange(4)
    (low_a, high_a), (low_b, high_b) = a.bounds(), b.bounds()
    by = [eighths(rng, -0.5, 1) for _ in range(3)]
    for k in range(3):
        if rng.random() < 0.6:
            by[k] = (0.0, low_a[k] - low_b[k], high_a[k] - high_b[k], high_a[k] - low_b[k])[choice if k else 1]
    return [a, moved(b, tuple(by))]


def flush_pair(rng):
    """A boss, a bore or a socket whose curves are closed and without corners, but which ends in a plane of the other
    body, has its vertices on edges of it, or has its size."""
    n = 4 * rng.randint(2, 12)
    r, h = eighths(rng, 0.25, 0.75), eighths(rng, 0.25, 1)
    kind = rng.randrange(6)
    plate = box((-1, -1, -h), (1, 1, 0))
    if rng.random() < 0.3:
        plate = cylinder(1, 4 * rng.randint(2, 12), -h, 0, rng.randrange(2))
    if kind < 3:  # through or into a plate: it ends in a plane of the plate at one side or at both
        low, high = rng.choice([(-h, 1), (-h, 0), (-h / 2, 0), (0, 1), (-1 - h, 0), (-1 - h, 1), (-h / 2, 1)])
        body = cylinder(r, n, low, high, rng.randrange(3))
        if rng.random() < 0.3:
            body = moved(rng.choice([shapes.sphere(r, 2), shapes.torus(0.5, 0.25, 24, 12)]), (0, 0, low))
        return [plate, moved(body, (eighths(rng, -0.25, 0.25), eighths(rng, -0.25, 0.25), 0))]
    if kind == 3:  # the pin that fills a hole, or has its centre
        hole = shapes.frame([(-1, -1), (1, -1), (1, 1), (-1, 1)], n_gon(r, n), -h, 0)
        return [hole, cylinder(rng.choice([r, r + 0.125, r - 0.125]), n, rng.choice([-h, -2]), rng.choice([0, 1]))]
    tube = cylinder(r, n, -1, 1, rng.randrange(2))
    if kind == 4:  # pipes whose axes cross: the second starts on the axis of the first, or runs through
        other = cylinder(rng.choice([r / 2, r - 0.125, 0.125]), n, rng.choice([0, -1]), 1)
        return [tube, axes_swapped(other, rng.choice([(2, 1, 0), (2, 0, 1), (1, 2, 0)]))]
    return [tube, moved(shapes.sphere(rng.choice([r / 2, r - 0.125, r + 0.125]), 2), (0, 0, rng.choice([-1, 0, 1])))]


# --- booleans --------------------------------------------------------------------------------------------------------

@family
def generic(rng):
    """Nothing degenerate: what the other families are compared with."""
    if rng.random() < 0.6:
        return boolean(rng, shuffled(rng, round_pair(rng)))
    a, b = any_body(rng), any_body(rng)
    b = moved(any_pose(rng, b), tuple(rng.uniform(-0.5, 1) for _ in range(3)))
    return boolean(rng, [a, b])


@family
def coplanar(rng):
    return boolean(rng, shuffled(rng, coplanar_pair(rng)))


@family
def touching(rng):
    """Contact without a common volume, in a vertex, an edge or a face; or across a common edge."""
    a = exact_body(rng)
    low, high = a.bounds()
    kind = rng.randrange(5)
    if kind == 0:  # boxes whose bounds touch, in one to three directions
        b = exact_body(rng)
        blow, bhigh = b.bounds()
        by = [eighths(rng, -0.5, 1) for _ in range(3)]
        for k in rng.sample(range(3), rng.randint(1, 3)):
            by[k] = rng.choice([high[k] - blow[k], low[k] - bhigh[k]])
        return boolean(rng, [a, moved(b, tuple(by))])
    if kind == 1:  # an apex on a face
        b = moved(rotated(shapes.cone(0.5, rng.choice([4, 12]), 1), (1, 0, 0), math.pi), (0, 0, 1))
        b = b.mapped(lambda p: p if abs(p[2]) > 1e-9 else (p[0], p[1], 0.0))
        return boolean(rng, [a, moved(b, (eighths(rng, 0, 1), eighths(rng, 0, 1), high[2]))])
    if kind == 2:  # a vertex of one body is a vertex of the other
        b = exact_body(rng)
        return boolean(rng, [a, moved(b, sub(rng.choice(a.points), rng.choice(b.points)))])
    if kind == 3:  # a vertex in the middle of an edge or a face
        b = any_body(rng)
        corners = [a.points[v] for v in rng.choice(a.faces)][:rng.randint(2, 3)]
        middle = times(1 / len(corners), tuple(map(sum, zip(*corners))))
        return boolean(rng, [a, moved(b, sub(middle, rng.choice(b.points)))])
    ridge = shapes.octahedron(eighths(rng, 0.5, 1))  # its equator lies in a plane, along edges and through faces
    return boolean(rng, [a, moved(ridge, (eighths(rng, 0, 2), eighths(rng, 0, 2), high[2]))])


@family
def tangent(rng):
    kind = rng.randrange(7)
    n, level = 4 * rng.randint(2, 12), rng.randint(1, 3)
    r = eighths(rng, 0.25, 1)
    plate = box((-2, -2, -0.5), (2, 2, 0))
    ball = shapes.sphere(r, level)
    if kind == 0:  # a ball on, or under, a plane
        return boolean(rng, [plate, moved(ball, (0, 0, rng.choice([r, -r])))])
    if kind == 1:  # two balls, from outside or from inside
        other = eighths(rng, 0.25, 1)
        apart = rng.choice([r + other, r - other])
        return boolean(rng, [ball, moved(shapes.sphere(other, level), (apart, 0, 0))])
    lying = rotated(cylinder(r, n, -1, 1), (1, 0, 0), math.pi / 2)
    if kind == 2:  # a cylinder that lies on a plane with an edge, or with a side
        if rng.random() < 0.5:
            lying = rotated(lying, (0, 1, 0), math.pi / n)
        return boolean(rng, [plate, moved(lying, (0, 0, rng.choice([1, -1]) * -lying.bounds()[0][2]))])
    if kind == 3:  # a cylinder as wide as the slab in which it lies
        slab = box((-2, -eighths(rng, 0.5, 2), -r), (2, 2, r))
        return boolean(rng, shuffled(rng, [slab, lying]))
    if kind == 4:  # two cylinders of the same radius that cross: their curves meet in two points
        other = rotated(cylinder(r, n, -1, 1), (0, 1, 0), math.pi / 2)
        return boolean(rng, [lying, other if rng.random() < 0.5 else moved(other, (0, 0, 2 * r))])
    if kind == 5:  # a ball as wide as the cylinder that it closes
        return boolean(rng, [cylinder(r, n, -1, 1), moved(ball, (0, 0, eighths(rng, 0, 1)))])
    ring = shapes.torus(1, r / 2, 24, 12)
    return boolean(rng, [plate, moved(ring, (0, 0, rng.choice([r / 2, -r / 2, 0])))])


@family
def nearly_coincident(rng):
    """Common planes missed by 1e-15 to 1e-3."""
    a, b = coplanar_pair(rng)
    shift = log_uniform(rng, 1e-15, 1e-3)
    by = times(shift, direction(rng)) if rng.random() < 0.5 else tuple(rng.choice([-shift, 0, shift]) for _ in range(3))
    return boolean(rng, [a, moved(b, by)])


@family
def rotated_by_epsilon(rng):
    """Common planes, of which one is then tilted a little."""
    a, b = coplanar_pair(rng)
    axis = direction(rng) if rng.random() < 0.5 else rng.choice([(1, 0, 0), (0, 1, 0), (0, 0, 1)])
    return boolean(rng, [a, rotated(b, axis, log_uniform(rng, 1e-15, 1e-2), rng.choice(b.points))])


@family
def rotated_coplanar(rng):
    """Common planes, both bodies turned in doubles: coplanar in theory, not to the last bit."""
    a, b = coplanar_pair(rng)
    axis, angle, by = direction(rng), rng.uniform(0, 2 * math.pi), times(rng.choice([0, 1, 100]), direction(rng))
    return boolean(rng, [moved(rotated(m, axis, angle), by) for m in (a, b)])


@family
def sliver(rng):
    """Triangles, walls and overlaps that are thin."""
    thin = log_uniform(rng, 1e-9, 1e-2)
    kind = rng.randrange(5)
    if kind == 0:  # corners that overlap a little
        a, b = box((0, 0, 0), (1, 1, 1)), any_body(rng)
        by = [rng.uniform(-0.5, 0.5) for _ in range(3)]
        for k in rng.sample(range(3), rng.randint(1, 2)):
            by[k] = 1 - thin - b.bounds()[0][k]
        return boolean(rng, [a, moved(b, tuple(by))])
    if kind == 1:  # a thin plate through a body
        plate = moved(box((-2, -2, 0), (2, 2, thin)), (1, 1, rng.uniform(0, 1)))
        body = moved(round_body(rng), (1, 1, 1)) if rng.random() < 0.5 else any_body(rng)
        return boolean(rng, shuffled(rng, [body, any_pose(rng, plate) if rng.random() < 0.5 else plate]))
    if kind == 2:  # one step in the outline is tiny
        outline = n_gon(1, rng.randint(3, 12))
        (x, y), (u, v) = outline[:2]
        outline.insert(1, (x + thin * (u - x), y + thin * (v - y)))
        outline[1] = times(1 + thin / 2, (*outline[1], 0))[:2]  # off the straight line: a corner of its own
        a = shapes.prism(outline, 0, 1, "prism with a tiny side")
        return boolean(rng, shuffled(rng, [a, moved(any_body(rng), (-0.3, -0.2, 0.4))]))
    if kind == 3:  # fine around, long along: every face of the side is a sliver
        a = cylinder(1, rng.choice([100, 200]), -5, 5)
        b = any_pose(rng, scaled(round_body(rng), 0.7)) if rng.random() < 0.5 else any_body(rng)
        return boolean(rng, [a, moved(b, (0.8, 0.2, 0.1))])
    a = box((0, 0, 0), (1, 1, 1))  # surfaces that meet at a small angle
    b = moved(rotated(box((-1, -1, 0), (2, 2, 0.5)), (1, 0.3, 0), max(thin, 1e-4)), (0, 0, 1 - thin / 2))
    return boolean(rng, shuffled(rng, [a, b]))


@family
def needle(rng):
    """Bodies that are long and thin."""
    thin = log_uniform(rng, 1e-5, 3e-2)
    kind = rng.randrange(4)
    if kind == 0:
        pin = box((-thin, -thin, -3), (thin, thin, 3))
    elif kind == 1:
        pin = cylinder(thin, rng.choice([5, 12]), -3, 3)
    elif kind == 2:
        pin = moved(shapes.cone(thin, rng.choice([4, 9]), 4), (0, 0, -1))
    else:
        pin = moved(shapes.prism([(0, 0), (thin, 0), (0, 1)], -3, 3), (0, 0.1, 0))
    if rng.random() < 0.4:  # in the middle of faces much larger than it is
        body = box((-2, -2, -2), (2, 2, 2))
        return boolean(rng, [body, moved(pin, (rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-3, 3)))])
    pin = any_pose(rng, pin) if rng.random() < 0.7 else pin
    body = any_body(rng) if rng.random() < 0.8 else shapes.cone(thin, 6, 3)
    centre = times(0.5, add(*body.bounds()))
    return boolean(rng, shuffled(rng, [body, moved(pin, add(centre, times(0.2, direction(rng))))]))


@family
def tiny_and_huge(rng):
    """Bodies of very different size."""
    a, b = any_body(rng), any_body(rng)
    ratio = log_uniform(rng, 1e3, 1e6)
    b = scaled(b, 1 / ratio)
    if rng.random() < 0.5:
        a, b = box((-1, -1, -1), (1, 1, 1)), scaled(round_body(rng), 1 / ratio)
    inside = rng.choice(a.points) if rng.random() < 0.3 else point_on(rng, a)
    b = moved(any_pose(rng, b) if rng.random() < 0.5 else b, sub(inside, times(rng.random() / ratio, (1, 1, 1))))
    factor = log_uniform(rng, 1e-4, 1e6)
    return boolean(rng, [scaled(m, factor) for m in shuffled(rng, [a, b])])


def point_on(rng, mesh):
    a, b, c = (mesh.points[v] for v in rng.choice(mesh.faces))
    u, v = sorted((rng.random(), rng.random()))
    return add(a, add(times(u, sub(b, a)), times(1 - v, sub(c, a))))


@family
def far_away(rng):
    """Bodies of size 1 at 1e2 to 1e8 from the origin: their coordinates have few digits left."""
    by = times(log_uniform(rng, 1e2, 1e8), direction(rng))
    a, b = coplanar_pair(rng) if rng.random() < 0.5 else round_pair(rng)
    return boolean(rng, [moved(a, by), moved(b, by)])


@family
def many_bodies(rng):
    """Three to six parts in one command."""
    kind = rng.random()
    parts = flush_pair(rng) if kind < 0.3 else round_pair(rng) if kind < 0.6 else [exact_body(rng)]
    regular = rng.random()
    for _ in range(rng.randint(3, 6) - len(parts)):
        if kind < 0.6:  # another boss, bore or ball, often apart from the others
            body = cylinder(eighths(rng, 0.125, 0.5), 4 * rng.randint(2, 8), -1, 2)
            part = rng.choice([body, body, shapes.sphere(eighths(rng, 0.25, 1), 2)])
        else:
            part = any_body(rng) if rng.random() < 0.5 else exact_body(rng)
        if regular < 0.5:
            by = tuple(eighths(rng, -1, 1) for _ in range(3))
        else:
            by = tuple(rng.uniform(-0.8, 0.8) for _ in range(3))
            part = any_pose(rng, part)
        parts.append(moved(part, by))
    operation = rng.choice(["union"] * 6 + ["difference"] * 3 + ["intersection"])
    trial = boolean(rng, parts, operation)
    options = trial.steps[0].options
    if options and rng.random() < 0.3:
        options[1] = ",".join("%.6g" % draw_radius(rng, parts[k:k + 2]) for k in range(len(parts) - 1))
    return trial


# --- edges of one mesh -----------------------------------------------------------------------------------------------

def sharp_edges(mesh, angle):
    """Edges (v, w), v < w, whose faces' normals differ by more than the angle, in degrees."""
    faces = {}
    for f, face in enumerate(mesh.faces):
        for i in range(3):
            faces.setdefault(frozenset((face[i - 1], face[i])), []).append(f)
    found = []
    for edge, (f, g) in faces.items():
        n, m = mesh.normal(f), mesh.normal(g)
        if math.degrees(math.atan2(length(cross(n, m)), dot(n, m))) > angle:
            found.append(tuple(sorted(edge)))
    return sorted(found)


def chains(edges):
    """Joins edges into polylines, which end where another number than two of them meet."""
    at = {}
    for edge in edges:
        for v in edge:
            at.setdefault(v, []).append(edge)
    left, polylines = dict.fromkeys(edges), []

    def follow(line):
        while len(at[line[-1]]) == 2:
            edge = next((e for e in at[line[-1]] if e in left), None)
            if edge is None:
                break
            del left[edge]
            line.append(edge[0] if edge[1] == line[-1] else edge[1])
        return line

    while left:
        edge = next(iter(left))
        del left[edge]
        line = follow(list(edge))
        polylines.append(follow(line[::-1]) if line[0] != line[-1] else line)
    return polylines


def some_edges(rng, mesh, edges):
    """A subset that users would choose: one, those about a vertex, those of a plane, many, all."""
    kind = rng.randrange(6)
    v = rng.choice(edges)[0]
    if kind == 0:
        return [rng.choice(edges)]
    if kind == 1:
        return [e for e in edges if v in e]
    if kind == 2:  # around a side that is parallel to a plane of coordinates
        k, at = rng.randrange(3), mesh.points[v]
        found = [e for e in edges if all(mesh.points[w][k] == at[k] for w in e)]
        return found or [e for e in edges if v in e]
    if kind == 3:  # parallel edges
        along = sub(mesh.points[rng.choice(edges)[1]], mesh.points[v])
        parallel = lambda d: length(cross(d, along)) < 1e-6 * length(d) * length(along)
        return [e for e in edges if parallel(sub(mesh.points[e[1]], mesh.points[e[0]]))] or edges
    if kind == 4:
        share = rng.random()
        return [e for e in edges if rng.random() < share] or [edges[0]]
    return edges


def law(rng, radius):
    """Fractions of the arc length and radii."""
    inner = [[round(rng.uniform(0.2, 0.8), 3), radius * rng.uniform(0.5, 1.5)]] if rng.random() < 0.3 else []
    return [[0, radius * rng.uniform(0.5, 1.5)]] + inner + [[1, radius * rng.uniform(0.5, 1.5)]]


def fillet(rng, mesh, edges):
    """A fillet of the edges, handed over in one of the three ways the program knows."""
    radius = draw_radius(rng, [mesh]) * rng.choice([0.3, 1])
    options = blend_options(rng, radius)
    if rng.random() < 0.1:
        options[1] = ",".join("%.6g:%.6g" % tuple(pair) for pair in law(rng, radius))
    if rng.random() < 0.35:
        options.append("--keep-going")
    files = {}
    if edges is None:
        options = ["--sharp-angle", "30"] + options
    elif rng.random() < 0.3:
        files["edges.selection.txt"] = "\n\n" + " ".join("%d %d" % e for e in edges) + "\n"
        options = ["--edges", "edges.selection.txt"] + options
    else:
        varied, by_law = rng.random() < 0.4, rng.random() < 0.1
        blends = []
        for line in chains(edges):
            blend = {"polyline": line, "radius": radius * (rng.uniform(0.5, 1.5) if varied else 1)}
            if by_law and rng.random() < 0.5:
                blend["radius"] = law(rng, radius)
            blends.append(blend)
        files["blends.json"] = json.dumps({"blends": blends})
        options = ["--blends", "blends.json"] + options
    return Trial({"a.off": mesh}, [Step("fillet", ["a.off"], options)], files)


def polyhedron(rng):
    kind = rng.randrange(12)
    a, t, h = eighths(rng, 1.5, 3), eighths(rng, 0.25, 0.625), eighths(rng, 0.5, 2)
    if kind < 2:
        return box((0, 0, 0), (a, eighths(rng, 0.5, 2), h))
    if kind == 2:
        return shapes.prism([(0, 0), (a, 0), (0, eighths(rng, 0.25, 2))], 0, h, "wedge")
    if kind == 3:
        return shapes.pyramid(n_gon(1, rng.randint(3, 7)), h)
    if kind == 4:
        return shapes.pyramid(n_gon(1, rng.randint(3, 7)), h, rng.choice([0.25, 0.5, 0.75, 1.5]))
    if kind == 5:
        return shapes.prism(n_gon(1, rng.randint(3, 9)), 0, h)
    if kind == 6:
        return rng.choice([shapes.l_bracket, shapes.t_bracket, shapes.u_bracket])(a, t, h)
    if kind == 7:
        return shapes.steps(rng.randint(2, 4), eighths(rng, 0.25, 1), h)
    if kind in (8, 9):
        body = None
        while body is None:
            points = [tuple(rng.randint(-1000, 1000) for _ in range(3)) for _ in range(rng.randint(4, 12))]
            body = shapes.polytope(points)
        return scaled(body, 1 / 1024)
    if kind == 10:
        return stepped_block(rng)
    return rng.choice([shapes.octahedron(1), exact_body(rng)])


@family
def edges(rng):
    """Some edges of a polyhedron: they end, and they meet in corners."""
    mesh = polyhedron(rng)
    found = sharp_edges(mesh, 1)
    if rng.random() < 0.3:
        mesh = any_pose(rng, mesh)
    return fillet(rng, mesh, None if rng.random() < 0.2 else some_edges(rng, mesh, found))


@family
def creases(rng):
    """All creases of one of the bodies of the other families, or some of them."""
    mesh = any_body(rng)
    if rng.random() < 0.5:
        mesh = any_pose(rng, mesh)
    found = sharp_edges(mesh, 30)
    if not found or rng.random() < 0.7:
        return fillet(rng, mesh, None)
    return fillet(rng, mesh, rng.choice([[e for e in found if set(e) <= set(line)] for line in chains(found)]))


@family
def creases_of_booleans(rng):
    """The creases of what a boolean left, degenerate or not."""
    draw = rng.choice([generic, coplanar, nearly_coincident, sliver, many_bodies, rotated_coplanar])
    sharp = draw(rng)
    first = sharp.steps[0]
    first.options, first.output = [], "sharp.off"
    second = fillet(rng, next(iter(sharp.meshes.values())), None).steps[0]
    second.inputs = ["sharp.off"]
    return Trial(sharp.meshes, [first, second])

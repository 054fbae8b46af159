# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed triangle meshes, oriented outward, and motions of them.

Coordinates that a CAD user would type (multiples of a power of two) stay exact, so that planes which ought to coincide
do: nothing is moved into place by arithmetic that rounds, unless a family wants that.
"""
import itertools
import math


class Mesh:
    """Points and triangles; `name` says what it is."""

    def __init__(self, name, points, faces):
        self.name, self.points, self.faces = name, [tuple(map(float, p)) for p in points], [tuple(f) for f in faces]

    def mapped(self, function, reverse=False):
        faces = [(a, c, b) for a, b, c in self.faces] if reverse else self.faces
        return Mesh(self.name, [function(p) for p in self.points], faces)

    def bounds(self):
        """Returns the least and the greatest corner of the bounding box."""
        return tuple(map(min, zip(*self.points))), tuple(map(max, zip(*self.points)))

    def extents(self):
        low, high = self.bounds()
        return sub(high, low)

    def volume(self):
        o = self.points[0]  # far from the origin, products of large numbers would cancel
        p = [sub(q, o) for q in self.points]
        return math.fsum(dot(p[a], cross(p[b], p[c])) for a, b, c in self.faces) / 6

    def normal(self, face):
        a, b, c = (self.points[v] for v in self.faces[face])
        return cross(sub(b, a), sub(c, a))

    def off(self):
        lines = ["OFF", "%d %d 0" % (len(self.points), len(self.faces))]
        lines += ["%r %r %r" % p for p in self.points]
        lines += ["3 %d %d %d" % f for f in self.faces]
        return "\n".join(lines) + "\n"


def read_off(text):
    words = text.split()
    if not words or words[0] != "OFF":
        raise ValueError("no OFF file")
    vertices, faces = int(words[1]), int(words[2])
    end = 4 + 3 * vertices
    if len(words) != end + 4 * faces:
        raise ValueError("%d words, not %d" % (len(words), end + 4 * faces))
    numbers = list(map(float, words[4:end]))
    indices = list(map(int, words[end:]))
    if any(indices[i] != 3 for i in range(0, len(indices), 4)):
        raise ValueError("a face is no triangle")
    return Mesh("file", zip(*[iter(numbers)] * 3), [indices[i + 1:i + 4] for i in range(0, len(indices), 4)])


# --- vectors ---------------------------------------------------------------------------------------------------------

def add(a, b):
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def times(s, a):
    return s * a[0], s * a[1], s * a[2]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def length(a):
    return math.sqrt(dot(a, a))


# --- motions ---------------------------------------------------------------------------------------------------------

def moved(mesh, by):
    return mesh.mapped(lambda p: add(p, by))


def scaled(mesh, by):
    x, y, z = by if isinstance(by, tuple) else (by, by, by)
    return mesh.mapped(lambda p: (x * p[0], y * p[1], z * p[2]), reverse=x * y * z < 0)


def rotated(mesh, axis, angle, centre=(0, 0, 0)):
    """Rotates about an axis through the centre (Rodrigues)."""
    k = times(1 / length(axis), axis)
    c, s = math.cos(angle), math.sin(angle)

    def turn(p):
        q = sub(p, centre)
        return add(centre, add(add(times(c, q), times(s, cross(k, q))), times(dot(k, q) * (1 - c), k)))

    return mesh.mapped(turn)


def axes_swapped(mesh, order):
    """Exact rotation or reflection: the axes in another order."""
    odd = order in ((0, 2, 1), (1, 0, 2), (2, 1, 0))
    return mesh.mapped(lambda p: (p[order[0]], p[order[1]], p[order[2]]), reverse=odd)


# --- bodies ----------------------------------------------------------------------------------------------------------

def box(low, high):
    points = [[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)]
    return Mesh("box", points, [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
                                (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)])


def cut_ears(outline):
    """Triangulates a simple polygon, counter-clockwise, without further points."""
    def turn(i, j, k):
        (ax, ay), (bx, by), (cx, cy) = outline[i], outline[j], outline[k]
        return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)

    def is_ear(i, j, k):
        return turn(i, j, k) > 0 and not any(
            m not in (i, j, k) and turn(i, j, m) >= 0 and turn(j, k, m) >= 0 and turn(k, i, m) >= 0 for m in left)

    left, triangles = list(range(len(outline))), []
    while len(left) > 3:
        for n, j in enumerate(left):
            i, k = left[n - 1], left[(n + 1) % len(left)]
            if is_ear(i, j, k):
                triangles.append((i, j, k))
                del left[n]
                break
        else:
            raise ValueError("the outline crosses itself")
    return triangles + [tuple(left)]


def prism(outline, z0, z1, name="prism"):
    """Right prism over a simple outline in the xy-plane, counter-clockwise."""
    n = len(outline)
    points = [(x, y, z) for z in (z0, z1) for x, y in outline]
    faces = []
    for a, b, c in cut_ears(outline):
        faces += [(a, c, b), (n + a, n + b, n + c)]
    for i in range(n):
        j = (i + 1) % n
        faces += [(i, j, n + j), (i, n + j, n + i)]
    return Mesh(name, points, faces)


def n_gon(radius, n, phase=0.0):
    return [(radius * math.cos(2 * math.pi * i / n + phase), radius * math.sin(2 * math.pi * i / n + phase))
            for i in range(n)]


def l_bracket(a, t, h):
    """Legs of length a and thickness t, height h."""
    return prism([(0, 0), (a, 0), (a, t), (t, t), (t, a), (0, a)], 0, h, "L")


def t_bracket(a, t, h):
    return prism([(-t / 2, 0), (t / 2, 0), (t / 2, a - t), (a / 2, a - t), (a / 2, a), (-a / 2, a), (-a / 2, a - t),
                  (-t / 2, a - t)], 0, h, "T")


def u_bracket(a, t, h):
    return prism([(0, 0), (a, 0), (a, a), (a - t, a), (a - t, t), (t, t), (t, a), (0, a)], 0, h, "U")


def steps(n, rise, h):
    """Block with n steps in profile."""
    outline = [(0, 0), (n, 0)]
    for k in range(n, 0, -1):
        outline += [(k, (n + 1 - k) * rise), (k - 1, (n + 1 - k) * rise)]
    return prism(outline, 0, h, "steps")


def frame(outer, inner, z0, z1):
    """Plate with a hole: both outlines counter-clockwise, about the origin, star-shaped seen from there."""
    n, m = len(outer), len(inner)
    points = [(x, y, z) for z in (z0, z1) for x, y in list(outer) + list(inner)]
    above = n + m

    def turn(outline, k, l):
        (ax, ay), (bx, by) = outline[k % len(outline)], outline[l % len(outline)]
        return math.remainder(math.atan2(by, bx) - math.atan2(ay, ax), 2 * math.pi)

    start = min(range(m), key=lambda k: abs(turn([outer[0], inner[k]], 0, 1)))
    at_outer, at_inner = 0.0, turn([outer[0], inner[start]], 0, 1)  # angles from the first corner
    cap, i, j = [], 0, 0
    while i < n or j < m:
        o, p = i % n, n + (start + j) % m
        next_outer = at_outer + turn(outer, i, i + 1)
        next_inner = at_inner + turn(inner, start + j, start + j + 1)
        # A side of one outline belongs to that corner of the other that is nearest in angle to its middle.
        if j == m or i < n and at_outer + next_outer <= at_inner + next_inner:
            cap.append((o, (i + 1) % n, p))
            i, at_outer = i + 1, next_outer
        else:
            cap.append((o, n + (start + j + 1) % m, p))
            j, at_inner = j + 1, next_inner
    faces = [(a, c, b) for a, b, c in cap] + [(above + a, above + b, above + c) for a, b, c in cap]
    for k in range(n):
        l = (k + 1) % n
        faces += [(k, l, above + l), (k, above + l, above + k)]
    for k in range(n, n + m):
        l = n + (k + 1 - n) % m
        faces += [(k, above + l, l), (k, above + k, above + l)]
    return Mesh("plate with a hole", points, faces)


def turned(outline, n, name):
    """Body of revolution about the z-axis in n steps; the outline runs from the axis below to the axis above."""
    points, faces = [], []
    for rho, z in outline[1:-1]:
        points += [(x, y, z) for x, y in n_gon(rho, n)]
    bottom, top = len(points), len(points) + 1
    points += [(0, 0, outline[0][1]), (0, 0, outline[-1][1])]
    last = bottom - n
    for i in range(n):
        j = (i + 1) % n
        faces += [(bottom, j, i), (top, last + i, last + j)]
        for a in range(0, last, n):
            faces += [(a + i, a + j, a + n + j), (a + i, a + n + j, a + n + i)]
    return Mesh(name, points, faces)


def cylinder(radius, n, z0, z1, rings=0):
    sides = [(radius, z0 + k * (z1 - z0) / (rings + 1)) for k in range(rings + 1)] + [(radius, z1)]
    return turned([(0, z0)] + sides + [(0, z1)], n, "cylinder")


def cone(radius, n, height):
    return turned([(0, 0), (radius, 0), (0, height)], n, "cone")


def pyramid(outline, height, top=0.0):
    """Pyramid over an outline about the origin; cut off parallel to its base where `top`, a share, is above 0."""
    if top == 0:
        n = len(outline)
        faces = [(a, c, b) for a, b, c in cut_ears(outline)] + [(i, (i + 1) % n, n) for i in range(n)]
        return Mesh("pyramid", [(x, y, 0) for x, y in outline] + [(0, 0, height)], faces)
    body = prism(outline, 0, height, "frustum")
    return body.mapped(lambda p: p if p[2] == 0 else (top * p[0], top * p[1], p[2]))


def torus(major, minor, n_major, n_minor):
    points, faces = [], []
    for i in range(n_major):
        u = 2 * math.pi * i / n_major
        for j in range(n_minor):
            v = 2 * math.pi * j / n_minor
            rho = major + minor * math.cos(v)
            points.append((rho * math.cos(u), rho * math.sin(u), minor * math.sin(v)))
    for i in range(n_major):
        for j in range(n_minor):
            k, l = (i + 1) % n_major, (j + 1) % n_minor
            a, b, c, d = i * n_minor + j, k * n_minor + j, k * n_minor + l, i * n_minor + l
            faces += [(a, b, c), (a, c, d)]
    return Mesh("torus", points, faces)


def sphere(radius, level):
    """Icosahedron split `level` times: 20 * 4^level faces."""
    g = (1 + math.sqrt(5)) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
              (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    for _ in range(level):
        middles, finer = {}, []

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middles:
                middles[key] = len(points)
                p = add(points[i], points[j])
                points.append(times(length(points[0]) / length(p), p))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return Mesh("sphere", [times(radius / length(p), p) for p in points], faces)


def octahedron(a):
    points = [(a, 0, 0), (-a, 0, 0), (0, a, 0), (0, -a, 0), (0, 0, a), (0, 0, -a)]
    faces = []
    for x, y, z in itertools.product((0, 1), (2, 3), (4, 5)):
        even = (x + y + z) % 2 == 0
        faces.append((x, y, z) if even else (x, z, y))
    return Mesh("octahedron", points, faces)


def polytope(points):
    """Convex hull of a few points with whole coordinates in general position; None if four lie in one of its planes."""
    used, faces = {}, []
    for triple in itertools.combinations(range(len(points)), 3):
        a, b, c = (points[v] for v in triple)
        normal = cross(sub(b, a), sub(c, a))
        sides = [dot(normal, sub(points[v], a)) for v in range(len(points)) if v not in triple]
        if min(sides) < 0 < max(sides):
            continue
        if 0 in sides:
            return None
        faces.append(triple if sides[0] < 0 else (triple[0], triple[2], triple[1]))
    for face in faces:
        for v in face:
            used.setdefault(v, len(used))
    return Mesh("polytope", [points[v] for v in used], [tuple(used[v] for v in face) for face in faces])


def cells(lines, full, name):
    """Body of the full cells (i, j, k) of a grid with the given coordinate lines along x, y and z."""
    index, faces = {}, []
    for cell in sorted(full):
        for axis in range(3):
            for side in (0, 1):
                beside = list(cell)
                beside[axis] += 2 * side - 1
                if tuple(beside) in full:
                    continue
                u, v = (axis + 1) % 3, (axis + 2) % 3
                square = []
                for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(cell)
                    corner[axis] += side
                    corner[u] += du
                    corner[v] += dv
                    square.append(index.setdefault(tuple(corner), len(index)))
                a, b, c, d = square if side else square[::-1]
                faces += [(a, b, c), (a, c, d)]
    return Mesh(name, [tuple(lines[k][corner[k]] for k in range(3)) for corner in index], faces)

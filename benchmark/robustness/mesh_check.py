# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks a written mesh without the library's help: closed, oriented, manifold, with area everywhere, volume positive.

Self-intersections are left to the program's own `check`: exact predicates on all pairs of faces take Python too long.
"""
import collections
import fractions
import math

from shapes import cross, dot, sub


def defects(mesh):
    """Returns what is wrong with the mesh, as a list of short texts."""
    if not mesh.faces:
        return ["no faces"]
    if not all(math.isfinite(x) for p in mesh.points for x in p):
        return ["a coordinate is not finite"]
    if not all(0 <= v < len(mesh.points) for face in mesh.faces for v in face):
        return ["a face has a vertex that does not exist"]
    found = edge_defects(mesh) + vertex_defects(mesh)
    if any(without_area(*(mesh.points[v] for v in face)) for face in mesh.faces):
        found.append("a face without area")
    if not mesh.volume() > 0:
        found.append("volume %r" % mesh.volume())
    return found


def edge_defects(mesh):
    uses = collections.Counter((face[i - 1], face[i]) for face in mesh.faces for i in range(3))
    if any(count > 1 for count in uses.values()):
        return ["an edge with two faces on one side"]
    if any((b, a) not in uses for a, b in uses):
        return ["not closed"]
    return []


def vertex_defects(mesh):
    """The faces about a vertex must form one fan; every vertex must have some."""
    following = collections.defaultdict(dict)
    for face in mesh.faces:
        for i in range(3):
            following[face[i]][face[i - 2]] = face[i - 1]
    if len(following) < len(mesh.points):
        return ["a vertex without faces"]
    for link in following.values():
        start = v = next(iter(link))
        steps = 0
        while steps <= len(link):
            v = link.get(v)
            steps += 1
            if v is None or v == start:
                break
        if v != start or steps != len(link):
            return ["the faces about a vertex form no fan"]
    return []


def without_area(a, b, c):
    if a == b or b == c or c == a:
        return True
    u, v = sub(b, a), sub(c, a)
    normal = cross(u, v)
    if dot(normal, normal) > 1e-24 * dot(u, u) * dot(v, v):  # far from zero, whatever the rounding
        return False
    p, q, r = ([fractions.Fraction(x) for x in point] for point in (a, b, c))
    return not any(cross(sub(q, p), sub(r, p)))

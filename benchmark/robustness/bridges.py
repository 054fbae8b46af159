#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws bridges on models and judges every run: random spots, radii, shapes and twists, on one body or between two.

  bridges.py --models FOLDER --runs 500        a table, and results.json in the output folder
  bridges.py --models FOLDER --seed 17         replays one run, keeps its files and prints its command

A run is good if the program writes a mesh that `cgal-blend check` accepts, with the Euler characteristic that a bridge
leaves, or refuses by name with one line and nothing written. Exit status: 0 if all runs are good.
"""
import argparse
import collections
import json
import math
import pathlib
import random
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODELS = ["bear", "blub_fish", "bob", "dino", "hand_palm", "nefertiti_bust", "octopus", "spot"]
SIGNALLED = "signal"


def read_off(path):
    words = [w for line in path.read_text().splitlines() if not line.startswith("#") for w in line.split()]
    n, m = int(words[1]), int(words[2])
    numbers = words[4:]
    points = [tuple(float(x) for x in numbers[3 * i:3 * i + 3]) for i in range(n)]
    faces = [tuple(int(x) for x in numbers[3 * n + 4 * i + 1:3 * n + 4 * i + 4]) for i in range(m)]
    return points, faces


def euler(points, faces):
    edges = {tuple(sorted((f[i], f[(i + 1) % 3]))) for f in faces for i in range(3)}
    return len({v for f in faces for v in f}) - len(edges) + len(faces)


def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def scaled(a, s): return tuple(s * x for x in a)
def unit(a): return scaled(a, 1 / math.sqrt(dot(a, a)))


class Model:
    def __init__(self, path):
        self.path = path
        self.points, self.faces = read_off(path)
        self.euler = euler(self.points, self.faces)
        low = [min(p[k] for p in self.points) for k in range(3)]
        high = [max(p[k] for p in self.points) for k in range(3)]
        self.diagonal = math.dist(low, high)

    def spot(self, rng):
        """A random point of a random face, with its normal."""
        while True:
            corners = [self.points[v] for v in self.faces[rng.randrange(len(self.faces))]]
            u, v = sorted((rng.random(), rng.random()))
            weights = (u, v - u, 1 - v)
            place = tuple(sum(w * c[k] for w, c in zip(weights, corners)) for k in range(3))
            normal = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))
            if dot(normal, normal) > 0:
                return place, unit(normal)

    def open_spot(self, rng, tries):
        """The one of several random spots with the least of the body in front of it."""
        def in_front(spot):
            return max(dot(spot[1], p) for p in self.points[::16]) - dot(spot[1], spot[0])
        return min((self.spot(rng) for _ in range(tries)), key=in_front)


def turn_onto(a, b, angle):
    """The rotation that takes a unit vector to another, with a further turn about that one."""
    def frame(n):
        u = unit(cross(n, (1, 0, 0) if abs(n[0]) < 0.7 else (0, 1, 0)))
        return u, cross(n, u), n
    u, v, w = frame(b)
    c, s = math.cos(angle), math.sin(angle)
    target = (tuple(c * x + s * y for x, y in zip(u, v)), tuple(c * y - s * x for x, y in zip(u, v)), w)
    source = frame(a)
    return [[sum(target[k][i] * source[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def text(p): return ",".join(repr(x) for x in p)


def curve(rng, radius):
    kind = rng.choice(["circle", "circle", "ellipse", "rect", "star", "cross"])
    a, b = radius, radius * rng.uniform(0.4, 0.9)
    return {"circle": "circle", "ellipse": f"ellipse:{a!r},{b!r}", "rect": f"rect:{a!r},{b!r}",
            "star": f"star:{rng.uniform(0.05, 0.4)!r},{rng.randint(2, 7)}", "cross": f"cross:{a!r},{b / 2!r}"}[kind]


def draw(rng, models):
    """Arguments of a run, and the Euler characteristic of what goes in, if it says what is to come out."""
    a = rng.choice(models)
    place, normal = a.open_spot(rng, rng.choice([1, 4, 8]))
    radii = [a.diagonal * math.exp(rng.uniform(math.log(0.005), math.log(0.1))) for _ in range(2)]
    arguments = [str(a.path)]
    kind = rng.random()
    if kind < 0.15:  # another body that crosses, bridged around the intersection
        return crossing(rng, a, place, normal, radii, models), None
    if kind < 0.8:  # another body, placed so that the spots face each other, more or less
        b = rng.choice(models)
        there, facing = b.open_spot(rng, rng.choice([1, 4, 8]))
        scale = a.diagonal / b.diagonal * rng.uniform(0.3, 1)
        m = turn_onto(facing, scaled(normal, -1), rng.uniform(0, 2 * math.pi))
        m = [[scale * x for x in row] for row in m]
        gap = max(radii) * rng.uniform(0.5, 8)
        target = tuple(p + gap * n + 0.3 * max(radii) * rng.uniform(-1, 1) for p, n in zip(place, normal))
        shift = [target[i] - dot(m[i], there) for i in range(3)]
        arguments += [str(b.path), "--transform-b", " ".join(repr(x) for i in range(3) for x in [*m[i], shift[i]])]
        second, total = target, a.euler + b.euler
    else:
        second, total = a.spot(rng)[0], a.euler
    arguments += ["--at-a", text(place), "--at-b", text(second)]
    for end, radius in zip("ab", radii):
        arguments += [f"--radius-{end}", repr(radius), f"--curve-{end}", curve(rng, radius)]
        arguments += [f"--lambda-{end}", repr(rng.choice([0, rng.random(), rng.random(), 0.999]))]
    arguments += ["--mu", repr(rng.uniform(0.05, 0.95)), "--order", str(rng.randint(1, 3))]
    arguments += ["--twist", repr(rng.choice([0, 0, rng.uniform(-180, 180)]))]
    return arguments, total


def crossing(rng, a, place, normal, radii, models):
    """Arguments of a run that unites two bodies, the second one pushed in at a spot of the first."""
    b = rng.choice(models)
    there, facing = b.open_spot(rng, 4)
    m = turn_onto(facing, scaled(normal, -1), rng.uniform(0, 2 * math.pi))
    scale = a.diagonal / b.diagonal * rng.uniform(0.2, 0.6)
    m = [[scale * x for x in row] for row in m]
    target = tuple(p - 0.05 * a.diagonal * rng.random() * n for p, n in zip(place, normal))
    shift = [target[i] - dot(m[i], there) for i in range(3)]
    arguments = [str(a.path), str(b.path), "--cross"]
    arguments += ["--transform-b", " ".join(repr(x) for i in range(3) for x in [*m[i], shift[i]])]
    for end, radius in zip("ab", radii):
        arguments += [f"--radius-{end}", repr(0.3 * radius), f"--lambda-{end}", repr(rng.random())]
    return arguments


def judge(program, arguments, before, folder, seconds):
    """Returns the outcome of a run: 'bridged', the name of a refusal, or something that begins with '!'."""
    out, report = folder / "out.off", folder / "report.json"
    command = [program, "bridge", *arguments, "-o", str(out), "--report", str(report), "--quiet"]
    (folder / "command").write_text(" ".join(f"'{word}'" for word in command) + "\n")
    try:
        done = subprocess.run(command, capture_output=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return "! timeout"
    if done.returncode < 0:
        return f"! {SIGNALLED} {-done.returncode}"
    status = json.loads(report.read_text())["status"]
    if done.returncode != 0:
        if done.returncode != 4 or out.exists() or len(done.stderr.splitlines()) != 1:
            return f"! exit {done.returncode}: {status}"
        return status
    if subprocess.run([program, "check", str(out), "--quiet"], capture_output=True).returncode != 0:
        return "! invalid"
    if before is None:  # that of a union is not known beforehand
        return "bridged"
    after = euler(*read_off(out))
    return "bridged" if after == before - 2 else f"! Euler characteristic {after}, not {before - 2}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/cgal-blend"))
    parser.add_argument("--models", type=pathlib.Path, required=True, help="folder with " + ", ".join(MODELS))
    parser.add_argument("--runs", type=int, default=500)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--seed", type=int)
    parser.add_argument("--time", type=float, default=60, help="seconds per run")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "build/bridges")
    options = parser.parse_args()
    models = [Model(options.models / f"{name}.off") for name in MODELS]
    seeds = [options.seed] if options.seed is not None else range(options.first_seed, options.first_seed + options.runs)
    options.output.mkdir(parents=True, exist_ok=True)
    results, bad = {}, 0
    started = time.monotonic()
    for seed in seeds:
        folder = options.output / f"run_{seed}"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        arguments, before = draw(random.Random(seed), models)
        result = judge(options.program, arguments, before, folder, options.time)
        results[seed] = result
        if options.seed is not None:
            print((folder / "command").read_text(), end="")
        elif not result.startswith("!"):
            shutil.rmtree(folder)
        if result.startswith("!"):
            bad += 1
            print(f"seed {seed}: {result}")
    (options.output / "results.json").write_text(json.dumps(results, indent=1) + "\n")
    for result, count in collections.Counter(results.values()).most_common():
        print(f"{count:6d}  {100 * count / len(results):5.1f} %  {result}")
    print(f"{len(results)} runs in {time.monotonic() - started:.0f} s, {bad} defects")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())

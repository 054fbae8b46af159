#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs cgal-blend on drawn degenerate input and judges every run.

  robustness.py --runs 2000                    all families in turn; results.json, a table, the files of the defects
  robustness.py --family sliver --seed 17      replays one run, keeps its files and prints its commands

Exit status: 0 no defect; else that of the gravest class of defect found (see CLASSES).
"""
import sys

sys.dont_write_bytecode = True

import argparse
import collections
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import tempfile
import threading

import families
import mesh_check
import shapes

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Class of a run and the exit status that it asks for.
CLASSES = {
    "blended": 0,   # valid, all curves blended
    "partly": 0,    # valid, some curves left sharp, as --keep-going allows
    "sharp": 0,     # valid, no radius given
    "refused": 0,   # exit 2 to 4, by name, one line on stderr, nothing written
    "timeout": 10,
    "contract": 11,  # more or less than a line on stderr, a file changed without right, a report that is wrong
    "internal": 12,  # exit 5: the program withheld its own result
    "crash": 13,    # a signal, or an exit status that is none of the program's
    "invalid": 14,  # written, but not a valid mesh, or not what the command asked for
}
DEFECTS = [name for name, status in CLASSES.items() if status]

KEPT = b"a file of the user\n"  # stands where the output goes; a refusal must leave it alone


@dataclasses.dataclass
class Limits:
    seconds: float
    gigabytes: float


@dataclasses.dataclass
class Ended:
    """How a call of the program ended."""
    exit: int  # negative: the signal
    killed: bool
    stdout: bytes
    stderr: bytes
    seconds: float  # of the processor
    megabytes: float


class Defect(Exception):
    """Ends the judgement of a run: a class of CLASSES and why."""

    def __init__(self, kind, why):
        super().__init__(why)
        self.kind = kind


def call(command, folder, limits):
    """Runs a command in a folder. Time is that of the processor, so that a busy machine does not spoil the figures."""
    def limit():
        seconds = int(limits.seconds + 1)
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if limits.gigabytes:
            size = int(limits.gigabytes * 2**30)
            resource.setrlimit(resource.RLIMIT_AS, (size, size))

    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        child = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                 preexec_fn=limit)
        killed = []
        timer = threading.Timer(5 * limits.seconds, lambda: (killed.append(True), child.kill()))  # asleep, not busy
        timer.start()
        _, status, usage = os.wait4(child.pid, 0)
        timer.cancel()
        child.returncode = os.waitstatus_to_exitcode(status)
        seconds = usage.ru_utime + usage.ru_stime
        over = child.returncode in (-signal.SIGXCPU, -signal.SIGKILL) and seconds > limits.seconds
        out.seek(0)
        err.seek(0)
        return Ended(child.returncode, bool(killed) or over, out.read(), err.read(), seconds, usage.ru_maxrss / 1024)


# --- one run ---------------------------------------------------------------------------------------------------------

class Run:
    """One trial in a folder of its own, step by step; `result` is what goes into the JSON."""

    def __init__(self, program, family, seed, folder, limits):
        self.program, self.folder, self.limits = program, pathlib.Path(folder), limits
        self.rng = random.Random("%s/%d" % (family, seed))
        self.result = {"family": family, "seed": seed, "class": "", "status": "", "why": "", "exit": None,
                       "seconds": 0.0, "megabytes": 0.0, "commands": []}
        self.trial = families.FAMILIES[family](self.rng)
        self.careful = self.rng.random() < 0.1  # these are also run twice, and their output file exists beforehand
        self.known = dict(self.trial.meshes)

    def execute(self):
        for name, mesh in self.trial.meshes.items():
            self.write(name, mesh.off())
        for name, text in self.trial.files.items():
            self.write(name, text)
        try:
            for step in self.trial.steps:
                self.judge(step)
                if self.result["class"] == "refused":
                    break
        except Defect as defect:
            self.result.update({"class": defect.kind, "why": str(defect)})
        return self.result

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def files(self):
        return {p.name: p.read_bytes() for p in self.folder.iterdir()}

    def command(self, step, output, report):
        return [step.command, *step.inputs, *step.options, "-o", output, "--quiet", "--report", report]

    def call(self, arguments):
        ended = call([self.program] + arguments, self.folder, self.limits)
        self.result["seconds"] = round(self.result["seconds"] + ended.seconds, 3)
        self.result["megabytes"] = round(max(self.result["megabytes"], ended.megabytes))
        self.result["exit"] = ended.exit
        return ended

    def judge(self, step):
        if self.careful:
            (self.folder / step.output).write_bytes(KEPT)
        before = self.files()
        arguments = self.command(step, step.output, "report.json")
        self.result["commands"].append("cgal-blend " + subprocess.list2cmdline(arguments))
        ended = self.call(arguments)
        if ended.killed:
            raise Defect("timeout", "%.0f s, %.0f MB" % (ended.seconds, ended.megabytes))
        if ended.exit not in (0, 2, 3, 4, 5):
            lines = ended.stderr.decode(errors="replace").strip().splitlines()
            why = signal.Signals(-ended.exit).name if ended.exit < 0 else "exit status %d" % ended.exit
            raise Defect("crash", " ".join([why] + lines[:3]))
        report = self.report(step, ended)
        self.check_files(step, ended, before)
        if ended.exit == 5:
            raise Defect("internal", report["message"])
        if ended.exit == 0:
            self.check_output(step, report)
        if self.careful:
            self.check_repeatable(step, ended)

    def report(self, step, ended):
        """Reads the report and takes class and status from it."""
        message = ended.stderr.decode(errors="replace")
        try:
            report = json.loads((self.folder / "report.json").read_text())
        except FileNotFoundError:
            if ended.exit != 2:
                raise Defect("contract", "no report") from None
            report = {"status": "usage", "message": message.strip(), "blends": [], "output": None}
        except ValueError as error:
            raise Defect("contract", "the report is no JSON: %s" % error) from None
        self.result["status"] = report["status"]
        if ended.stdout:
            raise Defect("contract", "--quiet, but: %r" % ended.stdout[:200])
        if ended.exit == 0:
            if message:
                raise Defect("contract", "success, but on stderr: %r" % message[:200])
            if report["status"] != "ok":
                raise Defect("contract", "success, but status " + report["status"])
            sharp = [b for b in report["blends"] if b["status"] != "ok"]
            if sharp and "--keep-going" not in step.options:
                raise Defect("contract", "a curve was left sharp without --keep-going")
            self.result["class"] = "sharp" if not step.has_radius() else "partly" if sharp else "blended"
            self.result["why"] = ", ".join(sorted({b["status"] for b in sharp}))
            errors = [b["radius_error"] for b in report["blends"] if b.get("radius_error") is not None]
            if errors:
                self.result["radius_error"] = max(errors)
            return report
        self.result["class"], self.result["why"] = "refused", message.strip()
        if message.count("\n") != 1 or not message.endswith("\n") or len(message) < 20:
            raise Defect("contract", "not one line on stderr: %r" % message[:300])
        if report["status"] == "ok":
            raise Defect("contract", "refused, but status ok")
        return report

    def check_files(self, step, ended, before):
        after = self.files()
        may_change = {"report.json"} | ({step.output} if ended.exit == 0 else set())
        touched = {name for name in before.keys() | after.keys() if before.get(name) != after.get(name)}
        if touched - may_change:
            raise Defect("contract", "wrote, changed or removed " + ", ".join(sorted(touched - may_change)))
        if ended.exit == 0 and step.output not in touched:
            raise Defect("contract", "success, but no output")

    def check_output(self, step, report):
        try:
            mesh = shapes.read_off((self.folder / step.output).read_text())
        except ValueError as error:
            raise Defect("invalid", "unreadable: %s" % error) from None
        check = self.call(["check", step.output, "--quiet"])
        self.result["exit"] = 0
        if check.exit != 0:
            raise Defect("invalid", "check: " + check.stderr.decode(errors="replace").strip())
        defects = mesh_check.defects(mesh) or implausible(step, [self.known[name] for name in step.inputs], mesh)
        if defects:
            raise Defect("invalid", "; ".join(defects))
        if (len(mesh.points), len(mesh.faces)) != (report["output"]["vertices"], report["output"]["faces"]):
            raise Defect("contract", "the report counts other vertices and faces than the file has")
        self.known[step.output] = mesh
        if self.result["class"] == "sharp" and len(step.inputs) == 2:
            self.check_volume(step, mesh)

    def check_volume(self, step, mesh):
        """The volumes of union and intersection add up to those of the bodies; those of difference and intersection to
        that of the first."""
        other = dataclasses.replace(step, command="union" if step.command == "intersection" else "intersection")
        arguments = self.command(other, "other.off", "other.json")
        if self.call(arguments).exit == 0:
            a, b = (self.known[name].volume() for name in step.inputs)
            sum_of_both = mesh.volume() + shapes.read_off((self.folder / "other.off").read_text()).volume()
            expected = a if step.command == "difference" else a + b
            if abs(sum_of_both - expected) > 1e-6 * (a + b):
                raise Defect("invalid", "the volumes of %s and %s add up to %r, not %r" %
                             (step.command, other.command, sum_of_both, expected))
        self.result["exit"] = 0
        for name in ("other.off", "other.json"):
            (self.folder / name).unlink(missing_ok=True)

    def check_repeatable(self, step, ended):
        again = self.call(self.command(step, "again.off", "again.json"))
        if again.exit != ended.exit:
            raise Defect("contract", "exit status %d, and %d when run again" % (ended.exit, again.exit))
        if again.exit == 0 and (self.folder / "again.off").read_bytes() != (self.folder / step.output).read_bytes():
            raise Defect("contract", "the output differs from run to run")
        for name in ("again.off", "again.json"):
            (self.folder / name).unlink(missing_ok=True)


def implausible(step, bodies, mesh):
    """Says what cannot be right about the result, whatever the curves: a blend stays within the hull of the bodies,
    one between united bodies adds material, one on an intersection or a difference takes some away."""
    (low, high), volume = bodies[0].bounds(), mesh.volume()
    volumes = [body.volume() for body in bodies]
    for body in bodies[1:] if step.command == "union" else []:
        low, high = tuple(map(min, low, body.bounds()[0])), tuple(map(max, high, body.bounds()[1]))
    slack = 1e-2 * shapes.length(shapes.sub(high, low)) if step.has_radius() else 1e-9 * max(map(abs, low + high))
    found = []
    if any(a < b - slack for a, b in zip(mesh.bounds()[0], low)) or any(
            a > b + slack for a, b in zip(mesh.bounds()[1], high)):
        found.append("it reaches beyond the bodies: %r to %r" % mesh.bounds())
    slack = (1e-3 if step.has_radius() else 1e-6) * max(volumes)  # curved bodies: the blend is on the true surface
    least = max(volumes) if step.command == "union" else 0
    most = {"union": sum(volumes), "intersection": min(volumes), "difference": volumes[0]}.get(step.command)
    if step.has_radius() and step.command == "union" or most is None:
        sides = shapes.sub(high, low)
        most = sides[0] * sides[1] * sides[2]
    if not least - slack <= volume <= most + slack:
        found.append("volume %r, not between %r and %r" % (volume, least, most))
    return found


def run_one(program, family, seed, keep, limits, always_keep=False):
    """Runs a trial in a temporary folder; keeps the folder as KEEP/FAMILY-SEED if it shows a defect, or if asked to."""
    with tempfile.TemporaryDirectory(prefix="robustness-") as scratch:
        run = Run(program, family, seed, scratch, limits)
        result = run.execute()
        if always_keep or result["class"] in DEFECTS:
            run.write("commands.txt", "\n".join(result["commands"]) + "\n")
            kept = pathlib.Path(keep) / ("%s-%d" % (family, seed))
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(scratch, kept)
            result["kept"] = str(kept)
        return result


# --- all runs --------------------------------------------------------------------------------------------------------

def totals(runs):
    counts = {name: 0 for name in CLASSES}
    counts.update(collections.Counter(run["class"] for run in runs))
    refusals = collections.Counter(run["status"] for run in runs if run["class"] == "refused")
    with_radius = len(runs) - counts["sharp"]
    return {"runs": len(runs), "classes": counts, "refusals": dict(refusals.most_common()),
            "blended_share": round((counts["blended"] + counts["partly"]) / max(1, with_radius), 3),
            "seconds": round(sum(run["seconds"] for run in runs), 1)}


def table(by_family, everything):
    """One row per family: runs by class, share blended, refusals by name."""
    names = [name for name in CLASSES if everything["classes"][name] or name in ("blended", "sharp", "refused")]
    head = ["family", "runs"] + names + ["blended %", "refusals"]
    rows = []
    for family, t in list(by_family.items()) + [("all", everything)]:
        refusals = ", ".join("%s %d" % item for item in t["refusals"].items())
        rows.append([family, t["runs"]] + [t["classes"][name] for name in names] +
                    ["%.0f" % (100 * t["blended_share"]), refusals])
    lines = [head, ["---"] + ["---:"] * (len(head) - 2) + ["---"]] + rows
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def run_all(options, names, limits):
    tasks = [(names[i % len(names)], options.first_seed + i // len(names)) for i in range(options.runs)]
    runs = []
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        futures = [pool.submit(run_one, options.program, *task, options.output, limits) for task in tasks]
        try:
            for future in concurrent.futures.as_completed(futures):
                runs.append(future.result())
                if runs[-1]["class"] in DEFECTS:
                    print("%(class)s: --family %(family)s --seed %(seed)d: %(why)s" % runs[-1], flush=True)
                if sys.stderr.isatty():
                    print("\r%d of %d" % (len(runs), len(tasks)), end="", file=sys.stderr)
        except KeyboardInterrupt:  # what has been found is worth a table
            pool.shutdown(wait=True, cancel_futures=True)
    runs.sort(key=lambda run: (names.index(run["family"]), run["seed"]))
    by_family = {name: totals([run for run in runs if run["family"] == name]) for name in names}
    everything = totals(runs)
    with open(pathlib.Path(options.output) / "results.json", "w") as out:
        json.dump({"program": options.program, "limits": dataclasses.asdict(limits), "totals": everything,
                   "families": by_family, "runs": runs}, out, indent=1)
    print(table(by_family, everything))
    return runs


def replay(options, limits):
    result = run_one(options.program, options.family[0], options.seed, options.output, limits, always_keep=True)
    print("cd %s" % result["kept"])
    for command in result["commands"]:
        print(command)
    print("%(class)s, exit %(exit)s, status %(status)s, %(seconds).1f s: %(why)s" % result)
    return [result]


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/cgal-blend"), help="[%(default)s]")
    parser.add_argument("--runs", type=int, default=200, help="spread over the families [%(default)s]")
    parser.add_argument("--first-seed", type=int, default=0, metavar="N", help="[%(default)s]")
    parser.add_argument("--family", action="append", choices=sorted(families.FAMILIES), help="only this; repeatable")
    parser.add_argument("--seed", type=int, help="replay this run of the family")
    parser.add_argument("--jobs", type=int, default=1, help="runs at a time [%(default)s]")
    parser.add_argument("--time", type=float, default=20, help="seconds of processor time per call [%(default)s]")
    parser.add_argument("--memory", type=float, default=2, help="gigabytes per call, 0: no limit [%(default)s]")
    parser.add_argument("--output", default=str(ROOT / "build/robustness"), metavar="DIR", help="[%(default)s]")
    options = parser.parse_args()
    if options.seed is not None and len(options.family or []) != 1:
        parser.error("--seed needs one --family")
    options.program = str(pathlib.Path(options.program).resolve())
    return options


def main():
    options = parse_options()
    limits = Limits(options.time, options.memory)
    pathlib.Path(options.output).mkdir(parents=True, exist_ok=True)
    names = options.family or list(families.FAMILIES)
    runs = replay(options, limits) if options.seed is not None else run_all(options, names, limits)
    return max(CLASSES[run["class"]] for run in runs)


if __name__ == "__main__":
    sys.exit(main())

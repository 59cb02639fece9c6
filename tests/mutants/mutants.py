#!/usr/bin/env python3
"""Makes small mutations of the product, and counts those that its tests find.

    mutants.py N [--seed S] [--root FOLDER]

Each of N mutants is one small mutation (mutations.py) of one source file of lang, motion, drivers or
runtime, drawn by the seed. It is built, and the tests of its layer run: first those of its folder in
the layer's test binary, then the others, at last the tests from outside. A mutant is dead when a
test fails, crashes, or takes several times as long as without it. Which of the three found it is
printed. A mutation that does not compile, or compiles to the same code, does not count: another one
is drawn.

It works on a copy, build-mutants/source, and never touches the sources. It prints each survivor with
its position. The exit code is 0 if at least 90 % died.
"""

import argparse
import fcntl
import hashlib
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True  # no files beside the sources
from mutations import mutations_of  # noqa: E402

LAYERS = ("lang", "motion", "drivers", "runtime")
SOURCES = (*LAYERS, "base", "tests", "docs", "examples", "CMakeLists.txt", "README.md", "CHANGELOG.md", "LICENSE",
           "packages.txt")
GOAL = 0.9
NOT_IN_REAL_TIME = "--source-file-exclude=*/link/*,*/machines/*,*/real_time_*"
# Names of ctest: what tests a layer from outside, beside <layer>_test.
OUTSIDE = {
    "lang": "^(programs|samples|examples|docs)/|^README|^cli_test",
    "motion": "^(motions|examples|docs)/|^judge$|drawings$|^(drivers|cli|runtime)_test$|^cli_test/",
    "drivers": "^(cells|examples)/|^(cli|runtime)_test|^real_time/",
    "runtime": "^(programs|examples|docs)/|^cli_test|^real_time/cli_test$",
}


class Failed(Exception):
    """What is wrong with the run itself, for the person who started it."""


def limit_resources():
    """For a mutant that goes on and on: bytes of memory, and of what it writes to one file."""
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    resource.setrlimit(resource.RLIMIT_FSIZE, (256 << 20, 256 << 20))


def processor_time(session):
    """Seconds of processor time that the processes of a session have used, with the children that
    they have waited for."""
    ticks = 0
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue  # it has ended
        if int(fields[3]) == session:
            ticks += sum(int(field) for field in fields[11:15])
    return ticks / os.sysconf("SC_CLK_TCK")


class Limit:
    """How long a run may take: in processor time, which other work on the machine does not change,
    and in time that passes, for a run that only waits."""

    def __init__(self, used, passed):
        self.used = used
        self.passed = passed

    def wait_for(self, process):
        """Whether the process ended within the limits with 0."""
        begin = time.monotonic()
        while True:
            try:
                return process.wait(1) == 0
            except subprocess.TimeoutExpired:
                passed = time.monotonic() - begin
                if passed > self.passed or processor_time(process.pid) > self.used:
                    return False


def run(command, folder, limit=None, environment=None):
    """Runs it in a session of its own, which is killed as a whole when it goes beyond the limit or
    this program ends. Whether it returned 0, and all that it wrote."""
    with tempfile.TemporaryFile() as out:
        # No abort between the start and what kills it.
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM})

        def prepare():
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
            if limit:
                limit_resources()

        process = subprocess.Popen(
            command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
            env=environment, start_new_session=True, preexec_fn=prepare,
        )  # fmt: skip
        try:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
            passed = limit.wait_for(process) if limit else process.wait() == 0
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass  # all have ended
            process.wait()
        out.seek(0)
        return passed, out.read().decode(errors="replace")


class Copy:
    """The copy of the sources, and its build."""

    def __init__(self, root):
        self.root = root
        self.source = root / "build-mutants" / "source"
        self.build = root / "build-mutants" / "build"

    def lock(self):
        """Until this program ends; only one run may use the copy."""
        self.source.mkdir(parents=True, exist_ok=True)
        self.locked = os.open(self.source, os.O_RDONLY | os.O_CLOEXEC)
        try:
            fcntl.flock(self.locked, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Failed("another run is at work on build-mutants") from None

    def synchronize(self):
        """Makes the copy like the sources; what is the same keeps its time, so that it is not built
        again. A mutant that an aborted run has left is overwritten."""
        wanted = set()
        for name in SOURCES:
            start = self.root / name
            files = [start] if start.is_file() else sorted(start.rglob("*"))
            wanted.update(file.relative_to(self.root) for file in files if file.is_file())
        for file in wanted:
            copy = self.source / file
            if copy.is_file() and copy.read_bytes() == (self.root / file).read_bytes():
                continue
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.root / file, copy)
            shutil.copymode(self.root / file, copy)
        for copy in list(self.source.rglob("*")):
            if copy.is_file() and copy.relative_to(self.source) not in wanted:
                copy.unlink()

    def configure(self):
        done, out = run(
            ["cmake", "-G", "Ninja", "-S", self.source, "-B", self.build, "-DROB_WERROR=OFF",
             "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O1 -w"],
            self.root,
        )  # fmt: skip
        if not done:
            raise Failed(out + "\nthe build could not be configured")

    def make(self, target):
        """Whether it compiles and links."""
        return run(["cmake", "--build", self.build, "--target", target], self.root)

    def code_of(self, layer):
        """A sum over the layer's compiled code."""
        library = self.build / f"librob_{layer}.a"
        return hashlib.sha256(library.read_bytes()).digest() if library.exists() else None


class Trial:
    """The tests that a mutant of one layer has to survive, and the time that each may take. It begins
    with a copy that is whole."""

    LONGEST = Limit(3600, 7200)  # s without a mutant
    PATIENCE = 5  # times the processor time used without a mutant, and some seconds
    DELAY = 10  # times the time that passed without a mutant, and a minute

    def __init__(self, copy, layer):
        built, out = copy.make("all")  # what is built may yet be the mutant before, of another layer
        if not built:
            raise Failed(out + "\nthe sources do not compile without a mutant")
        self.copy = copy
        self.layer = layer
        self.binary = f"{layer}_test"
        self.code = copy.code_of(layer)
        self.limits = dict.fromkeys(("folder", "binary", "outside"), self.LONGEST)
        for name in self.limits:
            begin = time.monotonic()
            used = resource.getrusage(resource.RUSAGE_CHILDREN)
            passed, out = self.passes(name, "")
            if not passed:
                raise Failed(f"{out}\nthe tests of {layer} fail without a mutant")
            end = resource.getrusage(resource.RUSAGE_CHILDREN)
            used = end.ru_utime + end.ru_stime - used.ru_utime - used.ru_stime
            passed = time.monotonic() - begin
            self.limits[name] = Limit(20 + self.PATIENCE * used, 60 + self.DELAY * passed)

    def passes(self, stage, folder):
        """Whether the tests of a stage pass, and what they wrote. They have a home of their own, for
        the mutants that write files or delete them."""
        alone = [next(self.copy.build.rglob(self.binary)), "--abort-after=1", NOT_IN_REAL_TIME]
        command = {
            "folder": [*alone, f"--source-file=*/tests/{folder}/*"],
            "binary": alone,
            "outside": ["ctest", "--stop-on-failure", "--output-on-failure", "--no-tests=error",
                        "--parallel", str(os.cpu_count()), "-R", OUTSIDE[self.layer]],
        }[stage]  # fmt: skip
        with tempfile.TemporaryDirectory(dir=self.copy.build) as home:
            names = ("HOME", "TMPDIR", "XDG_STATE_HOME", "XDG_DATA_HOME")
            environment = {**os.environ, **dict.fromkeys(names, home)}
            return run(command, self.copy.build, self.limits[stage], environment)

    def fate(self, file):
        """The stage whose tests find the mutant that is in the copy, "" if none does; None if it is
        no mutant."""
        compiles, _ = self.copy.make(self.binary)
        if not compiles:
            return None
        if file.suffix == ".cpp" and self.code and self.copy.code_of(self.layer) == self.code:
            return None
        for stage in self.limits:
            if stage == "outside" and not self.copy.make("all")[0]:
                return None
            if not self.passes(stage, file.parent)[0]:
                return stage
        return ""


def all_mutations(source):
    """(file, mutation) of the whole product, in a fixed order."""
    for layer in LAYERS:
        for file in sorted((source / layer).rglob("*")):
            if file.suffix in (".cpp", ".h"):
                for mutation in mutations_of(file.read_text()):
                    yield file.relative_to(source), mutation


def shown(text, mutation):
    """The lines of a mutation, before and after it."""
    begin = text.rfind("\n", 0, mutation.begin) + 1
    end = text.find("\n", mutation.end)
    after = text[begin : mutation.begin] + mutation.replacement + text[mutation.end : end]
    return text[begin:end].strip(), after.strip()


def try_mutant(copy, trial, file, mutation):
    """As Trial.fate(); the copy is whole again afterwards."""
    path = copy.source / file
    text = path.read_text()
    try:
        path.write_text(mutation.apply(text))
        return trial.fate(file)
    finally:
        path.write_text(text)


def hunt(copy, count, seed):
    """Prints what became of `count` mutants; returns how many died."""
    mutations = list(all_mutations(copy.source))
    random.Random(seed).shuffle(mutations)
    trials = {}
    tried = died = 0
    for file, mutation in mutations:
        if tried == count:
            break
        layer = file.parts[0]
        if layer not in trials:
            trials[layer] = Trial(copy, layer)
        text = (copy.source / file).read_text()
        stage = try_mutant(copy, trials[layer], file, mutation)
        if stage is None:
            continue
        tried += 1
        died += stage != ""
        before, after = shown(text, mutation)
        state = f"died ({stage})" if stage else "SURVIVED"
        print(f"{tried}/{count} {state} {file}:{mutation.line(text)}\n    - {before}\n    + {after}")
        sys.stdout.flush()
    return tried, died


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("count", type=int, metavar="N")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    copy = Copy(options.root.resolve())
    copy.lock()
    copy.synchronize()
    copy.configure()
    tried, died = hunt(copy, options.count, options.seed)
    share = died / tried if tried else 0
    print(f"{died} of {tried} mutants died ({100 * share:.0f} %), seed {options.seed}")
    return 0 if tried and share >= GOAL else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except Failed as failure:
        print(failure, file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)

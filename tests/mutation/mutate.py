#!/usr/bin/env python3
"""Mutation testing: changes the sources one place at a time, and sees whether a test fails.

    tests/mutation/mutate.py BUILD [--only WORD] [--list] [--jobs N]

BUILD is a folder for a copy of the sources, its build and what was found (results.tsv); the sources themselves stay as they
are. A second run goes on where the last one ended: mutants of a file that has not changed are not tried again, unexplained
survivors only when tests have changed. The exit code is 1 if a mutant survives that equivalent.txt does not explain.
"""
import argparse, collections, functools, hashlib, os, pathlib, re, resource, shutil, signal, subprocess, sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]

# The targets: source, number of its mutants, and the test programs that guard it, the quickest first. Names of Catch2
# cases or [#file] follow a colon.
TARGETS = [
    ("runner/studies/statistics/means.cpp", 12, "statistics:[#tests_test]|statistics"),
    ("runner/studies/statistics/sign_flip.cpp", 8, "statistics:[#tests_test]|statistics"),
    ("runner/studies/statistics/factorial.cpp", 10, "statistics:[#tests_test]|statistics"),
    ("runner/measurements/accuracy/state_error.cpp", 10, "accuracy:[#state_error_test]|accuracy"),
    ("runner/measurements/accuracy/convergence.cpp", 12, "accuracy:[#convergence_test]|accuracy"),
    ("runner/results/golden/tolerance.cpp", 12, "golden:[#tolerance_test]|golden"),
    ("runner/results/golden/compare.cpp", 12, "golden:[#compare_test]|golden"),
    ("core/biology/sense.cpp", 8, "biology"),
    ("core/biology/neighbour_senses.cpp", 8, "biology|simulation:[#senses_test]"),
    ("core/biology/distant_senses.cpp", 6, "biology|simulation:[#senses_test]"),
    ("core/biology/logical_dna.cpp", 14, "biology|simulation:[#division_size_test]"),
    ("core/division/cut.cpp", 12, "division"),
    ("core/division/place_plane.cpp", 12, "division"),
    ("core/contacts/adhesion.cpp", 12, "contacts:[#adhesion_test]|contacts|simulation:[#adhesion_test]"),
    ("core/contacts/pair_energy.cpp", 12, "contacts:[#pair_law_test],[#contact_areas_test]|contacts"),
    ("core/simulation/settle.cpp", 14, "simulation:[#settle_test]"),
    ("core/simulation/damped_motion.cpp", 14, "simulation:[#settle_test]"),
    ("core/contacts/pair_law_kernel.h", 16, "contacts:[#pair_law_test],[#viscosity_test]|simulation:[#two_cells_under_load_test]|contacts"),
    ("core/contacts/surface_kernel.h", 12, "contacts:[#pair_law_test]|contacts"),
    ("core/contacts/acting_kernel.h", 10, "contacts:[#acting_pairs_test]|contacts"),
    ("core/physics/spring_kernel.h", 10, "physics:[#spring_force_test],[#spring_weights_test]|physics"),
    ("core/physics/pressure_kernel.h", 10, "physics:[#pressure_force_test],[#drag_test],[#xpbd_test]|physics"),
    ("core/physics/ring_kernel.h", 10, "physics:[#volume_test],[#pressure_force_test]|physics"),
    ("core/physics/shell_kernel.h", 10, "physics:[#shell_test]|physics"),
    ("core/physics/relax_kernel.h", 12, "physics:[#relax_test]|simulation:[#settle_test]"),
]

SWAPS = {"+": "-", "*": "/", "<": "<=", ">": ">=", "==": "!=", "&&": "||", "&": "|", "+=": "-=", "*=": "/=", "min": "max",
         "true": "false"}
SWAPS |= {new: old for old, new in SWAPS.items()}
# In formatted sources only a binary operator has blanks on both sides, no pointer, reference, sign or bracket.
OPERATOR = re.compile(r"(?<=\s)(?:[<>=!+*/-]=|&&|\|\||[-+*/<>&|])(?=\s)|\b(?:min|max)(?=_*\()|\b(?:true|false)\b")
NUMBER = re.compile(r"(?<![\w.])(\d+(?:\.\d*)?(?:e-?\d+)?)(?=u?(?![\w.']))")
STATEMENT = re.compile(r"^ *(?!return|delete)((?:\S+ [+*-]= |[\w.:>-]+\()[^;]*;) *$", re.M)  # a change of a number, or a call
CONDITION = re.compile(r"\b(?:if|while) \(")
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])*\''
                      r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.S | re.M)
# Tests do not cover failed invariants, the words of errors, and prefetches.
NOT_TESTED = re.compile(r"\b(?:static_assert|MORULA_CHECK|throw)\b[^;]*;|\[\[.*?\]\]"
                        r"|^[^\n]*prefetch\w*\([^;{]*\{.*?^\}|[^;{}]*\b\w*prefetch\w*(?:<\w+>)?\([^;{]*;", re.S | re.M)
TEMPLATE = re.compile(r"(?:\btemplate |(?<=\w))<[^<>;{}()]*>")

Mutant = collections.namedtuple("Mutant", "file line old new nth begin end text")  # old, new: lines without indentation


def code_of(text):
    """The text with blanks in place of code that is not mutated."""
    blank = lambda match: re.sub(r"[^\n]", " ", match[0])
    code = NOT_TESTED.sub(blank, NOT_CODE.sub(blank, text))
    while True:  # nested brackets, from the innermost outwards
        without = TEMPLATE.sub(lambda match: re.sub(r"[^\n]", "_", match[0]), code)
        if without == code: return code
        code = without


def changes(code):
    """All mutations of the code, as (begin, end, new text)."""
    for m in OPERATOR.finditer(code):
        if m[0] in SWAPS: yield m.start(), m.end(), SWAPS[m[0]]
    for m in NUMBER.finditer(code):
        if m[1].isdigit(): new = str(int(m[1]) + 1)
        else: new = repr(float(m[1]) / 2) if float(m[1]) else "1.0"
        yield m.start(), m.end(), new
    for m in STATEMENT.finditer(code):
        before = code[:m.start()].rstrip()
        if before.endswith((";", "{", "}", ")", "else")): yield m.start(1), m.end(1), ";"
    for m in CONDITION.finditer(code):
        depth, end = 1, m.end()
        while depth:
            depth += {"(": 1, ")": -1}.get(code[end], 0)
            end += 1
        if ";" not in code[m.end():end]: yield m.end(), end - 1, None


def mutants_of(file, text):
    """All mutants of a source, in the order of their places."""
    found, seen = [], collections.Counter()
    for begin, end, new in sorted(changes(code_of(text)), key=lambda c: (c[0], c[1], c[2] or "")):
        first, last = text.rfind("\n", 0, begin) + 1, text.find("\n", end)
        new = f"!({text[begin:end]})" if new is None else new
        words = lambda lines: " ".join(lines.split())
        key = words(text[first:last]), words(text[first:begin] + new + text[end:last])
        found.append(Mutant(file, text.count("\n", 0, begin) + 1, *key, seen[key], begin, end, new))
        seen[key] += 1
    return found


def chosen(mutants, count):
    """A sample of the mutants, the same for the same lines: one of each line before a second of any line."""
    digest = lambda m: hashlib.sha256(f"{m.old}\n{m.new}\n{m.nth}".encode()).hexdigest()
    turn, order = collections.Counter(), []
    for m in sorted(mutants, key=digest):
        order.append((turn[m.line], digest(m), m))
        turn[m.line] += 1
    return sorted((m for _, _, m in sorted(order)[:count]), key=lambda m: m.begin)


def read_accepted(text):
    """Reads blocks of four lines (file, - old, + new, why) as {(file, old line, new line): why}."""
    accepted = {}
    for block in re.split(r"\n\s*\n", re.sub(r"^#.*\n?", "", text, flags=re.M).strip()):
        lines = block.splitlines()
        if not lines: continue
        if len(lines) < 4 or lines[1][:2] != "- " or lines[2][:2] != "+ ":
            sys.exit(f"equivalent.txt: file, - old line, + new line and why are expected, not\n{block}")
        accepted[lines[0], lines[1][2:], lines[2][2:]] = " ".join(lines[3:])
    return accepted


def run(command, cpu_limit=None, **options):
    """Returns (how the program ended, "" for success; CPU seconds). A program that exceeds its limit hangs."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
        if cpu_limit: resource.setrlimit(resource.RLIMIT_CPU, (int(cpu_limit) + 1, int(cpu_limit) + 2))

    used = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    before = used()
    try:
        done = subprocess.run(command, preexec_fn=limit, timeout=cpu_limit and 10 * cpu_limit + 60, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace", **options)
    except subprocess.TimeoutExpired:
        return "hangs", used() - before
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL): return "hangs", used() - before
    if done.returncode == 0: return "", used() - before
    case = re.search(r"^-{60,}\n(.+)", done.stdout, re.M)
    ended = f" ({signal.Signals(-done.returncode).name})" if done.returncode < 0 else ""
    return (case[1].strip() if case else done.stdout[-300:].strip()) + ended, used() - before


class Bench:
    """The copy of the sources, and its build."""

    def __init__(self, folder, jobs):
        self.source, self.build, self.jobs = folder / "source", folder / "build", jobs
        (folder / "tmp").mkdir(parents=True, exist_ok=True)
        self.environment = os.environ | {"TMPDIR": str(folder / "tmp")}
        listed = subprocess.check_output(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, text=True)
        files = {f for f in listed.split("\0") if f and (ROOT / f).is_file()}
        for f in files: self.write(f, (ROOT / f).read_bytes())
        for path in [p for p in self.source.rglob("*") if p.is_file()]:
            if str(path.relative_to(self.source)) not in files: path.unlink()
        if not (self.build / "build.ninja").exists():  # only the kernels that every machine of the architecture runs
            subprocess.run(["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                            "-DMORULA_UNITY=OFF", "-DMORULA_PORTABLE=ON"], check=True)

    def write(self, file, content):
        """Copies only files that differ, so that only these are built."""
        path = self.source / file
        if path.exists() and path.read_bytes() == content: return
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
        shutil.copymode(ROOT / file, path)

    def make(self, tests):
        programs = ["test_unit_" + t.split(":")[0] for t in tests]
        return run(["ninja", "-C", self.build, f"-j{self.jobs}", *programs])[0]

    def test(self, test, cpu_limit=None):
        program, _, cases = test.partition(":")
        command = [self.build / "tests" / ("test_unit_" + program), "--abort", "--filenames-as-tags", *([cases] if cases else [])]
        return run(command, cpu_limit, cwd=self.source, env=self.environment)

    @functools.cache
    def seconds(self, test):
        """Measures the CPU time without mutation."""
        failed, seconds = self.test(test)
        if failed: sys.exit(f"{test} fails without any mutation: {failed}")
        return seconds

    def judge(self, mutant, text, tests):
        """Returns (killed | survived | does not compile, by which test)."""
        self.write(mutant.file, (text[:mutant.begin] + mutant.text + text[mutant.end:]).encode())
        if self.make(tests): return "does not compile", ""
        for test in tests:
            failed, _ = self.test(test, 5 + 5 * self.seconds(test))
            if failed: return "killed", f"{test}: {failed.splitlines()[0]}"
        return "survived", ""


def digest(*paths):
    return hashlib.sha256(b"".join(p.read_bytes() for p in paths)).hexdigest()[:12]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("build", type=lambda p: pathlib.Path(p).resolve(), metavar="BUILD")
    arguments.add_argument("--only", default="", metavar="WORD", help="files with this in their path")
    arguments.add_argument("--list", action="store_true", help="say what would be tried")
    arguments.add_argument("--jobs", type=int, default=1, help="of the compiler")
    options = arguments.parse_args()

    accepted = read_accepted((HERE / "equivalent.txt").read_text())
    tests_are = digest(*sorted((ROOT / "tests/unit").rglob("*.*")))
    results = options.build / "results.tsv"
    known = {}
    if results.exists():
        for line in results.read_text().splitlines():
            source, tests, file, _, nth, old, new, result, by = line.split("\t")
            explained = (file, old, new) in accepted
            if result != "survived" or tests == tests_are or explained: known[source, file, old, new, int(nth)] = result, by
    bench, table, unexplained = None, [], []
    try:
        for file, count, guards in TARGETS:
            if options.only not in file: continue
            text, source_is, tests = (ROOT / file).read_text(), digest(ROOT / file), guards.split("|")
            every = mutants_of(file, text)
            for entry in accepted:
                if entry[0] == file and entry[1:] not in {(m.old, m.new) for m in every}:
                    unexplained.append(f"equivalent.txt explains what {file} no longer has: {entry[1]}")
            found = collections.Counter()
            for mutant in chosen(every, count):
                said = f"{file}:{mutant.line}: {mutant.old}  →  {mutant.new}"
                if options.list:
                    print(said)
                    continue
                key = source_is, file, mutant.old, mutant.new, mutant.nth
                if key not in known:
                    bench = bench or Bench(options.build, options.jobs)
                    if not found["tried"]:
                        if bench.make(tests): sys.exit(f"{guards} cannot be built: ninja -C {bench.build}")
                        for test in tests: bench.seconds(test)
                    found["tried"] += 1
                    known[key] = bench.judge(mutant, text, tests)
                    with results.open("a") as out:
                        row = source_is, tests_are, file, mutant.line, mutant.nth, mutant.old, mutant.new, *known[key]
                        print(*(str(x).replace("\t", " ") for x in row), sep="\t", file=out)
                result, by = known[key]
                why = accepted.get((file, mutant.old, mutant.new))
                if result == "survived" and why: result, by = "equivalent" if why.startswith("Equivalent:") else "not seen", why
                if result == "survived": unexplained.append(said)
                found[result] += 1
                print(f"{said}\n    {result}{by and ': ' + by}", flush=True)
            if bench: bench.write(file, text.encode())
            table.append((file, found))
    except KeyboardInterrupt:
        print("interrupted; the next run goes on from here")
        unexplained.append("not all mutants were tried")
    if options.list: return 0
    columns = "killed", "survived", "not seen", "equivalent", "does not compile"
    table.append(("all", sum((f for _, f in table), collections.Counter())))
    print(f"\n{'':46}{'mutants':>9}" + "".join(f"{c:>18}" for c in columns))
    for file, found in table:
        mutants = sum(found[c] for c in columns[:4])
        print(f"{file:46}{mutants:9}" + "".join(f"{found[c]:18}" for c in columns))
    total = table[-1][1]
    print(f"killed: {total['killed'] / max(1, sum(total[c] for c in columns[:3])):.1%} of those that are not equivalent")
    if unexplained: print("\nneither killed nor explained in equivalent.txt:", *unexplained, sep="\n")
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main())

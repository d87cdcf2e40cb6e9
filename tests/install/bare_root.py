#!/usr/bin/python3
"""Runs the commands of the reusable workflow and the container file in a bare Debian 12, as root.

    bare_root.py BUILD SOURCE-FOLDER

The root is BUILD/bare-root, which debootstrap makes from this machine's own mirror unless it is there; MORULA_TEST_ROOT names another one, with
sources from which apt-get can install. It is changed. The package is the .deb that cpack makes of BUILD.
The commands are the files' own; how long they take is printed, for people. Exit codes: 0 the commands work, and the package leaves nothing
behind; 1 one of them fails; 77 skipped: debootstrap is missing, or the user is not root.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import time

build, source = (os.path.abspath(folder) for folder in sys.argv[1:])


def skip(why):
    print("skipped:", why)
    sys.exit(77)


def made_root():
    """The bare root, made from the mirror that this machine's own packages come from."""
    root = os.path.join(build, "bare-root")
    if os.path.exists(os.path.join(root, "made")):
        return root
    if os.geteuid() != 0:
        skip("only root can make a bare root; MORULA_TEST_ROOT names one that is there")
    if not shutil.which("debootstrap"):
        skip("debootstrap is not installed")
    targets = ["apt-get", "indextargets", "--format", "$(REPO_URI)", "Created-By: Packages", "Codename: bookworm", "Component: main"]
    mirrors = subprocess.run(targets, stdout=subprocess.PIPE, text=True, check=True).stdout.split()
    if not mirrors:
        skip("this machine has no source of Debian 12's packages")
    shutil.rmtree(root, ignore_errors=True)
    began = time.monotonic()
    made = subprocess.run(["debootstrap", "--variant=minbase", "bookworm", root, mirrors[0]], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    if made.returncode != 0:
        print(made.stdout[-2000:], "\nNOT SO: debootstrap makes a bare root")
        sys.exit(1)
    for file in glob.glob("/etc/apt/apt.conf.d/9*"):  # this machine's way to the mirror
        shutil.copy(file, os.path.join(root, "etc/apt/apt.conf.d"))
    open(os.path.join(root, "made"), "w", encoding="utf-8").close()
    print(f"debootstrap makes a bare root, in {time.monotonic() - began:.0f} s with the network", flush=True)
    return root


root = os.environ.get("MORULA_TEST_ROOT", "") or made_root()
config = os.path.join(build, "CPackConfig.cmake")
subprocess.run(["cpack", "-G", "DEB", "--config", config, "-B", os.path.join(build, "packages")], stdout=subprocess.DEVNULL, check=True)
packages = sorted(glob.glob(os.path.join(build, "packages/*.deb")), key=os.path.getmtime, reverse=True)
import yaml

package = packages[0]
faults = []


def inside(command, folder="/", **environment):
    """Runs a command in the root; its output goes to stdout."""
    began = time.monotonic()
    words = ["env", *[f"{name}={value}" for name, value in environment.items()], "DEBIAN_FRONTEND=noninteractive", "LC_ALL=C", "sh", "-euc"]
    # /proc is mounted in a namespace that ends with the command, as in a container.
    mounted = ["unshare", "--mount", "sh", "-euc", 'mount -t proc proc "$0/proc"; exec chroot "$0" "$@"', root]
    code = subprocess.run([*mounted, *words, f"cd {folder}\n{command}"], check=False, stdin=subprocess.DEVNULL).returncode
    return code, time.monotonic() - began


def holds(what, so):
    print(("" if so else "NOT SO: ") + what, flush=True)
    if not so:
        faults.append(what)


def files():
    listed = subprocess.run(["chroot", root, "find", "/", "-xdev", "-path", "*morula*", "-not", "-path", "/proc/*"], stdout=subprocess.PIPE, check=True)
    return set(listed.stdout.decode().split("\n")) - {""}


def crate_of_study():
    """Writes the crate of a study of eight runs into the root's /srv/crate; returns True if that succeeds."""
    work = os.path.join(build, "bare-root-study")
    for folder in (work, os.path.join(root, "srv/crate")):
        shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(work)
    shutil.copy(os.path.join(source, "scenarios/thesis/unique-four.yaml"), os.path.join(work, "base.yaml"))
    with open(os.path.join(work, "small.study.yaml"), "w", encoding="utf-8") as file:
        file.write("morula-study: 1\nname: small\nbase: base.yaml\nvary:\n  drag:\n    some: {physics.drag: 5}\n    much: {physics.drag: 10}\n"
                   "  plane:\n    longest: {division.plane: longest}\n    random: {division.plane: random}\nseeds: 1..2\nmeasures: [sphericity, clone_radius]\n")
    program = os.path.join(build, "morula")
    for words in (["run", "small.study.yaml", "--out", "out", "--no-predict"], ["export", "out", "--out", os.path.join(root, "srv/crate"), "--license", "CC-BY-4.0"]):
        if subprocess.run([program, "study", *words, "--quiet"], cwd=work, stdout=subprocess.DEVNULL, check=False).returncode != 0:
            return False
    return True


inside("apt-get purge -qy morula >/dev/null 2>&1 || true; rm -rf /tmp/*")  # removes an earlier test's remains
shutil.copy(package, os.path.join(root, "srv", "given.deb"))
project = os.path.join(root, "srv", "project")
shutil.rmtree(project, ignore_errors=True)
os.makedirs(os.path.join(project, "scenarios", "thesis"))
os.makedirs(os.path.join(project, "golden", "thesis"))
shutil.copy(os.path.join(source, "scenarios/thesis/unique-four.yaml"), os.path.join(project, "scenarios/thesis"))
shutil.copy(os.path.join(source, "golden/thesis/unique-four.golden"), os.path.join(project, "golden/thesis"))

workflow = yaml.safe_load(open(os.path.join(source, ".github/workflows/check.yml"), encoding="utf-8"))
steps = {step["name"]: step for step in workflow["jobs"]["check"]["steps"] if "name" in step}
code, seconds = inside(steps["Install"]["run"], PACKAGE="/srv/given.deb")
holds(f"the workflow installs the package, in {seconds:.0f} s with the network", code == 0)
code, seconds = inside("morula run /usr/share/morula/scenarios/thesis/unique-four.yaml --out /tmp/out --quiet >/dev/null && rm -r /tmp/out")
holds(f"a shipped scenario runs and is checked, in {seconds:.1f} s", code == 0)
holds("a study's crate is made on this machine", crate_of_study())
code, seconds = inside("morula study replay /srv/crate --runs 2 >/dev/null")
holds(f"the package repeats two runs of the crate and the comparison to the byte, in {seconds:.1f} s", code == 0)
code, seconds = inside(steps["Check"]["run"], "/srv/project", SCENARIOS="")
holds(f"the workflow checks a project, in {seconds:.1f} s", code == 0)
holds("there is a report", os.path.exists(os.path.join(project, "morula-report/report.html")))
scenario = os.path.join(project, "scenarios/thesis/unique-four.yaml")
text = open(scenario, encoding="utf-8").read()
open(scenario, "w", encoding="utf-8").write(re.sub(r"(?m)^(\s*pressure: \{constant: )[0-9.]+", r"\g<1>190", text))
code, _ = inside(steps["Check"]["run"], "/srv/project", SCENARIOS="scenarios/thesis/unique-four.yaml")
holds("a scenario that differs fails the workflow", code == 1)
code, _ = inside("apt-get purge -qy morula >/dev/null")
left = {name for name in files() if not name.startswith(("/srv/", "/tmp/morula.deb", "/var/cache/", "/var/log/"))}
holds(f"removed, it leaves nothing: {sorted(left)[:5]}", code == 0 and not left)

container = open(os.path.join(source, "runner/install/Containerfile"), encoding="utf-8").read()
final = container.split("\nFROM ")[-1]
run = re.search(r"^RUN (.*?)(?<!\\)$", final, re.M | re.S).group(1).replace("\\\n", "")
shutil.copy(package, os.path.join(root, "tmp"))
code, seconds = inside(run)
holds(f"the container installs the package, in {seconds:.0f} s with the network", code == 0)
code, _ = inside("morula check", "/srv/project")
holds("its program answers in a project", code == 1)
sys.exit(1 if faults else 0)

#!/usr/bin/python3
"""What the reusable workflow and the container file do, done in a bare Debian 12, as root.

    MORULA_TEST_ROOT=ROOT bare_root.py BUILD SOURCE-FOLDER

ROOT: made by `debootstrap --variant=minbase bookworm ROOT`, with sources from which apt-get can install; it is changed. BUILD: where
./morula package has put its .deb. The commands are the files' own; how long they take is printed, for people. Exit codes: 0 they work, and the
package leaves nothing behind; 1 not so, 77 skipped.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import time

build, source = sys.argv[1:]
root = os.environ.get("MORULA_TEST_ROOT", "")
packages = glob.glob(os.path.join(build, "packages/*.deb"))
if not root or not packages:
    print("skipped:", "./morula package has made no .deb" if root else "MORULA_TEST_ROOT names no bare root to install into")
    sys.exit(77)
import yaml

package = packages[0]
faults = []


def inside(command, folder="/", **environment):
    """Runs a command there; what it says goes to stdout."""
    began = time.monotonic()
    words = ["env", *[f"{name}={value}" for name, value in environment.items()], "DEBIAN_FRONTEND=noninteractive", "LC_ALL=C", "sh", "-euc"]
    # /proc as in a container, in a namespace that ends with the command
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

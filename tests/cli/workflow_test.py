#!/usr/bin/python3
"""Tests the example workflow of reports/README.md and the reusable workflow: both are YAML, their paths and commands
exist, and the page is uploaded even if the check fails.

    workflow_test.py MORULA SOURCE-FOLDER

Exit codes: 0 passed, 1 failed, 77 skipped: Python has no module yaml.
"""
import os
import re
import subprocess
import sys

try:
    import yaml
except ImportError:
    print("skipped: Python has no module yaml")
    sys.exit(77)

program, source = sys.argv[1:]
text = open(os.path.join(source, "reports/README.md"), encoding="utf-8").read()
workflow = yaml.safe_load(re.search(r"```yaml\n(.*?)```", text, re.S).group(1))
faults = []


def holds(what, so):
    if not so:
        faults.append(what)


job = workflow["jobs"]["check"]
steps = job["steps"]
holds("it runs on pushes and pull requests", set(workflow[True]) == {"push", "pull_request"})  # YAML 1.1 reads `on` as true
holds("in Debian 12", job["container"] == "debian:12")
uses = [step.get("uses", "").split("@")[0] for step in steps]
checkout, cache, upload = (uses.index("actions/" + name) for name in ("checkout", "cache", "upload-artifact"))
runs = [number for number, step in enumerate(steps) if "./morula" in step.get("run", "")]
holds("checked out, then from the cache, then checked, then uploaded", checkout < cache < runs[0] <= runs[-1] < upload)
holds("what checks out needs git, and comes before it", any("git" in step.get("run", "").split() for step in steps[:checkout]))
holds("uploaded always", steps[upload]["if"] == "always()")
kept = steps[cache]["with"]["path"].split()
holds("the build and what ccache keeps are cached", kept == ["build", "~/.cache/ccache"])
for name in re.findall(r"'([^']+)'", steps[cache]["with"]["key"]):
    holds(f"{name} is there, by which the cache is told", os.path.exists(os.path.join(source, name)))
command = steps[runs[0]]["run"].split()
holds("the folder that is written is uploaded", command[-1] == steps[upload]["with"]["path"])
usage = subprocess.run([program, command[1], "--help"], stdout=subprocess.PIPE, check=True).stdout.decode()
for option in command[2:]:
    holds(f"{command[1]} has {option}", not option.startswith("-") or option in usage)
holds("./morula is there", os.access(os.path.join(source, command[0]), os.X_OK))

# Outputs of other actions must reach a shell as variables, never as parts of its text.
workflow = yaml.safe_load(open(os.path.join(source, ".github/workflows/check.yml"), encoding="utf-8"))
inputs, steps = workflow[True]["workflow_call"]["inputs"], workflow["jobs"]["check"]["steps"]
holds("every input is used, and none that is not there",
      set(re.findall(r"inputs\.(\w+)", str(steps))) == set(inputs))
holds("no input stands in a command", not any("${{" in step.get("run", "") for step in steps))
for step in steps:
    said = subprocess.run(["sh", "-nc", step.get("run", "")], stderr=subprocess.PIPE, check=False).stderr.decode()
    holds(f"the shell reads {step.get('name')}: {said}", not said)
checks = next(step["run"] for step in steps if "morula check" in step.get("run", ""))
written = re.search(r"morula check .* --reports (\S+)", checks).group(1)
holds("the folder that is written is uploaded, always",
      steps[-1]["with"]["path"].endswith("/" + written) and steps[-1]["if"] == "always()")

print("\n".join("not so: " + fault for fault in faults))
sys.exit(1 if faults else 0)

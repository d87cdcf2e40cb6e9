#!/usr/bin/python3
"""Runs the jobs of golden/CI.md in a project: once as accepted, once with one key changed, and once with a claim that
does not hold.

    golden_ci_test.py MORULA SOURCE-FOLDER
"""
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

program, source = (os.path.abspath(name) for name in sys.argv[1:])
page = open(os.path.join(source, "golden/CI.md"), encoding="utf-8").read()
workflow, script = (re.search(rf"```{kind}\n(.*?)```", page, re.S).group(1) for kind in ("yaml", "sh"))
steps = [step for step in re.findall(r"- run: (.*)", workflow) if "apt-get" not in step]
faults = []
SCENARIO = """morula: 1
name: pair
dna: |
  START: a0
  g1(divide|a0)
cycle: {length: 0.125}
stop: {time: 0.25}
physics:
  mesh: {icosphere: 1}
  cell: {radius: 0.95}
  drag: 1
  pressure: {constant: 155, outside: 43}
  contact: {}
variation: {cycle: 0.1}
check: {}
"""
STUDY = """morula-study: 1
name: pairs
base: pair.yaml
vary: {drag: {one: {}, ten: {physics.drag: 10}}}
seeds: 1..10
measures: [kinetic-energy, cells]
check:
  - {measure: kinetic-energy, a: {drag: ten}, b: {drag: one}, says: lower}
  - {measure: cells, at: {drag: one}, mean: 1.5, within: 0.6}
"""


def holds(what, so):
    if not so:
        faults.append(what)


def write(name, text):
    os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)


def read(name):
    with open(name, encoding="utf-8") as file:
        return file.read()


def shell(commands, **more):
    env = {key: value for key, value in os.environ.items() if key not in ("CI", "GITHUB_ACTIONS", "GITHUB_STEP_SUMMARY")}
    return subprocess.run(["sh", "-c", commands], stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                          check=False, env={**env, "PATH": f"{os.getcwd()}/bin:" + env["PATH"], **more})


def failures(name):
    """The failed cases of a JUnit file, and the number of cases that follow from them."""
    suites = xml.parse(name).getroot()
    failed = [case for case in suites.iter("testcase") if case.find("failure") is not None]
    holds(f"{name} counts its failures", int(suites.get("failures")) == len(failed))
    return failed, len(list(suites.iter("skipped")))


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    os.mkdir("bin")
    os.symlink(program, "bin/morula")
    write("scenarios/pair.yaml", SCENARIO)
    write("scenarios/pairs.study.yaml", STUDY)
    first = shell("morula review scenarios/pair.yaml --accept --by tests --why 'the first one'")
    holds("accepted: " + first.stderr, first.returncode == 0)

    holds("the workflow has one step that checks", len(steps) == 1)
    passing = shell(steps[0], CI="true", GITHUB_ACTIONS="true", GITHUB_STEP_SUMMARY="page.md")
    holds("the workflow passes: " + passing.stdout, passing.returncode == 0 and "::error" not in passing.stdout)
    holds("its page says so", read("page.md") == read("reports/summary.md") and "| pair | " in read("page.md"))
    holds("no case fails", failures("reports/junit.xml") == ([], 0))
    passing = shell(script, CI="true")
    holds("the script passes: " + passing.stdout + passing.stderr, passing.returncode == 0)
    holds("both claims hold", "pairs: 2 of 2 claims hold" in passing.stdout)
    holds("of the study, too, no case fails", failures("reports/pairs/junit.xml") == ([], 0))

    write("scenarios/pair.yaml", SCENARIO.replace("constant: 155", "constant: 160"))
    os.remove("page.md")
    failing = shell(steps[0], CI="true", GITHUB_ACTIONS="true", GITHUB_STEP_SUMMARY="page.md")
    holds("the workflow fails", failing.returncode == 1)
    told = [line for line in failing.stdout.splitlines() if line.startswith("::error ")]
    holds("one annotation, in words", len(told) == 1 and told[0].startswith(
        "::error file=golden/pair.golden,title=INPUT_CHANGED%3A pair::the scenario changed: physics.pressure.constant: "
        "155 → 160; same lineage; "))
    summary = read("page.md")
    for row in ("| changed | physics.pressure.constant: 155 → 160 |", "| lineage | the same |", "| follow | bits; step_hashes"):
        holds("the page has " + row, row in summary)
    holds("who moved, and how far", re.search(r"\| moved \| cell \w+ the farthest: [0-9.e-]+ radii of the egg \|", summary))
    holds("no hashes and ulps", not re.search(r"[0-9a-f]{32}|ulp", summary + told[0]))
    failed, follow = failures("reports/junit.xml")
    holds("one failed case, and those that follow", [case.get("name") for case in failed] == ["scenario"] and follow >= 4)
    if failed:
        text = failed[0].find("failure").text
        holds("with the change in words", "physics.pressure.constant: 155 → 160" in text and "consequences: bits" in text)
        holds("and what to type", "explain scenarios/pair.yaml" in text)

    # The waiting result lies in this folder, and is accepted by its name.
    waiting = [name for name in os.listdir("golden/.pending") if name.endswith(".golden")]
    holds("it waits in the project", len(waiting) == 1 and waiting[0].startswith("pair-"))
    shown = shell("morula review")
    holds("review shows it with its path", shown.returncode == 1 and "scenarios/pair.yaml: " in shown.stdout
          and "waits    golden/.pending/" + waiting[0] in shown.stdout)
    os.mkdir("elsewhere")
    holds("and nowhere else", shell("cd elsewhere && morula review").stderr.strip() == "no result waits for a review")
    before = read("golden/pair.golden")
    refused = shell("morula review --accept --by tests --why 'as measured'")
    holds("nothing is accepted without a name: " + refused.stderr, refused.returncode == 2
          and "review scenarios/pair.yaml --accept --why 'as measured'" in refused.stderr and read("golden/pair.golden") == before)
    explained = shell("morula explain scenarios/pair.yaml")
    holds("explain says where it began: " + explained.stdout, "where it began: different before the first step" in explained.stdout
          and re.search(r"moves +first at step 1, time [0-9.e-]+: the egg, vertex \d+, by [0-9.e-]+ radii", explained.stdout))

    # The results contradict this claim.
    accepted = shell("morula review scenarios/pair.yaml --accept --by tests --why 'as measured'")
    holds("accepted by name: " + accepted.stderr, accepted.returncode == 0 and not os.path.exists("golden/.pending/" + waiting[0]))
    write("scenarios/pairs.study.yaml", STUDY.replace("says: lower", "says: higher").replace("mean: 1.5", "mean: 8"))
    failing = shell(script.replace("study run", "study run --update"), CI="true")
    holds("the script fails: " + failing.stdout + failing.stderr, failing.returncode == 1)
    holds("for the claims alone", "pair: all " in failing.stdout and "pairs: 0 of 2 claims hold" in failing.stdout)
    failed, _ = failures("reports/pairs/junit.xml")
    holds("a failed case each, with the sentence", [case.get("name") for case in failed] == [
        "kinetic_energy: ten higher than one", "cells: 8 ± 0.6 with drag: one"] and "under ten" in failed[0].find("failure").text)
    os.chdir("/")

print("\n".join("not so: " + fault for fault in faults))
sys.exit(1 if faults else 0)

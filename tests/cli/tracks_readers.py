#!/usr/bin/python3
"""Reads tracks, graphs and tables of morula with programs of others (Zarr, networkx, jsonschema, pandas), and compares
them with the database.

    tracks_readers.py MORULA

Exit codes: 0 passed, 1 failed, 77 skipped: a reader is not installed.
"""
import glob
import json
import math
import os
import sqlite3
import subprocess
import sys
import tempfile

try:
    import jsonschema
    import networkx
    import numpy
    import pandas
    import zarr
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

morula = sys.argv[1]
work = tempfile.TemporaryDirectory()
folder = work.name
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "geff.schema.json"), encoding="utf-8") as stream:
    schema = json.load(stream)

# Nine cells, of which one dies. Names need quotes in CSV, or have more bytes than letters; one is another cell's path.
scene = """morula: 1
name: {name}
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
  g3(a2|a1,A)
  g4(divide|a1)
  g5(die|a2,A)
  g6(a3|a1,B)
  g7(divide|a3,A)
stop: {{time: 3.75}}
physics: {{mesh: {{icosphere: 1}}, drag: 5, contact: {{}}}}
connections: {{}}
record: {{every: 0.5, measures: [generation, contact_share]}}
"""
known_names_and_units = """names: {egg: P0, cells: {A: "Z,1", B: "Ωβ", BA: AB}}
units: {length: µm, per-length: 27, time: min, per-time: 4}
"""


def run(*words, silent=False):
    done = subprocess.run([morula, *words], cwd=folder, capture_output=True, text=True, check=False)
    expect(done.returncode == 0 and not (silent and done.stderr), f"{words} succeeds: {done.stderr}")
    return done.stdout


def export(name, text):
    with open(os.path.join(folder, name + ".yaml"), "w", encoding="utf-8") as scenario:
        scenario.write(text)
    run("run", "--quiet", "--no-pictures", "--db", name + ".db", name + ".yaml")
    for form, ending in (("tracks", "csv"), ("geff", "geff"), ("csv", "tables")):  # without a second run, and so a word
        run("export", name + ".db", "--format", form, "-o", f"{name}.{ending}", silent=True)


def expect(holds, what):
    if not holds:
        sys.exit("NOT SO: " + what)


def same(a, b, what):
    expect(a == b, f"{what}: {a!r} is not {b!r}")


def read_json(*names):
    with open(os.path.join(folder, *names), encoding="utf-8") as stream:
        return json.load(stream)


def stored_spots(name, length, time):
    """The database's samples of cells, by time and path, in known units, with the cells' names and ends."""
    database = sqlite3.connect(os.path.join(folder, name + ".db"))
    rows = database.execute("SELECT s.time, s.z, s.y, s.x, s.volume, s.path, c.name, c.parent, c.fate "
                            "FROM cell_sample s JOIN cell c USING (run_id, path) ORDER BY s.time, s.path").fetchall()
    names = {r[6] for r in rows}
    return [{"t": r[0] * time, "z": r[1] * length, "y": r[2] * length, "x": r[3] * length, "volume": r[4] * length**3,
             "path": r[5] or "egg", "name": r[6] or ("" if (r[5] or "egg") in names else r[5] or "egg"),
             "parent": None if r[7] is None else r[7] or "egg", "fate": r[8]} for r in rows]


def near(a, b, what):
    """Two roundings of a product: its factors may be multiplied in another order."""
    expect(len(a) == len(b) and numpy.allclose(a, b, rtol=1e-14, atol=0), f"{what}: {list(a)} is not {list(b)}")


def check_table(name, spots):
    table = pandas.read_csv(os.path.join(folder, name + ".csv"))
    columns = read_json(name + ".columns.json")
    same(list(table.columns), list(columns), "the described columns")
    for column in ("t", "z", "y", "x", "volume"):
        near(table[column], [s[column] for s in spots], column)
    for column in ("path", "fate"):
        same(list(table[column]), [s[column] for s in spots], column)
    same(list(table["name"].fillna("")), [s["name"] for s in spots], "name")
    # As pandas reads it by default, each mother is a row, and the founder alone has none.
    for column in ("track_id", "parent_track_id"):
        expect(numpy.issubdtype(table[column].dtype, numpy.integer), f"{column} is whole")
    path_of = dict(zip(table["track_id"], table["path"]))
    mothers = {path_of[r.track_id]: path_of.get(r.parent_track_id) for r in table.itertuples()}
    same(mothers, {s["path"]: s["parent"] for s in spots}, "mothers")
    same(set(table["parent_track_id"]) - set(table["track_id"]), {0}, "the founder's mother")
    return columns


def check_graph(name, spots, units):
    group = zarr.open_group(os.path.join(folder, name + ".geff"), mode="r")
    attributes = dict(group.attrs)
    jsonschema.Draft202012Validator(schema).validate(attributes)
    about = attributes["geff"]
    same((about["geff_version"], about["directed"]), ("1.2", True), "the version")
    ids, edges = group["nodes/ids"][:], group["edges/ids"][:]
    same((ids.dtype, edges.dtype, edges.shape[1]), (numpy.uint64, numpy.uint64, 2), "types of ids")
    same(len(set(ids.tolist())), len(spots), "a node a spot")
    properties = {p: group[f"nodes/props/{p}/values"][:] for p in group["nodes/props"]}
    same(set(properties), set(about["node_props_metadata"]), "the described properties")
    for p, values in properties.items():
        described = about["node_props_metadata"][p]
        same(described["identifier"], p, "identifier")
        same(len(values), len(ids), f"length of {p}")
        same("str" if values.dtype == object else values.dtype.name, described["dtype"], f"type of {p}")
        expect("missing" not in group[f"nodes/props/{p}"], f"{p} is known of all spots")
    for p in ("t", "z", "y", "x", "volume"):
        near(properties[p], [s[p] for s in spots], p)
    near(properties["radius"], [math.cbrt(3 * s["volume"] / 4 / math.pi) for s in spots], "radius")
    for p in ("name", "path", "fate"):
        same(list(properties[p]), [s[p] for s in spots], p)
    same([(a["name"], a["type"], a.get("unit")) for a in about["axes"]],
         [("t", "time", units[1]), *((axis, "space", units[0]) for axis in "zyx")], "axes")
    for axis in about["axes"]:
        same((axis["min"], axis["max"]), (properties[axis["name"]].min(), properties[axis["name"]].max()), "range")
        same(about["node_props_metadata"][axis["name"]].get("unit"), axis.get("unit"), "unit of the property")
    expect(about["sphere"] in properties and about["track_node_props"]["tracklet"] in properties, "named properties")

    graph = networkx.DiGraph()
    graph.add_nodes_from((int(i), {p: values[k] for p, values in properties.items()}) for k, i in enumerate(ids))
    graph.add_edges_from((int(a), int(b)) for a, b in edges)
    same(graph.number_of_nodes(), len(ids), "edges join nodes")
    expect(networkx.is_arborescence(graph), "one tree")
    expect(all(graph.nodes[a]["t"] < graph.nodes[b]["t"] for a, b in graph.edges), "edges lead forward in time")
    # Tracklets: what is left without the edges that leave a division.
    chains = networkx.DiGraph(graph)
    chains.remove_edges_from([(a, b) for a, b in graph.edges if graph.out_degree(a) > 1])
    tracklets = [{graph.nodes[n]["track_id"] for n in part} for part in networkx.weakly_connected_components(chains)]
    expect(all(len(t) == 1 for t in tracklets) and len(set.union(*tracklets)) == len(tracklets), "tracklets")
    lineage = {c["path"] or "egg": (c["name"] or "", c["parent"] if c["parent"] is None else c["parent"] or "egg")
               for c in json.loads(run("lineage", name + ".db", "--json"))["cells"]}
    found = {}
    for a, b in graph.edges:
        one, other = graph.nodes[a], graph.nodes[b]
        if one["path"] != other["path"]:
            found[other["path"]] = one["path"]
    same(found, {path: parent for path, (_, parent) in lineage.items() if parent}, "the lineage")
    same({s["path"] for s in spots}, set(lineage), "cells of the lineage")


def check_tables(name):
    """Every table that pandas reads by default has its described columns, and names beside paths."""
    described = read_json(name + ".tables", "columns.json")
    files = glob.glob(os.path.join(folder, name + ".tables", "*.csv"))
    same({os.path.basename(f)[:-4] for f in files}, set(described), "the described tables")
    cells = pandas.read_csv(os.path.join(folder, name + ".tables", "cells.csv"))
    names = dict(zip(cells["path"], cells["name"].fillna("")))
    beside = {"path": "name", "parent": "parent_name", "a": "a_name", "b": "b_name", "other": "other_name"}
    checked = 0
    for file in files:
        table = pandas.read_csv(file)
        columns = described[os.path.basename(file)[:-4]]
        same(list(table.columns), list(columns), f"columns of {file}")
        expect(all(c["meaning"] for c in columns.values()), f"meanings of {file}")
        for paths in set(beside) & set(table.columns):
            known = table[table[paths].notna()]
            same(list(known[beside[paths]].fillna("")), [names[p] for p in known[paths]], f"names in {file}")
            checked += len(known)
    expect(checked > 50, "names beside paths")
    tree = networkx.DiGraph(list(cells.dropna(subset=["parent"])[["parent", "path"]].itertuples(index=False)))
    expect(networkx.is_arborescence(tree), "cells.csv, as pandas reads it, is one tree")
    return described


export("known", scene.format(name="known") + known_names_and_units)
known = stored_spots("known", 27, 4)
same({s["fate"] for s in known}, {"divided", "died", "alive"}, "every fate")
expect(len({s["path"] for s in known}) >= 9, "nine cells")
columns = check_table("known", known)
same([columns[c]["unit"] for c in ("t", "z", "x", "volume", "name")], ["min", "µm", "µm", "µm³", ""], "units")
check_graph("known", known, ("micrometer", "minute"))
tables = check_tables("known")
same(tables["cell_samples"]["volume"]["known_unit"], {"name": "µm³", "factor": 27.0**3}, "a known unit")
same(tables["measures_pair"]["contact_share"]["unit"], "", "a pure number")
export("own", scene.format(name="own"))
own = stored_spots("own", 1, 1)
columns = check_table("own", own)
same([columns[c]["unit"] for c in ("t", "x", "volume")], ["time", "length", "length³"], "the scene's own units")
check_graph("own", own, (None, None))
tables = check_tables("own")
expect("known_unit" not in tables["cell_samples"]["volume"], "no known unit")

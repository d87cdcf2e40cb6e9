"""Reads what export_readers.sh had exported, with programs of others, and compares it with the database.

    export_readers.py FOLDER
"""
import csv
import glob
import json
import math
import os
import sqlite3
import struct
import sys
import xml.etree.ElementTree

import numpy
from Bio import Phylo
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOGeometry import vtkGLTFReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

folder = sys.argv[1]
database = sqlite3.connect(os.path.join(folder, "kept.db"))
runs = [r for (r,) in database.execute("SELECT run_id FROM run ORDER BY started, run_id")]
run = runs[0]
bound_of_float = 2.0**-23  # relative rounding error of single precision


def path(*names):
    return os.path.join(folder, *names)


def rows(sql, *values):
    return database.execute(sql, values).fetchall()


def expect(holds, what):
    if not holds:
        sys.exit("NOT SO: " + what)


def same(a, b, what):
    expect(a == b, f"{what}: {a!r} is not {b!r}")


def kept_surface(time, cell):
    """Vertices and faces, decoded as the database's comments describe."""
    mesh, *box, numbers = rows(
        "SELECT mesh, low_x, low_y, low_z, step_x, step_y, step_z, vertices FROM mesh_sample "
        "WHERE run_id = ? AND time = ? AND path = ?", run, time, cell)[0]
    ((faces,),) = rows("SELECT content FROM run_document JOIN document USING (hash) "
                       "WHERE run_id = ? AND role = 'faces' AND path = ?", run, str(mesh))
    numbers = numpy.frombuffer(numbers, "<u2").reshape(-1, 3)
    return box[:3] + numbers * numpy.array(box[3:]), numpy.frombuffer(faces, "<u2").reshape(-1, 3)


def volume(points, faces):
    a, b, c = (points[faces[:, k]] for k in range(3))
    return float(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6)


cells = rows("SELECT path, name, born, ended, fate, state FROM cell WHERE run_id = ? ORDER BY path", run)
paths = [c[0] for c in cells]
states = sorted({s for (s,) in rows("SELECT state FROM cell WHERE run_id = ?1 UNION SELECT state FROM cell_sample WHERE run_id = ?1", run)})
names = {c[1] for c in cells}
label = {c[0]: c[1] or ("/" if c[0] in names else "") + (c[0] or "egg") for c in cells}
csv_paths = [p or "egg" for p in paths]  # names in exported tables
colours = {"a1": "#e41a1c", "a3": "#377eb8", "a4": "#4daf4a", "a5": "#ff7f00"}
times = [t for (t,) in rows("SELECT DISTINCT time FROM mesh_sample WHERE run_id = ? ORDER BY time", run)]
end = rows("SELECT time FROM run WHERE run_id = ?", run)[0][0]
same(len(times), 6, "0, 1, 2, 3, 4 and the end")
same(len(rows("SELECT * FROM run_document WHERE run_id = ? AND role = 'faces'", run)), 2, "meshes")
expect({"died", "divided", "alive"} == {c[4] for c in cells}, "every fate")


def colour_of(state):
    known = [colours[s] for s in state.split() if s in colours]
    return tuple(bytes.fromhex(known[0][1:])) if len(known) == 1 else None


names_beside = {"path": "name", "parent": "parent_name", "a": "a_name", "b": "b_name", "other": "other_name"}


def comparable(row, columns):
    """Numbers compare as numbers, because several texts of a number are exact. The egg's path is empty in the database
    and `egg` in tables."""
    def value(v, column):
        if column in names_beside and v == "":
            return "egg"
        try:
            return float(v)
        except (TypeError, ValueError):
            return "" if v is None else v
    return [value(v, column) for v, column in zip(row, columns)]


def check_csv():
    tables = {"runs": "run", "cells": "cell", "samples": "sample", "cell_samples": "cell_sample", "contacts": "contact",
              "connections": "connection", "divisions": "division", "settlings": "settling", "time_steps": "time_step", "checks": "check_result"}
    for where, which in (("tables", [run]), ("both.tables", runs)):
        for file, table in tables.items():
            with open(path(where, file + ".csv"), newline="", encoding="utf-8") as stream:
                text = stream.read()
            same(text.count("\n"), text.count("\r\n"), "lines end in CR LF")
            read = list(csv.reader(text.splitlines(keepends=True), strict=True))
            marks = ",".join("?" * len(which))
            query = database.execute(f'SELECT * FROM "{table}" WHERE run_id IN ({marks})', which)
            columns = [c[0] for c in query.description]
            added = [names_beside[c] for c in columns if names_beside.get(c, c) not in columns]
            same(sorted(read[0]), sorted(columns + added), f"columns of {file}")
            for paths in set(names_beside) & set(columns):
                at = read[0].index(paths)
                expect(names_beside[paths] in columns or read[0][at + 1] == names_beside[paths], f"names beside {paths} in {file}")
            keep = [i for i, c in enumerate(read[0]) if c not in added]
            read = [[row[i] for i in keep] for row in read]
            same(read[0], columns, f"columns of {file}")
            stored = query.fetchall()
            same(len(read) - 1, len(stored), f"rows of {file}")
            expect(not any(field == "" for row in read[1:] for field, column in zip(row, read[0]) if column in ("path", "a", "b")),
                   f"no path of {file} looks like a missing value")
            given = [[None if v == "" else v for v in row] for row in read[1:]]
            same(sorted((comparable(r, read[0]) for r in given), key=str), sorted((comparable(r, read[0]) for r in stored), key=str),
                 f"rows of {file}")
    with open(path("tables", "cells.csv"), newline="") as stream:
        raw = stream.read()
    expect(f"{run},egg,,,0" in raw, "the egg has a path, and no mother")
    same({r["path"] for r in csv.DictReader(raw.splitlines()) if r["parent"] == "egg" and r["run_id"] == run}, {"A", "B"}, "daughters of the egg")
    with open(path("cells.csv"), newline="") as stream:
        same(stream.read(), raw, "one table alone")
    with open(path("tables", "measures_cell.csv"), newline="") as stream:
        wide = list(csv.DictReader(stream))
    same({(r["run_id"], float(r["time"]), r["path"].replace("egg", ""), float(r["generation"])) for r in wide},
         set(rows("SELECT run_id, time, a, value FROM measure WHERE run_id = ? AND name = 'generation'", run)), "generations")
    expect(os.path.exists(path("tables", "measures_world.csv")) and os.path.exists(path("tables", "measures_pair.csv")),
           "a table for each scope")


def check_newick():
    tree = Phylo.read(path("kept.newick"), "newick")
    life = {label[p]: (end if ended is None else ended) - born for p, _, born, ended, _, _ in cells}
    expect("/AB" in life and "P_1" in life and "E(x)" in life, "names that need quotes")
    clades = list(tree.find_clades())
    same(sorted(c.name for c in clades), sorted(life), "labels")
    for clade in clades:
        same(clade.branch_length, life[clade.name], f"the branch of {clade.name}")
        of = [c for c in cells if label[c[0]] == clade.name][0]
        same([d.name for d in clade.clades], [label[p] for p in (of[0] + "A", of[0] + "B") if p in label], "daughters")
        expect(f"fate={of[4]}" in clade.comment and f"path={of[0] or 'egg'}:" in clade.comment, f"comment {clade.comment}")
    same({t.name for t in tree.get_terminals()}, {label[c[0]] for c in cells if c[4] != "divided"}, "leaves")
    same(sorted(os.listdir(path("both.newick"))), sorted(r + ".nwk" for r in runs), "a tree a run")
    with open(path("plain.newick")) as stream:
        plain = stream.read()
    expect("[" not in plain and ":" in plain, "a tree without comments")
    bare = Phylo.read(path("plain.newick"), "newick")
    same([(c.name, c.branch_length, c.comment) for c in bare.find_clades()], [(c.name, c.branch_length, None) for c in clades],
         "the tree is the same without comments")
    for r in runs:
        read = Phylo.read(path("both.newick", r + ".nwk"), "newick")
        same(read.count_terminals(), rows("SELECT count(*) FROM cell WHERE run_id = ? AND fate <> 'divided'", r)[0][0], "leaves")


def read_vtp(name):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(name)
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    reader.Update()
    expect(not errors, f"VTK reads {name}")
    return reader.GetOutput()


def check_vtk():
    collection = xml.etree.ElementTree.parse(path("kept.vtk", "surfaces.pvd")).getroot().find("Collection")
    listed = [(float(d.get("timestep")), d.get("file")) for d in collection]
    same([t for t, _ in listed], times, "times of the collection")
    with open(path("kept.vtk", "cells.csv"), newline="") as stream:
        same([r["path"] for r in csv.DictReader(stream)], csv_paths, "the table of cells")
    with open(path("kept.vtk", "states.csv"), newline="") as stream:
        read_states = list(csv.DictReader(stream))
    for time, file in listed:
        data = read_vtp(path("kept.vtk", file))
        fields = data.GetFieldData()
        same(fields.GetArray("TimeValue").GetValue(0), time, "the file's time")
        text = fields.GetAbstractArray("paths")
        same([text.GetValue(i) for i in range(text.GetNumberOfValues())], paths, "paths in the file")
        text = fields.GetAbstractArray("states")
        same([text.GetValue(i) for i in range(text.GetNumberOfValues())], [r["substances"] for r in read_states], "states")
        points = vtk_to_numpy(data.GetPoints().GetData())
        triangles = vtk_to_numpy(data.GetPolys().GetData()).reshape(-1, 4)
        expect((triangles[:, 0] == 3).all(), "triangles")
        fieldOf = {data.GetCellData().GetArrayName(i): vtk_to_numpy(data.GetCellData().GetArray(i))
                   for i in range(data.GetCellData().GetNumberOfArrays())}
        measured = rows("SELECT path, volume, pressure, area, neighbours, state, x, y, z, sphericity FROM cell_sample WHERE run_id = ? AND time = ? ORDER BY path", run, time)
        first = 0
        for cell, vol, pressure, area, neighbours, state, *more in measured:
            exact, faces = kept_surface(time, cell)
            expect((points[first:first + len(exact)] == exact).all(), "points are the database's")
            of = fieldOf["cell"] == paths.index(cell)
            expect((triangles[of][:, 1:] - first == faces).all(), "faces are the database's")
            first += len(exact)
            for name, value in (("volume", vol), ("pressure", pressure), ("area", area), ("neighbours", neighbours),
                                *zip("xyz", more), ("sphericity", more[3])):
                expect((fieldOf[name][of] == value).all(), f"{name} of {cell}")
            same({read_states[i]["substances"] for i in fieldOf["state"][of]}, {state}, "state")
            if colour_of(state):
                same({tuple(c) for c in fieldOf["colour"][of]}, {colour_of(state)}, "colour")
            # The surface that VTK extracts encloses the stored volume up to rounding to 16 bits: area × half a step.
            threshold = vtkThreshold()
            threshold.SetInputData(data)
            threshold.SetInputArrayToProcess(0, 0, 0, 1, "cell")
            threshold.SetLowerThreshold(paths.index(cell) - 0.5)
            threshold.SetUpperThreshold(paths.index(cell) + 0.5)
            surface = vtkGeometryFilter()
            surface.SetInputConnection(threshold.GetOutputPort())
            mass = vtkMassProperties()
            mass.SetInputConnection(surface.GetOutputPort())
            mass.Update()
            step = numpy.ptp(exact, axis=0).max() / 65535
            expect(abs(mass.GetVolume() - vol) <= area * step + 1e-6 * vol, f"the volume of {cell}: {mass.GetVolume()}, {vol}")
        same(first, len(points), "no other points")


def read_ply(name):
    reader = vtkPLYReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def check_ply():
    series = sorted(glob.glob(path("kept.series", "*.ply")))
    same(len(series), len(times), "a file a time")
    with open(path("kept.series", "times.csv"), newline="") as stream:
        same([float(r["time"]) for r in csv.DictReader(stream)], times, "times of the files")
    for time, name in list(zip(times, series)) + [(end, path("kept.ply"))]:
        data = read_ply(name)
        points = vtk_to_numpy(data.GetPoints().GetData())
        triangles = vtk_to_numpy(data.GetPolys().GetData()).reshape(-1, 4)[:, 1:]
        colour = vtk_to_numpy(data.GetPointData().GetArray("RGB"))
        first = face = 0
        for cell, state in rows("SELECT path, state FROM cell_sample WHERE run_id = ? AND time = ? ORDER BY path", run, time):
            exact, faces = kept_surface(time, cell)
            off = numpy.abs(points[first:first + len(exact)] - exact).max()
            expect(off <= bound_of_float * numpy.abs(exact).max(), f"points of {name}")
            expect((triangles[face:face + len(faces)] - first == faces).all(), f"faces of {name}")
            if colour_of(state):
                same({tuple(c) for c in colour[first:first + len(exact)]}, {colour_of(state)}, "colour")
            first, face = first + len(exact), face + len(faces)
        same((first, face), (len(points), len(triangles)), "counts")
    body = lambda name: open(name, "rb").read().split(b"end_header\n", 1)[1]
    expect(body(path("kept.ply")) == body(path("again.ply")), "a run made again has the surfaces that it would have kept")


def check_glb(file):
    with open(path(file), "rb") as stream:
        data = stream.read()
    magic, version, length, json_length, json_kind = struct.unpack_from("<4sIII4s", data)
    same((magic, version, length, json_kind), (b"glTF", 2, len(data), b"JSON"), "the header")
    document = json.loads(data[20:20 + json_length])
    binary_length, binary_kind = struct.unpack_from("<I4s", data, 20 + json_length)
    same(binary_kind, b"BIN\0", "the second chunk")
    same((json_length % 4, binary_length % 4, 28 + json_length + binary_length), (0, 0, len(data)), "lengths of chunks")
    binary = data[28 + json_length:]
    same(document["buffers"][0]["byteLength"], len(binary), "the buffer")
    same(document["asset"]["version"], "2.0", "the version")
    kinds = {5126: "<f4", 5125: "<u4", 5123: "<u2"}

    def values(number):
        accessor = document["accessors"][number]
        view = document["bufferViews"][accessor["bufferView"]]
        kind = numpy.dtype(kinds[accessor["componentType"]])
        width = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
        size = accessor["count"] * width * kind.itemsize
        same(view["byteLength"], size, "an accessor fills its view")
        expect(view["byteOffset"] % 4 == 0 and view["byteOffset"] + size <= len(binary), "a view within the buffer")
        array = numpy.frombuffer(binary, kind, accessor["count"] * width, view["byteOffset"]).reshape(-1, width)
        if "min" in accessor:
            same((accessor["min"], accessor["max"]), (array.min(0).tolist(), array.max(0).tolist()), "bounds")
        return array

    *nodes, root = document["nodes"]
    same(document["scenes"][0]["nodes"], [len(nodes)], "the scene is its root")
    same(root["children"], list(range(len(nodes))), "all nodes of cells are in the scene")
    measured = rows("SELECT path, state, volume FROM cell_sample WHERE run_id = ? AND time = 2 ORDER BY path", run)
    same(len(nodes), len(measured), "a node a cell")
    for node, (cell, state, vol) in zip(nodes, measured):
        same((node["name"], node["extras"]["path"], node["extras"]["state"], node["extras"]["volume"]), (label[cell], cell, state, vol), "node")
        mesh = document["meshes"][node["mesh"]]
        (primitive,) = mesh["primitives"]
        exact, faces = kept_surface(2, cell)
        positions, normals = values(primitive["attributes"]["POSITION"]), values(primitive["attributes"]["NORMAL"])
        expect("min" in document["accessors"][primitive["attributes"]["POSITION"]], "positions have bounds")
        expect(numpy.abs(positions - exact).max() <= bound_of_float * numpy.abs(exact).max(), "positions")
        expect(numpy.abs(numpy.linalg.norm(normals, axis=1) - 1).max() < 1e-6, "normals of length 1")
        expect((numpy.einsum("ij,ij->i", normals, positions - positions.mean(0)) > 0).mean() > 0.9, "normals look outwards")
        expect((values(primitive["indices"]).reshape(-1, 3) == faces).all(), "faces")
        material = document["materials"][primitive["material"]]
        same(material["name"], state, "material")
        wanted = colour_of(state)
        if wanted:
            linear = [c / 255 / 12.92 if c <= 10 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in wanted]
            expect(max(abs(a - b) for a, b in zip(linear, material["pbrMetallicRoughness"]["baseColorFactor"])) < 1e-6, "colour")
    same(len({m["name"] for m in document["materials"]}), len(document["materials"]), "a material a state")
    return binary


def check_upright():
    """The points as VTK shows the file: the simulation's z is glTF's y, which points upwards."""
    reader = vtkGLTFReader()
    reader.SetFileName(path("kept.glb"))
    reader.Update()
    shown, box = reader.GetOutput(), [0.0] * 6
    shown.GetBounds(box)
    points = numpy.concatenate([kept_surface(2, cell)[0] for (cell,) in rows("SELECT path FROM cell_sample WHERE run_id = ? AND time = 2", run)])
    x, y, z = points.T
    upright = numpy.array([x, z, -y])
    wanted = numpy.array([upright.min(1), upright.max(1)]).T.ravel()
    expect(numpy.abs(box - wanted).max() < 1e-6, f"the organism stands upright: {box}, {wanted.tolist()}")
    sizes = numpy.ptp(points, axis=0)
    expect(abs(sizes[1] - sizes[2]) > 0.01, f"the organism is not as deep as it is high, so that it matters: {sizes}")


def check_after_death():
    """Series continue to the end of the run after the last cell has died."""
    gone = sqlite3.connect(os.path.join(folder, "gone.db"))
    every = [t for (t,) in gone.execute("SELECT time FROM sample ORDER BY time")]
    counts = [c for (c,) in gone.execute("SELECT cells FROM sample ORDER BY time")]
    expect(counts[0] == 1 and counts[-1] == 0, f"the only cell dies before the end: {counts}")
    for name, ending in (("gone-ply", ".ply"), ("gone-gltf", ".glb"), ("gone-vtk", ".vtp")):
        same(len(glob.glob(path(name, "*" + ending))), len(every), f"a file a time: {name}")
    with open(path("gone-ply", "times.csv"), newline="") as stream:
        same([float(r["time"]) for r in csv.DictReader(stream)], every, "times")
    collection = xml.etree.ElementTree.parse(path("gone-vtk", "surfaces.pvd")).getroot().find("Collection")
    same([float(d.get("timestep")) for d in collection], every, "times of the collection")
    for i, cells_then in enumerate(counts):
        expect((read_ply(path("gone-ply", f"{i:04}.ply")).GetNumberOfPoints() > 0) == (cells_then > 0), "points of a ply file")
        expect((read_vtp(path("gone-vtk", f"surfaces_{i:04}.vtp")).GetNumberOfPoints() > 0) == (cells_then > 0), "points of a vtp file")
    with open(path("gone-gltf", f"{len(every) - 1:04}.glb"), "rb") as stream:
        data = stream.read()
    magic, _, length, json_length, _ = struct.unpack_from("<4sIII4s", data)
    same((magic, length, json_length), (b"glTF", len(data), len(data) - 20), "a file without cells has no second chunk")
    document = json.loads(data[20:])
    expect("buffers" not in document and "children" not in document["nodes"][0], "no list is empty")


def check_npz():
    kept, again = numpy.load(path("kept.npz")), numpy.load(path("again.npz"))
    for data in (kept, again):
        same(data["paths"].tolist(), paths, "paths")
        same(data["born"].tolist(), [c[2] for c in cells], "born")
        same(data["fates"].tolist(), [c[4] for c in cells], "fates")
        same([data["states"][i] for i in data["last_states"]], [c[5] for c in cells], "last states")
        expect(all((math.isnan(e) and c[3] is None) or e == c[3] for e, c in zip(data["ended"], cells)), "ended")
        sampled = [t for (t,) in rows("SELECT time FROM sample WHERE run_id = ? ORDER BY time", run)]
        same(data["times"].tolist(), sampled, "times of samples")
        for i, time in enumerate(sampled):
            here = slice(*data["cell_start"][i:i + 2])
            stored = rows("SELECT path, state, x, y, z, volume, area, pressure, sphericity, neighbours FROM cell_sample "
                          "WHERE run_id = ? AND time = ? ORDER BY path", run, time)
            same([paths[k] for k in data["cell"][here]], [s[0] for s in stored], "cells of a sample")
            same([data["states"][k] for k in data["state"][here]], [s[1] for s in stored], "states of a sample")
            same(data["centroids"][here].tolist(), [list(s[2:5]) for s in stored], "centroids")
            for k, name in enumerate(("volumes", "areas", "pressures", "sphericities", "neighbours")):
                same(data[name][here].tolist(), [s[5 + k] for s in stored], name)
            here = slice(*data["contact_start"][i:i + 2])
            stored = rows("SELECT a, b, area FROM contact WHERE run_id = ? AND time = ? ORDER BY a, b", run, time)
            same([[paths[a], paths[b]] for a, b in data["contacts"][here]], [list(s[:2]) for s in stored], "contacts")
            same(data["contact_areas"][here].tolist(), [s[2] for s in stored], "areas of contacts")
    seen = 0
    for i, time in enumerate(kept["times"]):
        for u in range(*kept["surface_start"][i:i + 2]):
            cell = paths[kept["surface_cell"][u]]
            exact, faces = kept_surface(float(time), cell)
            expect((kept["vertices"][slice(*kept["vertex_start"][u:u + 2])] == exact).all(), "vertices")
            expect((kept[f"faces_{kept['surface_mesh'][u]}"] == faces).all(), "faces")
            ((vol, area),) = rows("SELECT volume, area FROM cell_sample WHERE run_id = ? AND time = ? AND path = ?", run, float(time), cell)
            expect(abs(volume(exact, faces) - vol) <= 2 * area * kept["surface_bound"][u], "the kept surface has the exact volume")
            seen += 1
    same(seen, rows("SELECT count(*) FROM mesh_sample WHERE run_id = ?", run)[0][0], "surfaces")
    same(len(again["surface_cell"]), len(again["cell"]), "made again: surfaces at every sample")
    same(sorted(os.listdir(path("both.npz"))), sorted(r + ".npz" for r in runs), "a file a run")
    for r in runs:
        same(numpy.load(path("both.npz", r + ".npz"))["times"].tolist(), [1.0], "one time")


check_csv()
check_newick()
check_vtk()
check_ply()
same(check_glb("kept.glb"), check_glb("again.glb"), "a run made again has the surfaces that it would have kept")
check_upright()
check_after_death()
check_npz()
print(f"{len(cells)} cells, {len(times)} times of surfaces: csv, newick, vtk, ply, gltf and npz as read by others")

# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Reads the files of write_formats with meshio, VTK, Gmsh and three.js, and has write_formats read what the first three write.
# usage: read_formats.py WRITE_FORMATS FOLDER   (FOLDER holds the files and expected.txt, what write_formats printed)
import json
import subprocess
import sys
from pathlib import Path

import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from checks import check, finish, run

tool, folder = sys.argv[1], Path(sys.argv[2])


def ninths(area):
    """Areas are whole numbers of this unit: the boxes have coordinates in thirds."""
    return round(9 * area, 6)


def parse(text):
    """Counts, and groups as {(dimension, name): (count, area)}."""
    counts, groups = {}, {}
    for line in text.splitlines():
        word, rest = line.split(" ", 1)
        if word == "group":
            dimension, count, area, name = rest.split(" ", 3)
            groups[int(dimension), name] = (int(count), ninths(float(area)))
        else:
            counts[word] = int(rest)
    return counts, groups


counts, groups = parse((folder / "expected.txt").read_text())
surfaces = {name: value for (dimension, name), value in groups.items() if dimension == 2}


def area(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return ninths(float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2))


def check_counts(name, points, triangles, lines=None):
    check(f"{name}, points", len(points), counts["points"])
    check(f"{name}, triangles", len(triangles), counts["triangles"])
    check(f"{name}, area", area(points, triangles), sum(value[1] for value in surfaces.values()))
    if lines is not None:
        check(f"{name}, lines", lines, counts["lines"])


def check_summary(name, path):
    """What write_formats finds in a file that another program wrote."""
    done = subprocess.run([tool, "--read", str(path)], capture_output=True, text=True)
    if done.returncode != 0:
        return check(name, done.stderr.strip(), "")
    check(name, parse(done.stdout), (counts, groups))


# ---- meshio


def triangles_of(mesh):
    return np.concatenate([block.data for block in mesh.cells if block.type == "triangle"])


def values_of(mesh, key):
    return np.concatenate([data for block, data in zip(mesh.cells, mesh.cell_data[key]) if block.type == "triangle"])


def lines_of(mesh):
    return sum(len(block.data) for block in mesh.cells if block.type == "line")


def by_tags(mesh, tags, name_of_tag):
    triangles = triangles_of(mesh)
    return {
        name: (int((tags == tag).sum()), area(mesh.points, triangles[tags == tag])) for tag, name in name_of_tag.items()
    }


def meshio_gmsh(file):
    mesh = meshio.read(folder / file, file_format="gmsh")
    check_counts(f"meshio {file}", mesh.points, triangles_of(mesh), lines_of(mesh))
    names = {int(tag): name for name, (tag, dimension) in mesh.field_data.items() if dimension == 2}
    check(f"meshio {file}, groups", by_tags(mesh, values_of(mesh, "gmsh:physical"), names), surfaces)


def meshio_vtu():
    text = (folder / "boxes-vtu.vtu").read_text()
    begin, end = text.index("<FieldData>"), text.index("</FieldData>") + len("</FieldData>")
    path = folder / "without-names.vtu"  # meshio refuses arrays of strings
    path.write_text(text[:begin] + text[end:])
    mesh = meshio.read(path)
    check_counts("meshio vtu", mesh.points, triangles_of(mesh), lines_of(mesh))
    check("meshio vtu, groups", by_tags(mesh, values_of(mesh, "group"), dict(enumerate(surfaces, 1))), surfaces)


def meshio_medit():
    mesh = meshio.read(folder / "boxes-mesh.mesh", file_format="medit")
    check_counts("meshio mesh", mesh.points, triangles_of(mesh), lines_of(mesh))
    check("meshio mesh, references", len(set(values_of(mesh, "medit:ref"))), faces)


def meshio_abaqus():
    mesh = meshio.read(folder / "boxes-inp.inp")
    check_counts("meshio inp", mesh.points, triangles_of(mesh))
    triangles = triangles_of(mesh)
    found = {}
    for name, sets in mesh.cell_sets.items():
        if name.startswith("FACE_"):
            continue
        members = np.concatenate([block.data[np.asarray(part, dtype=int)] for block, part in zip(mesh.cells, sets) if part is not None])
        found[name] = (len(members), area(mesh.points, members))
    legal = {"".join(c if c.isalnum() else "_" for c in name): value for name, value in surfaces.items()}
    check("meshio inp, sets", found, legal)
    nodes = {name: len(members) for name, members in mesh.point_sets.items()}
    expected = {name: value[0] for (dimension, name), value in groups.items() if dimension < 2}
    check("meshio inp, node sets", nodes, expected)
    check("meshio inp, triangles", len(triangles), counts["triangles"])


def meshio_nastran():
    mesh = meshio.read(folder / "boxes-bdf.bdf")
    check_counts("meshio bdf", mesh.points, triangles_of(mesh))
    text = (folder / "boxes-bdf.bdf").read_text()
    tags = values_of(mesh, "nastran:ref")
    found = {}
    for line in text.splitlines():
        if line.startswith("$HMNAME COMP"):
            count, size = found.get(line.split('"')[1], (0, 0))
            part = triangles_of(mesh)[tags == int(line[24:32])]
            found[line.split('"')[1]] = (count + len(part), size + area(mesh.points, part))
    check("meshio bdf, names", found, surfaces)


def meshio_writes():
    mesh = meshio.read(folder / "boxes-msh.msh", file_format="gmsh")
    for kind, options in {"gmsh22": {"binary": False}, "gmsh": {"binary": False}}.items():
        path = folder / f"meshio-{kind}.msh"
        meshio.write(path, mesh, file_format=kind, **options)
        check_summary(f"our reader of meshio's {kind}", path)
    plain = meshio.Mesh(mesh.points, [("triangle", triangles_of(mesh))], cell_data={"medit:ref": [values_of(mesh, "gmsh:physical")]})
    for kind, name, options in [("medit", "m.mesh", {}), ("vtu", "m.vtu", {"binary": False}), ("vtk", "m.vtk", {"binary": False})]:
        path = folder / f"meshio-{name}"
        meshio.write(path, plain, file_format=kind, **options)
        check_surface(f"our reader of meshio's {kind}", path)


def check_surface(name, path):
    """Counts only: the file has no names."""
    done = subprocess.run([tool, "--read", str(path)], capture_output=True, text=True)
    found = parse(done.stdout)[0] if done.returncode == 0 else done.stderr.strip()
    check(name, found, {"points": counts["points"], "lines": 0, "triangles": counts["triangles"]})


# ---- VTK


def vtk_grid(reader, name):
    reader.SetFileName(str(folder / name))
    reader.Update()
    return reader.GetOutput()


def check_grid(name, grid):
    types = vtk_to_numpy(grid.GetCellTypesArray())
    triangles = np.array([[grid.GetCell(i).GetPointId(k) for k in range(3)] for i in np.flatnonzero(types == vtk.VTK_TRIANGLE)])
    check_counts(name, vtk_to_numpy(grid.GetPoints().GetData()), triangles, int((types == vtk.VTK_LINE).sum()))
    field = grid.GetFieldData()
    texts = field.GetAbstractArray("group_names")
    found = {}
    for i in range(texts.GetNumberOfValues() if texts else 0):
        dimension, tag = (int(field.GetArray(key).GetValue(i)) for key in ("group_dimensions", "group_tags"))
        if dimension != 2:
            continue
        members = vtk_to_numpy(grid.GetCellData().GetArray("group"))[types == vtk.VTK_TRIANGLE] == tag
        found[texts.GetValue(i)] = (int(members.sum()), area(vtk_to_numpy(grid.GetPoints().GetData()), triangles[members]))
    check(f"{name}, groups", found, surfaces)


def vtk_reads_and_writes():
    legacy = vtk_grid(vtk.vtkUnstructuredGridReader(), "boxes-vtk.vtk")
    check_grid("VTK vtk", legacy)
    xml = vtk_grid(vtk.vtkXMLUnstructuredGridReader(), "boxes-vtu.vtu")
    check_grid("VTK vtu", xml)
    for version in (42, 51):
        writer = vtk.vtkUnstructuredGridWriter()
        writer.SetFileVersion(version)
        write_grid(writer, legacy, f"vtk-{version}.vtk", lambda w: w.SetFileTypeToASCII())
    write_grid(vtk.vtkXMLUnstructuredGridWriter(), xml, "vtk.vtu", lambda w: w.SetDataModeToAscii())
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(legacy)
    surface.Update()
    path = folder / "vtk-poly.vtk"
    writer = vtk.vtkPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(surface.GetOutput())
    writer.Write()
    check_summary("our reader of VTK's PolyData", path)


def write_grid(writer, grid, name, as_text):
    path = folder / name
    as_text(writer)
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.Write()
    check_summary(f"our reader of VTK's {name}", path)


# ---- Gmsh


def gmsh(name, source, *options):
    path = folder / f"gmsh-{name}"
    command = ["gmsh", str(folder / source), "-save", "-o", str(path), "-v", "2", *options]
    done = subprocess.run(command, capture_output=True, text=True)
    check(f"Gmsh reads {source}", (done.returncode, done.stdout.strip(), done.stderr.strip()), (0, "", ""))
    return path


def gmsh_reads_and_writes():
    for source in ("boxes-msh.msh", "boxes-msh22.msh"):
        for kind in ("msh41", "msh22"):
            path = gmsh(f"{source[6:-4]}-{kind}.msh", source, "-format", kind)
            check_summary(f"our reader of Gmsh's {kind} of {source}", path)
    for source in ("boxes-mesh.mesh", "boxes-vtk.vtk", "boxes-bdf.bdf"):
        path = gmsh(f"{source[6:]}.msh", source, "-format", "msh22", "-save_all")
        mesh = meshio.read(path, file_format="gmsh")
        check_counts(f"Gmsh {source}", mesh.points, triangles_of(mesh))
    for kind in ("vtk", "mesh"):
        path = gmsh(f"out.{kind}", "boxes-msh.msh", "-format", kind)
        done = subprocess.run([tool, "--read", str(path)], capture_output=True, text=True)
        found = parse(done.stdout)[0] if done.returncode == 0 else done.stderr.strip()
        check(f"our reader of Gmsh's {kind}", found, counts)


# ---- GLB


def three(name):
    program = Path(__file__).with_name("read_glb.mjs")
    return json.loads(subprocess.run(["node", program, folder / name], capture_output=True, text=True, check=True).stdout)


def array_of(mesh, name):
    attribute = mesh["attributes"][name]
    return np.array(attribute["values"], dtype=np.float64).reshape(-1, attribute["itemSize"])


def vtk_parts(name):
    """The pieces of a scene, a primitive each."""
    reader = vtk.vtkGLTFReader()
    reader.SetFileName(str(folder / name))
    reader.Update()
    parts, pieces = reader.GetOutput().NewIterator(), []
    parts.InitTraversal()
    while not parts.IsDoneWithTraversal():
        pieces.append(parts.GetCurrentDataObject())
        parts.GoToNextItem()
    return pieces


def polys_of(part):
    return vtk_to_numpy(part.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def rounded(size):
    """Float32 coordinates: areas to five digits."""
    return round(size, 5)


expected_parts = {name: (count, rounded(size)) for name, (count, size) in surfaces.items()}


def three_reads_glb():
    meshes = three("boxes.glb")
    found = {}
    for mesh in meshes:
        points, triangles = array_of(mesh, "position"), np.array(mesh["index"]).reshape(-1, 3)
        check("three.js glb, points", len(points), counts["points"])
        found[mesh["name"]] = (len(triangles), rounded(area(points, triangles)))
    check("three.js glb, materials", found, expected_parts)


def three_reads_data():
    (mesh,) = three("painted.glb")
    side = np.arange(24) // 4
    check("three.js glb, vertices of a painted cube", len(array_of(mesh, "position")), 24)
    found = {tuple(row) for row in array_of(mesh, "uv")}
    check("three.js glb, texture coordinates", found, {(k / 8, 0.75) for k in side})
    check("three.js glb, colours", {tuple(row) for row in array_of(mesh, "color")}, {(k / 8, 0.5, 1) for k in side})
    points, normals = array_of(mesh, "position"), array_of(mesh, "normal")
    outward = [(point - 0.5) @ normal for point, normal in zip(points, normals)]
    check("three.js glb, normals", (set(outward), set(np.linalg.norm(normals, axis=1))), ({0.5}, {1.0}))


def vtk_reads_glb():
    parts = vtk_parts("boxes.glb")
    check("VTK glb, parts", len(parts), len(surfaces))
    found = [(part.GetNumberOfCells(), rounded(area(vtk_to_numpy(part.GetPoints().GetData()), polys_of(part)))) for part in parts]
    check("VTK glb, triangles", sorted(found), sorted(expected_parts.values()))
    names = {name: vtk_parts("painted.glb")[0].GetPointData().GetArray(name).GetNumberOfTuples() for name in ("NORMAL", "COLOR_0", "TEXCOORD_0")}
    check("VTK glb, data", names, {"NORMAL": 24, "COLOR_0": 24, "TEXCOORD_0": 24})


faces = sum(line.startswith("*ELEMENT") for line in (folder / "boxes-inp.inp").read_text().splitlines())
run(
    lambda: meshio_gmsh("boxes-msh.msh"),
    lambda: meshio_gmsh("boxes-msh22.msh"),
    meshio_vtu,
    meshio_medit,
    meshio_abaqus,
    meshio_nastran,
    meshio_writes,
    vtk_reads_and_writes,
    gmsh_reads_and_writes,
    three_reads_glb,
    three_reads_data,
    vtk_reads_glb,
)
finish()

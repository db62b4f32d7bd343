# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Has Gmsh fill the projects of write_projects with tetrahedra, and checks what meshio finds in its files: names of regions and faces,
# volumes and areas, that every triangle inside has two tetrahedra, of the two regions it parts.
# usage: read_projects.py FOLDER
import re
import subprocess
import sys
from collections import Counter, defaultdict
from pathlib import Path

import meshio
import numpy as np

from checks import check, finish, run, skip

folder = Path(sys.argv[1])


class Expected:
    """What write_projects says of a project."""

    def __init__(self, name):
        self.volumes, self.pairs, self.faces = {}, defaultdict(float), {}
        for line in (folder / f"{name}.txt").read_text().splitlines():
            word, rest = line.split(" ", 1)
            if word == "region":
                volume, region = rest.split(" ", 1)
                self.volumes[region] = float(volume)
            elif word == "pair":
                area, regions = rest.split(" ", 1)
                self.pairs[tuple(sorted(regions.split("|")))] += float(area)
            else:
                count, area, face = rest.split(" ", 2)
                self.faces[face] = (int(count), float(area))


def fill(name):
    """Tetrahedra, as Gmsh writes them: an element once for each of its groups."""
    path = folder / f"{name}-filled.msh"
    command = ["gmsh", folder / f"{name}.geo", "-3", "-format", "msh22", "-o", path, "-v", "2"]
    done = subprocess.run(command, capture_output=True, text=True)
    check(f"Gmsh fills {name}", (done.returncode, done.stdout.strip(), done.stderr.strip()), (0, "", ""))
    return meshio.read(path, file_format="gmsh")


def cells_by_name(mesh, kind, dimension):
    names = {int(tag): name for name, (tag, d) in mesh.field_data.items() if d == dimension}
    found = defaultdict(list)
    for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        for tag in np.unique(tags) if block.type == kind else []:
            found[names[int(tag)]].append(block.data[tags == tag])
    return {name: np.concatenate(parts) for name, parts in found.items()}


def close(found, expected):
    """The keys are equal, the values to nine digits."""
    return found.keys() == expected.keys() and all(abs(found[key] - value) <= 1e-9 * abs(value) for key, value in expected.items())


def signed_volumes(points, tets):
    a, b, c, d = (points[tets[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6


def area(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def triangles_of_tets(tets_of_region):
    """Every triangle of a tetrahedron with the regions of those it belongs to."""
    regions = defaultdict(list)
    for region, tets in tets_of_region.items():
        for k in range(4):
            for triangle in np.sort(np.delete(tets, k, axis=1)):
                regions[tuple(triangle)].append(region)
    return regions


def check_conformity(name, points, tets, faces, expected):
    regions = triangles_of_tets(tets)
    on_faces = {tuple(sorted(t)) for triangles in faces.values() for t in triangles}
    uses = Counter()
    for triangle, both in regions.items():
        uses[len(both), len(set(both)), triangle in on_faces] += 1
    # two tetrahedra of one region, inside; two of two regions, on a face; one, on a face
    check(f"{name}, tetrahedra at a triangle", set(uses) <= {(2, 1, False), (2, 2, True), (1, 1, True)}, True)
    check(f"{name}, triangles of faces have tetrahedra", on_faces <= regions.keys(), True)
    shared = defaultdict(list)
    for triangle in on_faces & regions.keys():
        if len(regions[triangle]) == 2:
            shared[tuple(sorted(regions[triangle]))].append(triangle)
    areas = {pair: area(points, np.array(triangles)) for pair, triangles in shared.items()}
    check(f"{name}, faces between regions: {areas} for {dict(expected.pairs)}", close(areas, expected.pairs), True)


def check_project(name):
    expected, mesh = Expected(name), fill(name)
    tets, faces = cells_by_name(mesh, "tetra", 3), cells_by_name(mesh, "triangle", 2)
    check(f"{name}, regions", sorted(tets), sorted(expected.volumes))
    volumes = {region: signed_volumes(mesh.points, cells) for region, cells in tets.items()}
    check(f"{name}, tetrahedra that are inside out or flat", [r for r, v in volumes.items() if v.min() <= 0 < v.max()], [])
    sums = {region: float(abs(v.sum())) for region, v in volumes.items()}
    check(f"{name}, volumes: {sums} for {expected.volumes}", close(sums, expected.volumes), True)
    counts = {face: len(cells) for face, cells in faces.items()}
    check(f"{name}, triangles of faces", counts, {face: count for face, (count, _) in expected.faces.items()})
    areas = {face: area(mesh.points, cells) for face, cells in faces.items()}
    check(f"{name}, areas of faces: {areas}", close(areas, {face: size for face, (_, size) in expected.faces.items()}), True)
    check_conformity(name, mesh.points, tets, faces, expected)
    return expected


def check_boxes():
    check("boxes, what they are", check_project("boxes").volumes, {"steel": 15.0})


def check_parts():
    check("parts, volumes", sorted(check_project("parts").volumes.values()), [1, 1, 26])


def check_exchanger():
    """Five solids in contact: names of both sides on every face between two."""
    if not (folder / "exchanger.txt").exists():
        return skip("five solids of a heat exchange: no data in MORTISE_DATA")
    expected = check_project("exchanger")
    check("exchanger, regions", sorted(expected.volumes), ["bottomAir", "heater", "leftSolid", "rightSolid", "topAir"])
    named = {tuple(sorted(re.findall(r"\w+", name[len("interface"):]))): size for name, (_, size) in expected.faces.items() if name.startswith("interface(")}
    check(f"exchanger, faces between regions are named by both: {named} for {dict(expected.pairs)}", close(named, expected.pairs), True)


run(check_boxes, check_parts, check_exchanger)
finish()

# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Has Gmsh mesh the square and the box of write_views, and compares edges with what the sources ask for where they are.
# usage: read_views.py FOLDER
import json
import subprocess
import sys
from pathlib import Path

import meshio
import numpy as np

from checks import check, finish, run

folder = Path(sys.argv[1])


def meshed(name):
    """Points and edges of the triangles."""
    path = folder / f"{name}-sized.msh"
    command = ["gmsh", folder / f"{name}.geo", "-2", "-format", "msh22", "-o", path, "-v", "2"]
    done = subprocess.run(command, capture_output=True, text=True)
    check(f"Gmsh meshes {name}", (done.returncode, done.stdout.strip(), done.stderr.strip()), (0, "", ""))
    mesh = meshio.read(path, file_format="gmsh")
    triangles = mesh.get_cells_type("triangle")
    edges = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    return mesh.points, np.unique(edges, axis=0)


def distances(points, source):
    a, b = np.array(source["from"]), np.array(source["to"])
    square = (b - a) @ (b - a)
    t = np.clip((points - a) @ (b - a) / square, 0, 1) if square > 0 else np.zeros(len(points))
    return np.linalg.norm(points - a - t[:, None] * (b - a), axis=1)


def sizes_at(points, asked):
    """S + D (f - 1) of every source, the least of them."""
    sizes = [source["size"] + (source["growth"] - 1) * distances(points, source) for source in asked["sources"]]
    return np.minimum(asked["global"], np.min(sizes, axis=0))


def check_view(name):
    asked = json.loads((folder / f"{name}.json").read_text())
    points, edges = meshed(name)
    ends = points[edges]
    lengths, middles = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1), ends.mean(axis=1)
    ratios = lengths / sizes_at(middles, asked)
    check(f"{name}, median of length by size: {np.median(ratios):.3f}", 0.85 < np.median(ratios) < 1.15, True)
    check(f"{name}, nine tenths of lengths by size: {np.quantile(ratios, [0.05, 0.95])}", bool(np.all(np.abs(np.log2(np.quantile(ratios, [0.05, 0.95]))) < 1)), True)
    for k, source in enumerate(asked["sources"]):
        near = lengths[distances(middles, source) < source["size"]]
        check(f"{name}, {len(near)} edges near source {k}: {near.max():.4f} long", bool(near.max() < 2 * source["size"]), True)


def check_square():
    check_view("square")


def check_block():
    check_view("block")


run(check_square, check_block)
finish()

#!/usr/bin/env python3
"""Makes beam.msh, tetrahedra of irregular size in the beam of this case. Needs gmsh.

    make_mesh.py [SIZE]

SIZE is the length of edges [m]; 0.295 makes about 1900 vertices.
"""
import pathlib
import subprocess
import sys
import tempfile

size = sys.argv[1] if len(sys.argv) > 1 else "0.295"
here = pathlib.Path(__file__).resolve().parent
geometry = f"""
SetFactory("OpenCASCADE");
Box(1) = {{0, -1, -1, 10, 2, 2}};
Mesh.MeshSizeMin = {size};
Mesh.MeshSizeMax = {size};
Mesh.MshFileVersion = 2.2;
"""
with tempfile.NamedTemporaryFile("w", suffix=".geo") as file:
    file.write(geometry)
    file.flush()
    subprocess.run(["gmsh", "-3", file.name, "-o", str(here / "beam.msh")], check=True)

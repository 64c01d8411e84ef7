"""The walls of a case as triangles: the zero level of the signed distance of their solids."""
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

CELLS = 120  # along the longest side of the box in which walls are drawn


def distance(shape, x):
    """Signed distance of points x [3][...] to a shape of a case file, negative inside."""
    kind = shape["shape"]
    if kind in ("union", "intersection", "difference"):
        parts = [distance(part, x) for part in shape["of"]]
        if kind == "union":
            return np.min(parts, axis=0)
        if kind == "difference":
            parts[1:] = [-part for part in parts[1:]]
        return np.max(parts, axis=0)
    if kind == "half_space":
        normal = np.array(shape["normal"]) / np.linalg.norm(shape["normal"])
        return np.tensordot(normal, relative(x, shape["point"]), 1)
    if kind == "box":
        low, high = relative(x, shape["lower"]), relative(x, shape["upper"])
        return np.max(np.maximum(-low, high), axis=0)
    if kind in ("ball", "cylinder"):
        away = relative(x, shape["centre"])
        if kind == "cylinder":
            axis = np.array(shape["axis"]) / np.linalg.norm(shape["axis"])
            away = away - axis[:, None, None, None] * np.tensordot(axis, away, 1)
        return np.linalg.norm(away, axis=0) - shape["radius"]
    raise SystemExit(f"walls of the shape {kind} cannot be drawn")


def relative(x, point):
    return x - np.array(point, dtype=float)[:, None, None, None]


def solids(case, x, time):
    """Signed distance to the nearest wall; walls that move are where a constant velocity took them."""
    found = np.full(x.shape[1:], np.inf)
    for boundary in case.get("boundary", []):
        if boundary["kind"] == "pressure":
            continue
        velocity = boundary.get("velocity", [0, 0, 0])
        if not all(isinstance(part, (int, float)) for part in velocity):
            raise SystemExit(f"wall {boundary['name']} moves by a formula and cannot be drawn")
        moved = relative(x, np.multiply(velocity, time))
        found = np.minimum(found, distance(boundary["geometry"], moved))
    return found


def surface(case, time, box, plane):
    """Walls inside a box [2][3], opened by a plane or not, with the cut faces closed."""
    step = np.ptp(box, axis=0).max() / CELLS
    low = box[0] - step
    counts = np.ceil((box[1] + step - low) / step).astype(int) + 1
    grid = np.stack(np.meshgrid(*(low[a] + step * np.arange(counts[a]) for a in range(3)),
                                indexing="ij"))
    ends = np.max(np.maximum(relative(-grid, -box[0]), relative(grid, box[1])), axis=0)
    solid = np.maximum(solids(case, grid, time), ends)
    if plane is not None:
        normal = -np.array(plane.GetNormal())
        solid = np.maximum(solid, np.tensordot(normal, relative(grid, plane.GetOrigin()), 1))
    image, contour, normals = vtk.vtkImageData(), vtk.vtkFlyingEdges3D(), vtk.vtkPolyDataNormals()
    image.SetDimensions(*map(int, counts))
    image.SetOrigin(*low)
    image.SetSpacing(step, step, step)
    values = numpy_to_vtk(np.clip(solid, -10 * step, 10 * step).ravel(order="F"), deep=True)
    image.GetPointData().SetScalars(values)
    contour.SetInputData(image)
    contour.SetValue(0, 0)
    contour.ComputeNormalsOff()
    normals.SetInputConnection(contour.GetOutputPort())
    normals.SetFeatureAngle(40)
    normals.Update()
    return normals.GetOutput()

"""Surfaces of bodies in a frame of a result, whole or opened by a plane, with a field on them."""
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

PARTICLE = 1  # of the field `kind`; the rest are ghosts


def magnitude(values):
    return np.linalg.norm(values, axis=1) if values.ndim == 2 else values


def column(field):
    """A field and a component of it, as in velocity_y; component -1 is the magnitude."""
    name, _, axis = field.rpartition("_")
    return (name, "xyz".index(axis)) if name and axis in "xyz" else (field, -1)


class Frame:
    """Particles and surface of one frame."""

    def __init__(self, file, index, field):
        name, component = column(field)
        steps, data = file["VTKHDF/Steps"], file["VTKHDF/PointData"]
        first = steps["PointOffsets"][index] if "PointOffsets" in steps else 0
        part = slice(first, first + file["VTKHDF/NumberOfPoints"][index])
        inside = data["kind"][part] == PARTICLE
        values = data[name][part][inside]
        self.time = steps["Values"][index]
        self.points = file["VTKHDF/Points"][part][inside]
        self.body = data["body"][part][inside]
        self.values = magnitude(values) if component < 0 else values[:, component]
        surface = file["surface"]
        vertices, pieces = surface["NumberOfPoints"][:], surface["NumberOfCells"][:]
        v, p = vertices[:index].sum(), pieces[:index].sum()
        self.vertex = surface["Points"][v:v + vertices[index]]
        self.piece = surface["Connectivity"][p:p + pieces[index]]
        self.owner = surface["PointData/body"][v:v + vertices[index]]

    def spacing(self):
        first = self.points[self.body == self.body[0]]
        return (np.prod(np.ptp(first, axis=0)) / len(first)) ** (1 / 3)


def surface_of(frame, body):
    """Triangles of one body, welded, with normals that keep its edges."""
    mesh = triangles(frame.vertex, frame.piece[frame.owner[frame.piece[:, 0]] == body])
    clean, normals = vtk.vtkCleanPolyData(), vtk.vtkPolyDataNormals()
    clean.SetInputData(mesh)
    clean.SetToleranceIsAbsolute(True)
    clean.SetAbsoluteTolerance(1e-2 * frame.spacing())
    clean.ConvertPolysToLinesOff()
    clean.ConvertLinesToPointsOff()
    normals.SetInputConnection(clean.GetOutputPort())
    normals.SetFeatureAngle(50)
    normals.ConsistencyOn()
    normals.AutoOrientNormalsOn()
    normals.Update()
    return normals.GetOutput()


def triangles(points, pieces):
    mesh, places, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(pieces.ravel()), deep=True))
    mesh.SetPoints(places)
    mesh.SetPolys(cells)
    return mesh


def coloured(mesh, frame, body):
    """The field of the nearby particles of a body at the points of a mesh."""
    cloud, mine = vtk.vtkPolyData(), frame.body == body
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(frame.points[mine]), deep=True))
    cloud.SetPoints(places)
    values = numpy_to_vtk(np.ascontiguousarray(frame.values[mine], dtype=float), deep=True)
    values.SetName("value")
    cloud.GetPointData().AddArray(values)
    kernel, interpolator = vtk.vtkGaussianKernel(), vtk.vtkPointInterpolator()
    kernel.SetKernelFootprintToNClosest()
    kernel.SetNumberOfPoints(12)
    kernel.SetSharpness(3)
    kernel.SetRadius(2 * frame.spacing())
    interpolator.SetInputData(mesh)
    interpolator.SetSourceData(cloud)
    interpolator.SetKernel(kernel)
    interpolator.Update()
    mesh = interpolator.GetOutput()
    mesh.GetPointData().SetActiveScalars("value")
    mesh.GetPointData().SetActiveNormals("Normals")
    return mesh


def clipped(mesh, plane):
    clip = vtk.vtkClipPolyData()
    clip.SetInputData(mesh)
    clip.SetClipFunction(plane)
    clip.Update()
    return clip.GetOutput()


def section(mesh, origin, axis, spacing, lift):
    """The part of the plane across an axis that lies inside a closed mesh, in fine triangles.
    `lift` moves it along the axis, so that it lies in front of walls that end in the plane."""
    bounds = np.array(mesh.GetBounds()).reshape(3, 2)
    kept = [a for a in range(3) if a != axis]
    low, high = bounds[:, 0] - spacing, bounds[:, 1] + spacing
    low[axis] = high[axis] = origin[axis]
    corners = low.copy(), low.copy(), low.copy()
    corners[1][kept[0]], corners[2][kept[1]] = high[kept[0]], high[kept[1]]
    source, clip, away = vtk.vtkPlaneSource(), vtk.vtkClipPolyData(), vtk.vtkImplicitPolyDataDistance()
    source.SetOrigin(corners[0])
    source.SetPoint1(corners[1])
    source.SetPoint2(corners[2])
    source.SetResolution(*(int(np.ceil(6 * (high[a] - low[a]) / spacing)) for a in kept))
    source.Update()
    plane = source.GetOutput()
    points = vtk_to_numpy(plane.GetPoints().GetData())
    outline = outline_of(mesh, axis, origin)
    distance = vtk.vtkDoubleArray()
    away.SetInput(mesh)
    away.FunctionValue(plane.GetPoints().GetData(), distance)
    signed = np.abs(vtk_to_numpy(distance))
    # Off the lattice, so that no ray runs through a corner of the outline.
    signed[is_inside(points[:, kept] + 1e-3 * spacing, outline[:, :, kept])] *= -1
    values = numpy_to_vtk(signed, deep=True)
    plane.GetPointData().SetScalars(values)
    clip.SetInputData(plane)
    clip.InsideOutOn()
    clip.Update()
    cut = clip.GetOutput()
    vtk_to_numpy(cut.GetPoints().GetData())[:, axis] += lift
    return cut


def outline_of(mesh, axis, origin):
    """Segments [segment][2][3] in which a mesh meets the plane across an axis."""
    plane, cutter = vtk.vtkPlane(), vtk.vtkCutter()
    plane.SetOrigin(origin)
    plane.SetNormal(np.eye(3)[axis])
    cutter.SetInputData(mesh)
    cutter.SetCutFunction(plane)
    cutter.Update()
    cut = cutter.GetOutput()
    pairs = vtk_to_numpy(cut.GetLines().GetConnectivityArray()).reshape(-1, 2)
    return vtk_to_numpy(cut.GetPoints().GetData())[pairs]


def is_inside(points, segments):
    """Whether points lie within an outline of segments [segment][2][2]. Where a wall holds a body its
    outline is open, so that two of the four rays along the axes suffice: those that cross an odd
    number of segments."""
    turned = [(points, segments), (points[:, ::-1], segments[:, :, ::-1])]
    votes = sum(crossings(sign * x, sign * s) % 2 for x, s in turned for sign in (1, -1))
    return votes >= 2


def crossings(points, segments):
    """How many segments a ray upwards from each point meets."""
    count = np.zeros(len(points), dtype=int)
    for (x0, y0), (x1, y1) in segments:
        across = (points[:, 0] < x0) != (points[:, 0] < x1)
        if x0 != x1:
            height = y0 + (points[:, 0] - x0) * (y1 - y0) / (x1 - x0)
            count += across & (points[:, 1] < height)
    return count

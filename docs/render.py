#!/usr/bin/env python3
"""Renders the surface of bodies in 3D, shaded and coloured by a field.

    docs/render.py results/liver_aspiration picture.png --cut y --walls
    docs/render.py results/organ picture.png --times 0 0.06 0.12 --field velocity

The run needs `output.surface = true`. `--cut y` opens the bodies at their middle and shows the
field inside; `--walls` draws the solids of fixed walls and of contact walls too. Needs
python3-vtk9, python3-h5py, python3-matplotlib and, without a display, `xvfb-run -a` before it.
"""
import argparse
import pathlib
import tomllib

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import frame_surface
import wall_shapes

def shown(mesh, colours, limits, flat):
    mapper, actor = vtk.vtkPolyDataMapper(), vtk.vtkActor()
    mapper.SetInputData(mesh)
    mapper.SetLookupTable(colours)
    mapper.SetScalarRange(*limits)
    mapper.InterpolateScalarsBeforeMappingOn()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToPhong()
    look.SetAmbient(0.75 if flat else 0.25)
    look.SetDiffuse(0.3 if flat else 0.85)
    look.SetSpecular(0.0 if flat else 0.35)
    look.SetSpecularPower(30)
    return actor


def wall(mesh):
    actor = shown(mesh, None, (0, 1), False)
    actor.GetMapper().ScalarVisibilityOff()
    actor.GetProperty().SetColor(0.72, 0.75, 0.79)
    actor.GetProperty().SetSpecular(0.1)
    return actor


def lookup(name):
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *matplotlib.colormaps[name](i / 255))
    table.Build()
    return table


class Scene:
    """The bodies and walls of one frame."""

    def __init__(self, arguments, box, limits):
        self.arguments, self.box, self.limits = arguments, box, limits
        self.colours = lookup(arguments.colours)
        self.origin = box.mean(axis=0)
        self.axis = "xyz".index(arguments.cut) if arguments.cut else None
        self.up = np.eye(3)["xyz".index(arguments.up)]
        self.towards = self.direction(*np.radians(arguments.view))
        self.plane = vtk.vtkPlane()
        if self.axis is not None:
            away = -np.sign(self.towards[self.axis]) * np.eye(3)[self.axis]
            self.plane.SetOrigin(self.origin)
            self.plane.SetNormal(away)

    def direction(self, azimuth, elevation):
        """From the middle to the camera: turned about the upward axis, then raised."""
        first = np.roll(self.up, 1)
        second = np.cross(self.up, first)
        flat = np.cos(azimuth) * first + np.sin(azimuth) * second
        return np.cos(elevation) * flat + np.sin(elevation) * self.up

    def actors(self, frame, case):
        for body in np.unique(frame.body):
            outside = frame_surface.surface_of(frame, body)
            if self.axis is not None:
                lift = 0.02 * frame.spacing() * np.sign(self.towards[self.axis])
                inside = frame_surface.section(outside, self.origin, self.axis, frame.spacing(), lift)
                outside = frame_surface.clipped(outside, self.plane)
                yield shown(frame_surface.coloured(inside, frame, body), self.colours, self.limits, True)
            yield shown(frame_surface.coloured(outside, frame, body), self.colours, self.limits, False)
        if self.arguments.walls:
            yield wall(wall_shapes.surface(case, frame.time, self.wall_box(),
                                           self.plane if self.axis is not None else None))

    def wall_box(self):
        margin = self.arguments.margin * np.ptp(self.box, axis=0).max()
        return np.array([self.box[0] - margin, self.box[1] + margin])

    def image(self, frame, case, size):
        """Pixels [row][column][3] of one frame."""
        renderer = vtk.vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        for actor in self.actors(frame, case):
            renderer.AddActor(actor)
        self.light(renderer)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(self.origin)
        camera.SetPosition(self.origin + self.towards)
        camera.SetViewUp(self.up)
        camera.SetViewAngle(20)
        bounds = self.wall_box() if self.arguments.walls else self.box
        renderer.ResetCamera(*bounds.T.ravel())
        camera.Zoom(self.arguments.zoom)
        renderer.ResetCameraClippingRange()
        return pixels(renderer, size)

    def light(self, renderer):
        """Three lights, and corners that less light reaches."""
        kit = vtk.vtkLightKit()
        kit.SetKeyLightAngle(40, -35)
        kit.SetKeyToFillRatio(2)
        kit.SetKeyLightWarmth(0.55)
        kit.AddLightsToRenderer(renderer)
        size = np.ptp(self.box, axis=0).max()
        occlusion, edges = vtk.vtkSSAOPass(), vtk.vtkOpenGLFXAAPass()
        occlusion.SetRadius(0.15 * size)
        occlusion.SetBias(0.002 * size)
        occlusion.SetKernelSize(64)
        occlusion.BlurOn()
        occlusion.SetDelegatePass(vtk.vtkRenderStepsPass())
        edges.SetDelegatePass(occlusion)
        renderer.SetPass(edges)


def pixels(renderer, size):
    window, grab = vtk.vtkRenderWindow(), vtk.vtkWindowToImageFilter()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, 3)[::-1]


def trimmed(images, margin=12):
    """The images without the white rows and columns that all of them have at their edges."""
    seen = np.any([image.min(axis=2) < 250 for image in images], axis=0)
    rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
    part = (slice(max(rows[0] - margin, 0), rows[-1] + margin),
            slice(max(columns[0] - margin, 0), columns[-1] + margin))
    return [image[part] for image in images]


def draw(path, images, titles, limits, colours, label):
    """The images side by side over one bar of colours."""
    rows, columns, _ = images[0].shape
    figure, axes = plt.subplots(1, len(images), squeeze=False, layout="constrained",
                                figsize=(columns * len(images) / 100, rows / 100 + 1))
    for axis, image, title in zip(axes.flat, images, titles):
        axis.imshow(image, interpolation="none")
        axis.set_title(title)
        axis.axis("off")
    scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*limits), colours)
    figure.colorbar(scale, ax=axes, label=label, location="bottom", shrink=0.5, aspect=40,
                    fraction=0.05, pad=0.01)
    figure.savefig(path, dpi=100, pil_kwargs={"optimize": True})


def options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture")
    parser.add_argument("--field", default="displacement",
                        help="its magnitude, or a component, as in velocity_y")
    parser.add_argument("--label", help="what the colour bar says (default: the field)")
    parser.add_argument("--scale", type=float, default=1, help="factor of the colour bar's numbers")
    parser.add_argument("--range", type=float, nargs=2, help="ends of the colours")
    parser.add_argument("--times", type=float, nargs="+", help="frames nearest to them (default: last)")
    parser.add_argument("--cut", choices="xyz", help="open the bodies across this axis")
    parser.add_argument("--walls", action="store_true", help="draw the walls")
    parser.add_argument("--margin", type=float, default=0.1, help="of walls around the bodies")
    parser.add_argument("--up", choices="xyz", default="z")
    parser.add_argument("--view", type=float, nargs=2, default=[-60, 25],
                        metavar=("AZIMUTH", "ELEVATION"), help="of the camera, degrees")
    parser.add_argument("--zoom", type=float, default=1.2)
    parser.add_argument("--colours", default="plasma", help="a colour map of matplotlib")
    parser.add_argument("--size", type=int, nargs=2, default=[1100, 800])
    return parser.parse_args()


def main():
    arguments = options()
    with h5py.File(arguments.folder / "result.h5", "r") as file:
        if "surface" not in file:
            raise SystemExit("this result has no surface; run with --set output.surface=true")
        times = file["VTKHDF/Steps/Values"][:]
        wanted = arguments.times or [times[-1]]
        frames = [frame_surface.Frame(file, int(np.abs(times - t).argmin()), arguments.field) for t in wanted]
        case = tomllib.loads(file["run/case.toml"][()].decode())
    for frame in frames:
        frame.values = frame.values * arguments.scale
    points = np.concatenate([frame.points for frame in frames])
    box = np.array([points.min(axis=0), points.max(axis=0)])
    limits = arguments.range or [min(frame.values.min() for frame in frames),
                                 max(frame.values.max() for frame in frames)]
    scene = Scene(arguments, box, limits)
    size = arguments.size[0] // len(frames), arguments.size[1]
    images = [scene.image(frame, case, size) for frame in frames]
    titles = [f"t = {frame.time:.4g} s" if len(frames) > 1 else "" for frame in frames]
    draw(arguments.picture, trimmed(images), titles, limits, arguments.colours,
         arguments.label or arguments.field)


if __name__ == "__main__":
    main()

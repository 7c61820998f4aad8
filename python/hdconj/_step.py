# SPDX-License-Identifier: GPL-3.0-or-later
"""Rings between two planes as solids of Open CASCADE, and STEP files of them."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NamedTuple, Union

import numpy as np
from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeVertex
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.collections import Array1_double, Array1_int, Array2_gp_Pnt
from OCP.Geom import Geom_BSplineSurface, Geom_CylindricalSurface, Geom_Plane
from OCP.Geom2d import Geom2d_Line
from OCP.gp import gp_Ax3, gp_Dir, gp_Dir2d, gp_Pnt, gp_Pnt2d
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.Message import Message, Message_Gravity
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDocStd import TDocStd_Document
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Face, TopoDS_Shell, TopoDS_Solid, TopoDS_Wire
from OCP.XCAFApp import XCAFApp_Application
from OCP.XCAFDoc import XCAFDoc_DocumentTool

from ._errors import FileError
from ._files import write_whole
from ._loft import Strip

CLOSE = 1e-6  # mm; edges of neighbours agree to less


class Loop(NamedTuple):
    """Walls around the axis, each joined to the next and the last to the first; or a cylinder of that radius."""

    walls: Union[Sequence[Strip], float]
    is_hole: bool
    """Whether the material is outside of it."""


class _Wall(NamedTuple):
    surface: Any
    first: float
    last: float


def _compressed(knots: Any) -> tuple[Any, Any]:
    values, times = np.unique(knots, return_counts=True)
    made, counts = Array1_double(1, len(values)), Array1_int(1, len(values))
    for i, (value, count) in enumerate(zip(values, times), 1):
        made.SetValue(i, float(value))
        counts.SetValue(i, int(count))
    return made, counts


def _spline(strip: Strip) -> _Wall:
    rows, columns = strip.poles.shape[:2]
    poles = Array2_gp_Pnt(1, columns, 1, rows)
    for i in range(columns):
        for j in range(rows):
            poles.SetValue(i + 1, j + 1, gp_Pnt(*strip.poles[j, i].tolist()))
    (u, u_times), (v, v_times) = _compressed(strip.knots), _compressed(strip.z_knots)
    made = Geom_BSplineSurface(poles, u, v, u_times, v_times, strip.degree, strip.z_degree)
    return _Wall(made, float(strip.knots[0]), float(strip.knots[-1]))


def _walls(loop: Loop) -> list[_Wall]:
    if isinstance(loop.walls, float):
        axes, halves = gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), ((0.0, np.pi), (np.pi, 2 * np.pi))
        return [_Wall(Geom_CylindricalSurface(axes, loop.walls), *half) for half in halves]
    return [_spline(strip) for strip in loop.walls]


class _Shell:
    """Faces with common edges, between the planes at low and high."""

    def __init__(self, low: float, high: float) -> None:
        self.low, self.high = low, high
        self.build = BRep_Builder()
        self.shell = TopoDS_Shell()
        self.build.MakeShell(self.shell)

    def wire(self, edges: Sequence[Any]) -> Any:
        made = TopoDS_Wire()
        self.build.MakeWire(made)
        for edge in edges:
            self.build.Add(made, edge)
        made.Closed(True)
        return made

    def face(self, wall: _Wall, edges: Sequence[Any], forward: bool) -> None:
        """Edges: bottom, next side, top, own side; all run with the parameters of the surface."""
        bottom, after, top, before = edges
        made = TopoDS_Face()
        self.build.MakeFace(made, wall.surface, CLOSE)
        lines = ((bottom, 0, self.low, 1, 0), (top, 0, self.high, 1, 0), (before, wall.first, 0, 0, 1),
                 (after, wall.last, 0, 0, 1))  # fmt: skip
        for edge, x, y, dx, dy in lines:
            line = Geom2d_Line(gp_Pnt2d(x, y), gp_Dir2d(dx, dy))
            self.build.UpdateEdge(edge, line, wall.surface, TopLoc_Location(), CLOSE)
        self.build.Add(made, self.wire([bottom, after, top.Reversed(), before.Reversed()]))
        self.build.Add(self.shell, made if forward else made.Reversed())

    def loop(self, loop: Loop) -> tuple[Any, Any]:
        """Adds the walls; returns the wires of both planes, as the planes' upward faces have them."""
        walls = _walls(loop)
        # Walls of outlines run clockwise, cylinders counter-clockwise: normals point to the axis, or outward.
        forward = loop.is_hole != isinstance(loop.walls, float)
        corners = [
            [BRepBuilderAPI_MakeVertex(wall.surface.Value(wall.first, z)).Vertex() for wall in walls]
            for z in (self.low, self.high)
        ]
        sides: list[Any] = []
        bottoms: list[Any] = []
        tops: list[Any] = []
        for i, wall in enumerate(walls):
            after = (i + 1) % len(walls)
            side = wall.surface.UIso(wall.first)
            sides.append(BRepBuilderAPI_MakeEdge(side, corners[0][i], corners[1][i], self.low, self.high).Edge())
            for z, ends, edges in ((self.low, corners[0], bottoms), (self.high, corners[1], tops)):
                curve = wall.surface.VIso(z)
                made = BRepBuilderAPI_MakeEdge(curve, ends[i], ends[after], wall.first, wall.last)
                edges.append(made.Edge())
        for i, wall in enumerate(walls):
            self.face(wall, (bottoms[i], sides[(i + 1) % len(walls)], tops[i], sides[i]), forward)
        if not forward:
            bottoms, tops = ([edge.Reversed() for edge in edges] for edges in (bottoms, tops))
        return self.wire(bottoms), self.wire(tops)

    def caps(self, outer: tuple[Any, Any], holes: Sequence[tuple[Any, Any]]) -> None:
        for i, z in enumerate((self.low, self.high)):
            plane = Geom_Plane(gp_Ax3(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)))
            made = BRepBuilderAPI_MakeFace(plane, outer[i], True)
            for hole in holes:
                made.Add(hole[i])
            face = made.Face()
            self.build.Add(self.shell, face if i else face.Reversed())


def solid_of(outer: Loop, hole: Loop, low: float, high: float) -> Any:
    """The closed solid between two loops and two planes."""
    shell = _Shell(low, high)
    shell.caps(shell.loop(outer), [shell.loop(hole)])
    shell.shell.Closed(True)
    solid = TopoDS_Solid()
    shell.build.MakeSolid(solid)
    shell.build.Add(solid, shell.shell)
    return solid


def is_sound(solid: Any) -> bool:
    """Whether Open CASCADE finds nothing to object to."""
    return bool(BRepCheck_Analyzer(solid).IsValid())


def volume_of(solid: Any) -> float:
    """In mm^3; negative where the solid is inside out."""
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(solid, found, 1e-6)  # relative error; without it 1e-3
    return float(found.Mass())


@contextmanager
def _quiet() -> Iterator[None]:
    """Open CASCADE says on standard output what it writes."""
    printers = list(Message.DefaultMessenger_s().Printers())
    levels = [printer.GetTraceLevel() for printer in printers]
    for printer in printers:
        printer.SetTraceLevel(Message_Gravity.Message_Fail)
    try:
        yield
    finally:
        for printer, level in zip(printers, levels):
            printer.SetTraceLevel(level)


def write(solids: dict[str, Any], file: str | os.PathLike[str]) -> None:
    """Write named solids in mm, whole or not at all."""
    document = TDocStd_Document(TCollection_ExtendedString("BinXCAF"))
    XCAFApp_Application.GetApplication_s().InitDocument(document)
    tool = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    for name, solid in solids.items():
        TDataStd_Name.Set_s(tool.AddShape(solid, False), TCollection_ExtendedString(name))

    def fill(name: str) -> None:
        with _quiet():
            writer = STEPCAFControl_Writer()
            if not writer.Transfer(document) or writer.Write(name) != IFSelect_ReturnStatus.IFSelect_RetDone:
                raise FileError(f"{file}: Open CASCADE could not write it")

    write_whole(file, fill)

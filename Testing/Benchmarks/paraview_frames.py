#!/usr/bin/env python3
"""What a picture takes in ParaView: the first one, reading included; another camera, plane, colours.

    with-paraview.sh pvpython paraview_frames.py FILE FIELD

FIELD: of the points. Milliseconds of 800 x 600 pixels, medians of 20 pictures each; run it where
there is a display (xvfb-run) and no other work.
"""

import math
import statistics
import sys
import time

from paraview.simple import (
    ColorBy,
    CreateView,
    GetColorTransferFunction,
    OpenDataFile,
    Render,
    ResetCamera,
    Show,
)

PICTURES = 20


def milliseconds(work):
    begin = time.perf_counter()
    work()
    return 1e3 * (time.perf_counter() - begin)


def median(view, change):
    times = []
    for k in range(PICTURES):
        change(k)
        times.append(milliseconds(view.SMProxy.StillRender))
    return statistics.median(times)


def main():
    name, field = sys.argv[1:]
    begin = time.perf_counter()
    source = OpenDataFile(name)
    source.UpdatePipeline()
    box = source.GetDataInformation().GetBounds()
    view = CreateView("RenderView")
    view.ViewSize, view.OrientationAxesVisibility = [800, 600], 0
    shown = Show(source, view)
    shown.SetRepresentationType("PixelExact")
    ColorBy(shown, ("POINTS", field))
    shown.CutFunction.Normal = [0, 0, 1]
    ResetCamera(view)
    Render(view)
    first = 1e3 * (time.perf_counter() - begin)
    centre = list(view.CameraFocalPoint)
    distance = math.dist(view.CameraPosition, centre)
    colors = GetColorTransferFunction(field)

    def turn(k):
        angle = 0.3 + 0.02 * k
        view.CameraPosition = [
            centre[0] + distance * math.sin(angle),
            centre[1] + 0.1 * distance,
            centre[2] + distance * math.cos(angle),
        ]

    def move(k):
        shown.CutFunction.Origin = [*centre[:2], box[4] + (box[5] - box[4]) * (0.3 + 0.02 * k)]

    turned, moved = median(view, turn), median(view, move)
    recolored = median(view, lambda k: colors.RescaleTransferFunction(-1.0 - 0.01 * k, 1.0))
    print(f"first {first:.0f}, camera {turned:.0f}, plane {moved:.0f}, colours {recolored:.0f} ms")


main()

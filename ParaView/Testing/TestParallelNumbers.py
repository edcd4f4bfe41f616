"""Filters, picks, selections and reports give the same in two and three processes as in one."""

import os
import shutil
import subprocess
import unittest

import numbers_of
import pictures
import scene

# How many processes, and the script's arguments.
CASES = {
    "parts": (2, "plain", "toroid_prism_g3_p4.vtu"),
    "parts_with_neighbours": (3, "lines", "escher_tet_g3_p3.vtu"),
    "redistributed": (3, "redistributed", "toroid_hex_g3_p6.vtu"),
    "blocks": (2, "blocks", "toroid_hex_g3_p6.vtu", "toroid_prism_g3_p4.vtu"),
    "solver": (2, "plain", "nek_tet_varp/nek_tet_varp.xml"),
}


@unittest.skipIf(shutil.which("mpirun") is None, "there is no mpirun")
class ParallelNumbers(unittest.TestCase):
    def run_script(self, script, processes, *arguments):
        return subprocess.run(
            ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(processes)]
            + ["pvbatch", "--mpi", script, *arguments],
            env=pictures.environment(),
            capture_output=True,
            text=True,
            timeout=200,
        )

    def numbers(self, name, processes):
        _, kind, *files = CASES[name]
        answers = os.path.join(scene.PICTURES, f"numbers_{name}_{processes}.json")
        files = [scene.data(file) for file in files]
        done = self.run_script(numbers_of.script(), processes, kind, answers, *files)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("ERR|", done.stdout + done.stderr)
        return numbers_of.read(answers)

    def test_the_same(self):
        for name, (processes, *_) in CASES.items():
            with self.subTest(name):
                alone = self.numbers(name, 1)
                self.assertGreater(sum(point[0] == 1 for point in alone["picked"]), 3)
                numbers_of.compare(self, self.numbers(name, processes), alone)

    def test_processes_without_cells(self):
        script = os.path.join(scene.PICTURES, "one_cell_script.py")
        with open(script, "w") as file:
            file.write(ONE_CELL)
        told = []
        for processes in (1, 3):
            done = self.run_script(script, processes, scene.data("adversarial/pinched_hexahedron.vtu"))
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertNotIn("ERR|", done.stdout + done.stderr)
            told.append(done.stdout[done.stdout.index("PixelExact") :])
        self.assertEqual(told[1], told[0])

    def test_what_fails_fails_everywhere(self):
        # Else the processes behind would wait for the first one.
        script = os.path.join(scene.PICTURES, "failing_script.py")
        with open(script, "w") as file:
            file.write(FAILING)
        done = self.run_script(script, 2, scene.data("toroid_hex_g3_p6.vtu"))
        said = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, said)
        self.assertIn("Point1 and Point2 must be finite, and not the same", said)
        self.assertIn("there is no field 'w'", said)
        self.assertIn("points in blocks are not probed in several processes", said)
        self.assertIn("came to the end: 0 points", said)


FAILING = """
import sys
from paraview.simple import *
from paraview import servermanager
grid = PixelExactGridReader(FileName=sys.argv[1:2])
line = PixelExactPlotOverLine(Input=grid, Point1=[1, 1, 1], Point2=[1, 1, 1])
servermanager.Fetch(line)
integral = PixelExactIntegrate(Input=grid, Field="w")
servermanager.Fetch(integral)
lines = GroupDatasets(Input=[Line(), Line(Point1=[1, 1, 1])])
servermanager.Fetch(PixelExactProbe(Input=lines, Source=grid))
print("came to the end:", servermanager.Fetch(line).GetNumberOfPoints(), "points")
"""

ONE_CELL = """
import sys
from paraview.simple import *
from paraview import servermanager
grid = PixelExactGridReader(FileName=sys.argv[1:2])
grid.UpdatePipeline()
truncated = PixelExactTruncate(Input=grid)
for filter in (
    PixelExactConvert(Input=grid),
    PixelExactPack(Input=grid),
    PixelExactCertify(Input=grid),
    PixelExactSubdivide(Input=grid),
    truncated,
):
    filter.UpdatePipeline()
    print(filter.SMProxy.GetXMLName(), filter.GetDataInformation().GetNumberOfCells())
blocks = GroupDatasets(Input=[grid, PixelExactGridReader(FileName=sys.argv[1:2])])
blocks.UpdatePipeline()
for filter in (PixelExactCertify(Input=blocks), PixelExactTruncate(Input=blocks), PixelExactSubdivide(Input=blocks)):
    filter.UpdatePipeline()
    print("of blocks", filter.SMProxy.GetXMLName(), filter.GetDataInformation().GetNumberOfCells())
change = servermanager.Fetch(truncated).GetFieldData().GetArray("u_LargestChange").GetValue(0)
print("change %.6g" % change)
shown = Show(grid)
shown.SetRepresentationType("PixelExact")
ColorBy(shown, ("POINTS", "u"))
Render()
shown.UpdatePropertyInformation()
print("range %.9g %.9g" % tuple(shown.GetProperty("FieldRange")), shown.GetProperty("UnknownPixels")[0])
"""

if __name__ == "__main__":
    scene.main()

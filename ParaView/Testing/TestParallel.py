"""Two and four processes give the picture of one."""

import os
import shutil
import subprocess
import unittest

import numpy

import pictures
import scene

NEK = ("nek_tet_varp/nek_tet_varp.xml",)
# Script's arguments, how many processes, and by how much the pictures may differ: pixels, levels of
# a byte.
CASES = {
    "cut": (("cut", "toroid_hex_g3_p6.vtu"), (2, 4), 0, 0),
    "iso": (("iso", "escher_tet_g3_p3.vtu"), (2,), 0, 0),
    "slice": (("slice", "toroid_hex_g3_p6.vtu"), (2,), 0, 0),
    "clip": (("clip", "toroid_hex_g3_p6.vtu"), (3,), 0, 0),
    "packed": (("packed", "toroid_hex_g3_p6.vtu"), (2,), 0, 0),
    # Seen through, so that walls between the parts would show; blending rounds once more. Not of four:
    # ParaView blends processes in the order of their boxes, and theirs overlap.
    "boundary": (("boundary", *NEK), (2,), 320 * 240, 1),
    "boundary_opaque": (("boundary_opaque", *NEK), (4,), 0, 0),
    # Lines are decided by pixels' corners, which may be in another process' part.
    "contours": (("contours", "toroid_hex_g3_p6.vtu"), (2, 4), 0, 0),
    "contours_edges": (("contours_edges", "escher_tet_g3_p3.vtu"), (4,), 0, 0),
    "edges_dg": (("edges", "periodic_hex_dg_g3_p4.vtu"), (3,), 0, 0),
    "contours_orders": (("contours_edges", *NEK), (3,), 0, 0),
}


@unittest.skipIf(shutil.which("mpirun") is None, "there is no mpirun")
class Parallel(unittest.TestCase):
    def draw(self, name, arguments, processes):
        """The picture, and what was said."""
        picture = os.path.join(scene.PICTURES, f"parallel_{name}_{processes}.png")
        kind, *files = arguments
        # --sym: every process runs the script, as the processes of a batch job do.
        done = subprocess.run(
            ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(processes)]
            + ["pvbatch", "--mpi", "--sym", pictures.script(), kind, picture]
            + [scene.data(file) for file in files],
            env=pictures.environment(),
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("ERR|", done.stdout + done.stderr)
        return pictures.read(picture), done.stdout + done.stderr

    def picture(self, name, processes):
        return self.draw(name, CASES[name][0], processes)[0]

    def test_walls_are_refused(self):
        alone = self.picture("iso", 1)
        rgb, said = self.draw("walls", ("iso_walls", *CASES["iso"][0][1:]), 2)
        self.assertIn("jump walls are not shown", said)
        self.assertTrue((rgb == alone).all())

    def test_the_same(self):
        for name, (_, counts, pixels, levels) in CASES.items():
            with self.subTest(name):
                alone = self.picture(name, 1)
                for processes in counts:
                    off = numpy.abs(self.picture(name, processes) - alone).max(axis=-1)
                    self.assertLessEqual(numpy.count_nonzero(off), pixels, processes)
                    self.assertLessEqual(off.max(), levels, processes)


if __name__ == "__main__":
    scene.main()

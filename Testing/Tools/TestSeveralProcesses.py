# SPDX-License-Identifier: BSD-3-Clause
"""mpirun pixelexact render: several processes make the picture and the buffers of one, bit for bit."""

import os
import shutil
import subprocess
import unittest
from pathlib import Path

import numpy as np

import tool
from shells import Patches
from tool import DATA, ToolTest, case, read_buffers, read_image

MPIRUN = shutil.which("mpirun")
# Those of an MPI that runs this test, and what it needs of a machine with few cores.
OWN = {k: v for k, v in os.environ.items() if not k.startswith(("OMPI_", "PMIX_", "PMI_", "ORTE_"))}
OWN |= {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_rmaps_base_oversubscribe": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
    # The same for Open MPI 5.
    "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",
    "PRTE_MCA_hwloc_default_binding_policy": "none",
    # And for 6, which complains of these names where it has not its own.
    "PRTE_MCA_mapby": ":oversubscribe",
    "PRTE_MCA_bindto": "none",
    # On one machine; where it has no network Open MPI 5 complains.
    "OMPI_MCA_btl": "^tcp",
}
NEK = DATA / "nek_tet_varp"
FOLDED = DATA / "mfem_escher_tet_darcy_p3"

CASES = {
    "plane": (case("toroid_hex_g3_p6"), "--plane", "0,0,0,0,0,1"),
    "nothing said": (case("fichera_hex_g3_p4"),),
    "sphere and torus, translucent": (
        case("toroid_prism_g3_p4"),
        *("--sphere", "0.6,0,0,0.7", "--torus", "0,0,0,0,0,1,1,0.25"),
        *("--layer", "1:opacity=0.4", "--samples", "4"),
    ),
    "contours and edges": (
        case("toroid_hex_g3_p6"),
        *("--plane", "0,0,0,0.2,0.1,1", "--contours", "9", "--contour-labels", "--edges"),
    ),
    "iso-surface": (case("escher_tet_g3_p3"), "--isosurface", "u=0.2"),
    "expression on an iso-surface of one": (
        case("toroid_hex_g3_p6"),
        *("--isosurface", "u*u=0.01", "--field", "mag(grad(u)) + element"),
    ),
    "boundary": (case("escher_tet_g3_p3"), "--boundary", "--view", "iso"),
    "boundary of hexahedra": (case("fichera_hex_g3_p4"), "--boundary", "--view", "iso"),
    "boundary, some attributes": (FOLDED / "mfem_escher_tet_darcy_p3.mesh", FOLDED / "flux.gf")
    + ("--boundary=1", "--view", "iso"),
    "owners of points on faces": (case("fichera_hex_g3_p4"), "--plane", "0,0,0,0,0,1", "--owners"),
    "orders that vary": (NEK / "nek_tet_varp.xml", NEK / "nek_tet_varp.fld"),
}


def words(text):
    return [str(word) for word in text]


@unittest.skipIf(MPIRUN is None, "there is no mpirun")
@unittest.skipUnless(
    Path(tool.TOOL).with_name("pixelexact-mpi").exists(), "pixelexact-mpi was not built"
)
class SeveralProcesses(ToolTest):
    def mpirun(self, processes, *arguments):
        return subprocess.run(
            [MPIRUN, "-n", str(processes), tool.TOOL, *words(arguments)],
            env={k: v for k, v in OWN.items() if k != "DISPLAY"},
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )

    def rendered(self, processes, arguments):
        name = self.folder / f"of_{processes}"
        words = ("render", *arguments, "--size", "150x120", "--threads", "1", "--json")
        words += ("--output", f"{name}.png", "--buffers", f"{name}.vti")
        done = tool.run(*words) if processes == 1 else self.mpirun(processes, *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = tool.strict_json(done.stdout)
        for of_the_run in ("command", "seconds", "location"):
            del summary[of_the_run]
        return summary, read_image(f"{name}.png"), read_buffers(f"{name}.vti"), done.stderr

    def same(self, arguments, counts=(2, 3)):
        summary, image, buffers, said = self.rendered(1, arguments)
        self.assertGreater(summary["pixels"]["exact"], 500)
        for processes in counts:
            of_all = self.rendered(processes, arguments)
            self.assertEqual(of_all[0], summary)
            np.testing.assert_array_equal(of_all[1], image)
            self.assertEqual(of_all[2].keys(), buffers.keys())
            for name, values in buffers.items():
                self.assertEqual(of_all[2][name].tobytes(), values.tobytes(), name)
            self.assertEqual(of_all[3], said)

    def test_the_same(self):
        for name, arguments in CASES.items():
            with self.subTest(name):
                self.same(arguments)

    def test_more_processes_than_elements(self):
        cube = self.folder / "cube.vtu"
        cube.write_text(tool.unit_cube_grid([("u", [x for x, _, _ in tool.CUBE])]))
        self.same((cube, "--plane", "0.5,0.5,0.5,0,0,1"), (3,))

    def test_surfaces_beside_solids(self):
        """In a file the cells of both kinds are mixed; of files one has no surface."""
        made = Patches(3, 3, lambda x, y: [x, y, 0.3 * x * y], "mixed")
        points = made.points + [[x + 2.0, y, z] for x, y, z in tool.CUBE]
        cells = made.cells[:7] + [(12, list(range(len(made.points), len(points))))] + made.cells[7:]
        mixed, cube, both = (self.folder / name for name in ("mixed.vtu", "cube.vtu", "both.pvd"))
        mixed.write_text(tool.plain_grid(points, cells, [("u", [p[0] for p in points])]), encoding="utf-8")
        self.same((mixed, "--surface-elements", "--view", "iso"))
        cube.write_text(tool.unit_cube_grid(), encoding="utf-8")
        both.write_text('<VTKFile type="Collection"><Collection>' + "".join(
            f'<DataSet timestep="0" part="{k}" file="{name}.vtu"/>' for k, name in enumerate(("mixed", "cube"))) +
            "</Collection></VTKFile>", encoding="utf-8")
        summary, image, _, _ = self.rendered(2, (both, "--surface-elements", "--view", "iso"))
        whole, expected, _, _ = self.rendered(1, (mixed, "--surface-elements", "--view", "iso"))
        self.assertEqual(summary["pixels"], whole["pixels"])
        np.testing.assert_array_equal(image, expected)

    def test_pieces(self):
        """Of a .pvtu each process reads its own files, and elements have the numbers of the whole."""
        self.write_pieces(case("toroid_prism_g3_p4"), 3)
        self.same((self.folder / "all.pvtu", "--plane", "0,0,0,0,0,1"), (2, 4))
        self.same((self.folder / "all.pvtu", "--boundary", "--view", "iso"), (2, 4))

    def test_duplicates_count_once(self):
        """Of pieces that share cells: of each two shared ones the second is the later piece's, and the
        first is marked in both."""
        self.write_pieces(case("toroid_prism_g3_p4"), 3, shared=2)
        shot = (self.folder / "all.pvtu", "--boundary", "--view", "iso")
        done = tool.run("render", *shot, "--output", self.folder / "one.png", "--size", "8x8")
        self.assertIn("2 cells marked as a duplicate", done.stderr)
        self.same(shot, (2, 3))
        whole = tool.run("info", case("toroid_prism_g3_p4")).stdout.splitlines()[0]
        parts = tool.run("info", self.folder / "all.pvtu").stdout.splitlines()[0]
        self.assertEqual(parts, whole)

    def write_pieces(self, file, count, shared=0):
        from vtkmodules.vtkCommonCore import vtkIdList, vtkUnsignedCharArray

        try:
            from vtkmodules.vtkFiltersExtraction import vtkExtractCells
        except ImportError:  # from VTK 9.3 on
            from vtkmodules.vtkFiltersCore import vtkExtractCells
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(file))
        reader.Update()
        cells = reader.GetOutput().GetNumberOfCells()
        names = []
        for piece in range(count):
            ids = vtkIdList()
            begin, end = cells * piece // count, cells * (piece + 1) // count
            end = min(end + shared, cells)
            for cell in range(begin, end):
                ids.InsertNextId(cell)
            extract = vtkExtractCells()
            extract.SetInputConnection(reader.GetOutputPort())
            extract.SetCellList(ids)
            extract.Update()
            grid = extract.GetOutput()
            if shared:
                marks = vtkUnsignedCharArray()
                marks.SetName("vtkGhostType")
                own = cells * (piece + 1) // count - begin
                for cell in range(end - begin):
                    marks.InsertNextValue(1 if cell >= own or (piece and cell == 0) else 0)
                grid.GetCellData().AddArray(marks)
            writer = vtkXMLUnstructuredGridWriter()
            names.append(f"piece_{piece}.vtu")
            writer.SetInputData(grid)
            writer.SetFileName(str(self.folder / names[-1]))
            writer.Write()
        pieces = "".join(f'<Piece Source="{name}"/>' for name in names)
        (self.folder / "all.pvtu").write_text(
            '<VTKFile type="PUnstructuredGrid" version="1.0"><PUnstructuredGrid GhostLevel="0">'
            f"{pieces}</PUnstructuredGrid></VTKFile>"
        )

    def refused(self, status, *arguments, names):
        done = self.mpirun(2, *arguments)
        self.assertEqual(done.returncode, status, done.stderr)
        said = [line for line in done.stderr.splitlines() if line.startswith("pixelexact: ")]
        self.assertEqual(len(said), 1, done.stderr)
        for name in names:
            self.assertIn(name, said[0])

    def test_what_is_for_one_process(self):
        file = case("fichera_hex_g3_p4")
        self.refused(2, "info", file, names=["one process"])
        self.refused(2, "render", file, "--range", "field", names=["--range field", "mpirun"])
        self.refused(2, "render", file, "--mesh-outline", names=["--mesh-outline"])
        self.refused(2, "render", file, "--sweep", "z=0:1:3", names=["animation"])

    def test_mistakes_are_told_once(self):
        self.refused(2, "render", case("fichera_hex_g3_p4"), "--size", "0x0", names=["--size"])
        self.refused(1, "render", self.folder / "absent.vtu", names=["absent.vtu"])
        file = case("fichera_hex_g3_p4")
        self.refused(1, "render", file, "--field", "none", names=["'none'"])
        # One process alone cannot read its part.
        self.write_pieces(case("toroid_prism_g3_p4"), 2)
        (self.folder / "piece_1.vtu").write_text("cut short")
        self.refused(1, "render", self.folder / "all.pvtu", names=["piece_1.vtu"])


class WithoutMpi(ToolTest):
    def test_the_program_is_named(self):
        """Started by an mpirun for whose processes there is no program."""
        alone = self.folder / "pixelexact"
        shutil.copy(tool.TOOL, alone)
        done = subprocess.run(
            [alone, "info", case("fichera_hex_g3_p4")],
            env=OWN | {"OMPI_COMM_WORLD_SIZE": "2", "PATH": ""},
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(done.returncode, 2)
        self.assertIn("pixelexact-mpi", done.stderr)


if __name__ == "__main__":
    unittest.main()

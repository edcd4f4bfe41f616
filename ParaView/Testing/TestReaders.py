"""Each reader's fields have the values that the solver's library computed."""

import os
import shutil
import sys
import tempfile
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, VTK_TRIANGLE, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

import scene

# The writers of the program's tests.
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Testing", "Tools"))
import hdf5  # noqa: E402

flexi = None
if hdf5.LIBRARY:
    import flexi  # noqa: E402

NEKTAR = [
    "nek_hex_aniso_p3p5p7",
    "nek_hex_gll_lagrange_p6",
    "nek_prism_curved_p7",
    "nek_pyramid_curved_p6",
    "nek_tet_varp",
]
GRIDS = ["dolfinx_hex_g2_p4", "escher_tet_g3_p3", "fichera_hex_g3_p4", "toroid_hex_g3_p6"]


class Readers(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def check(self, reader, oracle, field, inputs, columns=("u",)):
        table = scene.oracle(oracle)
        points, values = scene.numbers(table, "x", "y", "z"), scene.numbers(table, *columns)
        found = scene.probe(reader, points)
        scale = numpy.abs(values).max()
        # A face's point may lie outside by its rounding.
        inside = found["Verdict"] == 1
        self.assertGreater(inside.mean(), 0.95)
        mine = found[field].reshape(values.shape)
        self.assertLess(numpy.abs(mine - values)[inside].max(), 1e-9 * scale)
        theirs = inputs and scene.tool_values([scene.data(n) for n in inputs], field, points)
        if theirs is not None and len(theirs) > 0:
            self.assertTrue(numpy.array_equal(mine[inside], theirs[inside]))

    def test_nektar(self):
        for name in NEKTAR:
            with self.subTest(name):
                files = [f"{name}/{name}.xml", f"{name}/{name}.fld"]
                reader = simple.PixelExactNektarReader(FileName=[scene.data(files[0])])
                self.check(reader, f"{name}/oracle.csv", "u", files)

    def test_nektar_field_finds_its_session(self):
        name = "nek_tet_varp"
        files = [f"{name}/{name}.xml", f"{name}/{name}.fld"]
        reader = simple.PixelExactNektarReader(FileName=[scene.data(files[1])])
        self.check(reader, f"{name}/oracle.csv", "u", files)

    def test_nektar_steps(self):
        name = "nek_pyramid_curved_p6"
        with tempfile.TemporaryDirectory() as folder:
            session = os.path.join(folder, "run.xml")
            shutil.copy(scene.data(f"{name}/{name}.xml"), session)
            for step in "0", "2", "10":
                shutil.copy(
                    scene.data(f"{name}/{name}.fld"), os.path.join(folder, f"run_{step}.chk")
                )
            reader = simple.PixelExactNektarReader(FileName=[session])
            reader.UpdatePipelineInformation()
            self.assertEqual(list(reader.TimestepValues), [0.0, 1.0, 2.0])
            self.check(reader, f"{name}/oracle.csv", "u", [])
            one = simple.PixelExactNektarReader(FileName=[os.path.join(folder, "run_10.chk")])
            self.check(one, f"{name}/oracle.csv", "u", [])

    def test_mfem_of_several_meshes(self):
        name = "mfem_escher_tet_darcy_p3"
        with tempfile.TemporaryDirectory() as folder:
            for file in "escher.mesh", "other.mesh":
                shutil.copy(scene.data(f"{name}/{name}.mesh"), os.path.join(folder, file))
            for file in "escher_pressure.gf", "flux.gf":
                shutil.copy(
                    scene.data(f"{name}/{file.split('_')[-1]}"), os.path.join(folder, file)
                )
            reader = simple.PixelExactMFEMReader(FileName=os.path.join(folder, "escher.mesh"))
            reader.UpdatePipeline()
            self.assertIn("escher_pressure", reader.PointData.keys())
            self.assertNotIn("flux", reader.PointData.keys())

    def test_mfem(self):
        name = "mfem_escher_tet_darcy_p3"
        files = [f"{name}/{name}.mesh", f"{name}/pressure.gf", f"{name}/flux.gf"]
        reader = simple.PixelExactMFEMReader(FileName=scene.data(files[0]))
        self.check(reader, f"{name}/oracle_pressure.csv", "pressure", files)
        self.check(reader, f"{name}/oracle_flux.csv", "flux", files, ("u0", "u1", "u2"))

    def test_fields_are_chosen(self):
        name = "mfem_escher_tet_darcy_p3"
        reader = simple.PixelExactMFEMReader(FileName=scene.data(f"{name}/{name}.mesh"))
        reader.UpdatePipelineInformation()
        self.assertEqual(list(reader.Fields), ["flux", "pressure"])
        reader.Fields = ["pressure"]
        reader.UpdatePipeline()
        self.assertIn("pressure", reader.PointData.keys())
        self.assertNotIn("flux", reader.PointData.keys())
        found = scene.probe(reader, [[0.0, 0.0, 0.0]])
        self.assertIn("pressure", found)
        self.assertNotIn("flux", found)

    def test_glvis(self):
        name = "mfem49_tinyzoo_g3_p5"
        saved = os.path.join(scene.PICTURES, "tinyzoo.saved")
        with open(saved, "w") as file:
            file.write("solution\n")
            for part in f"{name}.mesh", "u.gf":
                with open(scene.data(f"{name}/{part}")) as text:
                    file.write(text.read() + "\n")
        reader = simple.PixelExactGLVisReader(FileName=saved)
        self.check(reader, f"{name}/oracle_u.csv", "solution", [saved])

    def test_gmsh(self):
        name = "gmsh_zoo_g2"
        file = f"{name}/{name}.msh"
        reader = simple.PixelExactGmshReader(FileName=scene.data(file))
        reader.UpdatePipelineInformation()
        self.assertEqual(list(reader.TimestepValues), [0.0, 0.25, 0.5])
        self.check(reader, f"{name}/oracle.csv", "u", [file])

    def test_surfaces_beside_solids(self):
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0), (3, 0, 0), (4, 0, 0), (3, 1, 0), (3, 0, 1)]
        grid = vtkUnstructuredGrid()
        grid.SetPoints(vtkPoints())
        for point in points:
            grid.GetPoints().InsertNextPoint(point)
        grid.InsertNextCell(VTK_TETRA, 4, [4, 5, 6, 7])
        grid.InsertNextCell(VTK_TRIANGLE, 3, [0, 1, 2])
        grid.InsertNextCell(VTK_TRIANGLE, 3, [0, 2, 3])
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mixed.vtu")
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetFileName(file)
            writer.SetInputData(grid)
            writer.Write()
            reader = simple.PixelExactGridReader(FileName=[file])
            with scene.messages() as heard:
                reader.UpdatePipeline()
            self.assertIn("Surface Elements", heard[0])
            self.assertEqual(reader.GetDataInformation().GetNumberOfCells(), 1)
            reader.SurfaceElements = 1
            reader.UpdatePipeline()
            self.assertEqual(reader.GetDataInformation().GetNumberOfCells(), 2)

    def test_nek5000(self):
        file = "nek5000_bent/bent.nek5000"
        reader = simple.PixelExactNek5000Reader(FileName=[scene.data(file)])
        reader.UpdatePipelineInformation()
        self.assertEqual(list(reader.TimestepValues), [0.5, 1.25])
        self.check(reader, "nek5000_bent/oracle.csv", "pressure", [file])
        reader.Fields = ["pressure"]
        reader.UpdatePipeline()
        self.assertNotIn("velocity", reader.PointData.keys())

    def test_vtkhdf(self):
        """Steps of 1 + t x - 2 y z + (t + 1) x^2 on three cubes in two parts."""
        reader = simple.PixelExactGridReader(FileName=[scene.data("vtkhdf_steps.vtkhdf")])
        reader.UpdatePipelineInformation()
        self.assertEqual(list(reader.TimestepValues), [0.0, 0.5, 1.0])
        points = numpy.random.default_rng(5).uniform(0.05, 0.95, (100, 3)) * [3, 1, 1]
        x, y, z = points.T
        for t in reader.TimestepValues:
            simple.GetAnimationScene().AnimationTime = t
            reader.UpdatePipeline(t)
            found = scene.probe(reader, points)
            values = 1 + t * x - 2 * y * z + (t + 1) * x * x
            self.assertTrue((found["Verdict"] == 1).all())
            self.assertLess(numpy.abs(found["u"].ravel() - values).max(), 1e-12)

    @unittest.skipUnless(flexi, "there is no HDF5 library to write files with")
    def test_flexi(self):
        fields = {"Density": lambda x, y, z: 1 + x * y - z * z, "MomentumX": lambda x, y, z: z - x}
        with tempfile.TemporaryDirectory() as folder:
            flexi.write_mesh(os.path.join(folder, "box_mesh.h5"), (2, 1, 2), 2)
            states = [os.path.join(folder, f"box_State_{k}.h5") for k in (1, 2)]
            for state, time in zip(states, (0.25, 0.5)):
                flexi.write_state(state, (2, 1, 2), 6, fields, time=time)
            with scene.messages() as heard:
                reader = simple.PixelExactFLEXIReader(FileName=states)
                reader.UpdatePipelineInformation()
                self.assertEqual(list(reader.TimestepValues), [0.25, 0.5])
                points = flexi.bent(numpy.random.default_rng(6).uniform(0.01, 0.99, (3, 100)))
                found = scene.probe(reader, points.T)
            self.assertTrue((found["Verdict"] == 1).all())
            for name, function in fields.items():
                self.assertLess(numpy.abs(found[name].ravel() - function(*points)).max(), 1e-12)
            self.assertEqual(heard, [""])
            self.assertIn("PixelExactFlexiReader", self.readers_of(states[0]))

    def test_grids(self):
        for name in GRIDS:
            with self.subTest(name):
                file = f"{name}.vtu"
                reader = simple.PixelExactGridReader(FileName=[scene.data(file)])
                reader.UpdatePipelineInformation()
                self.assertIn("u", reader.Fields)
                reader.Fields = ["u"]
                self.assertEqual(set(scene.probe(reader, [[0, 0, 0]])) & {"u", "attribute"}, {"u"})
                self.check(reader, f"{name}.oracle.csv", "u", [file])

    def test_nodes_elsewhere(self):
        reader = simple.PixelExactGridReader(FileName=[scene.data("dolfinx_hex_g2_p4.vtu")])
        reader.Nodes = "Gauss-Lobatto"
        with scene.messages() as heard:
            reader.UpdatePipeline()
        self.assertIn("equispaced", heard[0])

    def readers_of(self, file):
        """What ParaView offers where a file of that name is opened; one is taken without a choice."""
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        if factory.GetNumberOfRegisteredPrototypes() == 0:
            factory.UpdateAvailableReaders()
        found = factory.GetReaders(file, servermanager.ActiveConnection.Session)
        return [found.GetString(i) for i in range(1, found.GetLength(), 3)]

    def test_files_are_opened_by_their_content(self):
        nektar, mfem = "nek_tet_varp/nek_tet_varp", "mfem_escher_tet_darcy_p3/"
        linear = os.path.join(scene.PICTURES, "linear.vtu")
        simple.SaveData(linear, simple.UnstructuredCellTypes(CellType="Hex"))
        quadratic = os.path.join(scene.PICTURES, "quadratic.vtu")
        simple.SaveData(quadratic, simple.UnstructuredCellTypes(CellType="Quadratic Hex"))
        cut_short = os.path.join(scene.PICTURES, "cut_short.vtu")
        with open(quadratic, "rb") as whole, open(cut_short, "wb") as part:
            part.write(whole.read()[:500])
        other = {}
        for suffix in "xml", "msh", "mesh", "saved", "chk", "vtu":
            other[suffix] = os.path.join(scene.PICTURES, "other." + suffix)
            with open(other[suffix], "w") as file:
                file.write("<other />")
        plain = "XMLUnstructuredGridReader"
        for file, readers in {
            scene.data(nektar + ".xml"): ["PixelExactNektarReader"],
            scene.data(nektar + ".fld"): ["PixelExactNektarReader"],
            scene.data(mfem + "mfem_escher_tet_darcy_p3.mesh"): ["PixelExactMFEMReader"],
            scene.data("gmsh_zoo_g2/gmsh_zoo_g2.msh"): ["PixelExactGmshReader"],
            scene.data("nek5000_bent/bent0.f00000"): ["PixelExactNek5000Reader"],
            scene.data("toroid_hex_g3_p6.vtu"): ["PixelExactGridReader", plain],
            quadratic: ["PixelExactGridReader", plain],
            linear: [plain],
            cut_short: [plain],
            other["xml"]: [],
            other["msh"]: [],
            other["mesh"]: [],
            other["saved"]: [],
            other["chk"]: [],
        }.items():
            with self.subTest(file):
                self.assertEqual([r for r in self.readers_of(file) if "GDAL" not in r], readers)

    def test_nektar_is_opened_as_a_file(self):
        """By File > Open: the property that takes the file is none of the others that name files."""
        name = "nek_tet_varp"
        files = [scene.data(f"{name}/{name}{suffix}") for suffix in (".xml", ".fld")]
        for file in files:
            with scene.messages() as heard:
                reader = simple.OpenDataFile(file)
                self.check(reader, f"{name}/oracle.csv", "u", [])
            self.assertEqual(heard, [""])

    def test_times(self):
        name = scene.data("toroid_hex_g3_p6.vtu")
        reader = simple.PixelExactGridReader(FileName=[name, name, name])
        reader.UpdatePipelineInformation()
        self.assertEqual(list(reader.TimestepValues), [0.0, 1.0, 2.0])
        reader.UpdatePipeline(1.0)
        self.assertEqual(reader.GetDataInformation().GetTime(), 1.0)

    def test_a_missing_session(self):
        name = os.path.join(scene.PICTURES, "alone.fld")
        with open(name, "w") as file:
            file.write("<NEKTAR />")
        with scene.messages() as heard:
            simple.PixelExactNektarReader(FileName=[name]).UpdatePipeline()
        for part in "alone.fld", "alone.xml", "Session Files":
            self.assertIn(part, heard[0])


if __name__ == "__main__":
    scene.main()

# SPDX-License-Identifier: BSD-3-Clause
"""Files of VTK's HDF format on the command line, against the same grids as .vtu and closed forms."""

import unittest

import hdf5
import numpy as np
from tool import CASES, CUBE, DATA, ToolTest, case, columns, oracle, plain_grid, read_csv, run
from vtkhdf import Part, example, lagrange_cube, read_grid, write, write_block, write_collection


@unittest.skipUnless(hdf5.LIBRARY, "there is no HDF5 library to write files with")
class VtkHdf(ToolTest):
    def setUp(self):
        super().setUp()
        if "without the HDF5 library" in run("info", DATA / "nek_hdf5" / "Tet_channel_m4_per_hdf5.xml").stderr:
            self.skipTest("built without the HDF5 library")

    def write(self, name, parts, **more):
        path = self.folder / name
        write(path, parts, **more)
        return path

    def probe(self, path, field, points, *options):
        out = self.folder / "out.csv"
        self.succeeds("probe", path, "--field", field, "--points", points, "--output", out, *options)
        return out.read_bytes()

    def values(self, path, points, *options, field="u"):
        table = self.folder / "points.csv"
        table.write_text("x,y,z\n" + "\n".join(",".join(map(repr, point)) for point in points.tolist()) + "\n")
        self.probe(path, field, table, *options)
        found = columns(read_csv(self.folder / "out.csv"))
        self.assertEqual(set(found["verdict"]), {"inside"})
        return found["value"]

    def test_same_as_vtu(self):
        """All bytes of probes at the oracles' points, and all that info states."""
        for name in CASES:
            grid = Part.of(read_grid(case(name)))
            for version, chunk in [((1, 0), None), ((2, 5), 100)]:
                with self.subTest(name=name, version=version):
                    path = self.write(f"{name}.vtkhdf", [grid], version=version, chunk=chunk)
                    points = DATA / f"{name}.oracle.csv"
                    self.assertEqual(self.probe(path, "u", points), self.probe(case(name), "u", points))
                    summaries = [self.summary("info", file) for file in (path, case(name))]
                    self.assertEqual(*summaries)

    def test_parts(self):
        name = "toroid_hex_g3_p6"
        grid = Part.of(read_grid(case(name)))
        count = len(grid.types)
        ends = [0, 3, count // 2, count // 2, count]
        path = self.write("parts.vtkhdf", [grid.cells(*ends[i:i + 2]) for i in range(4)])
        expected = oracle(name)
        self.probe(path, "u", DATA / f"{name}.oracle.csv")
        found = columns(read_csv(self.folder / "out.csv"))
        np.testing.assert_allclose(found["value"], expected["u"], rtol=0, atol=1e-13)
        self.assertEqual(self.summary("info", path)["elements"], count)

    def test_steps(self):
        """The mesh moves, or stands still and is written once; parts differ in number."""
        points = np.random.default_rng(3).uniform(0.05, 0.95, (50, 3))
        times = [0.5, 0.75, 2.0]
        for moving in [True, False]:
            every = [[lagrange_cube(x, lambda x, y, z, t=time: t * x * x + y * z) for x in range(2)] for time in times]
            if moving:
                every[1].append(lagrange_cube(2, lambda x, y, z: 0 * x))
            path = self.write("steps.vtkhdf", every, steps=times, moving=moving, chunk=5)
            self.assertEqual(self.summary("info", path)["times"], times)
            for step, time in enumerate(times):
                expected = time * points[:, 0] ** 2 + points[:, 1] * points[:, 2]
                for option in [("--time-step", step), ("--time", time)]:
                    np.testing.assert_allclose(self.values(path, points, *option), expected, rtol=0, atol=1e-13)
                elements = 3 if moving and step == 1 else 2
                self.assertEqual(self.summary("info", path, "--time-step", step)["elements"], elements)
        self.fails(1, "info", path, "--time-step", 3, names=["3 time steps"])

    def test_steps_without_numbers_of_parts(self):
        """Steps share all parts of a mesh that stands still, or have equally many."""
        points = np.random.default_rng(4).uniform(0.05, 0.95, (50, 3)) * [3, 1, 1]
        times = [0.5, 0.75]
        for moving in [True, False]:
            with self.subTest(moving=moving):
                every = [[lagrange_cube(x, lambda x, y, z, t=t: t * x * x + y) for x in range(3)] for t in times]
                path = self.write("steps.vtkhdf", every, steps=times, moving=moving, counted=False)
                for step, time in enumerate(times):
                    expected = time * points[:, 0] ** 2 + points[:, 1]
                    found = self.values(path, points, "--time-step", step)
                    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-13)

    def test_example(self):
        """Data/ holds what vtkhdf.py writes; TestTimeSeries.cxx reads it."""
        path = self.folder / "example.vtkhdf"
        example(path)
        points = np.random.default_rng(6).uniform(0.05, 0.95, (200, 3)) * [3, 1, 1]
        x, y, z = points.T
        for file in (path, DATA / "vtkhdf_steps.vtkhdf"):
            for step, t in enumerate([0.0, 0.5, 1.0]):
                expected = 1 + t * x - 2 * y * z + (t + 1) * x * x
                np.testing.assert_allclose(self.values(file, points, "--time-step", step), expected, rtol=0, atol=1e-13)

    def test_several_files(self):
        """Files with a time each are ordered by it; files without time by their number."""
        points = np.array([[0.5, 0.25, 0.25]])
        for times in [[2.0, 1.0], None]:
            files = []
            for number in range(2):
                part = lagrange_cube(0, lambda x, y, z, n=number: (n + 1) * x)
                more = {"steps": [times[number]]} if times else {}
                files.append(self.write(f"u_{number}.hdf", [[part]] if times else [part], **more))
            # The second file has the earlier time.
            expected = [1.0, 0.5] if times else [0.5, 1.0]
            for step in range(2):
                self.assertIn(f"step {step} of 2", self.succeeds("info", *files, "--time-step", step).stdout)
                found = self.values(files[0], points, *files[1:], "--time-step", step)
                self.assertAlmostEqual(found[0], expected[step], delta=1e-15)
        mixed = self.write("u_1.hdf", [[lagrange_cube(0, lambda x, y, z: x)]], steps=[1.0])
        self.fails(1, "info", files[0], mixed, names=["others have none"])

    def test_rational_weights_and_degrees(self):
        """A quarter of a ring is exact; purposes are marked at the array, at the group, or not at all."""
        half = np.sqrt(0.5)
        # Degrees 2, 1, 1: corners, then the middle points of the four edges along the first direction.
        ring = np.array([[r * x, r * y, z] for z in (0, 1) for r, x, y in ((1, 1, 0), (1, 0, 1), (2, 0, 1), (2, 1, 0))])
        middle = np.array([[r, r, z] for z in (0, 1) for r in (1, 2)])
        points = np.concatenate([ring, middle]).astype(float)
        weights = np.array([1.0] * 8 + [half] * 4)
        part = Part(points, [79], [0, 12], range(12), {"u": points[:, 2].copy(), "RationalWeights": weights},
                    {"HigherOrderDegrees": np.array([[2.0, 1.0, 1.0]])})
        angle = np.linspace(0.05, 1.5, 20)
        inside = np.array([[1.5 * np.cos(a), 1.5 * np.sin(a), 0.25] for a in angle])
        for marks in ["array", "group", None]:
            path = self.write("ring.vtkhdf", [part], marks=marks)
            self.assertEqual("'RationalWeights' is not marked" in self.succeeds("info", path).stderr, marks is None)
            np.testing.assert_allclose(self.values(path, inside), 0.25, rtol=0, atol=1e-13)
        part.data["PointData"]["RationalWeights"] = np.ones((12, 2))
        path = self.write("ring.vtkhdf", [part])
        self.fails(1, "info", path, names=["marked as RationalWeights", "2 components"])

    def test_types_keep_their_values(self):
        """Single precision stays single, integers stay whole, big-endian numbers are the same."""
        cube = np.array(CUBE)
        third = cube[:, 0] / 3
        arrays = {"single": third.astype("<f4"), "double": third, "big": third.astype(">f8"),
                  "whole": np.arange(8, dtype="<i2"), "tensor": np.arange(72.0).reshape(8, 3, 3)}
        path = self.write("types.vtkhdf", [Part(cube, [12], [0, 8], range(8), arrays)])
        at = np.array([[1.0, 1.0, 1.0]])
        for name, value in [("single", float(np.float32(1 / 3))), ("double", 1 / 3), ("big", 1 / 3), ("whole", 6.0)]:
            self.assertEqual(self.values(path, at, field=name)[0], value, name)
        fields = {field["name"]: field["components"] for field in self.summary("info", path)["fields"]}
        self.assertEqual(fields["tensor"], 9)
        single = self.write("points.vtkhdf", [Part(cube.astype("<f4"), [12], [0, 8], range(8), arrays)])
        self.assertEqual(self.values(single, at, field="double")[0], 1 / 3)

    def test_blocks_of_a_collection(self):
        parts = [lagrange_cube(x, lambda x, y, z: x * x + y * z) for x in range(3)]
        points = np.random.default_rng(4).uniform(0.05, 0.95, (20, 3)) * [3, 1, 1]
        expected = points[:, 0] ** 2 + points[:, 1] * points[:, 2]
        path = self.folder / "blocks.vtkhdf"
        blocks = {"right": {"parts": parts[2:]}, "left": {"parts": parts[:2]},
                  "skin": {"parts": parts[:1], "kind": "PolyData"}}
        for kind in ["PartitionedDataSetCollection", "MultiBlockDataSet"]:
            write_collection(path, blocks, kind)
            self.assertIn("'skin' is of type PolyData and is left out", self.succeeds("info", path).stderr)
            np.testing.assert_allclose(self.values(path, points), expected, rtol=0, atol=1e-13)
        write_collection(path, {"skin": blocks["skin"]})
        self.fails(1, "info", path, names=["no block of type UnstructuredGrid", "Append Datasets"])

    def test_refusals(self):
        part = lagrange_cube(0, lambda x, y, z: x)
        for kind in ["ImageData", "PolyData", "OverlappingAMR", "HyperTreeGrid"]:
            path = self.write("x.vtkhdf", [part], kind=kind)
            self.fails(1, "info", path, names=[path, f"type {kind}", "Append Datasets"])
        path = self.write("x.vtkhdf", [part], version=(3, 0))
        self.fails(1, "info", path, names=["version 3", ".vtu"])
        with hdf5.Writer(path) as file:
            file.dataset("/x", np.zeros(3))
        self.fails(1, "info", path, names=["no group VTKHDF"])
        path.write_text(plain_grid(CUBE, [(12, list(range(8)))]))
        self.fails(1, "info", path, names=["no sound HDF5 file"])
        polyhedron = Part(part.points, [42], [0, 27], range(27))
        path = self.write("x.vtkhdf", [polyhedron])
        self.fails(1, "info", path, names=["polyhedra", "Tetrahedralize"])

    def test_damaged_files(self):
        part = lagrange_cube(0, lambda x, y, z: x)
        sound = {name: getattr(part, name) for name in ["types", "offsets", "connectivity"]}
        for name, value, word in [("offsets", [0, 26], "Offsets"), ("offsets", [1, 27], "Offsets"),
                                  ("offsets", [0], "Offsets"), ("connectivity", [27] + list(range(1, 27)), "Connectivity"),
                                  ("connectivity", [-1] + list(range(1, 27)), "Connectivity"), ("types", [], "Types")]:
            broken = Part(part.points, **{**sound, name: value}, point_data={})
            path = self.folder / "x.vtkhdf"
            with hdf5.Writer(path) as file:
                write_block(file, "/VTKHDF", [broken], cells=1)
            self.fails(1, "info", path, names=[path, word])
        path = self.write("x.vtkhdf", [part])
        whole = path.read_bytes()
        for length in [len(whole) // 3, len(whole) // 2, len(whole) - 1]:
            path.write_bytes(whole[:length])
            self.fails(1, "info", path, names=[path, "HDF5"])
        path = self.write("x.vtkhdf", [[part], []], steps=[0.0, 1.0])
        self.succeeds("info", path)
        self.fails(1, "info", path, "--time-step", 1, names=["time step 1 has no parts", "--time-step"])
        part.data["PointData"]["u"] = part.data["PointData"]["u"][:20]
        self.fails(1, "info", self.write("x.vtkhdf", [part]), names=["/VTKHDF/PointData/u", "fewer values"])

    def test_mutated_files(self):
        """Files with changed bytes are read or refused in one line; none ends the program."""
        times = [0.0, 1.0]
        parts = [[lagrange_cube(x, lambda x, y, z, t=t: t + x) for x in range(2)] for t in times]
        path = self.write("x.vtkhdf", parts, steps=times)
        whole = bytearray(path.read_bytes())
        random = np.random.default_rng(11)
        for _ in range(40):
            changed = bytearray(whole)
            for place in random.integers(0, len(whole), random.integers(1, 30)):
                changed[place] = random.integers(0, 256)
            path.write_bytes(changed)
            done = run("info", path, "--time-step", 1, text=False)
            self.assertIn(done.returncode, (0, 1), done.stderr)
            if done.returncode == 1:
                self.assertIn(b"pixelexact: ", done.stderr)

    def test_picture(self):
        path = self.write("x.vtkhdf", [Part.of(read_grid(case("toroid_hex_g3_p6")))])
        pictures = []
        for file in (path, case("toroid_hex_g3_p6")):
            pictures.append(self.folder / f"{file.suffix[1:]}.png")
            self.succeeds("render", file, "--field", "u", "--boundary", "--size", "100x100", "--output", pictures[-1])
        self.assertEqual(*(picture.read_bytes() for picture in pictures))


if __name__ == "__main__":
    unittest.main()

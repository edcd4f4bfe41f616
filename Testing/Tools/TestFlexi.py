# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of HOPR and states of FLEXI on the command line, against closed forms."""

import unittest

import hdf5
import numpy as np
from flexi import CONDITIONS, bent, state_values, write_mesh, write_state
from tool import DATA, ToolTest, columns, read_buffers, read_csv, run

COUNTS = (2, 2, 1)
# Polynomials of x, y, z that are of order 4 in each direction on a bent grid.
FIELDS = {
    "Density": lambda x, y, z: 1 + x * y + z,
    "MomentumX": lambda x, y, z: x * x - z,
    "EnergyStagnationDensity": lambda x, y, z: 2 - x * z,
}


@unittest.skipUnless(hdf5.LIBRARY, "there is no HDF5 library to write files with")
class Flexi(ToolTest):
    def setUp(self):
        super().setUp()
        if "without the HDF5 library" in run("info", DATA / "nek_hdf5" / "Tet_channel_m4_per_hdf5.xml").stderr:
            self.skipTest("built without the HDF5 library")
        self.mesh = self.folder / "box_mesh.h5"
        self.state = self.folder / "box_State_0000000.000000000.h5"

    def write_both(self, order=2, n=6, **more):
        write_mesh(self.mesh, COUNTS, order)
        write_state(self.state, COUNTS, n, FIELDS, **more)

    def values(self, files, field, points, *options, verdicts=("inside",)):
        table, out = self.folder / "points.csv", self.folder / "out.csv"
        table.write_text("x,y,z\n" + "\n".join(",".join(map(repr, point)) for point in points.T.tolist()) + "\n")
        self.succeeds("probe", *files, "--field", field, "--points", table, "--output", out, *options)
        found = columns(read_csv(out))
        self.assertLessEqual(set(found["verdict"]), set(verdicts))
        return found["value"]

    def check(self, files, fields=FIELDS, *options):
        points = bent(np.random.default_rng(8).uniform(0.01, 0.99, (3, 200)))
        for name, function in fields.items():
            np.testing.assert_allclose(self.values(files, name, points, *options), function(*points), rtol=0,
                                       atol=1e-13, err_msg=name)

    def test_both_kinds_of_nodes_on_curved_meshes(self):
        for nodes in ["GAUSS", "GAUSS-LOBATTO"]:
            for order, n in [(2, 5), (3, 7), (5, 9)]:
                with self.subTest(nodes=nodes, order=order):
                    self.write_both(order, n, nodes=nodes)
                    self.check([self.state])
                    self.check([self.mesh, self.state])

    def test_polynomials_of_full_degree(self):
        """A product of Legendre polynomials of degree N, on a straight mesh."""
        def legendre(x):
            return np.polynomial.legendre.Legendre.basis(7)(2 * x - 1)

        def straight(points):
            return points * 2.0

        fields = {"u": lambda x, y, z: legendre(x / 2) * legendre(y / 2) * legendre(z / 2)}
        write_mesh(self.mesh, (1, 1, 1), 1, place=straight)
        points = np.random.default_rng(9).uniform(0.01, 1.99, (3, 200))
        for nodes in ["GAUSS", "GAUSS-LOBATTO"]:
            write_state(self.state, (1, 1, 1), 8, fields, nodes=nodes, place=straight)
            found = self.values([self.state], "u", points)
            np.testing.assert_allclose(found, fields["u"](*points), rtol=0, atol=1e-13)

    def test_states_are_time_steps(self):
        write_mesh(self.mesh, COUNTS, 2)
        files = []
        for number, time in enumerate([0.5, 2.0, 1.0]):
            files.append(self.folder / f"box_State_{number}.h5")
            write_state(files[-1], COUNTS, 5, {"u": lambda x, y, z, t=time: t * x}, time=time)
        self.assertEqual(self.summary("info", *files)["times"], [0.5, 1.0, 2.0])
        for given in (files, [self.mesh, *files]):
            for step, time in enumerate([0.5, 1.0, 2.0]):
                self.check(given, {"u": lambda x, y, z, t=time: t * x}, "--time-step", step)

    def test_steps_with_meshes_of_their_own(self):
        files = []
        for step, counts in enumerate([(1, 1, 1), (2, 1, 1)]):
            mesh = f"box{step}_mesh.h5"
            write_mesh(self.folder / mesh, counts, 2)
            files.append(self.folder / f"box_State_{step}.h5")
            write_state(files[-1], counts, 5, {"u": FIELDS["Density"]}, time=float(step), mesh=f"/far/away/{mesh}")
        for step in range(2):
            self.check(files, {"u": FIELDS["Density"]}, "--time-step", step)
        self.fails(1, "info", self.folder / "box1_mesh.h5", files[0], names=["1 element", "has 2"])

    def test_runs_in_the_plane(self):
        """One layer of nodes along xi3: fields are constant across."""
        write_mesh(self.mesh, (2, 1, 1), 1, place=lambda points: points)
        fields = {"u": lambda x, y, z: x * x + y}
        write_state(self.state, (2, 1, 1), 4, fields, across=1, place=lambda points: points)
        points = np.random.default_rng(10).uniform(0.01, 0.99, (3, 50))
        np.testing.assert_allclose(self.values([self.state], "u", points), fields["u"](*points), rtol=0, atol=1e-13)

    def test_info(self):
        self.write_both(n=5)
        summary = self.summary("info", self.state)
        self.assertEqual(summary["shapes"], {"hexahedron": 4})
        self.assertEqual(summary["geometry_orders"], {"2": 4})
        self.assertEqual([field["name"] for field in summary["fields"]], list(FIELDS))
        self.assertEqual({field["basis"] for field in summary["fields"]}, {"FLEXI, Gauss-Legendre nodes"})
        self.assertEqual(summary["attributes"], {"1": 2, "2": 2})
        # The grid has two elements along x and y and one along z.
        self.assertEqual(summary["boundary_attributes"], {"1": 4, "2": 2, "3": 2, "4": 2, "5": 2, "6": 4})
        text = self.succeeds("info", self.state).stdout
        for number, name in enumerate(CONDITIONS):
            self.assertIn(f"{number + 1} '{name}'", text)
        mesh = self.summary("info", self.mesh)
        self.assertEqual((mesh["elements"], mesh["fields"], mesh["times"]), (4, [], []))

    def test_conditions_are_on_their_sides(self):
        """The faces of a condition, seen from outside of a straight box, have its side's coordinate."""
        def straight(points):
            return points * np.array([[2.0], [3.0], [5.0]])

        write_mesh(self.mesh, (2, 1, 1), 1, place=straight)
        write_state(self.state, (2, 1, 1), 2, {"x": lambda x, y, z: x, "y": lambda x, y, z: y, "z": lambda x, y, z: z},
                    place=straight)
        sides = [("-z", 0.0), ("-y", 0.0), ("+x", 2.0), ("+y", 3.0), ("-x", 0.0), ("+z", 5.0)]
        for condition, (view, value) in enumerate(sides):
            done = self.succeeds("render", self.state, "--field", view[1], f"--boundary={condition + 1}", "--size",
                                 "40x40", "--view", view, "--output", self.folder / "side.png",
                                 "--buffers", self.folder / "side.vti")
            self.assertIn("exact", done.stdout)
            buffers = read_buffers(self.folder / "side.vti")
            seen = buffers["Verdict"] == 1
            self.assertGreater(seen.sum(), 100)
            np.testing.assert_allclose(buffers["Value"][seen], value, rtol=0, atol=1e-13)

    def test_divided_sides(self):
        """Small sides that follow a divided one are not counted as the element's sides."""
        sides = [[24, 0, 0, 0, 1], [24, 0, -1, 0, 0]] + [[24, 0, 1, 0, 0]] * 4 + [[24, 0, -2, 0, 0]]
        sides += [[24, 0, 1, 0, 0]] * 2 + [[24, 0, 0, 0, 4], [24, 0, 0, 0, 5], [24, 0, 0, 0, 6]]
        write_mesh(self.mesh, (1, 1, 1), 1, SideInfo=np.array(sides, np.int32),
                   ElemInfo=np.array([[108, 1, 0, 12, 0, 8]], np.int32))
        self.assertEqual(self.summary("info", self.mesh)["boundary_attributes"], {"1": 1, "4": 1, "5": 1, "6": 1})

    def test_further_data(self):
        """FieldData and ElemData are fields; others are named."""
        n = 5
        more = {"wall": lambda x, y, z: x - y}
        values = state_values(COUNTS, n, more.values())
        self.write_both(n=n, FieldData=values, VarNamesAddField=["wall".ljust(255)],
                        ElemData=np.array([[0.0, 7.0 + e] for e in range(4)]), VarNamesAdd=["FV_Elems", "rank"],
                        Spare=np.zeros(3))
        done = self.succeeds("info", self.state)
        self.assertIn("'Spare' is left out", done.stderr)
        self.check([self.state], {**FIELDS, **more})
        middle = bent(np.array([[0.25, 0.75], [0.25, 0.75], [0.5, 0.5]]))
        np.testing.assert_array_equal(self.values([self.state], "rank", middle), [7.0, 10.0])
        self.write_both(n=n, FieldData=values[:, :3], VarNamesAddField=["wall"])
        self.assertIn("FieldData has other nodes", self.succeeds("info", self.state).stderr)

    def test_finite_volumes_are_no_polynomials(self):
        self.write_both(n=5, ElemData=np.array([[1.0], [0.0], [0.0], [0.0]]), VarNamesAdd=["FV_Elems"])
        self.assertIn("1 of 4 elements hold means of finite volumes", self.succeeds("info", self.state).stderr)
        middle = bent(np.array([[0.25, 0.75], [0.25, 0.75], [0.5, 0.5]]))
        found = self.values([self.state], "Density", middle)
        self.assertTrue(np.isnan(found[0]))
        self.assertAlmostEqual(found[1], FIELDS["Density"](*middle[:, 1]), delta=1e-13)

    def test_values_that_are_not_finite(self):
        solution = state_values(COUNTS, 5, FIELDS.values())
        solution[3, 0, 0, 0, 1] = np.nan
        self.write_both(n=5, DG_Solution=solution)
        self.assertIn("'MomentumX' is NaN or infinite at nodes of 1 of 4", self.succeeds("info", self.state).stderr)
        self.check([self.state], {"Density": FIELDS["Density"]})

    def test_picture(self):
        self.write_both()
        picture = self.folder / "box.png"
        self.succeeds("render", self.state, "--field", "Density", "--boundary", "--size", "100x100", "--output", picture)
        self.assertGreater(picture.stat().st_size, 500)

    def test_refused_states(self):
        write_mesh(self.mesh, COUNTS, 2)
        solution = state_values(COUNTS, 5, FIELDS.values())
        for changes, words in [
            ({"NodeType": "CHEBYSHEV-GAUSS-LOBATTO"}, ["CHEBYSHEV-GAUSS-LOBATTO", "GAUSS-LOBATTO are read"]),
            ({"NodeType": None}, ["NodeType"]),
            ({"N": np.array([7])}, ["order N"]),
            ({"Time": np.array([np.nan])}, ["Time"]),
            ({"Time": None}, ["Time"]),
            ({"MeshFile": None}, ["MeshFile", "name the mesh before it"]),
            ({"MeshFile": "other_mesh.h5"}, ["other_mesh.h5", "copy it there"]),
            ({"DG_Solution": solution[:3]}, ["3 elements", "has 4"]),
            ({"DG_Solution": solution[..., 0]}, ["DG_Solution"]),
            ({"DG_Solution": solution[:, :, :4]}, ["DG_Solution"]),
            ({"DG_Solution": solution.astype(np.int32)}, ["DG_Solution", "another type"]),
            ({"DG_Solution": None}, ["neither a state of FLEXI", "nor a mesh of HOPR"]),
        ]:
            with self.subTest(words=words):
                write_state(self.state, COUNTS, 5, FIELDS, **changes)
                self.fails(1, "info", self.state, names=[self.state, *words])
        write_state(self.state, COUNTS, 5, FIELDS)
        self.fails(1, "info", self.mesh, self.state, self.mesh.rename(self.folder / "b_mesh.h5"), names=["no such file"])

    def test_refused_meshes(self):
        info = np.array([[208, 1, 0, 6, 0, 27]] * 4, np.int32)
        good = info.copy()
        good[:, 4], good[:, 5] = 27 * np.arange(4), 27 * np.arange(1, 5)
        good[:, 2], good[:, 3] = 6 * np.arange(4), 6 * np.arange(1, 5)
        beyond, sides, rows = good.copy(), good.copy(), np.zeros((108, 3))
        beyond[3, 4:] = [100, 127]
        sides[3, 3] = 30
        rows[5, 1] = np.inf
        for changes, words in [
            ({"kinds": [208, 204, 204, 206]}, ["2 of kind 'tetrahedron'", "1 of kind 'prism'", "splitToHex"]),
            ({"Ngeo": np.array([40])}, ["Ngeo", "40"]),
            ({"Ngeo": np.array([3])}, ["a hexahedron has 64"]),
            ({"nElems": np.array([5])}, ["nElems"]),
            ({"ElemInfo": beyond}, ["element 4", "of 108"]),
            ({"ElemInfo": sides}, ["element 4", "sides"]),
            ({"ElemInfo": good[:, :4].copy()}, ["ElemInfo"]),
            ({"NodeCoords": rows}, ["element 1"]),
            ({"NodeCoords": np.zeros((108, 2))}, ["NodeCoords"]),
            ({"NodeCoords": None}, ["nor a mesh of HOPR"]),
        ]:
            with self.subTest(words=words):
                write_mesh(self.mesh, COUNTS, 2, **changes)
                self.fails(1, "info", self.mesh, names=[self.mesh, *words])

    def test_truncated_and_mutated_files(self):
        """Damaged files are read or refused with a message; none ends the program."""
        self.write_both(n=3)
        random = np.random.default_rng(12)
        for path in (self.state, self.mesh):
            whole = path.read_bytes()
            path.write_bytes(whole[:len(whole) // 2])
            self.fails(1, "info", self.state, names=[path])
            for _ in range(20):
                changed = bytearray(whole)
                for place in random.integers(0, len(whole), random.integers(1, 30)):
                    changed[place] = random.integers(0, 256)
                path.write_bytes(changed)
                done = run("info", self.state, text=False)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                if done.returncode == 1:
                    self.assertIn(b"pixelexact: ", done.stderr)
            path.write_bytes(whole)


if __name__ == "__main__":
    unittest.main()

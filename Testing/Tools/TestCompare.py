# SPDX-License-Identifier: BSD-3-Clause
"""pixelexact compare: its table, its page, what it recommends, what it refuses."""

import re
import subprocess
import sys
import unittest

from tool import DATA, MIDDLE, CUBE, ToolTest, case, plain_grid, read_csv

# A small comparison of each family.
FEW = ["--resolutions", "16,32,64", "--grids", "8,16,32", "--levels", "0,1,2", "--repeat", "1"]
SMALL = ["--size", "120x100"]


class Compare(ToolTest):
    def compare(self, *arguments, output="trade"):
        folder = self.folder / output
        summary = self.summary("compare", *arguments, *SMALL, "--output", folder)
        return folder, summary, {row["setting"]: row for row in read_csv(folder / "trade.csv")}

    def test_triangles_and_patches(self):
        for option, file in (("--surface", "octahedron.stl"), ("--patch", "saddle.txt")):
            summary = self.summary(
                *("compare", case("toroid_hex_g3_p6"), "--field", "u", option),
                *(DATA / "surfaces" / file, "--size", "120x120", "--repeat", "1"),
                *("--levels", "0,2", "--truncate-orders", "none", "--output", self.folder / option),
            )
            coarse, fine = (s for s in summary["settings"] if s["setting"].startswith("sub"))
            self.assertGreater(fine["triangles"], 10 * coarse["triangles"])
            self.assertLess(fine["mean_error"], coarse["mean_error"])
            self.assertLess(fine["missing"], coarse["missing"])

    def test_linear_pictures_converge_to_the_exact_one(self):
        folder, summary, rows = self.compare(
            case("toroid_hex_g3_p6"), "--field", "u", "--plane", "z=0.1", "--contours", 5, *FEW
        )
        exact = rows["exact"]
        for column in ["missing", "invented", "largest_error", "share_error", "wrong_colors"]:
            self.assertEqual(float(exact[column]), 0.0, column)
        self.assertEqual(float(exact["first_ratio"]), 1.0)
        self.assertLess(float(rows["exact-float"]["largest_error"]), 1e-5)
        # The mean error falls with the square of the spacing.
        self.assertAlmostEqual(summary["orders"]["cut"]["overall"], 2.0, delta=0.15)
        self.assertAlmostEqual(summary["orders"]["subdivide"]["last"], 2.0, delta=0.4)
        for family in ["cut-64", "resample-32", "subdivide-2", "cells"]:
            self.assertGreater(float(rows[family]["mean_error"]), 0.0)
            self.assertGreater(float(rows[family]["first_seconds"]), 0.0)
            self.assertGreater(int(rows[family]["triangles"]), 100)
        self.assertLess(
            float(rows["cut-64"]["contour_displaced"]), float(rows["cut-16"]["contour_displaced"])
        )
        for name in rows:
            self.assertTrue((folder / f"{name}.png").exists(), name)
            self.assertTrue((folder / f"{name}-error.png").exists(), name)

    def test_derivatives_by_vtks_gradient_filter(self):
        # The filter averages over elements at the file's points, and in parts of one element.
        for name, bounds in [("toroid_hex_g3_p6", [0.05, 1e-5]), ("escher_tet_g3_p3", [0.5, 1e-3])]:
            folder, summary, rows = self.compare(
                *[case(name), "--field", "mag(grad(u))", "--plane", "z=0.1", "--share", "50"],
                *["--resolutions", "64", "--grids", "none", "--levels", "1,2,3", "--repeat", "1"],
                output=name,
            )
            means = [float(rows[f"gradient-{level}"]["mean_error"]) for level in (1, 2, 3)]
            self.assertLess(means[1], 0.7 * means[0], name)
            self.assertLess(means[2], 0.7 * means[1], name)
            for level in (2, 3):
                gradient = rows[f"gradient-{level}"]
                exact_nodes = rows[f"subdivide-{level}"]
                self.assertEqual(gradient["missing"], exact_nodes["missing"])
                self.assertEqual(gradient["triangles"], exact_nodes["triangles"])
                self.assertGreater(float(gradient["first_seconds"]), 0.0)
                self.assertGreater(
                    float(gradient["mean_error"]), float(exact_nodes["mean_error"]), name
                )
            cells = rows["gradient-cells"]
            self.assertLess(float(cells["share_error"]), bounds[0])
            self.assertGreater(float(cells["share_error"]), bounds[1])
            self.assertEqual(cells["family"], "gradient-cells")
            methods = {s["setting"]: s.get("method", "") for s in summary["settings"]}
            self.assertIn("VTK's Gradient filter and Calculator", methods["gradient-cells"])
            self.assertIn("VTK's Gradient filter and Calculator", methods["gradient-2"])
            self.assertEqual(methods["subdivide-2"], "")
            self.assertIn("gradient", summary["orders"])
            page = (folder / "report.html").read_text(encoding="utf-8")
            self.assertIn("Gradient filter and Calculator", page)
            self.assertTrue((folder / "gradient-cells-error.png").exists())

    def test_derivatives_of_linear_fields_lose_nothing(self):
        # A hexahedron, a tetrahedron, a wedge and a pyramid.
        shapes = [
            (CUBE, 12),
            ([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 10),
            ([CUBE[i] for i in (0, 3, 1, 4, 7, 5)], 13),
            (CUBE[:4] + [[0.5, 0.5, 1.0]], 14),
        ]
        for points, kind in shapes:
            path = self.folder / f"{kind}.vtu"
            fields = [
                ("f", [x + 2.0 * y + 3.0 * z for x, y, z in points]),
                ("v", [[2.0 * y, z - x, 5.0 * x] for x, y, z in points]),
            ]
            grid = plain_grid(points, [(kind, list(range(len(points))))], fields)
            path.write_text(grid, encoding="utf-8")
            # vtkCutter's planes are floats. The derivatives are constant, the expression is linear.
            text = "f*mag(grad(f)) + dot(curl(v), vec(x,y,z)) + Q(v)"
            _, _, rows = self.compare(
                *[path, "--field", text, "--plane", "z=0.25", "--levels", "0,1,2", "--repeat", "1"],
                *["--resolutions", "none", "--grids", "none"],
            )
            for level in range(3):
                row = rows[f"gradient-{level}"]
                self.assertGreater(int(row["shown"]), 1000)
                self.assertLess(float(row["largest_error"]), 1e-12, kind)

    def test_second_derivatives_are_the_filters_of_its_first_ones(self):
        path = self.folder / "cube.vtu"
        field = ("f", [x * y * z for x, y, z in CUBE])
        path.write_text(plain_grid(CUBE, [(12, list(range(8)))], [field]), encoding="utf-8")
        _, _, rows = self.compare(
            *[path, "--field", "hessian(f)[0,1] + 2*laplacian(f)", "--plane", "x=0.25"],
            *["--levels", "0,1,2", "--resolutions", "none", "--grids", "none", "--repeat", "1"],
        )
        for level in range(3):
            row = rows[f"gradient-{level}"]
            self.assertGreater(int(row["shown"]), 1000)
            self.assertLess(float(row["largest_error"]), 1e-12)

    def test_what_vtks_filters_cannot_compute_has_a_row_that_says_so(self):
        few = ["--levels", "1", "--resolutions", "none", "--grids", "none", "--repeat", "1"]
        mesh = case("toroid_hex_g3_p6")
        for text, name in [
            ("mag(grad(u))*detJ", "'detJ'"),
            ("mag(grad(u)) + element", "'element'"),
            ("u*mag(grad(xi))", "'xi'"),
        ]:
            _, summary, rows = self.compare(mesh, "--field", text, *few)
            self.assertIn(name, rows["gradient"]["refused"])
            self.assertNotIn("gradient-1", rows)
            self.assertNotIn("gradient-cells", rows)
            refused = [s for s in summary["settings"] if s["setting"] == "gradient"]
            self.assertIn(name, refused[0]["refused"])
        _, _, rows = self.compare(
            *[mesh, "--field", "mag(grad(u))", "--boundary", "--levels", "1", "--repeat", "1"]
        )
        self.assertIn("cuts", rows["gradient"]["refused"])
        # Nodal values of these are exact, whoever computes them.
        _, _, rows = self.compare(mesh, "--field", "u^2", *few)
        self.assertFalse([name for name in rows if name.startswith("gradient")])

    def test_iso_surfaces_of_derivatives_by_vtks_gradient_filter(self):
        _, _, rows = self.compare(
            *[case("toroid_hex_g3_p6"), "--field", "u", "--isosurface", "mag(grad(u))=2"],
            *["--levels", "2,3", "--repeat", "1", "--truncate-orders", "none"],
        )
        for level in (2, 3):
            self.assertEqual(rows[f"gradient-{level}"]["refused"], "")
            self.assertGreater(int(rows[f"gradient-{level}"]["triangles"]), 100)
        self.assertEqual(rows["gradient-cells"]["refused"], "")

    def test_the_page_needs_nobody(self):
        folder, _, rows = self.compare(case("toroid_hex_g3_p6"), *FEW)
        page = (folder / "report.html").read_text(encoding="utf-8")
        self.assertNotIn("http", page)
        sources = re.findall(r'(?:src|href)="([^"]*)"', page)
        self.assertGreaterEqual(len(sources), 3)
        for source in sources:
            self.assertTrue(source.startswith("data:image/png;base64,iVBOR"), source[:60])
        for name in rows:
            self.assertIn(f'"name":"{name}"', page)
        for name in ["pareto.png", "convergence.png", "truth.png"]:
            self.assertTrue((folder / name).exists(), name)

    def test_linear_fields_on_straight_cells_lose_nothing(self):
        path = self.folder / "cube.vtu"
        field = ("f", [x + 2.0 * y + 3.0 * z for x, y, z in CUBE])
        path.write_text(plain_grid(CUBE, [(12, list(range(8)))], [field]), encoding="utf-8")
        _, summary, rows = self.compare(path, "--plane", "z=0.5", *FEW)
        self.assertNotIn("orders", summary)
        for name, row in rows.items():
            if "stride" in name:
                continue
            # vtkCutter's points on an image are floats.
            rounded = name == "exact-float" or name.startswith("resample")
            self.assertLess(float(row["largest_error"]), 1e-6 if rounded else 1e-12, name)
            self.assertEqual(int(row["missing"]), 0, name)

    def test_iso_surfaces_are_compared_with_contour_filters(self):
        path = self.folder / "cube.vtu"
        fields = [
            ("f", [x + 2.0 * y + 3.0 * z for x, y, z in CUBE]),
            ("g", [2.0 * x - y for x, y, z in CUBE]),
        ]
        path.write_text(plain_grid(CUBE, [(12, list(range(8)))], fields), encoding="utf-8")
        iso = ["--field", "g", "--isosurface", "f=2.9"]
        _, _, rows = self.compare(path, *iso, "--levels", "0,1,2", "--repeat", "1")
        self.assertNotIn("cut-64", rows)
        for level in range(3):
            row = rows[f"subdivide-{level}"]
            self.assertLess(float(row["largest_error"]), 1e-6)
            self.assertGreater(int(row["shown"]), 1000)
            # Rays along the rim may go by.
            self.assertLess(int(row["missing"]), 0.01 * int(row["shown"]))
        self.fails(2, "compare", path, *iso, "--grids", "8", names=["--grids"])

    def test_iso_surfaces_of_components_and_magnitudes(self):
        path = self.folder / "cube.vtu"
        fields = [
            ("v", [[x, 2.0 * y, 0.5 + z] for x, y, z in CUBE]),
            ("g", [2.0 * x - y for x, y, z in CUBE]),
        ]
        path.write_text(plain_grid(CUBE, [(12, list(range(8)))], fields), encoding="utf-8")
        options = ["--field", "g", "--levels", "1,2,3", "--repeat", "1"]
        # A plane, y = 0.3, and a part of an ellipsoid.
        _, _, rows = self.compare(path, "--isosurface", "v.y=0.6", *options)
        self.assertLess(float(rows["subdivide-2"]["largest_error"]), 1e-6)
        _, _, rows = self.compare(path, "--isosurface", "v.magnitude=1.3", *options)
        errors = [float(rows[f"subdivide-{level}"]["mean_error"]) for level in (1, 2, 3)]
        self.assertGreater(int(rows["subdivide-3"]["shown"]), 1000)
        self.assertGreater(errors[2], 0.0)
        self.assertLess(errors[1], 0.5 * errors[0])
        self.assertLess(errors[2], 0.5 * errors[1])

    def test_boundaries_as_triangles_converge_at_second_order(self):
        for name in ["toroid_hex_g3_p6", "escher_tet_g3_p3", "toroid_prism_g3_p4"]:
            _, summary, rows = self.compare(
                *[case(name), "--field", "u", "--boundary", "--view", "iso"],
                *["--levels", "1,2,3,4", "--repeat", "1"],
            )
            self.assertNotIn("cut-64", rows)
            self.assertNotIn("cells", rows)
            errors = [float(rows[f"subdivide-{level}"]["mean_error"]) for level in (2, 3, 4)]
            # Linear faces hang inside of the curved ones, so that silhouettes move, too.
            self.assertLess(errors[1], 0.4 * errors[0], name)
            self.assertLess(errors[2], 0.4 * errors[1], name)
            exact = rows["exact"]
            self.assertGreater(int(exact["shown"]), 1000)
        self.fails(2, "compare", case(name), "--boundary", "--grids", "8", names=["--grids"])

    def test_tori_and_boxes_converge_too(self):
        for name, surface in [
            ("--torus", "0,0,0,0,0,1,1,0.2"),
            ("--box", "-1.1,-1,-0.2,1.2,0.9,0.15"),
        ]:
            _, _, rows = self.compare(
                *[case("toroid_hex_g3_p6"), "--field", "u", name, surface],
                *["--resolutions", "16,32,64", "--grids", "none", "--levels", "3", "--repeat", "1"],
            )
            means = [float(rows[f"cut-{n}"]["mean_error"]) for n in (16, 32, 64)]
            self.assertGreater(int(rows["cut-64"]["shown"]), 1000)
            self.assertLess(means[1], 0.5 * means[0])
            self.assertLess(means[2], 0.5 * means[1])
            missing = [int(rows[f"cut-{n}"]["missing"]) for n in (16, 64)]
            self.assertLess(missing[1], max(1, missing[0]))
            self.assertGreater(int(rows["subdivide-3"]["triangles"]), 100)

    def test_threads_change_no_error(self):
        errors = []
        for threads in [1, 2]:
            _, _, rows = self.compare(
                case("escher_tet_g3_p3"), "--sphere", "0,0,0,1", *FEW, "--threads", threads
            )
            errors.append(
                [
                    {k: v for k, v in row.items() if "seconds" not in k and "ratio" not in k}
                    for row in rows.values()
                ]
            )
            for row in errors[-1]:
                del row["peak_bytes"]
        self.assertEqual(errors[0], errors[1])

    def test_the_fastest_that_is_near_enough_is_recommended(self):
        for target in ["1e-2", "1e-5"]:
            folder, summary, rows = self.compare(
                case("toroid_hex_g3_p6"), "--plane", "z=0.1", *FEW, "--target-error", target
            )
            near = {
                name: float(row["first_seconds"])
                for name, row in rows.items()
                if float(row["share_error"]) <= float(target) and "samples" not in name
            }
            recommended = summary["recommended"]
            # Times up to a tenth longer than the shortest count as alike.
            fast = {name for name in near if near[name] <= 1.1 * min(near.values())}
            self.assertIn(recommended["setting"], fast)
            least = min(float(rows[name]["share_error"]) for name in fast)
            self.assertEqual(float(rows[recommended["setting"]]["share_error"]), least)
            self.assertIn(recommended["setting"], recommended["text"])
            self.assertIn("Recommendation", (folder / "report.html").read_text(encoding="utf-8"))
        # Nothing linear is as near as that; the command is render's.
        self.assertTrue(recommended["setting"].startswith("exact"))
        self.assertIn("pixelexact render ", recommended["text"])

    def test_the_most_accurate_in_time_is_recommended(self):
        _, summary, _ = self.compare(case("toroid_hex_g3_p6"), *FEW, "--target-time", "100")
        self.assertEqual(summary["recommended"]["setting"], "exact")
        _, summary, _ = self.compare(case("toroid_hex_g3_p6"), *FEW, "--target-time", "1e-9")
        self.assertIsNone(summary["recommended"]["setting"])
        self.assertIn("no setting meets it; nearest is", summary["recommended"]["text"])

    def test_the_recommended_program_makes_the_surface(self):
        folder = self.folder / "trade"
        summary = self.summary(
            *["compare", case("toroid_hex_g3_p6"), "--plane", "z=0.1", "--output", folder],
            *["--resolutions", "none", "--grids", "none", "--levels", "3", "--repeat", "1"],
            *["--size", "600x600", "--target-error", "0.01", "--timed", "next"],
        )
        self.assertFalse(summary["recommended"]["setting"].startswith("exact"))
        script = folder / "recommended.py"
        self.assertIn(str(script), summary["recommended"]["text"])
        surface = self.folder / "cut.vtp"
        done = subprocess.run(
            [sys.executable, script, surface], capture_output=True, text=True, check=False
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(surface.stat().st_size, 1000)

    def test_what_does_not_fit_into_memory_is_refused_with_the_number(self):
        _, _, rows = self.compare(
            case("toroid_hex_g3_p6"),
            *["--resolutions", "32,1000000", "--grids", "100000", "--levels", "none"],
            *["--repeat", "1"],
        )
        self.assertEqual(rows["cut-32"]["refused"], "")
        self.assertRegex(rows["cut-1000000"]["refused"], r"squares on the plane need .* GB")
        self.assertRegex(rows["resample-100000"]["refused"], r"\d+ nodes need .* GB")

    def test_wrong_use_is_named(self):
        mesh = case("toroid_hex_g3_p6")
        for arguments, name in [
            (["--edges", "2"], "--edges"),
            (["--samples", "4"], "--samples"),
            (["--precision", "float"], "--precision"),
            (["--plane", "x", "--plane", "y"], "one surface"),
            (["--share", "0"], "--share"),
            (["--target-time", "0"], "--target-time"),
            (["--levels", "6"], "--levels"),
            (["--grids", "1"], "--grids"),
            (["--resolutions", "4;5"], "--resolutions"),
        ]:
            self.fails(2, "compare", mesh, *arguments, names=[name])
        blocked = self.folder / "file"
        blocked.write_text("", encoding="utf-8")
        self.fails(1, "compare", mesh, "--field", "u", *MIDDLE, "--output", blocked, names=[blocked])


if __name__ == "__main__":
    unittest.main()

"""Runs check_layers.py over small trees, good and bad."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECKER = Path(__file__).with_name("check_layers.py")

# A tree in which every kind of allowed include occurs.
GOOD = {
    "Module/Core/Base/Verdict.h": "#include <cstdint>\n",
    "Module/Core/Math/Lanes-inl.h": '#include <hwy/highway.h>\n#include "Core/Base/Verdict.h"\n',
    "Module/Core/Math/Vec.h": "#include <glm/vec3.hpp>\n",
    "Module/Core/Element/Kernel.cxx": (
        "#include <hwy/foreach_target.h>\n#include <hwy/highway.h>\n"
        '#include "Core/Math/Lanes-inl.h"\n'
    ),
    "Module/Core/Location/PointKernels.cxx": "#include <hwy/foreach_target.h>\n",
    "Module/Core/Index/EmbreeScene.cxx": (
        '#include "EmbreeScene.h"\n#include <embree4/rtcore.h>\n'
    ),
    "Module/Core/Index/EmbreeScene.h": '#include "Core/Math/Vec.h"\n',
    "Module/vtkGrid.h": '#include "Core/Base/Verdict.h"\n#include <vtkUnstructuredGrid.h>\n',
    "Filters/vtkProbe.h": '#include "vtkGrid.h"\n',
    "Filters/Cuts/Clip.h": '#include "vtkProbe.h"\n',
    "Filters/Formats/MFEM/Text/Scanner.h": '#include "Formats/FileText.h"\n',
    "Filters/Formats/MFEM/Meshes/Mesh.h": '#include "Formats/MFEM/Text/Scanner.h"\n',
    "Filters/Formats/MFEM/Reader.h": '#include "Formats/MFEM/Meshes/Mesh.h"\n',
    "Filters/Formats/FileText.h": "#include <string>\n",
    "Rendering/Trace/Camera.h": '#include "Core/Math/Vec.h"\n',
    "Rendering/vtkMapper.h": '#include "Trace/Camera.h"\n#include "vtkGrid.h"\n',
    "Rendering/Tools/main.cxx": '#include "vtkMapper.h"\n#include "Commands/Render.h"\n',
    "Rendering/Tools/Base/Report.h": '#include "vtkProbe.h"\n',
    "Rendering/Tools/Commands/Render.h": '#include "Base/Report.h"\n',
    "Rendering/Tools/View/Window.h": '#include "Commands/Render.h"\n',
}

# file, its text, what the checker must say about it
BAD = {
    "layer upwards": (
        "Module/Core/Base/Bad.h",
        '#include "Core/Math/Vec.h"\n',
        "layer Base may not include Module/Core/Math/Vec.h",
    ),
    "layer upwards by a relative path": (
        "Module/Core/Math/Bad.h",
        '#include "../Index/EmbreeScene.h"\n',
        "layer Math may not include",
    ),
    "file outside of the layers": ("Module/Core/Bad.h", "\n", "lies in no layer"),
    "unknown layer": ("Module/Core/Misc/Bad.h", "\n", "lies in no layer"),
    "VTK in Core": (
        "Module/Core/Math/Bad.h",
        "  #  include <vtkMath.h>\n",
        "Core is free of VTK",
    ),
    "VTK in Trace": ("Rendering/Trace/Bad.h", "#include <vtkMath.h>\n", "Trace is free of VTK"),
    "our own VTK class in Trace": (
        "Rendering/Trace/Bad.cxx",
        '#include "vtkGrid.h"\n',
        "Trace may not include Module/vtkGrid.h",
    ),
    "Module to Filters": (
        "Module/vtkBad.cxx",
        '#include "vtkProbe.h"\n',
        "DataModel may not include Filters/vtkProbe.h",
    ),
    "Module to Rendering": (
        "Module/vtkBad.cxx",
        '#include "Trace/Camera.h"\n',
        "DataModel may not include Rendering/Trace/Camera.h",
    ),
    "Filters to Rendering": (
        "Filters/vtkBad.cxx",
        '#include "vtkMapper.h"\n',
        "Filters may not include",
    ),
    "Rendering to Filters": (
        "Rendering/vtkBad.cxx",
        '#include "vtkProbe.h"\n',
        "Rendering may not include",
    ),
    "Rendering to Tools": (
        "Rendering/vtkBad.cxx",
        '#include "Tools/main.cxx"\n',
        "Rendering may not include Rendering/Tools/main.cxx",
    ),
    "layer of a format upwards": (
        "Filters/Formats/MFEM/Text/Bad.h",
        '#include "Formats/MFEM/Meshes/Mesh.h"\n',
        "layer Text may not include Filters/Formats/MFEM/Meshes/Mesh.h (layer Meshes is above)",
    ),
    "layer of a format to its reader": (
        "Filters/Formats/MFEM/Meshes/Bad.h",
        '#include "Formats/MFEM/Reader.h"\n',
        "(what stands on the layers of MFEM is above)",
    ),
    "layer of Tools upwards": (
        "Rendering/Tools/Base/Bad.h",
        '#include "Commands/Render.h"\n',
        "layer Base may not include Rendering/Tools/Commands/Render.h (layer Commands is above)",
    ),
    "Tools to its window": (
        "Rendering/Tools/Commands/Bad.h",
        '#include "View/Window.h"\n',
        "layer Commands may not include Rendering/Tools/View/Window.h",
    ),
    "layer of Filters upwards": (
        "Filters/Grids/Bad.h",
        '#include "Cuts/Clip.h"\n',
        "layer Grids may not include Filters/Cuts/Clip.h (layer Cuts is above)",
    ),
    "out of the rooms": (
        "Filters/vtkBad.cxx",
        '#include "../Testing/Fields.h"\n',
        "Filters may not include Testing/Fields.h",
    ),
    "Highway outside of Lanes": (
        "Module/Core/Basis/Bad.h",
        "#include <hwy/highway.h>\n",
        "only Core/Math/Lanes*.h knows Highway",
    ),
    "Highway outside of kernels": (
        "Module/Core/Location/Bad.cxx",
        "#include <hwy/foreach_target.h>\n",
        "only Core/Math/Lanes*.h knows Highway",
    ),
    "Highway in a header of Element": (
        "Module/Core/Element/Bad.h",
        "#include <hwy/highway.h>\n",
        "only Core/Math/Lanes*.h knows Highway",
    ),
    "more of Highway in a kernel": (
        "Module/Core/Element/Bad.cxx",
        "#include <hwy/contrib/math/math-inl.h>\n",
        "only Core/Math/Lanes*.h knows Highway",
    ),
    "Embree outside of Embree*": (
        "Module/Core/Location/Bad.h",
        "#include <embree3/rtcore.h>\n",
        "only Core/Index/Embree* knows Embree",
    ),
}


def check(files):
    """The checker's exit status and output over a tree of these files."""
    with tempfile.TemporaryDirectory() as root:
        for name, text in files.items():
            path = Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        result = subprocess.run(
            [sys.executable, str(CHECKER), root], capture_output=True, text=True, check=False
        )
        return result.returncode, result.stdout + result.stderr


class CheckLayers(unittest.TestCase):
    def test_good_tree_passes(self):
        self.assertEqual(check(GOOD), (0, ""))

    def test_each_offence_is_reported(self):
        for name, (path, text, message) in BAD.items():
            with self.subTest(name):
                status, output = check({"Testing/Fields.h": "", **GOOD, path: text})
                self.assertEqual(status, 1, output)
                self.assertIn(message, output)
                self.assertTrue(output.startswith(f"{path}:1: "), output)
                self.assertEqual(len(output.splitlines()), 1, output)

    def test_all_offences_are_reported(self):
        bad = {
            "Module/Core/Base/Bad.h": "#pragma once\n#include <vtkMath.h>\n#include <hwy/base.h>\n"
        }
        status, output = check({**GOOD, **bad})
        self.assertEqual(status, 1)
        self.assertIn("Module/Core/Base/Bad.h:2: ", output)
        self.assertIn("Module/Core/Base/Bad.h:3: ", output)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of surfaces share: a picture with its buffers, and values at its positions."""

from tool import ToolTest, columns, read_buffers, read_csv, read_image

EXACT = 1


def numbers(values):
    return ",".join(repr(float(v)) for v in values)


class SurfaceTest(ToolTest):
    def render(self, source, *options, field="u"):
        image, buffers = self.folder / "image.png", self.folder / "buffers.vti"
        outputs = ["--output", image, "--buffers", buffers]
        summary = self.summary("render", source, "--field", field, *options, *outputs)
        return summary, read_buffers(buffers), read_image(image)

    def probe(self, source, positions):
        points, out = self.folder / "points.csv", self.folder / "out.csv"
        lines = "".join(numbers(position) + "\n" for position in positions)
        points.write_text("x,y,z\n" + lines, encoding="utf-8")
        self.succeeds("probe", source, "--field", "u", "--points", points, "--output", out)
        return columns(read_csv(out))

"""A client of pvserver shows what ParaView does without one."""

import os
import re
import shutil
import subprocess
import time
import unittest

import numpy

import numbers_of
import pictures
import scene

TORUS = scene.data("toroid_hex_g3_p6.vtu")
ESCHER = scene.data("escher_tet_g3_p3.vtu")


def text_of(name):
    with open(name) as file:
        return file.read()


@unittest.skipIf(shutil.which("mpirun") is None, "there is no mpirun")
class ClientServer(unittest.TestCase):
    def run_client(self, maker, kind, name, file):
        """What a script makes: the picture, or the numbers."""
        made = os.path.join(scene.PICTURES, name)
        done = subprocess.run(
            ["pvpython", maker.script(), kind, made, file],
            env=pictures.environment(),
            capture_output=True,
            text=True,
            timeout=300,
        )
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("ERR|", done.stdout + done.stderr)
        return maker.read(made)

    def served(self, maker, kind, file, processes):
        """The same of a client whose server has so many processes."""
        log = os.path.join(scene.PICTURES, f"server_{kind}_{processes}.txt")
        with open(log, "w") as out:
            server = subprocess.Popen(
                ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(processes)]
                + ["pvserver", "--server-port=0"],
                env=pictures.environment(),
                stdout=out,
                stderr=subprocess.STDOUT,
            )
        try:
            for _ in range(600):
                said = re.search(r"Accepting connection\S*: \S+:(\d+)", text_of(log))
                if said or server.poll() is not None:
                    break
                time.sleep(0.2)
            self.assertTrue(said, text_of(log))
            name = f"served_{kind}_{processes}{maker.SUFFIX}"
            found = self.run_client(maker, f"port:{said.group(1)}:{kind}", name, file)
            server.wait(timeout=60)  # it ends with its client
        finally:
            if server.poll() is None:
                server.terminate()
                server.wait()
        self.assertNotIn("ERR|", text_of(log))
        return found

    def test_the_same(self):
        for kind, file in (("cut", TORUS), ("iso", ESCHER), ("contours_edges", TORUS)):
            alone = self.run_client(pictures, kind, f"alone_{kind}.png", file)
            self.assertGreater(len(numpy.unique(alone.reshape(-1, alone.shape[-1]), axis=0)), 20)
            for processes in (1, 2):
                with self.subTest(kind, processes=processes):
                    served = self.served(pictures, kind, file, processes)
                    off = numpy.abs(served - alone).max(axis=-1)
                    self.assertEqual(numpy.count_nonzero(off), 0)

    def test_the_same_numbers(self):
        alone = self.run_client(numbers_of, "lines", "alone_lines.json", TORUS)
        self.assertIn("\nin [", "".join(alone["pointed"]))
        for processes in (1, 2):
            with self.subTest(processes=processes):
                numbers_of.compare(self, self.served(numbers_of, "lines", TORUS, processes), alone)


if __name__ == "__main__":
    scene.main()

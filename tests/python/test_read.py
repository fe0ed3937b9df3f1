# SPDX-License-Identifier: MPL-2.0
"""The Python module against the files of small runs that the program makes here."""

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: no numpy for", sys.executable, "(apt-get install python3-numpy)")
    sys.exit(77)
try:
    import h5py  # noqa: F401
except ImportError:
    h5py = None

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
import porefines  # noqa: E402

OUTPUT = ('output=[{kind="tracks", every="2 ms"}, {kind="summary", every="2 ms"}, '
          '{kind="fields", every="20 ms"}]')


def run_case(folder):
    subprocess.run(
        [os.environ["PF_BINARY"], "run", ROOT / "cases/throat/case.toml", OUTPUT, "-o", folder / "out"],
        check=True, stdout=subprocess.DEVNULL,
        env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"},
    )
    return folder / "out"


class Coupled(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = run_case(pathlib.Path(cls.scratch.name))
        cls.run_read = porefines.read(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def rows(self, name):
        with (self.folder / name).open() as file:
            return list(csv.DictReader(file))

    def test_series_holds_every_number_of_the_file(self):
        rows = self.rows("series.csv")
        self.assertEqual(self.run_read.series.rows, len(rows))
        for name, values in self.run_read.series.items():
            np.testing.assert_array_equal(values, [float(row[name]) for row in rows], err_msg=name)

    def test_tracks_come_by_time_and_by_particle(self):
        run = self.run_read
        times = [time for time, _ in run.frames()]
        self.assertEqual(times, sorted({float(row["time_s"]) for row in self.rows("tracks.csv")}))
        way = run.track(run.tracks["id"][0])
        self.assertEqual(way.rows, len(times))
        self.assertGreater(way["x_m"][-1], way["x_m"][0] + 5e-6)
        self.assertEqual(set(run.tracks["state"]), {row["state"] for row in self.rows("tracks.csv")})
        with self.assertRaises(KeyError):
            run.track(99)

    def test_the_clog_lies_in_its_throat(self):
        run = self.run_read
        first = run.clogging.where([0])
        self.assertEqual(str(first["event"][0]), "clogged")
        self.assertEqual(str(first["kind"][0]), "sieve")
        throat = int(first["throat"][0])
        self.assertAlmostEqual(run.throats["width_m"][throat], 8e-6, delta=0.4e-6)
        self.assertAlmostEqual(first["x_m"][0], run.throats["x_m"][throat], delta=1e-12)
        self.assertGreater(run.pores.rows, 1)
        self.assertTrue(np.all(run.throat_pressures["throat"] == throat))

    def test_retention_is_a_profile_per_sample(self):
        profile = self.run_read.retention()
        samples, bins = profile["retained"].shape
        self.assertEqual((samples, bins), (len(profile["time_s"]), len(profile["x_m"])))
        self.assertEqual(profile["retained"][-1].sum(), 1)
        self.assertEqual(profile["retained"][0].sum(), 0)

    def test_summary_and_case(self):
        self.assertEqual(self.run_read.summary["particles_inside"], 1)
        self.assertEqual(self.run_read.case["title"], "A sieved fine")
        self.assertEqual(self.run_read.case["flow"]["inlet"]["pressure"], "10 Pa")

    def test_what_is_not_there_is_said(self):
        with self.assertRaisesRegex(porefines.MissingOutput, "no folder of a finished run"):
            porefines.read(self.folder / "nowhere")
        with self.assertRaisesRegex(porefines.MissingOutput, "porefines compare"):
            _ = self.run_read.agreement

    @unittest.skipIf(h5py is None, "no h5py (apt-get install python3-h5py)")
    def test_fields_carry_the_flow_rate(self):
        run = self.run_read
        self.assertEqual(len(run.field_times), 4)
        fields = run.fields()
        self.assertEqual(fields.time, run.field_times[-1])
        self.assertEqual(fields.velocity.shape, fields.pressure.shape + (3,))
        self.assertAlmostEqual(fields.centres(0)[0], fields.origin[0] + 0.5 * fields.spacing[0])

        def rate_before_the_pillars(step):  # beside plates a face carries less than its u: 1 % at 9 cells
            moment = run.fields(step, names=["velocity"])
            planes = moment.velocity[..., 0].astype(float).sum(axis=(0, 1))[:8]
            np.testing.assert_allclose(planes, planes[0], rtol=1e-3)
            return planes[0] * fields.spacing[1] * fields.spacing[2]

        rates = np.array([rate_before_the_pillars(step) for step in range(4)])
        at = np.searchsorted(run.series["time_s"], run.field_times * (1 - 1e-9))
        written = run.series["flow_rate_m3_s"][at]
        np.testing.assert_allclose(rates / rates[-1], written / written[-1], rtol=1e-3)
        np.testing.assert_allclose(rates, written, rtol=0.012)
        with self.assertRaises(IndexError):
            run.fields(17)

    def test_the_example_runs_as_written(self):
        if h5py is None:
            self.skipTest("no h5py")
        done = subprocess.run(
            [sys.executable, str(ROOT / "python/examples/clogging.py"), str(self.folder)], cwd=self.scratch.name,
            env={**os.environ, "PYTHONPATH": str(ROOT / "python")}, capture_output=True, text=True,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("8 um wide, by a sieve", done.stdout)


if __name__ == "__main__":
    unittest.main()

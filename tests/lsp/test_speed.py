"""Answers on a library of 5,000 lines come soon enough: CPU time, with room for a slower machine."""
import importlib.machinery
import importlib.util
import statistics
import subprocess
import tempfile
import unittest
from pathlib import Path

import client

BENCH = Path(__file__).resolve().parents[2] / "bench"
ROOM = 3  # times the limits of bench/lsp


def load_bench():
    loader = importlib.machinery.SourceFileLoader("bench_lsp", str(BENCH / "lsp"))
    bench = importlib.util.module_from_spec(importlib.util.spec_from_loader("bench_lsp", loader))
    loader.exec_module(bench)
    return bench


class Speed(unittest.TestCase):
    def test_limits(self):
        bench = load_bench()
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([BENCH / "make_library", folder], check=True)
            for name in ("library.style", "street.style"):
                checked = subprocess.run([client.PROGRAM, "check", Path(folder) / name],
                                         capture_output=True, text=True)
                self.assertEqual(checked.stderr, f"{folder}/{name}: no errors\n")
            limits = {"mansard check": ROOM * bench.CHECK}
            results = {**bench.measure(folder, 3),
                       "mansard check": bench.check_times(client.PROGRAM, folder, 3)}
        self.assertGreater(len(results), 25)
        for what, times in results.items():
            cpu = statistics.median(cpu for cpu, _ in times)
            self.assertLess(cpu, limits.get(what, ROOM * bench.ANSWER), what)


if __name__ == "__main__":
    client.main()

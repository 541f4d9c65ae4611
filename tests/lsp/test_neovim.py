"""Neovim with editors/neovim, as a user has it, against the real server."""
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import client

HERE = Path(__file__).resolve().parent
NVIM = shutil.which("nvim")

HOUSE = '''style House {
    var Height = 6
    Mass { FOOTPRINT -> extrude(Height) { comp { side : TILE } } }
    Tile { var WindowWidth = 1.2   TILE -> subdiv("X", 1r, WindowWidth, 1r) { WALL | WINDOW | WALL } }
}
'''

HEIR = '''import "house.style"
style Heir : House {
    Tile {
        var WindowWidth = 0.6
        // a comment
        TILE -> extruda(WindowWidth) { comp { side : WALL | top : WALL } } super
    }
}
'''


@unittest.skipUnless(NVIM, "there is no nvim in the PATH")
class Neovim(unittest.TestCase):
    def test_a_session(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name).resolve()
            (folder / "house.style").write_text(HOUSE)
            (folder / "heir.style").write_text(HEIR)
            said = folder / "said"
            environment = {**os.environ, "MANSARD": client.PROGRAM, "MANSARD_SAID": str(said),
                           "HOME": name, "XDG_CONFIG_HOME": name, "XDG_DATA_HOME": name,
                           "XDG_STATE_HOME": name, "XDG_CACHE_HOME": name}
            run = subprocess.run(
                [NVIM, "--headless", "-u", "NONE", "-i", "NONE", "-n",
                 "--cmd", f"set runtimepath+={HERE.parents[1] / 'editors/neovim'}",
                 "--cmd", "filetype plugin indent on | syntax on", "-S", HERE / "neovim.lua"],
                cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                text=True, timeout=120)
            lines = said.read_text().splitlines() if said.exists() else []
            steps = dict(json.loads(line) for line in lines)
            self.assertEqual((run.returncode, run.stderr), (0, ""), steps)
            self.check(steps)

    def check(self, steps):
        self.assertNotIn("timeout", steps)
        self.assertEqual(steps["filetype"], "mansard")
        self.assertEqual(steps["highlight"], [
            "mansardDeclaration", "mansardStyleName", "", "mansardOperation", "mansardRule", "mansardLabel",
            "mansardComment", "mansardControl"])
        self.assertEqual(steps["broken"], [[6, 1, "unknown operation 'extruda'"]])
        self.assertEqual(steps["mended"], [])
        self.assertEqual(steps["definition"], ["heir.style", 4, "WindowWidth"])
        self.assertEqual(steps["declaration"], ["house.style", 4, "WindowWidth"])
        self.assertIn("var WindowWidth = 0.6", steps["hover"])
        self.assertIn("Overrides `House.Tile` (house.style:4)", steps["hover"])
        self.assertEqual(steps["completion"], [True, True, True])
        house, heir = ("\n".join(lines) + "\n" for lines in steps["renamed"])
        self.assertEqual(house, HOUSE.replace("WindowWidth", "PaneWidth"))
        self.assertEqual(heir, HEIR.replace("WindowWidth", "PaneWidth").replace(
            "extruda", "extrude"))
        self.assertEqual(steps["formatted"], ["style Late : Heir { }"])


if __name__ == "__main__":
    client.main()

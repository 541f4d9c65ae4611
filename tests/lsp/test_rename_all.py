"""Every name of the examples is renamed, alone, and what comes out is checked: no new problems."""
import re
import shutil
import subprocess
from pathlib import Path

import client
from client import Case, Refused, edited

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
LIBRARY = EXAMPLES.parent / "styles" / "library"
DECLARED = re.compile(r"(?:\b(?:style|var|def)\s+([A-Za-z]\w*))|(?:([A-Za-z]\w*)\s*\{\s*$)|"
                      r"(?:^\s*([A-Za-z]\w*)(?:\([^()]*\))?\s*(?::[^|{}]*)?->)", re.M)


class RenameAll(Case):
    def problems(self, folder):
        scripts = sorted(folder.glob("*.style"))
        out = subprocess.run([client.PROGRAM, "check", "--quiet", *scripts], capture_output=True,
                             text=True)
        return out.stderr.count("error:"), out.stderr.count("warning:")

    def test_examples(self):
        for script in [*EXAMPLES.rglob("*.style"), *LIBRARY.glob("*.style")]:
            self.write(**{script.stem: script.read_text(encoding="utf-8")})
        self.serve(*self.texts)
        scratch = self.folder / ".renamed"
        scratch.mkdir()
        before = self.problems(self.folder)
        renamed = 0
        for name in sorted(self.texts):
            for match in DECLARED.finditer(self.texts[name]):
                group = match.lastindex
                if self.try_rename(name, match.start(group), match[group], scratch):
                    renamed += 1
                    self.assertEqual(self.problems(scratch), before, (name, match[group]))
        self.assertGreater(renamed, 100)

    def try_rename(self, name, at, word, scratch):
        """Writes all scripts as they are after the rename; False when it was refused."""
        text = self.texts[name]
        fresh = "FRESH_NAME" if word.isupper() else "FreshName"
        try:
            changes = self.client.request("textDocument/rename", {
                "textDocument": {"uri": self.uri(name)}, "newName": fresh,
                "position": client.position(text, text[at:], 0, 1)})["changes"]
        except Refused as refused:
            self.assertRegex(refused.message, "derivation begins|belongs to the language|"
                                              "no name here|name of a file")
            return False
        shutil.rmtree(scratch)
        scratch.mkdir()
        for other, content in self.texts.items():
            content = edited(content, changes.get(self.uri(other), []))
            (scratch / other).write_text(content, encoding="utf-8")
        self.assertTrue(changes, (name, word))
        return True


if __name__ == "__main__":
    client.main()

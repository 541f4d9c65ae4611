"""Every name of the examples is renamed, alone, and what comes out is checked: no new problems."""
import json
import os
import re
import subprocess
from itertools import islice
from pathlib import Path

import client
from client import Case, Refused, edited

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
LIBRARY = EXAMPLES.parent / "styles" / "library"
EVERY = int(os.environ.get("MANSARD_EVERY", "1"))  # a sample where programs are slow
DECLARED = re.compile(r"(?:\b(?:style|var|def)\s+([A-Za-z]\w*))|(?:([A-Za-z]\w*)\s*\{\s*$)|"
                      r"(?:^\s*([A-Za-z]\w*)(?:\([^()]*\))?\s*(?::[^|{}]*)?->)", re.M)
IMPORTED = re.compile(r'^\s*import\s+"([^"]+)"', re.M)


class RenameAll(Case):
    def problems(self, scripts):
        """Errors and warnings of each script."""
        found = {}
        for script in scripts:
            out = subprocess.run([client.PROGRAM, "check", "--quiet", script], capture_output=True,
                                 text=True)
            found[script.name] = out.stderr.count("error:"), out.stderr.count("warning:")
        return found

    def who_reads(self, changed):
        """Names of the scripts that are among the changed ones or import one of them."""
        reached = set(changed)
        while True:
            more = {name for name, text in self.texts.items()
                    if reached & set(Path(i).name for i in IMPORTED.findall(text))} - reached
            if not more:
                return reached
            reached |= more

    def test_examples(self):
        for script in [*EXAMPLES.rglob("*.style"), *LIBRARY.glob("*.style")]:
            self.write(**{script.stem: script.read_text(encoding="utf-8")})
        self.serve(*self.texts)
        scratch = self.folder / ".renamed"
        scratch.mkdir()
        for name, text in self.texts.items():
            (scratch / name).write_text(text, encoding="utf-8")
        before = self.problems(sorted(self.folder.glob("*.style")))
        self.seen = set()
        renamed = 0
        for name in sorted(self.texts):
            for match in islice(DECLARED.finditer(self.texts[name]), 0, None, EVERY):
                group = match.lastindex
                changed = self.try_rename(name, match.start(group), match[group], scratch)
                if not changed:
                    continue
                renamed += 1
                readers = map(scratch.joinpath, self.who_reads(changed))
                for other, found in self.problems(readers).items():
                    self.assertEqual(found, before[other], (name, match[group], other))
                for other in changed:
                    (scratch / other).write_text(self.texts[other], encoding="utf-8")
        self.assertGreater(renamed, 100 / EVERY)

    def try_rename(self, name, at, word, scratch):
        """Writes the scripts that the rename changes as they are after it and gives their names;
        none when it was refused, or is one that was there: another writing of a name."""
        text = self.texts[name]
        fresh = "FRESH_NAME" if word.isupper() else "FreshName"
        try:
            changes = self.client.request("textDocument/rename", {
                "textDocument": {"uri": self.uri(name)}, "newName": fresh,
                "position": client.position(text, text[at:], 0, 1)})["changes"]
        except Refused as refused:
            self.assertRegex(refused.message, "derivation begins|belongs to the language|"
                                              "no name here|name of a file")
            return set()
        changed = json.dumps(changes, sort_keys=True)
        if changed in self.seen:
            return set()
        self.seen.add(changed)
        written = {other for other in self.texts if self.uri(other) in changes}
        self.assertTrue(written, (name, word))
        for other in written:
            (scratch / other).write_text(
                edited(self.texts[other], changes[self.uri(other)]), encoding="utf-8")
        return written


if __name__ == "__main__":
    client.main()

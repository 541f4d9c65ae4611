#!/usr/bin/env python3
"""Every construct of the language has an example in docs/language.md that runs, and every one that
comes later is refused there in the words that are shown: tests/docs/check_constructs.py MANSARD

The examples themselves are run by run_examples.py; here is only looked whether each construct of
grammar/rules.hpp, and each word with a meaning of its own, is in one of them.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "language.md"
FENCE = re.compile(r"^```style\n(.*?)^```$", re.M | re.S)
# | `what` | `an example` | `the message` |
LATER = re.compile(r"^\| `(.+?)` \| `(.+?)` \| `(.+?)` \|$", re.M)

# What it is called, and what it looks like where comments are left out.
CONSTRUCTS = {
    # files and styles
    "import": r'import "',
    "style": r"\bstyle \w+ \{",
    "class": r"\bclass \w+",
    "one parent": r"\bstyle \w+ : \w+ \{",
    "several parents": r"\bstyle \w+ : \w+, \w+",
    "final style": r"\bfinal style",
    "start": r"\bstart \w+",
    "replace": r"\breplace \w+ \{",
    "empty style": r"\bstyle \w+ : [\w, ]+ \{ *\}",
    # members
    "variable": r"\bvar \w+ = ",
    "variable as in the thesis": r"\bvar \w+ [\d.(\"]",
    "variable of the style": r"(?m)^style [^\n]*\{\n(    [@/].*\n)*    var ",
    "function": r"\bdef \w+\(",
    "abstract symbol": r"\babstract [A-Z]\w*(?!\()\b",
    "abstract symbol with parameters": r"\babstract [A-Z]\w*\(",
    "abstract variable": r"\babstract var",
    "final variable": r"\bfinal var",
    "final rule": r"\bfinal [A-Z]\w*[ (]",
    "override of a variable": r"\boverride var",
    "override of a rule": r"\boverride [A-Z]\w*",
    "override of a function": r"\boverride def",
    **{f"@{name}": rf"@{name}\b" for name in
       ("range", "choice", "unit", "label", "group", "color", "hidden", "seed")},
    **{f"@per of {what}": rf'@per\("{word}"\)' for what, word in
       (("a shape", "shape"), ("a building", "building"), ("a symbol", "[A-Z]+"))},
    # rules
    "rule": r"\b\w+ +-> ",
    "condition": r"\b\w+ +: [A-Z] [<>]",
    "else": r": else +->",
    "else with a condition": r": else [^-\n]+->",
    "fits": r": fits +->",
    "fits in an expression": r"fits &&|&& fits|!fits",
    "probability": r"\} +: 0\.\d",
    "parameters": r"\b[A-Z]\w*\(\w+\) *(:[^\n]*)?->",
    "two parameters": r"\b[A-Z]\w*\(\w+, \w+\) *(:[^\n]*)?->",
    "index tested": r"\b\w+\[\d\] +->",
    "index bound": r"\b\w+\[[a-z]\] +->",
    # successors
    "saving a shape": r"(->|\|) *\[ ",
    "if": r"-> if ",
    "else if": r"\} else if ",
    "else in a successor": r"\} else \{",
    "super": r"\bsuper\b",
    "super with arguments": r"(?s)\w+\(\w+\) -> [^\n]*super",
    "another style": r"\b[A-Z]\w*::[A-Z]+",
    "a style by name": r"\bstyle\(.+?\)::",
    "symbol with arguments": r"-> [^\n]*\b[A-Z][a-z]\w*\(\d",
    "symbol as an argument": r"\b[A-Z]\w*\(\d, [A-Z]{2,}\)",
    "index set": r"\b[A-Z]\w*\[\w+[.\w]*\]",
    "operation without parts": r"-> [^\n{]*\b[a-z]\w*\([^)\n]*\) [A-Z]",
    "operation that only has parts": r"\bcomp \{",
    "parts by place": r"\{ [A-Z]\w+ \| ",
    "parts by name": r"\{ inner : ",
    "parts by number": r"\{ 0 : ",
    "nested parts": r"\{ [^{}\n]*\{ [^{}\n]*\{ ",
    "NIL": r"\bNIL\b",
    "pattern": r'\bsplit\("[XY]"\) \{ [^\n]*: ',
    "repeated group": r"\{ [^{}\n]*\}\* *\}",
    "repeated pattern": r'\bsplit\("[XY]"\) \{[^\n{}]*\}\*',
    "emitted variable": r"(?s)var Infill = BRICK.*\| Infill",
    "named argument": r"\boverhang = ",
    # sizes
    "metres": r'subdiv\("[XYZ]", 0\.\d',
    "per cent": r"\b\d+%",
    "per cent of an expression": r"\)%",
    "share": r"\b\dr\b",
    "share of an expression": r"\)r\b",
    "floating size": r"~\d",
    "list of sizes": r"var Storeys = \[",
    "one part for several sizes": r"(?s)var Storeys.*Storeys, 1r\) \{ \w+\[split\.index\] \}",
    **{f"axis {a}": rf'(subdiv|repeat|split)\("{a}"' for a in "XYZ"},
    "axis at an angle": r"subdiv\(-?\d+, ",
    **{f'repeat "{m}"': rf'repeat\([^)]*"{m}"\)' for m in ("nearest", "fit", "ceil")},
    # components
    **{f"selector {w}": rf"[{{|] *{w} : " for w in
       ("faces", "side", "facades", "sidefaces", "front", "back", "left", "right", "top", "bottom",
        "vertical", "horizontal", "slanted", "party", "court", "street", "main", "cut", "edges",
        "vertices", "all")},
    "comp of one selector": r'\bcomp\("',
    "edges by a word": r'(setback|offset)\([\d.]+, "',
    "edges by a list": r'(setback|offset)\([\d.]+, \["',
    "edges by a number": r"(setback|offset)\([\d.]+, \d\)",
    # expressions
    "number with an exponent": r"\b\d+(\.\d+)?e-?\d",
    "true and false": r"(?s)\btrue\b.*\bfalse\b",
    "text": r'"[a-z ]+"',
    "escapes": r'\\".*\\\\.*\\u[0-9a-fA-F]{4}',
    "list": r"\[\d[^\]\n]*, ",
    "list item": r"\b[A-Z]\w*\[\w+[^\]]*\] ",
    "conditional": r"\bif [^\n]* then [^\n]* else ",
    **{f"operator {o}": rf'[\w)"] {re.escape(o)} [\w("-]' for o in
       ("+", "-", "*", "/", "<", "<=", ">", ">=", "==", "!=", "&&", "||")},
    "operator !": r"!\w",
    "minus sign": r"[(= ]-\w",
    "parenthesis": r"[=*/+-] \(",
    "call of a function": r"\bmin\(",
    "call of a definition": r"(?s)def width\(.*\bwidth\(",
    "variable of another block": r"\b[A-Z]\w+\.[A-Z]\w+",
    "definition of another block": r"\b[A-Z]\w+\.[a-z]\w+\(",
    "comparison of symbols": r"symbol == [A-Z]",
    **{f"attribute {w}": rf"\b{re.escape(w)}\b" for w in
       ("W", "H", "D", "scope.sx", "scope.sy", "scope.sz", "scope.tx", "scope.ty", "scope.tz",
        "area", "volume", "perimeter", "inradius", "edges", "is_rectangle", "is_convex",
        "is_planar", "facing", "slope", "elevation", "split.index", "split.count", "split.round",
        "comp.index", "comp.count", "comp.name", "level", "index", "symbol", "seed",
        "BUILDING_HEIGHT", "BUILDING_LEVELS", "BUILDING_NAME", "BUILDING_USE")},
    "property": r'\battr\("',
    **{f"{f}()": rf"\b{f}\(" for f in ("rand", "normal", "choose", "str", "num", "set", "report")},
    "choose with weights": r"choose\(\[.*?\], \[",
    # questions
    **{f"question {w}": rf'\b{w}\("' for w in (r"Shape\.occ", "inside", "overlaps", "touches")},
    **{f"set {w}": rf'\("{w}"' for w in ("all", "noparent", "neighbours")},
    "set of a label": r'(?s)label\("bay"\).*Shape\.occ\("bay"\)',
    "distance": r'"distance", \d',
    **{f"group.{w}": rf"\bgroup\.{w}\(" for w in ("any", "best")},
    "group below a symbol": r'group\.any\(.*, "ROW"\)',
    "alternatives": r"\bbest\((?s:.*?)\) \{ .* \| ",
    **{f"{f}()": rf"\b{f}\(" for f in ("made", "report")},
    **{f"axis {a}S": rf'(subdiv|repeat|split)\("{a}S"' for a in "XYZ"},
    **{f"snapping {w}": rf'\b{w}\("[XYZ]S"' for w in ("subdiv", "repeat", "split")},
    "snap": r'\bsnap\("YZ"\)',
    "snap to a label": r'\bto = "',
    "tolerance": r"\btolerance = 0",
    "@stage": r"@stage\(2\)",
    "occluder": r"\boccluder\(",
    # elements and materials
    "elements": r"\bElements \{",
    "levels of detail": r'"\w+LOD1\.\w+" "\w+LOD2\.\w+"',
    "weight of an element": r'\.\w+" : 0\.\d',
    "bar between elements": r'\.\w+" \| "',
    "element added": r'\b[A-Z]+ +\+ "',
    "element taken": r'\b[A-Z]+ +- "',
    "entry removed": r"\bremove [A-Z]+",
    "materials": r"\bMaterials \{",
    "weight of a material": r"color\([^)]*\) : 0\.\d",
    "bar between materials": r"color\([^)]*\) \| ",
    "material added": r"\b[A-Z]+ +\+ color",
    "material taken": r"\b[A-Z]+ +- color",
    "opacity": r"\bopacity\(",
    "texture": r"\btexture\(",
    "metres": r"\bmetres\(",
    "roughness": r"\broughness\(\d",
    "picture of roughness": r'\broughness\("',
    "metallic": r"\bmetallic\(",
    "normals": r"\bnormals\(",
    **{f"per {w}": rf'per "{w}"' for w in ("building", "shape", "[A-Z]+")},
}
# Comments are looked for with them left in.
COMMENTS = {"line comment": r" // ", "comment": r"/\* [^*]*/\*.*?\*/.*?\*/", "documentation": r"/// "}


def main():
    page = PAGE.read_text(encoding="utf-8")
    whole = "\n".join(FENCE.findall(page))
    bare = re.sub(r'("(?:[^"\\\n]|\\.)*")|//[^\n]*|/\*.*?\*/', lambda m: m[1] or "", whole,
                  flags=re.S)
    problems = [f"no example of: {name}" for name, shape in CONSTRUCTS.items()
                if not re.search(shape, bare)]
    problems += [f"no example of: {name}" for name, shape in COMMENTS.items()
                 if not re.search(shape, whole, re.S)]
    later = LATER.findall(page)
    for what, example, message in later:
        problems += refusal(sys.argv[1], what, example.replace("\\|", "|"), message)
    print("\n".join(problems))
    print(f"constructs: {len(CONSTRUCTS) + len(COMMENTS)} with examples, {len(later)} refused, "
          f"{len(problems)} problems")
    return 1 if problems or not later else 0


def refusal(mansard, what, rules, message):
    """The example, in a style like that of the other fragments, must be refused in these words."""
    text = ("style Example {\nStart { FOOTPRINT -> extrude(6) comp { side : FACADE | top : ROOF } }\n"
            f"Rules {{ {rules} }}\n}}\n")
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "later.style"
        script.write_text(text, encoding="utf-8")
        done = subprocess.run([mansard, "derive", str(script), "rect:10x8", "-o",
                               str(Path(folder) / "later.obj")],
                              capture_output=True, text=True, timeout=60)
    said = [line[len("error: "):] for line in done.stderr.splitlines() if line.startswith("error: ")]
    if done.returncode != 1 or said != [message]:
        yield f"{what}: {rules}\n  says: {said}\n  not:  {message}"


if __name__ == "__main__":
    sys.exit(main())

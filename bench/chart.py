"""Lines over two logarithmic axes, as SVG."""
import math

WIDE, HIGH, LEFT, TOP, LOW, LEGEND = 640, 360, 70, 30, 310, 190


class Chart:
    """`across` and `up` are powers of ten: the first and the last one of an axis."""

    def __init__(self, across, up, bottom, left):
        self.across, self.up = across, up
        self.names = 0
        self.out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDE}" height="{HIGH}" '
                    'font-family="sans-serif" font-size="12">',
                    f'<rect width="{WIDE}" height="{HIGH}" fill="white"/>']
        for power in range(across[0], across[1] + 1):
            x, _ = self.place(10 ** power, 10 ** up[0])
            self.out.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{LOW}" stroke="#ddd"/>'
                            f'<text x="{x:.1f}" y="{LOW + 18}" text-anchor="middle">{10 ** power:,}</text>')
        for power in range(up[0], up[1] + 1):
            _, y = self.place(10 ** across[0], 10 ** power)
            value = f"{10 ** power:,}" if power > 0 else f"{10 ** power:g}"
            self.out.append(f'<line x1="{LEFT}" x2="{WIDE - LEGEND}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>'
                            f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{value}</text>')
        self.out.append(f'<text x="{LEFT}" y="18">{left}</text>'
                        f'<text x="{(LEFT + WIDE - LEGEND) / 2}" y="{LOW + 38}" text-anchor="middle">{bottom}</text>')

    def place(self, across, up):
        def share(value, powers):
            return (math.log10(max(value, 10.0 ** powers[0])) - powers[0]) / (powers[1] - powers[0])
        return (LEFT + share(across, self.across) * (WIDE - LEGEND - LEFT),
                LOW - share(up, self.up) * (LOW - TOP))

    def line(self, values, color, dashes=""):
        points = " ".join("{:.1f},{:.1f}".format(*self.place(*value)) for value in values)
        dashes = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.out.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="2"{dashes}/>')
        return self.place(*values[-1])

    def name(self, text, color, at, dashes=None):
        """Beside the place; with dashes as an entry of the legend, a piece of the line before it."""
        x, y = at
        if dashes is not None:
            stroke = f' stroke-dasharray="{dashes}"' if dashes else ""
            self.out.append(f'<line x1="{x}" x2="{x + 30}" y1="{y - 4}" y2="{y - 4}" stroke="{color}" '
                            f'stroke-width="2"{stroke}/>')
            x += 38
        text = text.replace('"', "&quot;")
        self.out.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{color}">{text}</text>')

    def svg(self):
        return "\n".join(self.out + ["</svg>", ""])

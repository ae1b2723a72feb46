"""Errors over mesh sizes, log-log, as SVG that takes the page's colours; one colour and one line of legend per order."""
import math

from page_frame import text

STYLE = """
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,420px),1fr));gap:0 18px}
figure.plot,html figure.plot{background:none;--soft:inherit}figure.plot svg{min-width:0;max-width:640px}
figure.plot figcaption{position:static;color:var(--ink)}
.plot text{fill:var(--ink);font:13px system-ui,'DejaVu Sans',sans-serif}.plot .grid{stroke:var(--line);stroke-width:1}
.plot .axis{stroke:var(--ink);stroke-width:1.2;fill:none}.plot path.line{fill:none;stroke-width:1.6}
.plot path.slope{fill:none;stroke-width:1.2;stroke-dasharray:5 4}
.c0{stroke:#0072b2;--c:#0072b2}.c1{stroke:#d55e00;--c:#d55e00}.c2{stroke:#009e73;--c:#009e73}.c3{stroke:#cc79a7;--c:#cc79a7}
.c4{stroke:#b38600;--c:#b38600}.c5{stroke:#7a7a7a;--c:#7a7a7a}.plot circle,.plot rect.key{fill:var(--c);stroke:none}
@media screen and (prefers-color-scheme:dark){.c0{stroke:#56b4e9;--c:#56b4e9}.c4{stroke:#f0e442;--c:#f0e442}}
"""
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 520, 340, 64, 12, 12, 46
LINES = 60
SUPER = str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹')


def order_of(series):
    """the order that its line is drawn under: the one that is wanted, or the one seen"""
    wanted = series['wanted']
    return wanted if wanted is not None and abs(wanted - series['slope']) < 0.5 else round(series['slope'])


def drawable(series):
    points = [(h, e) for h, e in series['points'] if h > 0 and e > 0]
    return sorted(points) if len(points) > 1 and math.isfinite(series['slope'] or 0) else []


class Axes:
    def __init__(self, lines):
        every = [p for line in lines for p in line]
        self.x = spread([math.log10(h) for h, _ in every], 0.04)
        self.y = spread([math.log10(e) for _, e in every], 0.06)

    def at(self, h, error):
        fx = (math.log10(h) - self.x[0]) / (self.x[1] - self.x[0])
        fy = (math.log10(error) - self.y[0]) / (self.y[1] - self.y[0])
        return LEFT + fx * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - fy * (HEIGHT - TOP - BOTTOM)


def spread(values, margin):
    low, high = min(values), max(values)
    more = max(margin * (high - low), 0.05)
    return low - more, high + more


def ticks(span):
    """decades, thinned; where there is less than one, 1, 2 and 5 of them"""
    decades = list(range(math.ceil(span[0]), math.floor(span[1]) + 1))
    if len(decades) > 1:
        return [(10.0 ** d, '10' + str(d).translate(SUPER)) for d in decades[::max(1, (len(decades) + 5) // 6)]]
    marks = [m * 10.0 ** d for d in range(math.floor(span[0]), math.ceil(span[1]) + 1) for m in (1, 2, 3, 5)]
    return [(v, f'{v:.6g}') for v in marks if span[0] <= math.log10(v) <= span[1]]


def frame(axes, over):
    parts = []
    for value, name in ticks(axes.x):
        x, _ = axes.at(value, 10 ** axes.y[0])
        parts.append(f'<path class="grid" d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}"/>'
                     f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{name}</text>')
    for value, name in ticks(axes.y):
        _, y = axes.at(10 ** axes.x[0], value)
        parts.append(f'<path class="grid" d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}"/>'
                     f'<text x="{LEFT - 7}" y="{y + 4:.1f}" text-anchor="end">{name}</text>')
    parts.append(f'<path class="axis" d="M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{WIDTH - RIGHT}"/>'
                 f'<text x="{(LEFT + WIDTH) / 2}" y="{HEIGHT - 8}" text-anchor="middle">{text(over)}</text>'
                 f'<text transform="translate(15,{(HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">relative error</text>')
    return ''.join(parts)


def slope_line(axes, line, order):
    """dashed, of the order itself, through the finest point"""
    (h0, e0), h1 = line[0], line[-1][0]
    e1 = e0 * (h1 / h0) ** order
    bounded = min(max(e1, 10 ** axes.y[0]), 10 ** axes.y[1])
    h1 = h0 * (bounded / e0) ** (1 / order) if order else h1
    (x0, y0), (x1, y1) = axes.at(h0, e0), axes.at(h1, bounded)
    return f'<path class="slope" d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}"/>'


def curve(axes, line, title):
    points = [axes.at(*p) for p in line]
    path = 'M' + 'L'.join(f'{x:.1f} {y:.1f}' for x, y in points)
    dots = ''.join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6"/>' for x, y in points)
    return f'<g><title>{text(title)}</title><path class="line" d="{path}"/>{dots}</g>'


OVER = {'h': 'size of an element, a panel or a step', 'step': 'spacing of the points', 'n': 'samples'}


def figure(series, caption):
    """all series of one function; '' where there is nothing to draw"""
    orders = {}
    for s in series:
        line = drawable(s)
        if line:
            orders.setdefault(order_of(s), []).append((s, line))
    drawn = {o: lines[:LINES] for o, lines in sorted(orders.items())}
    if not drawn:
        return ''
    axes = Axes([line for lines in drawn.values() for _, line in lines])
    over = series[0]['over'].split()[0]
    body, legend = [frame(axes, OVER.get(over, over))], []
    for k, (order, lines) in enumerate(drawn.items()):
        colour = f'c{k % 6}'
        curves = ''.join(curve(axes, line, f"{s['what']} {s['about']}: order {s['slope']:.2f}") for s, line in lines)
        slope = slope_line(axes, lines[0][1], order) if order else ''
        body.append(f'<g class="{colour}">{curves}{slope}</g>')
        seen = sorted(s['slope'] for s, _ in orders[order])
        span = f'{seen[0]:.2f}' if len(seen) == 1 else f'{seen[0]:.2f} to {seen[-1]:.2f}'
        names = sorted({s['what'] for s, _ in orders[order]})
        words = f'order {order:g}: {span}' if order else 'no order, all is rounding'
        legend.append(f'<span class="{colour}"><i></i>{words}'
                      f' <small>({len(seen)} of {text(", ".join(names[:4]))})</small></span>')
    svg = (f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{text(caption)}: error over size, log-log">'
           + ''.join(body) + '</svg>')
    return (f'<figure class="plot"><figcaption><b>{text(caption)}</b></figcaption>{svg}'
            f'<figcaption class="legend">{"".join(legend)}</figcaption></figure>\n')


STYLE += """
.legend span{display:inline-block;margin-right:16px}.legend i{display:inline-block;width:1em;height:.7em;border-radius:2px;
background:var(--c);margin-right:5px;print-color-adjust:exact}.legend small{color:var(--soft)}
"""

"""The verification page: rooms, ways and their worst checks, from what the tests recorded."""
import collections
import math

import plots
import records
from page_frame import headline, page, text

STYLE = """
.group>summary,.heads{display:grid;grid-template-columns:1.1rem minmax(0,1fr) 5rem 15.5rem 8rem;gap:2px 12px;align-items:baseline;
list-style:none}.group>summary::-webkit-details-marker{display:none}.group>summary::before{content:"▸";color:var(--soft)}
.group[open]>summary::before{content:"▾"}.heads{color:var(--soft);font-size:.82rem;
border-bottom:1.5px solid var(--ink);padding:4px 2px}
.against{margin:.9rem 0 .1rem;max-width:none;color:var(--soft);font-size:.86rem}.against code{color:var(--ink)}
.bare{margin:0;padding:4px 0 4px 1.8rem;max-width:none;font-size:.86rem;color:var(--soft)}.overview th{white-space:normal}
.group{border-bottom-color:transparent}.group>summary{padding:3px 2px}
.n{text-align:right;font-variant-numeric:tabular-nums}.group small,.bare small{color:var(--soft);display:block}.group summary span>small{display:inline;margin-left:8px}
.share{display:block;height:.7em;border:1px solid var(--soft);border-radius:2px;print-color-adjust:exact}
.share i{display:block;height:100%;background:var(--good);print-color-adjust:exact}.share.out i{background:var(--bad)}
.group .scroll{margin:.2rem 0 1rem 1.6rem}h3.way{margin-top:1.8rem}td.text{overflow-wrap:anywhere}
.group.failed>summary{color:var(--bad)}pre{max-height:24rem}
@media(max-width:700px){.heads{display:none}.group>summary{grid-template-columns:1.1rem minmax(0,1fr) auto}
.group>summary>.worst{grid-column:2}.group>summary>.bar{grid-column:3;width:5rem;align-self:center}.group .scroll{margin-left:0}}
"""
TOLD = 15


def number(x):
    return '' if x is None else '∞' if math.isinf(x) else f'{x:.2g}'


def digits(x):
    return '' if x is None else f'{x:.9g}'


def bar(r):
    """error over what is allowed, six decades long"""
    part = records.share(r)
    if part < 0:
        return '<small>a condition</small>'
    length = 100 if math.isinf(part) or part >= 1 else max(2.0, 100 * (1 + math.log10(max(part, 1e-6)) / 6))
    kind = 'share' if r['holds'] else 'share out'
    return f'<span class="{kind}" title="{number(part)} of what is allowed"><i style="width:{length:.0f}%"></i></span>'


def size(r, x):
    """of an error, beside what is wanted where that is not 0"""
    return number(x / abs(r['wanted']) if x is not None and r['wanted'] else x)


def judged(r):
    if r['least']:
        return f'{number(r["value"]) or "no number"}, at least {number(r["wanted"])}'
    error, allowed = size(r, r['error']) or 'no number', size(r, r['tolerance'])
    return f'{error} of {allowed} allowed' if allowed else ('holds' if r['holds'] else 'does not hold')


def rows(group):
    """what fails first, then what is nearest to its bound; the rest is counted"""
    ranked = sorted((r for r in group.told if r['tolerance'] is not None or not r['holds']),
                    key=lambda r: (r['holds'], -records.share(r)))
    shown = [r for k, r in enumerate(ranked) if k < TOLD or not r['holds']]
    lines = []
    for r in shown:
        of = f' <small>the worst of {r["count"]}</small>' if r.get('count', 1) > 1 else ''
        name = f'<b>{text(r["about"])}</b> ' if r['about'] else ''
        errors = '<td></td><td></td>' if r['least'] else f'<td>{size(r, r["error"])}</td><td>{size(r, r["tolerance"])}</td>'
        verdict = '<span class="good">yes</span>' if r['holds'] else '<span class="bad">no</span>'
        lines.append(f'<tr><td class="text">{name}<code>{text(r["what"])}</code>{of}</td><td>{digits(r["value"])}</td>'
                     f'<td>{"≥ " if r["least"] else ""}{digits(r["wanted"])}</td>{errors}<td>{verdict}</td>'
                     f'<td class="text"><small>{text(r["file"])}:{r["line"]:g}</small></td></tr>')
    left = group.count - group.conditions - sum(r.get('count', 1) for r in shown if r['tolerance'] is not None)
    more = f'<p><small>and {left} more, nearer to what is wanted; all of them stand in records/</small></p>' if left > 0 else ''
    held = sum(r['count'] for r in group.told if r['tolerance'] is None and r['holds'])
    more += f'<p><small>and {held} conditions without a number hold</small></p>' if held else ''
    return ('<div class="scroll"><table><thead><tr><th>what</th><th>computed</th><th>wanted</th><th>error</th><th>allowed</th>'
            f'<th>holds</th><th class="text">where</th></tr></thead><tbody>{"".join(lines)}</tbody></table>{more}</div>')


def group_html(program, group):
    worst = group.worst()
    kind = 'group failed' if group.failed else 'group'
    count = f'{group.failed} of {group.count} fail' if group.failed else f'{group.count}'
    name = records.words_of(group.function if group.function != 'main' else program.name[len('verify_'):])
    about = f' <small>{text(worst["about"])}</small>' if worst['about'] else ''
    return (f'<details class="{kind}"{" open" if group.failed else ""}><summary><span>{text(name)}{about}</span>'
            f'<span class="n">{count}</span><span class="worst">{judged(worst)}</span><span class="bar">{bar(worst)}</span></summary>'
            f'{rows(group)}</details>\n')


def program_html(program, way):
    """its checks of one way, under what they are held against"""
    parts = []
    by_source = collections.OrderedDict()
    for g in program.groups.values():
        if g.way == way:
            by_source.setdefault(g.source, []).append(g)
    for source, groups in by_source.items():
        said = '' if way == 'order' else text(source)
        parts.append(f'<p class="against"><code>{text(program.name)}</code> {said}</p>\n')
        parts += [group_html(program, g) for g in groups if not g.bare()]
        bare = [g for g in groups if g.bare()]
        if bare:
            names = text(', '.join(records.words_of(g.function) for g in bare))
            parts.append(f'<p class="bare">{sum(g.count for g in bare)} conditions without a number hold <small>{names}</small></p>\n')
    return ''.join(parts)


def figures(members):
    out = []
    for program in members:
        functions = collections.OrderedDict()
        for s in program.series:
            functions.setdefault(s['function'], []).append(s)
        out += [plots.figure(s, f'{records.words_of(f)} ({program.name})') for f, s in functions.items()]
    return f'<div class="plots">{"".join(out)}</div>\n' if any(out) else ''


def room_html(room, members):
    parts = [f'<h2 id="{text(room)}">{text(room)}</h2>\n']
    for program in members:
        trouble = program.trouble()
        if trouble:
            parts.append(f'<p class="note warn"><b>{text(program.name)}</b> {text(trouble)}</p>\n')
        elif program.checks() == 0:
            parts.append(f'<p class="note"><b>{text(program.name)}</b> checked nothing here: {text(program.output.strip()[-200:])}</p>\n')
    for way, name, meaning in records.WAYS:
        found = ''.join(program_html(p, way) for p in sorted(members, key=lambda p: (not p.failures(), p.name)))
        drawn = figures(members) if way == 'order' else ''
        if found or drawn:
            parts.append(f'<h3 class="way">{name} <small class="skip">{meaning}</small></h3>\n{drawn}<div class="heads"><span></span>'
                         '<span>what</span><span class="n">checks</span><span>error of the worst</span><span>share of the bound</span>'
                         f'</div>\n{found}')
    tables = ''.join(f'<details><summary>{text(p.name)} <small class="skip">{p.seconds:.1f} s. {text(p.sentence)}</small></summary>'
                     f'<pre>{text(p.output[-20000:])}</pre></details>\n' for p in members)
    parts.append(f'<h3>What the programs print</h3>\n{tables}')
    return ''.join(parts)


def overview(programs):
    """rooms by ways: checks, and how many fail"""
    ways = [w for w in records.WAYS if any(g.way == w[0] for p in programs for g in p.groups.values())]
    head = ''.join(f'<th>{name}</th>' for _, name, _ in ways)
    lines = []
    for room in rooms(programs):
        groups = [g for p in programs if p.room == room for g in p.groups.values()]
        cells = []
        for way, _, _ in ways:
            count = sum(g.count for g in groups if g.way == way)
            failed = sum(g.failed for g in groups if g.way == way)
            cells.append(f'<td class="bad">{failed} of {count} fail</td>' if failed
                         else f'<td>{count}</td>' if count else '<td class="zero">–</td>')
        lines.append(f'<tr><th class="text"><a href="#{text(room)}">{text(room)}</a></th>{"".join(cells)}</tr>')
    return (f'<div class="scroll overview"><table><caption>Checks, by room and by what they are held against</caption><thead><tr><th>room</th>{head}'
            f'</tr></thead><tbody>{"".join(lines)}</tbody></table></div>\n')


def sources(programs):
    """who says what the wanted numbers are"""
    found = collections.defaultdict(lambda: [0, set()])
    for p in programs:
        for g in p.groups.values():
            if g.way in ('published', 'other code', 'closed form'):
                found[(g.way, g.source)][0] += g.count
                found[(g.way, g.source)][1].add(p.name)
    names = {w: n for w, n, _ in records.WAYS}
    lines = ''.join(f'<tr><td class="text">{text(s)}</td><td class="text">{names[w]}</td><td>{n}</td>'
                    f'<td class="text"><small>{text(", ".join(sorted(by)))}</small></td></tr>'
                    for (w, s), (n, by) in sorted(found.items()))
    return ('<h2 id="sources">Where the wanted numbers are from</h2>\n<div class="scroll"><table><thead><tr><th>source</th>'
            f'<th class="text">way</th><th>checks</th><th class="text">programs</th></tr></thead><tbody>{lines}</tbody></table></div>\n')


def rooms(programs):
    there = {p.room for p in programs}
    return [r for r in records.ROOMS if r in there] + sorted(there - set(records.ROOMS))


# how much of their campaigns the programs ran
EXTENT = {'short': 'The tests ran in the short form that <code>./run check</code> runs too: campaigns and random trials with a part of '
                   'their numbers. <code>./run verification --long</code> runs them whole.',
          'long': 'The tests ran whole, with all numbers of their campaigns (<code>--long</code>).',
          'mixed': 'Some of the tests ran in the short form that <code>./run check</code> runs too, others whole '
                   '(<code>--long</code>).'}


def whole(programs, commit, versions, extent=''):
    failed = sum(p.failures() for p in programs)
    troubled = sum(1 for p in programs if p.trouble())
    series = sum(len(p.series) for p in programs)
    unsaid = sorted({p.name for p in programs for g in p.groups.values() if not g.way})
    checks, conditions = sum(p.checks() for p in programs), sum(p.conditions() for p in programs)
    body = headline([('Numbers judged', checks - conditions, ''), ('Conditions without a number', conditions, ''),
                     ('That do not hold', failed, ''),
                     ('Programs', len(programs), f'{troubled} in trouble' if troubled else 'all came to their end'),
                     ('Convergence series', series, ''), ('Commit', commit[0], commit[1])])
    body += ('<p>Every number here was left by a test of <code>tests/verify</code> in the act of judging it; a test that fails makes '
             'this page say so. What a test judges without a number (a verdict, a count, that two answers are the same) is a '
             'condition: counted apart, and not shown one by one while it holds. A row is all checks of one function, told by the '
             'worst of them; open it for the others. Errors are relative where what is wanted is not 0. The bar is the error over '
             'what is allowed, over six decades; where a number has only a least, the least over the number.</p>\n')
    body += f'<p class="note">{EXTENT[extent]}</p>\n' if extent in EXTENT else ''
    if unsaid:
        body += f'<p class="note warn">These do not say what they are held against: {text(", ".join(unsaid))}</p>\n'
    body += overview(programs)
    body += ''.join(room_html(r, [p for p in programs if p.room == r]) for r in rooms(programs))
    body += sources(programs)
    body += '<h2 id="versions">Versions</h2>\n<div class="scroll"><table><tbody>' + ''.join(
        f'<tr><td class="text">{text(a)}</td><td class="text">{text(b)}</td></tr>' for a, b in versions) + '</tbody></table></div>\n'
    links = [(r, r) for r in rooms(programs)] + [('sources', 'sources'), ('versions', 'versions')]
    return page('Verification', 'What stiffaxis computes, against what is known otherwise', links, body, STYLE + plots.STYLE)

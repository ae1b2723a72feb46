#!/usr/bin/env python3
"""Makes the gallery: runs the cases of cases/ and shows a picture of each with its command.  gallery.py --program FILE --out DIR
[--again] [CASE...]; a case is a name as `stiffaxis example` lists it; exit code 1 where a case does not run to its end."""
import argparse
import base64
import json
import os
import pathlib
import re
import subprocess
import sys

from page_frame import ROOT, commit, headline, page, text

STYLE = """
.cards{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,350px),1fr));gap:22px;margin:1rem 0}
.card{border:1px solid var(--line);border-radius:6px;overflow:hidden;display:flex;flex-direction:column}
.card .picture{background:#fff;height:250px;display:flex;align-items:center;justify-content:center;padding:8px;
border-bottom:1px solid var(--line)}.card img{max-width:100%;max-height:100%}
.card>div:last-child{padding:10px 14px 14px}.card h3{margin:0 0 .3rem}.card p{font-size:.9rem}
.card pre{margin:.5rem 0;padding:8px 10px;white-space:pre-wrap;overflow-wrap:anywhere}.card .links{color:var(--soft)}
@media print{.card{break-inside:avoid}}
"""
# what no `run` shows: its own command, and why it is not run here
OTHERS = {'scan': ('stiffaxis scan cases/scan/helical_0.98N.ply', 'settings for scans: docs/measurements.md'),
          'helical_nc_scanned': ('stiffaxis compare cases/scan/helical_nc_scanned.yaml', 'after the two scans that it names: docs/measurements.md'),
          'endoscope': ('./run endoscope', 'makes its synthetic ventricle first: docs/endoscope.md'),
          'design': ('stiffaxis design cases/endoscope/design.yaml --out results/design', 'a search of minutes: docs/endoscope.md')}
# top-level keys of a case, the heading that it comes under, and its pictures, the best first
KINDS = [('reach', 'What scopes reach', ('reach',)),
         ('sensitivity', 'What moves the answer', ('tornado', 'rods')),
         ('measured', 'Against measured shapes', ('measured', 'rods')),
         ('rod', 'Rods', ('rods', 'section')),
         ('fem', '3D segments', ('segment', 'section')),
         ('section', 'Sections', ('section',))]
HEAVY = 300_000  # bytes of an SVG, beyond which its PNG is taken


class Shown:
    """one case: what its file says of itself, how its run went, its picture"""

    def __init__(self, file):
        self.file, self.name = file, file.stem
        words = file.read_text(encoding='utf-8')
        self.title = (re.search(r'^title: *(.*)$', words, re.M) or ['', self.name])[1].strip('"')
        self.about = first_sentence(words)
        keys = set(re.findall(r'^(\w+):', words, re.M))
        if 'csv:' not in words:
            keys.discard('measured')  # errors that others published, no shapes
        self.kind = next((kind for kind in KINDS if kind[0] in keys), KINDS[-1])
        self.command, self.why = OTHERS.get(self.name, (f'stiffaxis run {file.relative_to(ROOT)} --out results/{self.name}', ''))
        self.code, self.seconds, self.told = None, 0.0, ''


def first_sentence(words):
    """of the comment at the head"""
    lines = []
    for line in words.splitlines():
        if not line.startswith('#') or line.startswith('#  ') or not line[1:].strip():
            break  # a command of its own
        lines.append(line[1:].strip())
    return re.split(r'(?<=[a-z\d)"]\.) (?=[A-Z])', ' '.join(lines))[0]


def run(shown, program, out):
    """processor time and exit code of one whole run"""
    target = out / shown.name
    done = subprocess.Popen([str(program), 'run', str(shown.file), '--out', str(target), '--force', '--quiet'],
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, cwd=ROOT)
    shown.told = done.stderr.read().decode('utf-8', 'replace').strip()
    _, status, used = os.wait4(done.pid, 0)
    done.returncode = shown.code = os.waitstatus_to_exitcode(status)
    shown.seconds = used.ru_utime + used.ru_stime


def picture(shown, out):
    """the first that there is, as SVG where it is small; '' where there is none"""
    for name in shown.kind[2]:
        svg, png = out / shown.name / f'{name}.svg', out / shown.name / f'{name}.png'
        for file, kind in ((svg, 'svg+xml'), (png, 'png')):
            if file.exists() and (file.suffix == '.png' or file.stat().st_size < HEAVY):
                data = base64.b64encode(file.read_bytes()).decode()
                return f'<img src="data:image/{kind};base64,{data}" alt="{text(name)} of {text(shown.title)}" loading="lazy">'
    return ''


VERDICTS = {0: '<span class="good">done</span>', 1: '<span class="bad">done, a comparison is out of tolerance</span>'}


def card(shown, out):
    drawn = picture(shown, out) if shown.code is not None else ''
    if shown.code is None:
        state = text(shown.why)
    else:
        state = VERDICTS.get(shown.code, f'<span class="bad">exit code {shown.code}: {text(shown.told[-300:])}</span>')
        state += f', {shown.seconds:.1f} s of processor time'
        if (out / shown.name / 'report.html').exists():
            state += f'; <a href="{text(shown.name)}/report.html">its page</a>'
    frame = f'<div class="picture">{drawn}</div>' if drawn else ''
    return (f'<section class="card" id="{text(shown.name)}">{frame}<div><h3>{text(shown.title)}</h3><p>{text(shown.about)}</p>'
            f'<pre>{text(shown.command)}</pre><p class="links">{state}</p></div></section>\n')


def whole(every, out):
    ran = [s for s in every if s.code is not None]
    name, day = commit()
    body = headline([('Cases', len(every), ''), ('Run here', len(ran), f'{sum(s.code != 0 for s in ran)} not well' if any(s.code for s in ran) else 'all well'),
                     ('Processor time', f'{sum(s.seconds for s in ran):.0f}', 's'), ('Commit', name, day)])
    body += '<p>Each picture is what <code>run</code> draws with the case beside it; <code>stiffaxis example NAME</code> writes any of ' \
            'them with a comment for every key.</p>\n'
    links = []
    for key, heading, _ in KINDS[::-1]:
        cards = ''.join(card(s, out) for s in every if s.kind[0] == key)
        if cards:
            links.append((key, heading))
            body += f'<h2 id="{key}">{heading}</h2>\n<div class="cards">\n{cards}</div>\n'
    return page('Gallery', 'What the cases of stiffaxis look like', links, body, STYLE)


def main():
    reader = argparse.ArgumentParser(description=__doc__.split('  ')[0])
    reader.add_argument('--program', type=pathlib.Path, required=True)
    reader.add_argument('--out', type=pathlib.Path, required=True, help='gets index.html and a folder per case')
    reader.add_argument('--again', action='store_true', help='from the runs that are there')
    reader.add_argument('names', nargs='*', help='only these cases')
    asked = reader.parse_args()

    every = [Shown(f) for f in sorted((ROOT / 'cases').glob('*.yaml')) + sorted((ROOT / 'cases').glob('*/*.yaml'))]
    unknown = set(asked.names) - {s.name for s in every}
    if unknown:
        sys.exit(f'gallery.py: no case is called {", ".join(sorted(unknown))}')
    every = [s for s in every if not asked.names or s.name in asked.names]
    out = asked.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    runs = out / 'runs.json'
    before = json.loads(runs.read_text(encoding='utf-8')) if runs.exists() else {}
    for shown in every:
        if asked.again and shown.name in before:
            shown.code, shown.seconds, shown.told = before[shown.name]
        elif not asked.again and not shown.why:
            run(shown, asked.program.resolve(), out)
    # those that were not asked for keep what they have
    before.update({s.name: (s.code, s.seconds, s.told) for s in every if s.code is not None})
    runs.write_text(json.dumps(before), encoding='utf-8')
    (out / 'index.html').write_text(whole(every, out), encoding='utf-8')

    wrong = [s for s in every if s.code is not None and (s.code > 1 or not picture(s, out))]
    for shown in wrong:
        print(f'{shown.name}: exit code {shown.code}' + (f': {shown.told}' if shown.told else ', no picture'))
    print(f'{len(every)} cases, {sum(s.code is not None for s in every)} of them run; {asked.out / "index.html"}')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())

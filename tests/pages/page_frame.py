"""The frame of the pages that are made from the repository: the style sheet of the program's own pages, a policy that asks nothing of
the network, words as text.  Python's standard library is enough."""
import html
import json
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]

MORE_STYLE = """
details{border-bottom:1px solid var(--line)}summary{cursor:pointer;padding:6px 2px}
summary:hover{background:var(--tint)}summary:focus-visible{outline:3px solid var(--accent)}
a{color:var(--accent)}header a{color:#fff}h2{scroll-margin-top:8px}
@media print{summary{list-style:none}}
"""


def text(words):
    """for markup: never anything but text"""
    return html.escape(str(words), quote=True)


def style():
    """the style sheet that the program writes into its pages, from where it stands"""
    source = (ROOT / 'reports/page_style.c').read_text(encoding='utf-8')
    table = re.search(r'style\[\] = \{(.*?)\n\};', source, re.S)
    if not table:
        raise SystemExit('reports/page_style.c: no style sheet is found in it')
    strings = re.findall(r'"((?:[^"\\]|\\.)*)"', table.group(1))
    return ''.join(s.replace('\\n', '\n').replace('\\"', '"') for s in strings)


def page(title, subtitle, links, body, more_style=''):
    """one file, closed in itself"""
    policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
    nav = ' '.join(f'<a href="#{text(to)}">{text(name)}</a>' for to, name in links)
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{text(title)} – stiffaxis</title>\n'
            f'<style>\n{style()}{MORE_STYLE}{more_style}</style>\n</head>\n<body>\n<header><div>\n<h1>{text(title)}</h1>\n'
            f'<p>{text(subtitle)}</p>\n<nav>{nav}</nav>\n</div></header>\n<main>\n{body}\n</main>\n</body>\n</html>\n')


def headline(pairs):
    """[(name, value, unit)] as the page's key numbers"""
    rows = ''.join(f'<div><dt>{text(n)}</dt><dd>{text(v)} <small>{text(u)}</small></dd></div>\n' for n, v, u in pairs)
    return f'<dl class="key">\n{rows}</dl>\n'


def commit():
    """what the numbers belong to: (short name, date), with a word where files differ from it"""
    def git(*words):
        run = subprocess.run(['git', '-C', str(ROOT), *words], capture_output=True, text=True, check=False)
        return run.stdout.strip() if run.returncode == 0 else ''
    name, _, day = git('log', '-1', '--format=%h %cs').partition(' ')
    changed = git('status', '--porcelain', '--untracked-files=no')
    return (name + (', with changes' if changed else '') if name else 'no git repository', day)


def versions(program):
    """[(part, versions)] of what the program works with, by its doctor"""
    try:
        run = subprocess.run([str(program), 'doctor', '--json'], capture_output=True, text=True, check=False)
        told = json.loads(run.stdout)
    except (OSError, ValueError):
        return []
    parts = [(p['what'], p['versions'] if p['works'] else 'not here') for p in told['parts'] if p['versions'] or not p['works']]
    return [('stiffaxis', told['version'])] + parts

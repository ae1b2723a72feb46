"""Every equation that code and docs cite stands in docs/theory.md, once.  theory.py ROOT

An equation is a paragraph that begins with its number: `(2.7) ...`. Cited are all numbers like it in parentheses in the comments of C and
in the theory itself, elsewhere those that follow the word theory; so are its sections.
"""
import pathlib
import re
import sys

NUMBER = r'[1-9]\d?\.[1-9]\d?[a-e]?'
CITED = re.compile(rf'\(({NUMBER})\)')
# theory (3.20) to (3.25); theory 5.12; docs/theory.md, (9.1) and (9.2)
LIST = re.compile(rf'theory(?:\.md\)?)?[,:]?\s+\(?{NUMBER}\)?(?:(?:,| and| to|-)\s*\(?{NUMBER}\)?)*')
SECTION = re.compile(r'theory(?:\.md\)?)?,? section (\d+)')
ROOMS = 'base io meshes section rodsolver measure fem reach reports app api tests bench examples'.split()


def defined(theory):
    """{number: lines} of paragraphs that begin with a number"""
    found, before = {}, ''
    for n, line in enumerate(theory.split('\n'), 1):
        start = re.match(rf'\(({NUMBER})\)', line)
        if start and not before.strip():
            found.setdefault(start[1], []).append(n)
        elif start:
            found.setdefault(f'{start[1]} within a paragraph', []).append(n)
        before = line
    return found


def comments(code):
    """(line, text): runs of lines of // are one comment"""
    run, first = [], 0
    for n, line in enumerate(code.split('\n') + [''], 1):
        at = line.find('//')
        if at >= 0:
            first = n if not run else first
            run.append(line[at + 2:].strip())
        if run and (at < 0 or line[:at].strip()):
            yield first, ' '.join(run)
            run = []


def cited(root):
    """(file, line, number or 'section N')"""
    theory = root / 'docs/theory.md'
    files = [f for room in ROOMS for kind in ('*.c', '*.h') for f in sorted((root / room).rglob(kind))]
    pages = sorted(root.glob('*.md')) + sorted((root / 'docs').rglob('*.md'))
    scripts = [f for kind in ('*.py', '*.sh', '*.js', '*.awk') for f in sorted(root.rglob(kind)) if 'build' not in f.parts]
    for f in files:
        for line, words in comments(f.read_text(encoding='utf-8')):
            yield from ((f, line, n) for n in sorted(set(CITED.findall(words) + lists(words))))
    for f in pages + scripts:
        for line, words in paragraphs(f.read_text(encoding='utf-8')):
            yield from ((f, line, n) for n in sorted(set(lists(words) + (CITED.findall(words[1:]) if f == theory else []))))


def lists(words):
    numbers = [n for part in LIST.findall(words) for n in re.findall(NUMBER, part)]
    return numbers + [f'section {n}' for n in SECTION.findall(words)]


def paragraphs(page):
    line = 1
    for part in page.split('\n\n'):
        yield line, ' '.join(part.split('\n'))
        line += part.count('\n') + 2


def main():
    root = pathlib.Path(sys.argv[1])
    theory = (root / 'docs/theory.md').read_text(encoding='utf-8')
    found = defined(theory)
    there = set(found) | {f'section {n}' for n in re.findall(r'^## (\d+)\.', theory, re.M)}
    wrong = [f'docs/theory.md:{lines[-1]}: ({n}) stands there {len(lines)} times' for n, lines in found.items() if len(lines) > 1]
    wrong += [f'docs/theory.md:{lines[0]}: a line begins with ({n}), as if it were the equation' for n, lines in found.items()
              if ' ' in n]
    every = list(cited(root))
    wrong += [f'{f.relative_to(root)}:{line}: the theory has no {n if n[0] == "s" else f"({n})"}' for f, line, n in every
              if n not in there]
    print('\n'.join(wrong) or f'theory: {len(found)} equations, cited {len(every)} times')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())

"""What a page of Markdown holds: fenced blocks with the comment before each, links, headings, and names of files."""
import os
import re

FENCE = re.compile(r'^( {0,3})```([\w+-]*)\s*$')
COMMENT = re.compile(r'^\s*<!--\s*(.*?)\s*-->\s*$')
LINK = re.compile(r'!?\[[^\]\[]*(?:\[[^\]]*\][^\]\[]*)?\]\(([^)\s]+)(?:\s+"[^"]*")?\)')
HTTP = re.compile(r'^https?://[\w.-]+\.[a-z]{2,}(?::\d+)?(?:/[^\s<>"]*)?$')
# paths that prose names, and programs of the tests
NAMED = re.compile(r'(?<![\w/.-])((?:docs|cases|examples|tests|bench|cmake|python|api|rodsolver|base)/'
                   r'[\w./-]*\w\.(?:md|yaml|py|sh|c|h|awk|png))\b')
PROGRAM = re.compile(r'`((?:verify|test|bench)_\w+)`')
# forms that this reader does not follow, and so refuses
REFUSED = [(re.compile(r'^\s*~~~'), 'a fence of ~~~: write ```'),
           (re.compile(r'^(?: {4,}|\t)\s*```'), 'a fence further in than 3 spaces'),
           (re.compile(r'^ {0,3}\[[^\]]+\]:\s*\S'), 'a link by reference: write [text](target)'),
           (re.compile(r'\]\[[^\]]*\]'), 'a link by reference: write [text](target)'),
           (re.compile(r'<(?:img|a)\s[^>]*(?:src|href)='), 'a link in HTML: write [text](target)')]
HEREDOC = re.compile(r"<<-?\s*['\"]?(\w+)['\"]?")
MADE = {'docs/keys.md'}  # by the program, where it is installed


class Block:
    """One fenced block: its language, lines, the comment before it, and where it stands."""

    def __init__(self, language, line, comment):
        self.language, self.line, self.comment = language, line, comment
        self.lines = []
        self.shown = None  # the output that the page shows for it: a Block

    def says(self, word):
        """what the comment says after `word`, or None"""
        for part in self.comment.split(';'):
            if part.strip() == word or part.strip().startswith(word + ' ') or part.strip().startswith(word + ':'):
                return part.strip()[len(word):].lstrip(': ').strip()
        return None


class Page:
    def __init__(self, path, root):
        self.path, self.root = path, root
        self.name = os.path.relpath(path, root)
        with open(path, encoding='utf-8') as file:
            self.lines = file.read().split('\n')
        self.blocks, self.prose = [], []  # prose: (line number, text without code)
        self.read()

    def read(self):
        block, comment, indent = None, '', ''
        for number, line in enumerate(self.lines, 1):
            fence = FENCE.match(line)
            if block and fence and not fence[2]:
                self.blocks.append(block)
                block = None
            elif block:
                block.lines.append(line[len(indent):] if line.startswith(indent) else line)
            elif fence:
                indent = fence[1]
                block = Block(fence[2], number, comment)
                comment = ''
            else:
                said = COMMENT.match(line)
                comment = said[1] if said else comment if not line.strip() else ''
                self.prose.append((number, line))
        if block:
            raise SystemExit(f'{self.name}:{block.line}: the block does not end')

    def refused(self):
        """lines on forms that would go by unread: the ones above, and commands that are only indented (formulas may be)"""
        listed = False
        for number, line in self.prose:
            bare = re.sub(r'`[^`]*`', '``', line) if '```' not in line else line
            for form, words in REFUSED:
                if form.search(bare):
                    yield f'{self.name}:{number}: {words}'
            listed = bool(re.match(r'\s*(?:[-*+]|\d+\.)\s', line)) or listed and (not line.strip() or line.startswith(' '))
            if re.match(r'(?: {4}|\t)\s*(?:\$ |stiffaxis |\./run |python3 )', line) and not listed:
                yield f'{self.name}:{number}: commands that are only indented: write ```'

    def headings(self):
        """anchors as GitHub makes them"""
        seen = {}
        for _, line in self.prose:
            heading = re.match(r'^#{1,6}\s+(.*?)\s*#*$', line)
            for anchor in re.findall(r'<a (?:id|name)="([^"]+)"', line):
                yield anchor
            if heading:
                text = LINK.sub(lambda m: m[0][m[0].index('[') + 1:m[0].index(']')], heading[1])
                slug = re.sub(r'[^\w\- ]', '', text.lower().replace('`', '')).replace(' ', '-')
                seen[slug] = seen.get(slug, -1) + 1
                yield slug if seen[slug] == 0 else f'{slug}-{seen[slug]}'

    def inline(self):
        """(line, command) of what prose names in backquotes: `stiffaxis ...`, `./run ...`"""
        for number, line in self.prose:
            for code in re.findall(r'`((?:stiffaxis|\./run)(?: [^`]*)?)`', line):
                yield number, code.replace('\\|', '|')

    def dead(self, counts):
        """lines on links that lead nowhere and files that are not there"""
        for number, line in self.prose:
            for target in LINK.findall(re.sub(r'`[^`]*`', '``', line)):
                counts['links'] += 1
                wrong = self.link(target)
                if wrong:
                    yield f'{self.name}:{number}: {wrong}'
            for name in NAMED.findall(line):
                if name not in MADE and not os.path.exists(os.path.join(self.root, name)):
                    yield f'{self.name}:{number}: {name} is named and not there'
            for program in PROGRAM.findall(line):
                if not any(program + '.c' in files for _, _, files in walk(self.root)):
                    yield f'{self.name}:{number}: {program} is named and not there'

    def link(self, target):
        if ':' in target.split('/')[0]:
            return None if HTTP.match(target) else f'{target} is no link'
        path, _, anchor = target.partition('#')
        file = os.path.normpath(os.path.join(os.path.dirname(self.path), path)) if path else self.path
        if not os.path.exists(file):
            return f'dead link: {target}'
        if anchor and file.endswith('.md') and anchor not in Page(file, self.root).headings():
            return f'dead link: {target}: no such heading'
        return None


def walk(root, memory={}):
    """of the folders that hold tests and benchmarks, once"""
    if root not in memory:
        memory[root] = [step for folder in ('tests', 'bench') for step in os.walk(os.path.join(root, folder))]
    return memory[root]


def commands(lines):
    """[(command, lines of output shown right below)] of an sh or console block"""
    found, until, more = [], None, False
    prompt = any(line.startswith('$ ') for line in lines)
    for line in lines:
        if until or more:
            found[-1][0] += '\n' + line
            until = None if until == line.strip() else until
        elif prompt and not line.startswith('$ '):
            found[-1][1].append(line)
            continue
        elif line.strip() and not line.lstrip().startswith('#'):
            found.append([line[2:] if prompt else line, []])
            here = HEREDOC.search(line)
            until = here[1] if here else None
        more = not until and line.endswith('\\')
    return found


def rewrite(page):
    lines = list(page.lines)
    for block, command, wanted, new in sorted(page.edits, key=lambda edit: -edit[0].line):
        start = block.line
        end = next(k for k in range(start, len(lines)) if FENCE.match(lines[k]))
        if block.language == 'console':  # the lines below one of its prompts
            words = ('$ ' + command).split('\n')
            start = len(words) + next(k for k in range(start, end) if lines[k:k + len(words)] == words
                                      and lines[k + len(words):k + len(words) + len(wanted)] == wanted)
            end = start + len(wanted)
        lines[start:end] = new
    with open(page.path, 'w', encoding='utf-8') as file:
        file.write('\n'.join(lines))
    print(f'{page.name}: {len(page.edits)} outputs renewed')

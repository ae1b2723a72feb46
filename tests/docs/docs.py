"""Runs what the pages show, and follows their links.  docs.py [--update] [--times] ROOT PROGRAM SCRATCH [PAGE...]

Blocks with a language are read as follows; a comment of one line before a block says more, parts parted by `;`.

sh, console  commands, run one after another in a scratch copy, exit code 0. A `text` block behind an sh block is its output
             (stdout, then stderr); in console blocks commands begin with `$ `. How outputs are compared: compare.py.
             <!-- exit 2 -->                 of the last command
             <!-- not run: REASON -->        counted and listed
             <!-- run by tests/X: WORDS -->  another test runs it: it is there and has these words
             <!-- needs NAME -->             a program or Python module; left out, and told, where it is not there
yaml         a whole case (`format:`) is checked. Parts:
             <!-- in cases/X.yaml -->, <!-- in cases/X.yaml below rod -->, <!-- in cases/X.yaml without section.shapes -->
             <!-- your file NAME -->         a file that the reader has: everything else must be right
python       one after another in one process per page; a `text` block behind one is its output
c            <!-- compiles in tests/X.h -->   after that file's lines, which end within a function
any          <!-- save as FILE -->           the reader is asked to; later commands find it
             <!-- makes FILE FILE -->        the commands have made these
             <!-- stands in FILE -->         the file holds these lines (`...` as in outputs)
             <!-- not output: REASON -->     of text that no command says

`limits` beside this file has commands that take long: in the short form with settings, or left to another test.
"""
import argparse
import os
import re
import resource
import shutil
import subprocess
import sys

import cases
import compare
from pages import Block, Page, commands, rewrite

SHELLS = ('sh', 'console', 'bash')
CHANGES = re.compile(r'^\s*(?:\w+=\S* +)*(?:sudo |\./run |apt-get |pip install|docker |dpkg-|cmake |ctest )', re.M)  # the machine, or the tree
ALONE = ('schema', 'example', 'doctor', 'man', 'completion')  # commands that need no file


def cpu():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


class Run:
    def __init__(self, options):
        self.root, self.program, self.scratch = options.root, options.program, options.scratch
        self.long = bool(os.environ.get('STIFFAXIS_LONG')) or options.update
        self.options = options
        self.wrong, self.told, self.times = [], [], []
        self.memory = {}
        self.counts = dict.fromkeys(('commands', 'again', 'elsewhere', 'short', 'outputs', 'cases', 'parts', 'python', 'not run',
                                     'left out', 'links'), 0)
        self.limits = self.read_limits(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'limits'))
        self.settle()

    def read_limits(self, path):
        """lines `COMMAND | --set K=V ...`, `COMMAND | same --set K=V ...`, `COMMAND | alone` or `COMMAND | tests/X: WORDS`"""
        with open(path, encoding='utf-8') as file:
            lines = [line.strip() for line in file if line.strip() and not line.startswith('#')]
        return {line.split(' | ')[0].strip(): line.split(' | ')[1].strip() for line in lines}

    def settle(self):
        """the scratch copy: cases to write beside, the rest as links, the program as a user has it"""
        here = self.scratch
        shutil.copytree(os.path.join(self.root, 'cases'), os.path.join(here, 'cases'))
        for name in ('README.md', 'docs', 'examples', 'python', 'api', 'tests', 'bench', 'rodsolver', 'base'):
            if os.path.exists(os.path.join(self.root, name)):
                os.symlink(os.path.join(self.root, name), os.path.join(here, name))
        os.makedirs(os.path.join(here, 'build'))
        os.makedirs(os.path.join(here, 'results'))
        build = os.path.dirname(os.path.dirname(self.program))
        os.symlink(build, os.path.join(here, 'build', 'release'))
        self.environment = dict(os.environ, PATH=os.path.dirname(self.program) + ':' + os.environ['PATH'], NO_COLOR='1',
                                PYTHONPATH=os.path.join(self.root, 'python'), PYTHONDONTWRITEBYTECODE='1',
                                STIFFAXIS_LIBRARY=os.path.join(os.path.dirname(self.program), 'libstiffaxis.so'))

    def fail(self, page, line, words):
        self.wrong.append(f'{page.name}:{line}: {words}')

    def there(self, page, block, named):
        """another test, and the words that it has"""
        name, _, words = named.partition(':')
        path = os.path.join(self.root, name.strip())
        if not os.path.isfile(path):
            return self.fail(page, block.line, f'{name.strip()} is to run this and is not there')
        with open(path, encoding='utf-8') as file:
            if words.strip() not in file.read():
                return self.fail(page, block.line, f'{name.strip()} is to run this and does not hold "{words.strip()}"')
        self.counts['elsewhere'] += 1

    def limit(self, command):
        line = ' '.join(command.split('#')[0].split()).replace('build/release/bin/stiffaxis', 'stiffaxis')
        return next((how for what, how in self.limits.items() if line.startswith(what)), None)

    # --- commands

    def shell(self, page, block):
        pairs = commands(block.lines)
        last = int(block.says('exit') or 0)
        said, compared = [], True
        for k, (command, shown) in enumerate(pairs):
            wanted = last if k == len(pairs) - 1 else 0
            text = self.one(page, block, command, wanted)
            if shown or block.language == 'console':
                if text is not None:
                    self.compare(page, block, shown, text, command)
            elif text is None:
                compared = False
            else:
                said += text
        for name in (block.says('makes') or '').split():
            if compared and not os.path.exists(os.path.join(self.scratch, name)):
                self.fail(page, block.line, f'{name} was not made')
        if block.shown and compared:
            self.compare(page, block.shown, block.shown.lines, said, pairs[-1][0])

    def one(self, page, block, command, wanted):
        """lines that a command says; None where it was not run as it stands"""
        how = self.limit(command) or ''
        how = how[len('always '):] if how.startswith('always ') else '' if self.long else how
        if how and not how.startswith(('-', 'same', 'alone')):
            self.there(page, block, how)
            return None
        if CHANGES.match(command):
            return self.fail(page, block.line, f'changes the machine: <!-- run by tests/X: WORDS --> or <!-- not run: REASON -->: {command}')
        key = ' '.join(command.split('#')[0].split()).replace('build/release/bin/', '')
        if (key, wanted) in self.memory:
            self.counts['again'] += 1
            return self.memory[key, wanted]
        before = cpu()
        settings = [word for word in (how or '').split() if word not in ('alone', 'same')]
        line = ' '.join([command.split(' #')[0]] + settings) if how else command
        around = dict(self.environment, PATH=os.path.dirname(self.program)) if 'alone' in (how or '') else self.environment
        done = subprocess.run(['/bin/bash', '-c', line], cwd=self.scratch, env=around, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, errors='replace')
        self.times.append((cpu() - before, page.name, command.split('\n')[0]))
        self.counts['short' if how else 'commands'] += 1
        text = (done.stdout + done.stderr).split('\n')
        if done.returncode != wanted:
            self.fail(page, block.line, f'exit code {done.returncode}, not {wanted}: {line}\n    ' + '\n    '.join(text[-5:]))
        text = text if not how or how == 'alone' or how.startswith('same') else None
        if done.returncode == wanted and lasting(key):
            self.memory[key, wanted] = text
        return text

    def compare(self, page, block, wanted, said, command):
        self.counts['outputs'] += 1
        wrong = compare.check(wanted, said)
        if not wrong:
            return
        if self.options.update:
            lines = compare.update(wanted, said)
            if lines is not None:
                page.edits.append((block, command, wanted, lines))
                return
        self.fail(page, block.line, f'{command.splitlines()[0]}\n    {wrong}')

    # --- cases, Python, files

    def yaml(self, page, block):
        into, lines = block.says('in'), block.lines
        if into:
            into, _, less = into.partition(' without ')
            into, _, inside = into.partition(' below ')
            with open(os.path.join(self.root, into), encoding='utf-8') as file:
                lines = cases.whole(file.read().split('\n'), lines, inside.strip(), less.split())
        elif not any(line.startswith('format:') for line in lines):
            return self.fail(page, block.line, 'part of a case: which one? <!-- in cases/X.yaml -->')
        self.counts['parts' if into else 'cases'] += 1
        path = block.says('save as')
        if not path:
            path = os.path.join('cases', f'shown_{block.line}.yaml')
            with open(os.path.join(self.scratch, path), 'w', encoding='utf-8') as file:
                file.write('\n'.join(lines) + '\n')
        reader = 'scan' if any(line.startswith('scan:') for line in lines) else 'check'
        done = subprocess.run([self.program, reader, path], cwd=self.scratch, env=self.environment, capture_output=True, text=True)
        theirs = block.says('your file')
        if done.returncode and not (theirs and (f'{theirs}: No such file' in done.stderr or theirs in done.stderr and '%' in theirs)):
            self.fail(page, block.line, f'check: {(done.stderr or done.stdout).strip()}')

    def python(self, page, blocks):
        """the page's blocks in one process; what each prints stands behind a line of its own"""
        blocks = [block for block in blocks if self.has(page, block)]
        if not blocks:
            return
        mark = '--- block at line '
        code = '\n'.join(f'print({mark + str(block.line)!r}, flush=True)\n' + '\n'.join(block.lines) for block in blocks)
        before = cpu()
        done = subprocess.run([python_with('numpy'), '-c', code], cwd=self.scratch, env=self.environment, capture_output=True,
                              text=True)
        self.times.append((cpu() - before, page.name, 'python'))
        self.counts['python'] += len(blocks)
        if done.returncode:
            self.fail(page, blocks[0].line, f'python: {done.stderr.strip()}')
        said = {int(part.split('\n')[0]): part.split('\n')[1:] for part in done.stdout.split(mark)[1:]}
        for block in blocks:
            if block.shown:
                self.compare(page, block.shown, block.shown.lines, said.get(block.line, []), 'python')

    def has(self, page, block):
        need = block.says('needs') or ''
        if block.language == 'python' and not os.path.exists(self.environment['STIFFAXIS_LIBRARY']):
            need = 'libstiffaxis'
        elif not need or shutil.which(need) or (block.language == 'python' and python_with(need)):
            return True
        self.counts['left out'] += 1
        self.told.append(f'{page.name}:{block.line}: left out here: no {need}')
        return False

    def compile(self, page, block, frame):
        with open(os.path.join(self.root, frame), encoding='utf-8') as file:
            code = file.read() + '\n'.join(block.lines) + '\n}\n'
        done = subprocess.run(['cc', '-std=c11', '-fsyntax-only', '-I', self.root, '-x', 'c', '-'], input=code, capture_output=True,
                              text=True)
        if done.returncode:
            self.fail(page, block.line, f'cc: {done.stderr.strip()}')

    def file(self, page, block, name):
        try:
            with open(os.path.join(self.scratch, name), encoding='utf-8') as file:
                said = file.read().split('\n')
        except OSError:
            return self.fail(page, block.line, f'{name} is not there')
        self.compare(page, block, block.lines, said, name)

    # --- commands in the middle of a sentence: run where they are whole, else the command is there, as are benchmarks

    def sentence(self, page, line, command):
        words = command.split(' | ')[0].split()
        if words[0] == './run':
            return self.front_door(page, line, words[1:])
        if len(words) == 1:
            return None
        whole = words[1] in ALONE or any(os.path.isfile(os.path.join(self.scratch, word)) for word in words[2:])
        if not whole or any(re.match(r'[A-Z]{3}', word) for word in words):
            words = [words[0], words[1], '--help']
        return self.one(page, Block('', line, ''), ' '.join(words), 0)

    def front_door(self, page, line, words):
        with open(os.path.join(self.root, 'run'), encoding='utf-8') as file:
            known = re.findall(r'[a-z]+', ' '.join(re.findall(r'^([a-z| -]+)\)', file.read(), re.M)))
        with open(os.path.join(self.root, 'bench', 'bench.sh'), encoding='utf-8') as file:
            benchmarks = re.findall(r'^    echo (\w+)$', file.read(), re.M)
        for name in words[:1]:
            if name not in known:
                self.fail(page, line, f'./run knows no {name}')
        for name in words[1:] if words[:1] == ['bench'] else []:
            if name not in benchmarks and not os.path.isfile(os.path.join(self.root, 'bench', f'bench_{name}.c')):
                self.fail(page, line, f'./run bench knows no {name}')

    # --- pages

    def block(self, page, block):
        saved, stands = block.says('save as'), block.says('stands in')
        if saved:
            path = os.path.join(self.scratch, saved)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'w', encoding='utf-8') as file:
                file.write('\n'.join(block.lines) + '\n')
        if stands:
            self.file(page, block, stands)
        elif block.says('run by'):
            self.there(page, block, block.says('run by'))
        elif block.says('not run') is not None or block.says('not output') is not None:
            reason = block.says('not run') or block.says('not output')
            if not reason:
                self.fail(page, block.line, 'not run, and no reason why')
            what = 'not run' if block.says('not run') is not None else 'not output'
            self.counts['not run'] += what == 'not run'
            if reason:
                self.told.append(f'{page.name}:{block.line}: {what}: {reason}')
        elif block.language in SHELLS:
            if self.has(page, block):
                self.shell(page, block)
        elif block.language == 'yaml':
            self.yaml(page, block)
        elif block.says('compiles in'):
            self.compile(page, block, block.says('compiles in'))
        elif block.language == 'python':
            return block
        elif not saved and not block.is_output:
            self.fail(page, block.line, f'a block of {block.language or "no language"}: neither output nor run, and no reason why')
        return None

    def page(self, page):
        page.edits = []
        runs = SHELLS + ('python',)
        for before, block in zip([None] + page.blocks, page.blocks):
            block.is_output = bool(block.language in ('', 'text') and not block.comment and before and before.language in runs
                                   and before.says('run by') is None and before.says('not run') is None)
            if block.is_output:
                before.shown = block
        waiting = [self.block(page, block) for block in page.blocks]
        self.python(page, [block for block in waiting if block])
        for line, command in page.inline():
            self.sentence(page, line, command)
        self.wrong += page.dead(self.counts)
        self.wrong += page.refused()
        if page.edits:
            rewrite(page)


def lasting(command):
    """says the same whenever it is run: it reads no file of the reader's own, which pages change"""
    files = [word for word in command.split() if re.search(r'\.\w+$', word)]
    return command.startswith(('stiffaxis ', 'python3 cases/')) and all(os.path.dirname(file) for file in files)


def python_with(module, memory={}):
    if module not in memory:
        test = f'import importlib.util as u, sys; sys.exit(u.find_spec({module!r}) is None)'
        memory[module] = next((python for python in ('/usr/bin/python3', sys.executable) if os.path.exists(python) and
                               subprocess.run([python, '-c', test]).returncode == 0), None)
    return memory[module]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--update', action='store_true', help='outputs are written anew into the pages')
    parser.add_argument('--times', action='store_true', help='what each command takes')
    parser.add_argument('root')
    parser.add_argument('program')
    parser.add_argument('scratch')
    parser.add_argument('pages', nargs='+')
    options = parser.parse_args()
    run = Run(options)
    for path in options.pages:
        run.page(Page(os.path.join(options.root, path), options.root))
    if options.times:
        for seconds, page, command in sorted(run.times, reverse=True)[:40]:
            print(f'{seconds:8.2f} s  {page}: {command}')
    print('\n'.join(run.told))
    print(', '.join(f'{count} {what}' for what, count in run.counts.items()) + f'; {cpu():.1f} s of processor time')
    print('\n'.join(run.wrong))
    sys.exit(bool(run.wrong))


if __name__ == '__main__':
    main()

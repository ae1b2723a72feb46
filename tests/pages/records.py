"""What the tests of tests/verify say of themselves (tests/record.h), read and folded: programs, groups of checks, series."""
import json
import math
import re

WAYS = [('closed form', 'Closed forms', 'a formula, or what holds exactly'),
        ('published', 'Published values', 'digits that others have printed'),
        ('other code', 'Independent codes', 'programs that share no line with ours'),
        ('order', 'Convergence orders', 'how fast the error falls, against theory'),
        ('second way', 'A second way', 'another method of our own, or a much finer run'),
        ('symmetry', 'Symmetries', 'the same thing turned, mirrored, in other units; balances'),
        ('made data', 'Made data', 'data made from a truth that is known')]
ROOMS = ['section', 'rodsolver', 'fem', 'meshes', 'measure', 'reach', 'app']


class Program:
    """one test: its sentence, what it judged, its series, how it ended"""

    def __init__(self, source):
        self.name, self.room = source.stem, source.parent.name
        self.sentence = sentence_of(source)
        self.groups, self.series = {}, []
        self.code, self.seconds, self.output, self.ended, self.recorded = None, 0.0, '', False, False
        self.extent = ''  # 'long' or 'short', where it ran

    def failures(self):
        return sum(g.failed for g in self.groups.values())

    def checks(self):
        return sum(g.count for g in self.groups.values())

    def conditions(self):
        """those of its checks that have no number"""
        return sum(g.conditions for g in self.groups.values())

    def trouble(self):
        """in a few words, or nothing"""
        if self.code is None:
            return 'was not run'
        if not self.recorded:
            return f'left no record, exit code {self.code}'
        if not self.ended:
            return f'did not come to its end, exit code {self.code}'
        if self.code != 0 and self.failures() == 0:
            return f'failed without a check that says so, exit code {self.code}'
        return ''


class Group:
    """the checks of one function, against one thing"""

    def __init__(self, record):
        self.function, self.way, self.source = record['function'], record['way'], record['source']
        self.count = self.failed = self.conditions = 0
        self.told = []

    def add(self, record, count, failed):
        self.count += count
        self.failed += failed
        self.conditions += count if record['tolerance'] is None else 0
        self.told.append(record)

    def bare(self):
        """nothing but conditions that hold"""
        return not self.failed and all(share(r) < 0 for r in self.told)

    def worst(self):
        """the one that fails, else the nearest to its bound; bare conditions come last"""
        return max(self.told, key=lambda r: (not r['holds'], share(r)))


def share(record):
    """error over what is allowed, the least that is allowed over what there is; -1 for a bare condition"""
    error, allowed = record['error'], record['tolerance']
    if allowed is None:
        return -1.0 if record['holds'] else math.inf
    if record['least']:
        value, least = record['value'], record['wanted']
        return math.inf if not record['holds'] else least / value if least > 0 and math.isfinite(value) else 0.0
    if error is None or not allowed > 0:
        return 0.0 if record['holds'] else math.inf
    return error / allowed if math.isfinite(error) else float(not record['holds'])


def sentence_of(source):
    """the comment at the head of the file, less its name"""
    words = []
    for line in source.read_text(encoding='utf-8').splitlines():
        if not line.startswith('//'):
            break
        if not line[2:].strip().startswith('tests/'):
            words.append(line[2:].strip())
    return re.sub(r' *docs/theory\.md', ' theory', ' '.join(words))


def words_of(function):
    return function.replace('_', ' ')


def read(path, program):
    """one program's record"""
    slopes = {}
    for number, line in enumerate(path.read_text(encoding='utf-8').splitlines(), 1):
        try:
            r = json.loads(line)
        except ValueError:
            raise SystemExit(f'{path}:{number}: not a record')
        r.setdefault('least', False)
        if r['kind'] == 'series':
            key = (r['function'], r['what'], r['about'], r['slope'])
            if key not in slopes:
                slopes[key] = r
                r['wanted'] = None
                program.series.append(r)
        elif r['kind'] == 'end':
            program.ended = True
        else:
            belongs(r, program)
            key = (r['function'], r['way'], r['source'])
            group = program.groups.setdefault(key, Group(r))
            group.add(r, r.get('count', 1), r.get('failed', 0 if r['holds'] else 1))
    program.recorded = True


def belongs(record, program):
    """a check of a slope is one of an order, and says which one its series should have"""
    for s in program.series:
        if record['value'] is not None and record['function'] == s['function'] and record['value'] == s['slope']:
            if not record['least']:  # a bound from below is not the order itself
                s['wanted'] = record['wanted'] or record['tolerance']
            record['way'], record['source'] = 'order', 'theory'

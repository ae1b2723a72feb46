"""What a page says, in pieces, and whether a piece says what it should: page_numbers.py, page_reach.py"""
import json
import math
import re
from html.parser import HTMLParser

NUMBER = re.compile(r'-?\d+(?:\.\d+)?(?:×10[⁻⁰¹²³⁴-⁹]+)?')
RAISED = str.maketrans('⁻⁰¹²³⁴⁵⁶⁷⁸⁹', '-0123456789')
checked = []
wrong = []


class Page(HTMLParser):
    """tables: (caption, header, rows of cells); key: names and values of the headline in turn; scenes: of the views; said: paragraphs"""

    def __init__(self):
        super().__init__()
        self.tables, self.key, self.scenes, self.said, self.text = [], [], [], [], ''
        self.row, self.scene, self.small = [], False, False

    def handle_starttag(self, tag, attrs):
        self.scene = tag == 'script' and ('type', 'application/json') in attrs
        if tag == 'table':
            self.tables.append(['', [], []])
        if tag == 'tr':
            self.row = []
        if tag in ('td', 'th', 'caption', 'dt', 'dd', 'script', 'p'):
            self.text = ''
        if tag == 'small':
            self.text += '|'

    def handle_data(self, data):
        self.text += data

    def handle_endtag(self, tag):
        if tag == 'caption':
            self.tables[-1][0] = self.text
        elif tag in ('td', 'th'):
            self.row.append(self.text.strip())
        elif tag == 'thead':
            self.tables[-1][1] = self.row
        elif tag == 'tr' and self.tables[-1][1]:
            self.tables[-1][2].append(self.row)
        elif tag in ('dt', 'dd'):
            self.key.append(self.text.strip())
        elif tag == 'p':
            self.said.append(self.text)
        elif tag == 'script' and self.scene:
            self.scenes.append(json.loads(self.text))


def numbers(text):
    """(value, half of the last digit) of each number in a cell"""
    found = []
    for word in NUMBER.findall(text.replace('−', '-')):
        digits, _, power = word.partition('×10')
        power = int(power.translate(RAISED)) if power else 0
        decimals = len(digits.partition('.')[2])
        found.append((float(digits) * 10.0 ** power, 0.5 * 10.0 ** (power - decimals)))
    return found


def same(where, text, *values):
    """the cell's numbers are these values, and no others"""
    values = [v for v in values if v is not None]
    found = numbers(text)
    good = len(found) == len(values)
    for (shown, half), value in zip(found, values):
        good = good and abs(shown - value) <= half * (1 + 1e-6) + 1e-12 * abs(value)
        checked.append(where)
    if not good:
        wrong.append(f'{where}: the page says {text!r}, JSON {values}')


def degrees(x):
    return None if x is None else math.degrees(x)


def times(factor, x):
    return None if x is None else factor * x


def points(factor, p):
    return [factor * x for x in p]

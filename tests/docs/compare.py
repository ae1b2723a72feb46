"""A page's block beside what was really said: words exactly, numbers within one unit of the last digit that the page prints.

`...` as a line stands for any lines, within a line for any text. Whole numbers are held exactly. Not held: seconds and
gigabytes, which are the machine's, and which number it is where both are below 1e-9: rounding.
"""
import re

NUMBER = re.compile(r'(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.]*\w)')
OF_THE_MACHINE = re.compile(r'^ (?:s|ms|GB|MB)\b')
ROUNDING = 1e-9


def unit(number):
    """of the last digit printed; 0 for whole numbers"""
    digits, _, exponent = number.lower().partition('e')
    if '.' not in digits and not exponent:
        return 0.0
    return 10.0 ** (int(exponent or 0) - len(digits.partition('.')[2]))


def same_number(wanted, said):
    a, b = float(wanted), float(said)
    if abs(a) < ROUNDING and abs(b) < ROUNDING:
        return True
    return abs(a - b) <= unit(wanted) * (1 + 1e-6)


def pieces(line):
    """texts with single blanks, and the numbers between them; numbers of the machine count as `...`"""
    texts, numbers, at = [], [], 0
    line = re.sub(r'\s+', ' ', line.strip())
    for number in NUMBER.finditer(line):
        texts.append(line[at:number.start()])
        numbers.append('...' if OF_THE_MACHINE.match(line[number.end():]) else number[0])
        at = number.end()
    return texts + [line[at:]], numbers


def skeleton(line):
    """a pattern: every number is any number, `...` any text; the text between is caught"""
    whole = []
    for part in line.strip().split('...'):
        texts, numbers = pieces(part)
        pattern = ''
        for k, text in enumerate(texts):
            pattern += r'\s*'.join(re.escape(word) for word in re.split(r' ', text)) if text.strip() else r'\s*'
            if k < len(numbers):
                pattern += r'[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?'
        whole.append('(' + pattern + ')')
    return re.compile(r'^\s*' + '.*?'.join(whole) + r'\s*$')


def same_line(wanted, said):
    if '...' in wanted:
        found = skeleton(wanted).match(said)
        parts = wanted.strip().split('...')
        return bool(found) and all(same_part(a, b) for a, b in zip(parts, found.groups()))
    return same_part(wanted, said)


def same_part(wanted, said):
    (texts, numbers), (other_texts, other_numbers) = pieces(wanted), pieces(said)
    if [t.strip() for t in texts] != [t.strip() for t in other_texts] or len(numbers) != len(other_numbers):
        return False
    return all('...' in (a, b) or same_number(a, b) for a, b in zip(numbers, other_numbers))


def alike(wanted, said):
    """the same line but for its numbers"""
    return bool(skeleton(wanted).match(said))


def renewed(wanted, said):
    """the page's line with today's numbers, its `...` kept"""
    if '...' not in wanted:
        return said
    start = wanted[:len(wanted) - len(wanted.lstrip())]
    return start + '...'.join(skeleton(wanted).match(said).groups())


def trim(lines):
    lines = [line.rstrip() for line in lines]
    while lines and not lines[-1]:
        lines.pop()
    while lines and not lines[0]:
        lines.pop(0)
    return lines


def stretches(wanted):
    """between the lines `...`: (first of the page's lines, lines)"""
    found, start = [], 0
    for k in [k for k, line in enumerate(wanted) if line.strip() == '...'] + [len(wanted)]:
        found.append((start, wanted[start:k]))
        start = k + 1
    return found


def match(wanted, said, same):
    """where each line of the page stands in what was said: list of (page, said); or (None, the line that is not there)"""
    places, at = [], 0
    parts = stretches(wanted)
    for k, (first, lines) in enumerate(parts):
        last = k == len(parts) - 1
        if last and lines:  # ends where what was said ends
            candidates = [len(said) - len(lines)]
        else:
            candidates = range(at, len(said) - len(lines) + 1)
        if k == 0 and lines:  # begins where it begins
            candidates = [0] if 0 in candidates or len(parts) == 1 else []
        best = 0
        for start in candidates:
            if start < at:
                continue
            count = next((i for i, line in enumerate(lines) if i + start >= len(said) or not same(line, said[start + i])),
                         len(lines))
            best = max(best, count)
            if count == len(lines):
                places += [(first + i, start + i) for i in range(count)]
                at = start + count
                break
        else:
            return None, lines[min(best, len(lines) - 1)]
    if not (wanted and wanted[-1].strip() == '...') and at != len(said):
        return None, f'(the end; said next: {said[at]})'
    return places, None


def check(wanted, said):
    """what is wrong, or None"""
    wanted, said = trim(wanted), trim(said)
    places, missing = match(wanted, said, same_line)
    if places is not None:
        return None
    near = [line for line in said if alike(missing, line)]
    return f'not said: {missing.strip()}' + (f'\n    but: {near[0].strip()}' if near else '')


def update(wanted, said):
    """the page's lines as they would be said today, or None where more than numbers changed between two `...`"""
    wanted, said = trim(wanted), trim(said)
    if not any(line.strip() == '...' for line in wanted):
        return [renewed(wanted[k], said[k]) if k < len(wanted) and alike(wanted[k], said[k]) else said[k]
                for k in range(len(said))]
    places, _ = match(wanted, said, alike)
    if places is None:
        return None
    lines = list(wanted)
    for page, line in places:
        lines[page] = renewed(wanted[page], said[line])
    return lines

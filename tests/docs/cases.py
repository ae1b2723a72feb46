"""Parts of a case that a page shows, put into the whole case that they name: by lines, since a case may hold any YAML."""
import re

KEY = re.compile(r'^( *)([A-Za-z_]\w*):(.*)$')


def parts(lines):
    """maps of keys: [(key, its lines)] at the first line's indentation; None where these lines are no map"""
    found, indent = [], None
    for line in lines:
        key = KEY.match(line)
        bare = not line.strip() or line.lstrip().startswith('#')
        if indent is None and not bare:
            if not key:
                return None
            indent = len(key[1])
        if key and len(key[1]) == indent:
            found.append((key[2], [line]))
        elif found:
            found[-1][1].append(line)
        elif not bare:
            return None
    return found


def is_map(lines):
    """the value below a key is a map in lines of its own"""
    return not KEY.match(lines[0])[3].split('#')[0].strip() and bool(parts(lines[1:]))


def merge(case, fragment):
    """the case's lines with the fragment's keys: maps go into maps, anything else takes the place of what was there"""
    mine, theirs = parts(case), parts(fragment)
    indent = len(KEY.match(mine[0][1][0])[1])
    step = indent - len(KEY.match(theirs[0][1][0])[1])
    for key, lines in theirs:
        lines = [' ' * step + line if step > 0 else line for line in lines]
        at = next((k for k, (name, _) in enumerate(mine) if name == key), None)
        if at is None:
            mine.append((key, lines))
        elif is_map(mine[at][1]) and is_map(lines):
            mine[at] = (key, [mine[at][1][0]] + merge(mine[at][1][1:], lines[1:]))
        else:
            mine[at] = (key, lines)
    return [line for _, lines in mine for line in lines]


def without(case, keys):
    """the case less the keys `a.b`, for fragments that take the place of others (png instead of shapes)"""
    for key in keys:
        first, _, rest = key.partition('.')
        kept = []
        for name, lines in parts(case):
            if name != first:
                kept += lines
            elif rest:
                kept += lines[:1] + without(lines[1:], [rest])
        case = kept
    return case


def whole(case, fragment, inside, less):
    """`inside`: the key below which a fragment belongs that begins with indentation"""
    first = next(line for line in fragment if line.strip())
    if inside:
        fragment = [f'{inside}:'] + [line if first.startswith(' ') else '  ' + line for line in fragment]
    return merge(without(case, less), fragment)

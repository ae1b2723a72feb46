"""What a page says and draws of a reach study, against its JSON document: for page_numbers.py"""
import base64
import math
import re

from page_cells import checked, degrees, points, same, times, wrong

N = '\0'  # where a number stands in a form
A_NUMBER = r'(−?\d+(?:\.\d+)?(?:×10[⁻⁰¹²³⁴-⁹]+)?)'
STEPS = 65535  # of a scene's box


def of(run):
    """the study's document, alone or within a run's; None: there is none"""
    return run.get('reach', run if 'scopes' in run else None)


def told(where, text, form, *values):
    """the text is this form, word by word, with these values"""
    found = re.fullmatch(A_NUMBER.join(re.escape(piece) for piece in form.split(N)), text)
    if not found:
        wrong.append(f'{where}: the page says {text!r}, not {form!r}')
        return
    for shown, value in zip(found.groups(), values, strict=True):
        same(where, shown, value)


def words_of(where, text, wanted):
    """words that the document has too, which may hold numbers of their own"""
    checked.append(where)
    if text != wanted:
        wrong.append(f'{where}: the page says {text!r}, JSON {wanted!r}')


def is_open(answer):
    return answer['verdict'] == 'collision' and not answer['proved']


def verdict(answer):
    return 'collision, not proved' if is_open(answer) else answer['verdict'].replace('_', ' ')


def bends(scope):
    """name, what a radian or newton is on the page, unit"""
    return [(j['name'], math.degrees(1) if j['unit'] == 'rad' else 1, 'deg' if j['unit'] == 'rad' else 'N')
            for j in scope['joints'][2:]]


# --- tables

def scopes(table, run):
    study = of(run)
    ours = [row for row in table[2] if not row[0].endswith('|as printed in the paper')]
    for row, s in zip(ours, study['scopes'], strict=True):
        where, m, answers = s['name'], s['map'], s['answers']
        words_of(where, row[0], f'{s["name"]}|{s["kind"]}')
        reached = sum(a['verdict'] == 'reached' for a in answers)
        same(f'{where}, reached', row[1], *([reached, len(answers)] if answers else []))
        same(f'{where}, open', row[2], *([sum(map(is_open, answers))] if answers else []))
        same(f'{where}, area', row[3], *([100 * m['area_reached_share'], 100 * m['standard_error_share']] if m else []))
        same(f'{where}, not known', row[4], *([100 * m['area_undecided_share']] if m else []))
        same(f'{where}, tip', row[5], 1e3 * s['length_m'])
        same(f'{where}, radius', row[6], 1e3 * s['radius_m'])
        same(f'{where}, CPU time', row[7], s['cpu_s'])
        words_of(f'{where}, anatomy', row[8], 'synthetic' if study['synthetic'] else 'as given')
    printed = study['as_printed_in_the_paper']
    for row in table[2][len(ours):]:
        key = 'helical_reached' if row[0].startswith('helical') else 'constant_curvature_reached'
        told(row[0], row[1], f'{N} of {N}', printed[key], printed['targets'])


def limits(table, run):
    for row, s in zip(table[2], of(run)['scopes'], strict=True):
        words_of('limits', row[0], s['name'])
        for name, cell, unit, joint in zip(table[1][1:], row[1:], (1e3, math.degrees(1)), s['joints']):
            told(f'{s["name"]}, {name}', cell, f'{N} to {N}', unit * joint['low'], unit * joint['high'])
        form = ', '.join(f'{name} {N} to {N} {unit}' for name, _, unit in bends(s))
        told(f'{s["name"]}, bending', row[3], form,
             *[unit * joint[end] for joint, (_, unit, _) in zip(s['joints'][2:], bends(s)) for end in ('low', 'high')])
        words_of(f'{s["name"]}, from where', row[4], s['limit_note'] or 'as the case gives them')


def reached(where, parts, s, a):
    """what stands below a verdict: form and values of each part"""
    q = [a['pose']['bend_rad']] if 'bend_rad' in a['pose'] else a['pose']['tensions_N']
    wanted = []
    if a['clearance_m'] is not None:
        shaft = a['least_clear_at_s_m'] < 0
        wanted.append((f'clearance {N} mm' + (' on the shaft' if shaft else f' at s = {N} mm'),
                       [1e3 * a['clearance_m']] + ([] if shaft else [1e3 * a['least_clear_at_s_m']])))
    wanted.append((', '.join(f'{name} {N} {unit}' for name, _, unit in bends(s)),
                   [unit * x for x, (_, unit, _) in zip(q, bends(s), strict=True)]))
    if a['strain'] is not None:
        wanted.append((f'strain {N} %', [100 * a['strain']]))
    if a['way_in']['clearance_m'] is not None:
        wanted.append((f'on the way in {N} mm', [1e3 * a['way_in']['clearance_m']]))
    if len(parts) != len(wanted):
        wrong.append(f'{where}: the page says {parts}, wanted {[form for form, _ in wanted]}')
    for part, (form, values) in zip(parts, wanted):
        told(where, part, form, *values)


def targets(table, run):
    study = of(run)
    for k, row in enumerate(table[2]):
        target = study['targets'][k]
        told('target', row[0], f'{target["name"]}|no. {N} at ({N}, {N}, {N})', k + 1, *points(1e3, target['p_m']))
        same(f'{target["name"]}, from the wall', row[1], times(1e3, target['depth_m']))
        for s, cell in zip(study['scopes'], row[2:], strict=True):
            where, a, parts = f'{target["name"]}, {s["name"]}', s['answers'][k], cell.split('|')
            good = a['verdict'] == 'reached'
            words_of(where, parts[0], ('✓ ' if good else '✗ ') + verdict(a))
            if good:
                reached(where, parts[1:], s, a)
            else:
                words_of(where, '|'.join(parts[1:]), a['why'] + ('|proved' if a['proved'] else ''))


def thoroughness(table, run):
    for row, s in zip(table[2], of(run)['scopes'], strict=True):
        missed = [a for a in s['answers'] if a['verdict'] != 'reached']
        one_bend = sum(j['low'] < j['high'] for j in s['joints'][2:]) <= 1
        far = [a for a in missed if not a['proved'] and a['verdict'] in ('out_of_reach', 'joint_limit') and one_bend]
        rest = [a for a in missed if not a['proved'] and a not in far]
        bounds = [a['clearance_bound_m'] for a in rest if (a['clearance_bound_m'] or -1) >= 0]
        where = f'thoroughness of {s["name"]}'
        words_of(where, row[0], s['name'])
        same(f'{where}, missed', row[1], len(missed))
        same(f'{where}, proved', row[2], sum(a['proved'] for a in missed))
        same(f'{where}, every bend', row[3], len(far))
        form = f'{N}|bound left, mm: {N}' if bounds else f'{N}|'
        told(f'{where}, searched', row[4], form, len(rest), *[1e3 * max(bounds)] if bounds else [])
        told(f'{where}, effort', row[5], f'{N}, {N}', *[max([a[key] for a in missed], default=0) for key in ('looks', 'starts')])
        form, m = (f'{N}|of the map: {N}', [1e3 * s['map']['spacing_m']]) if s['map'] else (N, [])
        told(f'{where}, tips apart', row[6], form, 1e3 * s['pose_spacing_m'], *m)


def goal(where, cell, design, value):
    if value is None:
        words_of(where, cell, 'no answer')
    else:
        told(where, cell, f'{N} %' if design['maximise'] == 'area' else N, 100 * value if design['maximise'] == 'area' else value)


def parameters(table, run):
    design = of(run)['design']
    best = ([i for i in design['improvements'] if i['best']] or [{'goal': None, 'score': None}])[0]
    for row, p in zip(table[2], design['parameters']):
        words_of('parameter', row[0], p['name'])
        for name, cell, key in zip(table[1][2:], row[2:], ('lower', 'upper', 'start', 'best'), strict=True):
            same(f'{p["name"]}, {name}', cell, p[key])
    goals, scores = table[2][len(design['parameters']):]
    goal('goal at first', goals[4], design, design['start_goal'])
    goal('goal found', goals[5], design, best['goal'])
    same('score at first', scores[4], design['start_score'])
    same('score found', scores[5], best['score'])


def improvements(table, run):
    design = of(run)['design']
    for row, i in zip(table[2], design['improvements']):
        same('island', row[0], i['island'])
        same('evaluation', row[1], i['evaluation'])
        goal('goal on the way', row[2], design, i['goal'])
        same('score on the way', row[3], i['score'])
        for name, cell, value in zip(table[1][4:], row[4:], i['values'], strict=True):
            same(f'{name} on the way', cell, value)


CAPTIONS = [('The scopes beside', scopes), ('Improvements on', improvements)]
# second word of the head, where the first is not enough
HEADS = [('target|mm', targets), ('parameter', parameters), ('insertion|mm', limits), ('not reached|targets', thoroughness)]


def table_of(table):
    """the function that knows this table; None: nobody does"""
    by = [f for word, f in CAPTIONS if table[0].startswith(word)] + [f for word, f in HEADS if word in table[1][:2]]
    return by[0] if by else None


# --- sentences

def headline(name, cell, run):
    s = [s for s in of(run)['scopes'] if name == f'Targets reached: {s["name"]}'][0]
    same(name, cell.split('|')[0], s['reached'], s['targets'])


def first(said, words):
    return ([text for text in said if words in text] or [''])[0]


def between(where, text, before, behind, form, *values):
    """what stands between these words"""
    found = re.search(re.escape(before) + '(.*?)' + re.escape(behind), text)
    told(where, found[1] if found else text, form, *values)


def sentences(said, run):
    r = of(run)
    mm = 1e3 * r['tolerance_m']
    between('tissue', first(said, 'Tissue: '), f'Tissue: {r["tissue"]["file"]}, ', ' ml', f'{N} triangles, {N} mm², enclosing {N}',
            r['tissue']['triangles'], 1e6 * r['tissue']['area_m2'], 1e6 * r['tissue']['volume_m3'])
    between('tolerance', first(said, 'A target counts'), 'comes within ', ' of it', f'{N} mm', mm)
    enter = first(said, 'The scopes enter')
    told('entry', enter.partition(';')[0].removesuffix('.'), f'The scopes enter at ({N}, {N}, {N}) mm along ({N}, {N}, {N})',
         *points(1e3, r['entry']['p_m']), *r['entry']['direction'])
    if r['entry']['free_m'] > 0:
        between('channel', enter, 'over the first ', ' of that line', f'{N} mm', 1e3 * r['entry']['free_m'])
    if r['clearance_m'] > 0:
        between('clearance asked for', enter, '; ', ' are left', f'{N} mm', 1e3 * r['clearance_m'])
    maps = [s['map'] for s in r['scopes'] if s['map']]
    if maps:
        wall = first(said, 'A place of the wall')
        between('wall', wall, 'comes within ', ' of it', f'{N} mm', mm + 1e3 * r['clearance_m'])
        between('wall', wall, 'at targets: ', ' places', N, maps[0]['samples'])
    between('resolution', first(said, 'in steps down to'), 'in steps down to ', ' mm', N, 1e3 * r['resolution_m'])
    if 'design' in r:
        d = r['design']
        between('design', first(said, 'was varied to make'), 'largest: ', ' without', f'{N} evaluations by {N} search'
                f'{"" if d["islands"] == 1 else "es"} side by side from seed {N}, {N} of them', d['evaluations'], d['islands'],
                d['seed'], d['failed'])


# --- the view

def is_view(scene):
    return [c['name'] for c in scene['choices']] == ['Scope', 'Target']


def target_at(scene, item):
    """number in the document of the target that an item belongs to"""
    return int(scene['choices'][1]['options'][item['at'][1]].partition(':')[0]) - 1


def view_words(scene, item, run):
    study = of(run)
    s, text = study['scopes'][item['at'][0]], item['words']
    if item['at'][1] < 0:
        told(s['name'], text, f'{s["name"]} ({s["kind"]}): {N} of {N} targets reached.', s['reached'], s['targets'])
        return
    k = target_at(scene, item)
    a, name = s['answers'][k], study['targets'][k]['name']
    form, values = f'Target {N}' + (f': {name}' if name else '') + f': {verdict(a)}', [k + 1]
    if a['clearance_m'] is not None:
        form += f', least clearance {N} mm at s = {N} mm'
        values += [1e3 * a['clearance_m'], 1e3 * a['least_clear_at_s_m']]
    if a['way_in']['clearance_m'] is not None:
        form += f', on the way in {N} mm'
        values.append(1e3 * a['way_in']['clearance_m'])
    form += f'; the tip is {"–" if a["miss_m"] is None else N} mm from it' + (f'. {a["why"]}' if a['why'] else '') + '.'
    told(f'view of {name}, {s["name"]}', text, form, *values, *([] if a['miss_m'] is None else [1e3 * a['miss_m']]))


def places(scene, item):
    """points of a packed item [mm], in rows of three"""
    data = base64.b64decode(item['points'])
    steps = [data[i] | data[i + 1] << 8 for i in range(0, len(data), 2)]
    at = [scene['low'][i % 3] + scene['size'] * step / STEPS for i, step in enumerate(steps)]
    return [at[i:i + 3] for i in range(0, len(at), 3)]


def near(where, scene, drawn, meant):
    """within half a step of the box, and what its corner is rounded by"""
    most = 0.5 * scene['size'] / STEPS * (1 + 1e-6)
    checked.append(where)
    if any(abs(a - 1e3 * b) > most for a, b in zip(drawn, meant, strict=True)):
        wrong.append(f'{where}: drawn at {drawn} mm, JSON {meant} m')


def view_drawn(scene, item, run):
    """targets where they are, and bodies from where they begin to the tip"""
    study = of(run)
    if item['kind'] == 'points':
        for label, at in zip(item['labels'], places(scene, item), strict=True):
            near(f'target {label}', scene, at, study['targets'][int(label) - 1]['p_m'])
    elif item['kind'] == 'tube' and item['frames'] == 1:
        body = study['scopes'][item['at'][0]]['answers'][target_at(scene, item)]['body']['p_m']
        drawn = places(scene, item)
        near('end of a body', scene, drawn[-1], body[-1])
        # the shaft may begin outside the box
        inside = [min(max(x, low / 1e3), (low + scene['size']) / 1e3) for x, low in zip(body[0], scene['low'])]
        near('beginning of a body', scene, drawn[0], inside)


def view(scene, run):
    for item in scene['items']:
        if item['kind'] == 'words':
            view_words(scene, item, run)
        view_drawn(scene, item, run)

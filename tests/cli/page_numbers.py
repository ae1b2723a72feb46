"""Holds every number of a page's tables, headline and views against the JSON document of the same run, to the digits that
the page prints; of a reach study those of its sentences too.  page_numbers.py report.html run.json"""
import json
import math
import re
import sys

import page_reach
from page_cells import Page, checked, degrees, numbers, points, same, times, wrong

# --- one function per table, by words of its caption or head

def sections(table, run):
    all_of = run['section']['stations']
    shown = len(table[2])
    for i, row in enumerate(table[2]):
        s = all_of[i * (len(all_of) - 1) // (shown - 1) if shown > 1 else 0]
        angle = [] if s['isotropic'] else [degrees(s['principal_angle_rad'])]
        wanted = [[1e3 * s['s_m']], [s['EA_N']], points(1e3, s['stiffness_centre_m']), angle, [1e6 * s['EI_Nm2'][0]],
                  [1e6 * s['EI_Nm2'][1]], [1e6 * s['GJ_Nm2']], points(1e3, s['shear_centre_m']), [1e6 * s['area_m2']],
                  [s['relative_error']]]
        for name, cell, values in zip(table[1], row, wanted, strict=True):
            same(f'section {i}, {name}', cell, *values)


def stiffness(table, run):
    for i, row in enumerate(table[2]):
        for j, cell in enumerate(row[1:]):
            unit = (1e3 if i > 2 else 1) * (1e3 if j > 2 else 1)
            same(f'K[{i}][{j}]', cell, unit * run['section']['stations'][0]['K'][i][j])


def more_of_section(table, run):
    s = run['section']['stations'][0]
    known = {
        'shear stiffness along x″': [s['shear_stiffness_N'][0]],
        'shear stiffness along y″': [s['shear_stiffness_N'][1]],
        'x″ turned': [degrees(s['shear_angle_rad'])],
        'turning rate of the pattern': [s['turn_rate_rad_per_m']],
        'centre of the area': points(1e3, s.get('geometric_centre_m') or []),
        'mass per length': [times(1e3, s.get('mass_kg_per_m'))],
        'mass centre': points(1e3, s.get('mass_centre_m') or []),
        'warping constant E Iω': [times(1e12, s.get('EI_warping_Nm4'))],
    }
    for row in table[2]:
        same(row[0], row[1], *known[row[0]])


def rods(table, run):
    rod = run['rod']
    names = [t['name'] for t in rod['tendons']] if isinstance(rod['tendons'][0], dict) else rod['tendons']
    for row in table[2]:
        number = int(numbers(row[0])[0][0])
        s = rod['solutions'][number - 1]
        for name, cell in zip(table[1][1:], row[1:], strict=True):
            name, _, unit = name.partition('|')
            if unit == 'N':
                k = names.index(name)
                pull = times(1e3, s['pulls_m'][k])
                same(f'rod {number}, {name}', cell, *([pull] if 'slack' in cell else [s['tensions_N'][k], pull]))
            elif unit == 'factor':
                same(f'rod {number}, {name}', cell,
                     s['load_factors'][[x['name'] for x in rod['loads']].index(name)])
            elif name == 'tip':
                same(f'rod {number}, tip', cell, *points(1e3, s['tip_position_m']))
            elif name == 'bend':
                same(f'rod {number}, bend', cell, degrees(s['total_bend_rad']))
            elif name.startswith('length of '):
                same(f'rod {number}, {name}', cell, 1e3 * s['tendon_length_m'][names.index(name[10:])])
            elif name == 'largest strain':
                same(f'rod {number}, strain', cell, 100 * s['largest_strain'])
            else:
                assert name == 'rel. error', name
                if cell.startswith('below '):
                    same(f'rod {number}, floor of the error', cell[6:].replace('10⁻', '1×10⁻'), 1e-15)
                    assert s['relative_error'] < 1e-15, s
                else:
                    same(f'rod {number}, error', cell, s['relative_error'])


def equilibria(table, run):
    for row in table[2]:
        s = run['rod']['solutions'][int(row[0]) - 1]
        wanted = [[] if row[1] == 'all' else [s['fraction']], [], [s['eigenvalue']], None, [times(1e6, s['energy_J'])],
                  [times(1e6, s['work_J'])], [s['energy_misfit']], [s['residual']], [s['iterations']]]
        for name, cell, values in zip(table[1][1:], row[1:], wanted, strict=True):
            if values is not None:
                same(f'equilibrium {row[0]}, {name}', cell, *values)
        for critical in s['critical_points'][:4]:
            same('critical', row[4].split('at ')[-1], critical['fraction']) if len(s['critical_points']) == 1 else None


def strains(table, run):
    for row in table[2]:
        solution = run['rod']['solutions'][int(row[3]) - 1]
        m = [m for m in solution['materials'] if m['name'] == row[0]][0]
        limit = m['linear_strain']
        same(f'strain of {row[0]}', row[1], 100 * m['largest_strain'])
        same(f'linear strain of {row[0]}', row[2], *([100 * limit] if limit else []))
        same(f'strain of {row[0]} at s', row[4], 1e3 * m['s_m'])
        same(f'strain of {row[0]} at', row[5], *points(1e3, m['at_m']))


def with_error(value, error):
    return [value] + ([error] if error else [])


def loads(table, run):
    fem = run['fem']
    for row, l in zip(table[2], fem['loads'], strict=True):
        row = [cell.split('|paper')[0] for cell in row]
        w, u = l['tip_rotation_rad'], l['tip_displacement_m']
        length = fem['length_m']
        wanted = [points(1e3, l['point_m']),
                  with_error(1e3 * l['shortening_m'], times(1e3, l['shortening_error_m'])) +
                  [100 * l['shortening_m'] / length],
                  with_error(-1e3 * u[2], times(1e3, l['tip_displacement_error_m'])),
                  with_error(math.degrees(math.hypot(w[0], w[1])), degrees(l['tip_rotation_error_rad'])),
                  [math.degrees(w[2])],
                  l['mid_curvature_per_m'] + with_error(0, l['mid_curvature_error_per_m'])[1:],
                  with_error(1e6 * l['strain_energy_J'], times(1e6, l['strain_energy_error_J']))]
        for name, cell, values in zip(table[1][1:], row[1:], wanted, strict=True):
            same(f'load {row[0]}, {name}', cell, *values)


def ends(table, run):
    for name, cell, value in zip(table[1], table[2][0], run['fem']['end_length_m'], strict=True):
        same(f'ends, {name}', cell, times(1e3, value))


def compare(table, run):
    rows = {r['what']: r for r in run['compare']['rows']}
    for row in table[2]:
        r = rows.pop(row[0].partition('|')[0])
        if r['skipped']:
            assert 'skipped' in row, row
            continue
        for cell, key in zip(row[1:3] + row[4:6], ('ours', 'other', 'difference_relative', 'tolerance_relative')):
            same(f'{r["what"]}, {key}', cell, r[key])
        if ('agrees' in row[7]) != r['ok']:
            wrong.append(f'{r["what"]}: verdict {row[7]}')


AXES = ['nx', 'ny', 'nz', 'mx', 'my', 'mz']


def models(table, run):
    m = run['compare']['models']
    C = m['compliance_3d']
    for row in table[2]:
        words = row[0].split()
        if words[0] in AXES and len(words) == 2:
            i, j = AXES.index(words[0]), AXES.index(words[1])
            unit = (1e3 if i < 3 else 1) * (1 if j < 3 else 1e-3)
            same(f'models, {row[0]}', row[1], unit * C[i][j])
            for a, cell in zip(m['assumptions'], row[2:], strict=True):
                if cell:
                    same(f'models, {row[0]}', cell, (a['compliance'][i][j] - C[i][j]) / math.sqrt(C[i][i] * C[j][j]))
        else:
            key = 'law_error' if 'law' in row[0] else 'error'
            for a, cell in zip(m['assumptions'], row[2:], strict=True):
                if cell:
                    same(f'models, {row[0]}', cell, a[key])


def paper(table, run):
    for row, s in zip(table[2], run['compare']['measured']['shapes'], strict=True):
        p = s['paper']
        same(f'{row[0]}, tip error', row[-2], 1e3 * p['tip_error_m'], 100 * p['tip_error_of_length'])
        same(f'{row[0]}, shape error', row[-1], 100 * p['shape_error'])


TABLES = [('Sections along', sections), ('Rows: wrench', stiffness), ('More of the section', more_of_section),
          ('One row for each', rods), ('Each solution as', equilibria), ('The largest principal', strains),
          ('What each load does', loads), ('What the layers', ends), ('The paper\'s model against', paper)]
# materials and loads are the case's, no answers
HEADS = [('what', compare), ('entry', models), ('material', None), ('load', None)]


def beyond(mark, run):
    """the bend says how many shapes strain a material by more than keeps it linear"""
    shapes = run['rod']['solutions']
    count = sum(any(m['linear_strain'] and abs(m['largest_strain']) > m['linear_strain'] for m in s['materials']) for s in shapes)
    same('shapes past the linear strain', mark, *([count, len(shapes)] if count else []))


def centre(said, run):
    """of the 3D segment, its meshes' error, and how far it lies from the section's own"""
    fem, stations = run['fem'], run['section']['stations'] if 'section' in run else []
    found = fem['stiffness_centre_m']
    wanted = points(1e3, found) + ([1e3 * fem['stiffness_centre_error_m']] if fem['stiffness_centre_error_m'] else [])
    wanted += points(1e3, fem['tip_centre_m'])
    if len(stations) == 1:
        wanted.append(1e3 * math.dist(found, stations[0]['stiffness_centre_m']))
    same('3D centre', said.replace('3D', ''), *wanted)


def headline(key, run):
    s = run['section']['stations'][0] if 'section' in run else None
    for name, cell in zip(key[::2], key[1::2], strict=True):
        if name.startswith('Stiffness centre off'):
            same(name, cell, 1e3 * math.hypot(*s['stiffness_centre_m']))
        elif name == 'Axial stiffness EA':
            same(name, cell, s['EA_N'])
        elif name.startswith('Torsional'):
            same(name, cell.split('|')[0], 1e6 * s['GJ_Nm2'])
        elif name.startswith('Largest bend'):
            cell, _, mark = cell.partition('⚠')
            same(name, cell, degrees(max(x['total_bend_rad'] for x in run['rod']['solutions'])))
            beyond(mark, run)
        elif name.startswith("Segment's tip angle: "):
            load = [l for l in run['fem']['loads'] if l['name'] == name[21:]][0]
            same(name, cell, math.degrees(math.hypot(*load['tip_rotation_rad'][:2])))
        elif name == 'Comparisons':
            if ('all agree' in cell) != run['compare']['ok']:
                wrong.append('headline: ' + cell)
        elif name.startswith('Targets reached: '):
            page_reach.headline(name, cell, run)
        else:
            wrong.append('headline that no document has: ' + name)


def words(scene, run):
    """what a view says of what is chosen"""
    for text in [i['words'] for i in scene['items'] if i['kind'] == 'words']:
        rod = re.match(r'Solution (\d+): .* Tip at \((.*)\) mm, bend (.*) deg, largest strain (.*?) %', text)
        load = re.match(r'(.*): acts at \((.*)\) mm. Shortening (.*) mm, tip angle (.*) deg, tip twist (.*) deg, mid '
                        r'curvature \((.*)\) 1/m; largest', text)
        if rod:
            s = run['rod']['solutions'][int(rod[1]) - 1]
            same(text, rod[2], *points(1e3, s['tip_position_m']))
            same(text, rod[3], degrees(s['total_bend_rad']))
            same(text, rod[4], 100 * s['largest_strain'])
        elif load:
            l = [l for l in run['fem']['loads'] if l['name'] == load[1]][0]
            same(text, load[2], *points(1e3, l['point_m']))
            same(text, load[3], 1e3 * l['shortening_m'])
            same(text, load[4], math.degrees(math.hypot(*l['tip_rotation_rad'][:2])))
            same(text, load[5], math.degrees(l['tip_rotation_rad'][2]))
            same(text, load[6], *l['mid_curvature_per_m'])
        elif not text.startswith(('The section', 'Small holes')):
            wrong.append('a view says what no document has: ' + text)


def check(page, run):
    for table in page.tables:
        by = [f for word, f in TABLES if table[0].startswith(word)] or [page_reach.table_of(table)]
        by = [f for f in by if f] or [f for word, f in HEADS if table[1][0].partition('|')[0] == word]
        if not by:
            wrong.append(f'a table that no document has: {table[0]} {table[1]}')
        elif by[0]:
            by[0](table, run)
    headline(page.key, run)
    for said in page.said:
        if said.startswith('Centre found by the 3D'):
            centre(said, run)
    if page_reach.of(run):
        page_reach.sentences(page.said, run)
    for scene in page.scenes:
        (page_reach.view if page_reach.is_view(scene) else words)(scene, run)


def main():
    page, run = Page(), json.load(open(sys.argv[2], encoding='utf-8'))
    page.feed(open(sys.argv[1], encoding='utf-8').read())
    check(page, run)
    for line in wrong[:10]:
        print(line)
    print(f'{len(checked)} numbers in {len(page.tables)} tables, the headline and {len(page.scenes)} views; {len(wrong)} wrong')
    sys.exit(1 if wrong or len(checked) < 20 else 0)


if __name__ == '__main__':
    main()

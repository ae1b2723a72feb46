"""What a person does with a page, in headless Chromium: page_browser.py report.html run.json DIRECTORY"""
import json
import os
import sys

from chromium import Browser

COVERED = 4.1  # mm: the radius of the section of constant_nc, and what a drawing may be off
HELP = '''
const [rod, segment] = document.querySelectorAll("figure.view");
const set = (e, value, event) => { e.value = value; e.dispatchEvent(new Event(event)); };
const state = (f) => Object.assign({words: f.querySelector(".words").textContent}, f.dataset);
const slider = rod.querySelectorAll("input[type=range]:not([hidden])")[0];
const factor = segment.querySelector("output").parentNode.querySelector("input");
'''
# contrast of text against what lies behind it, WCAG 2.1; pictures are white by day and by night
CONTRAST = '''(() => {
    const canvas = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
    const rgb = (c) => { canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = c; canvas.fillRect(0, 0, 1, 1);
                         return Array.from(canvas.getImageData(0, 0, 1, 1).data); };
    const light = (c) => c.slice(0, 3).map((x) => x / 255).map((x) => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4)
                          .reduce((sum, x, i) => sum + x * [0.2126, 0.7152, 0.0722][i], 0);
    const behind = (e) => { for (; e; e = e.parentElement) { const c = rgb(getComputedStyle(e).backgroundColor);
                                                             if (c[3] === 255) { return c; } }
                            return rgb("white"); };
    const seen = new Map(), walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    let number = 0;
    while (walk.nextNode()) {
        const e = walk.currentNode.parentElement;
        if (!walk.currentNode.textContent.trim() || e.closest("script,svg,option,select,button") || !e.getClientRects().length) { continue; }
        const a = light(rgb(getComputedStyle(e).color)), b = light(behind(e));
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        number++;
        if (ratio < 4.5) { seen.set(e.tagName + "." + e.className, ratio.toFixed(2)); }
    }
    return {number: number, low: Array.from(seen)};
})()'''
FOCUS = '''(() => {
    const e = document.activeElement, s = getComputedStyle(e), mark = e.querySelector(".mark, text");
    return {what: e.tagName + "." + (e.className.baseVal || e.className) + "#" + (e.type || ""), view: Boolean(e.closest(".view")),
            ring: s.outlineStyle !== "none" && parseFloat(s.outlineWidth) > 0 || Boolean(mark), name: e.getAttribute("aria-label") ||
            (e.closest("label") || e).textContent.trim()};
})()'''


def told_by_console(browser):
    assert browser.complaints == [], browser.complaints
    assert browser.requests == [], browser.requests


def in_sight(browser, state='live'):
    """one comes by every view, so that all of them are made"""
    for i in range(browser.ask('document.querySelectorAll("figure.view").length')):
        browser.ask('document.querySelectorAll("figure.view")[%d].scrollIntoView()' % i)
        browser.until('document.querySelectorAll("figure.view")[%d].dataset.state === "%s"' % (i, state))


def rods(browser, run):
    """every solution, by its slider: drawn where it is"""
    solutions, length = run['rod']['solutions'], 1e3 * run['rod']['length_m']
    told = browser.ask('(() => {' + HELP + '''const told = [];
        for (let i = 0; i <= Number(slider.max); i++) { set(slider, i, "input"); told.push(state(rod)); }
        return told; })()''')
    assert len(told) == len(solutions)
    quantum = length * 2 / 65535 + 1e-3  # coordinates are 16 bits of a box of the rod's size, told to a micrometre
    for shown, s in zip(told, solutions):
        end = [float(x) for x in shown['end'].split()]
        assert all(abs(a - 1e3 * b) < quantum for a, b in zip(end, s['tip_position_m'])), (shown['end'], s['tip_position_m'])
        low, high = ([float(x) for x in shown[k].split()] for k in ('low', 'high'))
        # what is drawn lies around the centreline, and no further
        for d in range(3):
            line = [1e3 * p['p_m'][d] for p in s['shape']]
            assert min(line) - COVERED < low[d] <= min(line) + 0.1 and max(line) - 0.1 <= high[d] < max(line) + COVERED, (d, low, high)
    assert len({shown['end'] for shown in told}) == len(solutions)
    every = browser.ask('(() => {' + HELP + '''set(rod.querySelectorAll("select")[0], 1, "change"); set(slider, -1, "input");
        return {shown: state(rod).shown, key: rod.querySelector(".keys").textContent, value: slider.getAttribute("aria-valuetext")}; })()''')
    assert every['shown'].count(';') == len(solutions) - 1 and every['value'] == 'all', every
    assert 'strain' in every['key'], every


def segment(browser, run):
    """at rest, as the slider begins, and twice that"""
    told = browser.ask('(() => {' + HELP + '''return [0, 20, 40].map((k) => { set(factor, k, "input");
        return Object.assign(state(segment), {value: factor.getAttribute("aria-valuetext")}); }); })()''')
    low, high = ([[float(x) for x in s[k].split()] for s in told] for k in ('low', 'high'))
    assert abs(high[0][2] - 1e3 * run['fem']['length_m']) < 0.01 and abs(high[0][0] - 4) < 0.01, high
    once, twice = high[1][0] - high[0][0], high[2][0] - high[0][0]
    load = run['fem']['loads'][0]
    assert once > 0.5 and abs(twice - 2 * once) < 0.05 * once, (once, twice)
    assert 0.8 < once / (1e3 * load['tip_displacement_m'][0]) < 1.2, (once, load['tip_displacement_m'])
    assert told[0]['value'] == 'times 0' and told[1]['value'] == 'times 1', [t['value'] for t in told]


def marks(browser, run):
    """values over the section: materials, axes and centres"""
    told = browser.ask('Array.from(document.querySelectorAll("svg .over")).map((g) => g.getAttribute("aria-label") + "|" + g.tabIndex)')
    assert all(m.endswith('|0') for m in told)
    want = 'stiffness centre: (%.5f' % (1e3 * run['section']['stations'][0]['stiffness_centre_m'][0])
    assert any(m.replace('\u2212', '-').startswith(want) for m in told), told
    assert sum('E = ' in m for m in told) == 2


def keyboard(browser):
    """Tab comes to everything, what has it shows it and has a name; arrows move the slider and turn the view"""
    browser.ask('document.activeElement.blur()')
    met = []
    for _ in range(120):
        browser.press('Tab')
        met.append(browser.ask(FOCUS))
        if met[-1]['what'].startswith('DIV.stage') and not any(m['what'].startswith('DIV.stage') for m in met[:-1]):
            before = browser.seen('.stage')
            browser.press('ArrowLeft')
            browser.ask('new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))')
            assert browser.seen('.stage') != before, 'the arrows do not turn the view'
        if met[-1]['view'] and met[-1]['what'].endswith('#range') and not any(m['what'].endswith('#range') for m in met[:-1]):
            browser.press('End')
            before = browser.ask('document.querySelector("figure.view").dataset.end')
            browser.press('ArrowLeft')
            assert browser.ask('document.querySelector("figure.view").dataset.end') != before, 'the slider does not move the shape'
        if met[-1]['what'].startswith('BODY') and len(met) > 5:
            break
    kinds = {m['what'] for m in met}
    for wanted in ('DIV.stage#', 'INPUT.#range', 'INPUT.#checkbox', 'BUTTON.#button', 'SELECT.#select-one'):
        assert any(k.startswith(wanted) for k in kinds), (wanted, kinds)
    for m in met:
        assert m['what'].startswith('BODY') or m['ring'], ('nothing shows where one is', m)
        assert m['what'].startswith('BODY') or m['name'], ('no name', m)


def graphics_lost(browser):
    """taken away and given back"""
    browser.ask('''window.taken = document.querySelector(".stage canvas").getContext("webgl").getExtension("WEBGL_lose_context"),
        taken.loseContext()''')
    browser.until('document.querySelector("figure.view").dataset.state === "still"')
    assert browser.ask('getComputedStyle(document.querySelector("figure.view .still")).display') != 'none'
    browser.ask('taken.restoreContext()')
    browser.until('document.querySelector("figure.view").dataset.state === "live"')
    assert browser.ask('document.querySelector(".stage").clientHeight') > 100


def looks(browser):
    for scheme in ('light', 'dark'):
        browser.media(color_scheme=scheme)
        told = browser.ask(CONTRAST)
        assert told['number'] > 300 and told['low'] == [], (scheme, told)
    browser.media(color_scheme='light')
    browser.ask('document.querySelector("td").style.color = "#999"')
    assert browser.ask(CONTRAST)['low'], 'grey that is too light goes unnoticed'


def printed(browser, work):
    """paper has the drawn pictures and no view"""
    browser.media('print')
    assert browser.ask('document.querySelectorAll("figure.view").length') == 2
    assert browser.ask('Array.from(document.querySelectorAll("figure.view")).every((f) => getComputedStyle(f).display === "none")')
    assert browser.ask('Array.from(document.querySelectorAll("figure svg, figure img")).filter((p) => p.getClientRects().length).length') == 9
    browser.media()
    browser.print(os.path.join(work, 'page.pdf'))
    with open(os.path.join(work, 'page.pdf'), 'rb') as f:
        assert f.read(5) == b'%PDF-'


def with_graphics(page, run, work):
    with Browser(os.path.join(work, 'profile')) as browser:
        browser.size(1200, 900)
        browser.open(page)
        in_sight(browser)
        rods(browser, run)
        segment(browser, run)
        marks(browser, run)
        keyboard(browser)
        told_by_console(browser)
        graphics_lost(browser)
        printed(browser, work)
        looks(browser)
        browser.complaints.clear()  # graphics that go are told by the browser
        browser.size(360, 740, True)
        browser.open(page)
        in_sight(browser)
        assert browser.ask('document.documentElement.scrollWidth') <= 360, 'a phone would scroll it sideways'
        told_by_console(browser)


def without_graphics(page, work):
    with Browser(os.path.join(work, 'other'), webgl=False) as browser:
        browser.size(1200, 900)
        browser.open(page)
        in_sight(browser, 'still')
        assert browser.ask('getComputedStyle(document.querySelector("figure.view .still")).display') != 'none'
        assert browser.ask('document.querySelectorAll("canvas").length') == 0
        told_by_console(browser)


def main():
    page, work = sys.argv[1], sys.argv[3]
    with open(sys.argv[2], encoding='utf-8') as f:
        run = json.load(f)
    with_graphics(page, run, work)
    without_graphics(page, work)


main()

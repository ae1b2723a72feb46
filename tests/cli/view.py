"""A view of scopes whose names hold markup, in headless Chromium: view.py report.html DIRECTORY"""
import os
import sys

from chromium import Browser

DO = '''(() => {
    const choose = (select, value) => { select.value = value; select.dispatchEvent(new Event("change")); };
    const selects = document.querySelectorAll("figure.view select"), boxes = document.querySelectorAll("figure.view input[type=checkbox]");
    const told = () => document.querySelector("figure.view .words").textContent;
    const log = [told()];
    choose(selects[0], 1); choose(selects[1], 1); log.push(told());
    choose(selects[0], 0); log.push(told());
    boxes.forEach((box) => box.click());
    const stage = document.querySelector("figure.view .stage");
    ["ArrowLeft", "ArrowUp", "+", "-", "0"].forEach((key) => stage.dispatchEvent(new KeyboardEvent("keydown", {key: key, cancelable: true})));
    return log;
})()'''
STATE = 'document.querySelector("figure.view").dataset.state === "%s"'


def shown(browser, page, state):
    browser.size(1200, 900)
    browser.open(page)
    browser.ask('document.querySelector("figure.view").scrollIntoView()')
    browser.until(STATE % state)


def names_stay_text(browser):
    assert browser.ask('document.querySelectorAll("figure.view b, h1 script, h1 a, [onload]").length') == 0, 'a name became markup'
    assert browser.ask('document.querySelectorAll("a:not([href^=\'#\'])").length') == 0, 'a name became a link'
    assert browser.ask('document.title').startswith('"onload="'), browser.ask('document.title')
    assert '<script>' in browser.ask('document.querySelector("h1").textContent')


def main():
    page, work = sys.argv[1], sys.argv[2]
    with open(page, encoding='utf-8') as f:
        text = f.read()
    with Browser(os.path.join(work, 'profile')) as browser:
        shown(browser, page, 'live')
        assert browser.ask('document.querySelectorAll("figure.view canvas").length') == 1
        names_stay_text(browser)
        log = browser.ask(DO)
        for words, wanted in zip(log, ('long (constant curvature): 2 of 3 targets reached.', 'short (constant curvature): 0 of 3', 'Target 2: ')):
            assert wanted in words, (words, wanted)
        assert 'Target 2: ' in log[1] and 'reached' in log[2], log
        assert browser.complaints == [] and browser.requests == [], (browser.complaints, browser.requests)
        # a script, an image and a handler that are not the page's own: none runs, none is fetched, and it is told
        theirs = os.path.join(work, 'theirs.html')
        with open(theirs, 'w', encoding='utf-8') as f:
            f.write(text.replace('</body>', '<script>document.body.dataset.state = "theirs"</script>'
                                 '<img src="http://127.0.0.1:9/x.png" onerror="document.body.dataset.state = \'theirs\'"></body>'))
        shown(browser, theirs, 'live')
        assert browser.ask('document.body.dataset.state') is None, "the page's policy lets any script run"
        assert any('Content Security Policy' in c for c in browser.complaints), browser.complaints
    with Browser(os.path.join(work, 'other'), webgl=False) as browser:
        shown(browser, page, 'still')
        assert browser.complaints == [], browser.complaints


main()

#!/usr/bin/env python3
"""Makes the verification page: runs the programs of tests/verify, each leaving the numbers that it judges (tests/record.h), and
lays them out.  verification.py --build DIR --out DIR [--jobs N] [--again] [--long] [NAME...]; exit code 1 where a check does not hold."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import records
from verification_page import whole
from page_frame import ROOT, commit, versions

SLOWEST_S = {False: 900, True: 7200}


def run(program, build, record_dir, whole_campaigns):
    """one test, with its record; its output is kept for the page"""
    began = time.monotonic()
    environment = dict(os.environ, STIFFAXIS_VERIFICATION=str(record_dir), STIFFAXIS_SOURCE=str(ROOT))
    environment.pop('STIFFAXIS_LONG', None)
    if whole_campaigns:
        environment['STIFFAXIS_LONG'] = '1'
    try:
        done = subprocess.run([str(build / 'bin' / program.name)], cwd=build, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=SLOWEST_S[whole_campaigns], check=False)
        program.code, program.output = done.returncode, done.stdout.decode('utf-8', 'replace')
    except subprocess.TimeoutExpired:
        program.code, program.output = -1, f'stopped after {SLOWEST_S[whole_campaigns]} s'
    except OSError as mistake:
        program.code, program.output = -1, str(mistake)
    program.seconds = time.monotonic() - began


def programs_of(names):
    sources = sorted((ROOT / 'tests/verify').glob('*/verify_*.c'))
    known = {s.stem for s in sources}
    for name in names:
        if name not in known:
            sys.exit(f'verification.py: no test is called {name}')
    return [records.Program(s) for s in sources if not names or s.stem in names]


def record_of(program, record_dir):
    return record_dir / f'{program.room}.{program.name}.jsonl'


def run_all(programs, asked, record_dir):
    """anew, or as they last ran"""
    told = record_dir / 'runs.json'
    if asked.again:
        runs = json.loads(told.read_text(encoding='utf-8'))
        for p in programs:
            p.code, p.seconds, p.output, p.extent = (*runs.get(p.name, (None, 0.0, '')), '')[:4]
        return
    if not asked.names:  # those that were not asked for keep what they have
        shutil.rmtree(record_dir, ignore_errors=True)
    record_dir.mkdir(parents=True, exist_ok=True)
    for p in programs:
        record_of(p, record_dir).unlink(missing_ok=True)
    runs = json.loads(told.read_text(encoding='utf-8')) if told.exists() else {}
    for p in programs:
        p.extent = 'long' if asked.long else 'short'
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        list(pool.map(lambda p: run(p, asked.build.resolve(), record_dir, asked.long), programs))
    runs.update({p.name: (p.code, p.seconds, p.output, p.extent) for p in programs})
    told.write_text(json.dumps(runs), encoding='utf-8')


def main():
    reader = argparse.ArgumentParser(description=__doc__.split('  ')[0])
    reader.add_argument('--build', type=pathlib.Path, required=True, help='where the tests were built')
    reader.add_argument('--out', type=pathlib.Path, required=True, help='gets index.html and records/')
    reader.add_argument('--jobs', type=int, default=os.cpu_count() or 1)
    reader.add_argument('--again', action='store_true', help='from the records that are there, without running anything')
    reader.add_argument('--long', action='store_true', help='whole campaigns, of which the tests else run a short form')
    reader.add_argument('names', nargs='*', help='only these tests')
    asked = reader.parse_args()

    record_dir = asked.out.resolve() / 'records'
    programs = programs_of(asked.names)
    run_all(programs, asked, record_dir)
    for program in programs:
        path = record_of(program, record_dir)
        if path.exists():
            records.read(path, program)
    extents = {p.extent for p in programs if p.extent}
    extent = extents.pop() if len(extents) == 1 else 'mixed' if extents else ''
    laid_out = whole(programs, commit(), versions(asked.build / 'bin' / 'stiffaxis'), extent)
    (asked.out / 'index.html').write_text(laid_out, encoding='utf-8')

    wrong = [p for p in programs if p.failures() or p.trouble()]
    for program in wrong:
        print(f'{program.room}/{program.name}: {program.trouble() or f"{program.failures()} checks do not hold"}')
    checks, conditions = sum(p.checks() for p in programs), sum(p.conditions() for p in programs)
    print(f'{checks - conditions} numbers and {conditions} conditions in {len(programs)} programs, '
          f'{sum(p.failures() for p in programs)} do not hold; {asked.out / "index.html"}')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())

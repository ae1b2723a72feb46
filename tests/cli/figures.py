"""The figures in DIR... as a journal would take them: figures.py DIR...

Of every SVG there is the same as PDF and PNG; the PDF's page is as large as the SVG says and fits a journal's two columns; its
letters are of one family, within the file, at least 7 pt high and on the sheet; nothing tells when it was written; what stands at an
axis has its unit, one and the same for a quantity everywhere. The PDF is read as cairo writes it: a line per fault, exit code 1.
"""

import glob
import os
import re
import sys
import zlib

WIDEST_MM = 180.0  # both columns
LEAST_PT = 7.0
POINT_MM = 25.4 / 72
FAMILY = "DejaVuSans"
UNITS = {"mm", "mm²", "N", "N mm", "N mm²", "MPa", "1/m", "%", "°", "rad", "J", "kg/m", "m/s²", "s", "ms", "targets",
         "% of the wall"}
# axes of plain numbers
PLAIN = re.compile(r"log₁₀ of the miss|eigenvalue \(1: at rest\)|factor of .*|strain over limit|evaluations of the island|relative error.*|unknowns.*|friction")

faults = []


def fault(path, words):
    faults.append(f"{path}: {words}")


def objects(data):
    """number -> (dictionary, stream or None)"""
    found = {}
    for m in re.finditer(rb"(?:^|\n)(\d+) 0 obj\s", data):
        end = data.index(b"\nendobj", m.end())
        body = data[m.end():end]
        head, _, stream = body.partition(b"stream\n")
        if stream and b"/FlateDecode" in head:
            stream = zlib.decompressobj().decompress(stream)
        found[int(m[1])] = (head.decode("latin1"), stream)
    return found


def letters(found):
    """font's name in the content -> (its own name, whether it lies within, code length in bytes, code -> letter)"""
    fonts = {}
    for head, _ in found.values():
        for name, number in re.findall(r"/(f-\d+-\d+) (\d+) 0 R", head):
            font = found[int(number)][0]
            kin = re.search(r"/DescendantFonts \[ (\d+) 0 R", font)
            descriptor = found[int(re.search(r"/FontDescriptor (\d+)", found[int(kin[1])][0] if kin else font)[1])][0]
            table = {}
            words = found[int(re.search(r"/ToUnicode (\d+)", font)[1])][1].decode("latin1")
            for code, letter in re.findall(r"^<(\w+)> <(\w{4,})>$", words, re.M):
                table[int(code, 16)] = bytes.fromhex(letter).decode("utf-16-be")
            fonts[name] = (re.search(r"/FontName /\S+\+(\S+)", descriptor)[1], "/FontFile" in descriptor, 2 if kin else 1, table)
    return fonts


TOKEN = re.compile(rb"\((?:\\.|[^\\)])*\)|<[0-9a-fA-F]*>|/[\w.-]+|-?[\d.]+|[A-Za-z*]+|\[|\]", re.S)
ESCAPE = re.compile(rb"\\([0-7]{3}|.)", re.S)


def plain(token):
    if token[:1] == b"<":
        return bytes.fromhex(token[1:-1].decode())
    return ESCAPE.sub(lambda m: bytes([int(m[1], 8)]) if len(m[1]) == 3 else m[1], token[1:-1])


def texts(content, fonts):
    """[words, height in points, x, y, whether it is turned] of every piece of text"""
    for block in re.findall(rb"BT\n(.*?)\nET\n", content, re.S):
        numbers, strings, piece, font = [], [], None, None
        for token in TOKEN.findall(block):
            if token[:1] in b"(<":
                strings.append(plain(token))
            elif re.fullmatch(rb"-?[\d.]+", token):
                numbers.append(float(token))
            elif token[:1] == b"/":
                font = fonts[token[1:].decode()]
            elif token == b"Tm":
                if piece:
                    yield piece
                a, b, c, d, x, y = numbers[-6:]
                piece = ["", (c * c + d * d) ** 0.5, x, y, abs(b) > abs(a)]
            elif token in (b"Tj", b"TJ"):
                for s in strings:
                    codes = [int.from_bytes(s[i:i + font[2]], "big") for i in range(0, len(s), font[2])]
                    piece[0] += "".join(font[3].get(k, "?") for k in codes)
            elif token == b"Td" and abs(numbers[-1]) > 1e-6:
                yield piece
                piece = ["", *piece[1:]]
            if token.isalpha():
                numbers, strings = [], []
        if piece:
            yield piece


def size_of(svg):
    tag = re.search(r"<svg[^>]*>", open(svg, encoding="utf-8").read(4096))[0]
    size = [re.search(rf' {side}="([\d.]+)mm"', tag) for side in ("width", "height")]
    return [float(m[1]) for m in size] if all(size) else None


def check_page(pdf, data, size):
    box = [float(x) for x in re.search(rb"/MediaBox \[ ([^]]*)\]", data)[1].split()]
    for points, mm in zip(box[2:], size):
        if abs(points * POINT_MM - mm) > 0.01:
            fault(pdf, f"{points} pt where the SVG says {mm} mm")
    if size[0] > WIDEST_MM + 1e-6:
        fault(pdf, f"{size[0]} mm wide")
    if b"CreationDate" in data or b"ModDate" in data:
        fault(pdf, "tells when it was written")
    return box


def check_texts(pdf, pieces, box, units):
    axes = 0
    for words, height, x, y, turned in pieces:
        if height < LEAST_PT - 1e-3:
            fault(pdf, f"{height:.2f} pt: {words}")
        if not (0 <= x <= box[2] and 0 <= y <= box[3]):
            fault(pdf, f"off the sheet: {words}")
        if re.search(r"\[(mm|N|MPa|1/m|rad|%)\]|\bdeg\b|µm|\bN·", words):
            fault(pdf, f"a unit written in another way: {words}")
        quantity, _, unit = words.rpartition(", ")
        if turned and unit not in UNITS and not PLAIN.fullmatch(words):
            fault(pdf, f"an axis without a unit: {words}")
        if quantity and unit in UNITS and (turned or len(words) < 48):
            axes += 1
            units.setdefault(quantity, {}).setdefault(unit, pdf)
    return axes


def check_figure(svg, units):
    stem = svg[:-4]
    for other in (".pdf", ".png"):
        if not os.path.exists(stem + other):
            return fault(stem + other, "is missing")
    size = size_of(svg)
    if not size:
        return fault(svg, "has no size in mm")
    data = open(stem + ".pdf", "rb").read()
    box = check_page(stem + ".pdf", data, size)
    found = objects(data)
    fonts = letters(found)
    for name, within, _, _ in fonts.values():
        if not within:
            fault(stem + ".pdf", f"the letters of {name} are not within")
        if name.split("-")[0] != FAMILY:
            fault(stem + ".pdf", f"letters of {name}")
    pieces = [p for _, stream in found.values() if b"BT" in stream for p in texts(stream, fonts)]
    if not pieces:
        fault(stem + ".pdf", "has no text")
    return check_texts(stem + ".pdf", pieces, box, units)


def main():
    units = {}
    for folder in sys.argv[1:]:
        figures = sorted(glob.glob(os.path.join(folder, "*.svg")))
        if not figures:
            fault(folder, "holds no figures")
        for svg in figures:
            check_figure(svg, units)
    for quantity, told in units.items():
        if len(told) > 1:
            faults.append(f"{quantity}: in {' and '.join(f'{u} ({p})' for u, p in told.items())}")
    if os.environ.get("TOLD"):
        print(*(f"{q}: {', '.join(u)}" for q, u in units.items()), sep="\n")
    print(*faults, sep="\n", end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

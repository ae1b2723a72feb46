"""Pictures of the pages, as the program draws them now: pictures.py [--update] DRAWN.png SHOWN.png TIMES

A picture on a page is what the program has drawn, TIMES times smaller, so that pages stay light. Whether it still is, tell
squares of 8 by 8 pixels: a square's mean may differ by how letters and edges are smoothed, while a digit that has changed shows. Exit code 1 where it differs; --update makes SHOWN anew.
"""
import struct
import sys
import zlib

SQUARE = 8
# of 255, a square's mean: the same libraries draw the same; another small grey letter is 4 off, another digit 29
APART = 3.0


def chunks(data):
    at = 8
    while at < len(data):
        length, = struct.unpack('>I', data[at:at + 4])
        yield data[at + 4:at + 8], data[at + 8:at + 8 + length]
        at += 12 + length


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def unfilter(kind, line, above, step):
    """in place, PNG specification 9.2"""
    if kind == 1:
        for c in range(step):
            left = 0
            for k in range(c, len(line), step):
                left = line[k] = line[k] + left & 255
    elif kind == 2:
        line[:] = bytes(x + y & 255 for x, y in zip(line, above))
    elif kind == 3:
        for k in range(len(line)):
            line[k] = line[k] + ((line[k - step] if k >= step else 0) + above[k] >> 1) & 255
    elif kind == 4:
        for k in range(len(line)):
            line[k] = line[k] + (paeth(line[k - step], above[k], above[k - step]) if k >= step else above[k]) & 255


def read(path):
    """width, height and rows of RGB; of 8 bits, without interlacing"""
    with open(path, 'rb') as file:
        data = file.read()
    header, packed = None, b''
    for name, body in chunks(data):
        if name == b'IHDR':
            header = struct.unpack('>IIBBBBB', body)
        elif name == b'IDAT':
            packed += body
    width, height, depth, colours, _, _, laced = header
    step = {2: 3, 6: 4}.get(colours)
    if depth != 8 or laced or not step:
        sys.exit(f'{path}: not RGB of 8 bits, or interlaced')
    raw = zlib.decompress(packed)
    rows, above = [], bytes(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        line = bytearray(raw[start + 1:start + 1 + width * step])
        unfilter(raw[start], line, above, step)
        above = line
        if step == 4:
            line = bytes(x for k in range(0, len(line), 4) for x in line[k:k + 3])
        rows.append(line)
    return width, height, rows


def smaller(picture, times):
    """means of TIMES by TIMES pixels"""
    width, height, rows = picture
    across, area = width // times, times * times
    out = []
    for y in range(height // times):
        line = bytearray(across * 3)
        block = rows[y * times:(y + 1) * times]
        for c in range(3):
            sums = [0] * across
            for row in block:
                channel = row[c::3]
                for shift in range(times):
                    sums = [s + x for s, x in zip(sums, channel[shift:across * times:times])]
            line[c::3] = bytes((s + area // 2) // area for s in sums)
        out.append(line)
    return across, height // times, out


def squares(picture):
    """sums over squares, one list a row of them, three numbers each"""
    width, height, rows = picture
    means = []
    for y in range(0, height - SQUARE + 1, SQUARE):
        total = [sum(column) for column in zip(*rows[y:y + SQUARE])]
        means.append([sum(total[3 * x + c:3 * (x + SQUARE) + c:3]) / SQUARE ** 2
                      for x in range(0, width - SQUARE + 1, SQUARE) for c in range(3)])
    return means


def apart(one, other):
    """the largest difference of two squares, and where it is"""
    per_row = one[0] // SQUARE
    found = (0.0, 0, 0)
    for y, (a, b) in enumerate(zip(squares(one), squares(other))):
        worst, k = max((abs(p - q), k) for k, (p, q) in enumerate(zip(a, b)))
        found = max(found, (worst, k // 3 % per_row * SQUARE, y * SQUARE))
    return found


def filtered(rows):
    """each row by that filter whose numbers are the least, as the specification advises"""
    above = bytes(len(rows[0]))
    for row in rows:
        left = bytes(3) + row[:-3]
        tries = [(0, row), (1, bytes(x - a & 255 for x, a in zip(row, left))), (2, bytes(x - b & 255 for x, b in zip(row, above))),
                 (4, bytes(x - paeth(a, b, c) & 255 for x, a, b, c in zip(row, left, above, bytes(3) + above[:-3])))]
        kind, line = min(tries, key=lambda one: sum(min(x, 256 - x) for x in one[1]))
        yield bytes([kind]) + line
        above = row


def write(path, picture):
    width, height, rows = picture
    parts = ((b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)),
             (b'IDAT', zlib.compress(b''.join(filtered([bytes(row) for row in rows])), 9)), (b'IEND', b''))
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n')
        for name, data in parts:
            file.write(struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data)))


def main():
    update = '--update' in sys.argv
    drawn, shown, times = [word for word in sys.argv[1:] if word != '--update']
    small = smaller(read(drawn), int(times))
    if update:
        write(shown, small)
    there = read(shown)
    if there[:2] != small[:2]:
        sys.exit(f'{shown}: {there[0]} x {there[1]} pixels, drawn now {small[0]} x {small[1]}')
    difference, x, y = apart(small, there)
    print(f'{shown}: at most {difference:.1f} of 255 from what is drawn now, at {x}, {y}')
    sys.exit(difference > APART)


if __name__ == '__main__':
    main()

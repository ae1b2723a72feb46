#!/usr/bin/env python3
"""Draws the helical prototype of the paper as 24 slices of 5 mm, 100 x 100 pixels of 84 um.

The stiff strip (green) turns by 180 deg along the tube (red) and gets narrower. Each slice shows
the section at its middle. Nothing but Python's own library is needed.
"""
import math
import os
import struct
import zlib

SLICES, PIXELS, PITCH, LENGTH = 24, 100, 0.084, 120.0  # the last two in mm
OUTER, INNER = 4.0, 3.2
NOTHING, SOFT, STIFF = 0, 1, 2
COLOURS = bytes([0, 0, 0, 255, 0, 0, 0, 255, 0])


def material(x, y, s):
    radius, angle = math.hypot(x, y), math.atan2(y, x)
    if not INNER <= radius <= OUTER:
        return NOTHING
    width = math.pi / 4 - math.pi / 8 * s / LENGTH
    off = abs(math.remainder(angle - math.pi * s / LENGTH, 2 * math.pi))
    return STIFF if off < width / 2 else SOFT


def chunk(name, data):
    return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))


def image(s):
    def place(k):
        return (k + 0.5 - PIXELS / 2) * PITCH

    rows = b''.join(b'\0' + bytes(material(place(i), -place(j), s) for i in range(PIXELS))
                    for j in range(PIXELS))
    head = struct.pack('>IIBBBBB', PIXELS, PIXELS, 8, 3, 0, 0, 0)
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'PLTE', COLOURS)
            + chunk(b'tRNS', b'\0') + chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b''))


if __name__ == '__main__':
    folder = os.path.dirname(os.path.abspath(__file__))
    for k in range(SLICES):
        with open(os.path.join(folder, f'slice_{k:02d}.png'), 'wb') as file:
            file.write(image((k + 0.5) * LENGTH / SLICES))

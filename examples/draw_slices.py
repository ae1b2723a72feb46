#!/usr/bin/env python3
"""Draws the print slices of a robot: one PNG per layer, one colour per material. Nothing but Python's own library is needed.

    python3 examples/draw_slices.py DIR

What is drawn is `material`: change it. Here: a soft tube with a stiff strip that changes sides half way, so that one tendon in the
middle bends it into an S.
"""
import math
import os
import struct
import sys
import zlib

LENGTH, LAYER = 120.0, 5.0  # mm, of the robot and of a slice
PIXELS, PITCH = 90, 0.1     # across an image; mm
COLOURS = {'nothing': (0, 0, 0, 0), 'soft': (255, 0, 0, 255), 'stiff': (0, 255, 0, 255)}  # red, green, blue, opacity


def material(x, y, s):
    """of the place x, y in the section and s along the robot, in mm"""
    radius, angle = math.hypot(x, y), math.atan2(y, x)
    if not 2.4 <= radius <= 4:
        return 'nothing'
    side = math.pi if s < LENGTH / 2 else 0
    off = abs(math.remainder(angle - side, 2 * math.pi))
    return 'stiff' if off < math.pi / 8 else 'soft'


def chunk(name, data):
    return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))


def image(s):
    """the slice at s as a PNG: x to the right, y up, the middle of the image is the origin"""
    def place(k):
        return (k + 0.5 - PIXELS / 2) * PITCH

    rows = b''.join(b'\0' + b''.join(bytes(COLOURS[material(place(i), -place(j), s)]) for i in range(PIXELS))
                    for j in range(PIXELS))
    head = struct.pack('>IIBBBBB', PIXELS, PIXELS, 8, 6, 0, 0, 0)
    return b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b'')


if __name__ == '__main__':
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    count = round(LENGTH / LAYER)
    for k in range(count):
        with open(os.path.join(folder, f'slice_{k:03d}.png'), 'wb') as file:
            file.write(image((k + 0.5) * LAYER))
    print(f'{count} slices of {LAYER:g} mm, {PIXELS} x {PIXELS} pixels of {PITCH:g} mm')

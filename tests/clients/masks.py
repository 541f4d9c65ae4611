"""Silhouettes: which pixels of a picture show the model, and how far two of them agree."""
import struct
import zlib


def channel_of(png, number):
    """(width, bytes) of one channel of the bytes of a PNG of 8 bits, its rows from the top."""
    if png[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("no PNG")
    at, packed = 8, b""
    while at < len(png):
        size, kind = struct.unpack_from(">I4s", png, at)
        data = png[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", data)
        elif kind == b"IDAT":
            packed += data
        at += 12 + size
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[color]
    if depth != 8 or interlaced:
        raise ValueError("a PNG of another kind")
    raw, rows = zlib.decompress(packed), bytearray()
    above = bytes(width)
    stride = width * channels + 1
    for row in range(height):
        line = raw[row * stride:(row + 1) * stride]
        # A filter looks only at bytes of the same channel.
        above = unfiltered(line[0], line[1 + number::channels], above)
        rows += above
    return width, bytes(rows)


def unfiltered(kind, line, above):
    """A row of one channel, PNG (ISO/IEC 15948) §9.2."""
    if kind == 0:
        return line
    if kind == 2:
        return bytes((a + b) & 255 for a, b in zip(line, above))
    row, left, corner = bytearray(), 0, 0
    for value, up in zip(line, above):
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + up) >> 1
        else:
            a, b, c = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
            guess = left if a <= b and a <= c else up if b <= c else corner
        left, corner = (value + guess) & 255, up
        row.append(left)
    return bytes(row)


def mask(values, shows):
    """A number with a bit for every pixel, 1 where `shows(value)`."""
    table = bytes(ord("1") if shows(value) else ord("0") for value in range(256))
    return int(values.translate(table), 2)


def agreement(one, other):
    """Intersection over union."""
    return (one & other).bit_count() / max(1, (one | other).bit_count())

"""Reads PNG files of 8 bits a channel, not interlaced, as citykiln writes them."""
import struct
import zlib


def predicted(kind, left, up, up_left):
    """The value that a filter (PNG specification, section 9) predicts from three neighbours."""
    if kind < 4:
        return (0, left, up, (left + up) // 2)[kind]
    estimate = left + up - up_left
    return min((left, up, up_left), key=lambda value: abs(estimate - value))


def pixels(path):
    """Width, height and the bytes of all pixels, row by row, and the number of channels."""
    data, at, packed = path.read_bytes(), 8, b""
    assert data.startswith(b"\x89PNG"), path
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, colour = struct.unpack(">IIBB", body[:10])
            channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
            assert bits == 8, path
        packed += body if kind == b"IDAT" else b""
        at += length + 12
    raw, row_bytes, rows = zlib.decompress(packed), width * channels, []
    above = bytes(row_bytes)
    for y in range(height):
        start = y * (row_bytes + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + row_bytes])
        for i in range(row_bytes):
            left, up_left = (row[i - channels], above[i - channels]) if i >= channels else (0, 0)
            row[i] = (row[i] + predicted(kind, left, above[i], up_left)) & 255
        rows.append(row)
        above = row
    return width, height, channels, b"".join(rows)


def mean_difference(a, b):
    """The mean difference of all channels of all pixels of two pictures of equal size, 0 to 1."""
    one, other = pixels(a), pixels(b)
    assert one[:3] == other[:3], (a, b)
    return sum(abs(x - y) for x, y in zip(one[3], other[3], strict=True)) / len(one[3]) / 255

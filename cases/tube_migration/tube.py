"""A round tube in section: share of pore in each pixel. python3 tube.py DIAMETER SIDE FILE (pixels)"""
import struct, sys, zlib
d, n, name = float(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
sub = 32
def share(i, j):
    inside = sum((i + (a + .5) / sub - n / 2) ** 2 + (j + (b + .5) / sub - n / 2) ** 2 < d * d / 4
                 for a in range(sub) for b in range(sub))
    return round(255 * inside / sub ** 2)
rows = b"".join(b"\0" + bytes(share(i, j) for i in range(n)) for j in range(n))
def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
open(name, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", n, n, 8, 0, 0, 0, 0))
                       + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))

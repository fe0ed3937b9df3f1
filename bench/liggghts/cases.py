# SPDX-License-Identifier: MPL-2.0
"""The spheres and the pore that both programs are given. All lengths in metres."""
import numpy as np

DIAMETER, DENSITY = 5e-6, 1050.0

INPUT = """atom_style granular
atom_modify map array
boundary {boundary}
newton off
communicate single vel yes
units si
read_data {data}
neighbor 0.5e-6 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 2.0e-8
{extra}
fix i all nve/sphere
thermo 1000000
thermo_style custom step atoms ke cpu
thermo_modify lost error norm no
run {warm}
run {steps}
"""


def write_data(name, low, high, position, seed):
    """LIGGGHTS data file: box, spheres, velocities of 5 mm/s root mean square per component."""
    velocity = np.random.default_rng(seed + 1).normal(0, 5e-3, position.shape)
    with open(name, "w") as out:
        out.write(f"LIGGGHTS data\n\n{len(position)} atoms\n1 atom types\n\n")
        for axis, a, b in zip("xyz", low, high):
            out.write(f"{a:.9g} {b:.9g} {axis}lo {axis}hi\n")
        out.write("\nAtoms\n\n")
        for i, p in enumerate(position, 1):
            out.write(f"{i} 1 {DIAMETER} {DENSITY} {p[0]:.9g} {p[1]:.9g} {p[2]:.9g}\n")
        out.write("\nVelocities\n\n")
        for i, v in enumerate(velocity, 1):
            out.write(f"{i} {v[0]:.6g} {v[1]:.6g} {v[2]:.6g} 0 0 0\n")


def box(name, count, fraction, seed=1):
    """Spheres on a jittered lattice that fills a cube to a volume fraction; returns its side."""
    rng = np.random.default_rng(seed)
    side = (count * np.pi / 6 * DIAMETER**3 / fraction) ** (1 / 3)
    n = int(np.ceil(count ** (1 / 3)))
    a = side / n
    ijk = np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), -1).reshape(-1, 3)
    jitter = max(0.0, (a - DIAMETER) / 2 * 0.9)
    where = (ijk[rng.permutation(len(ijk))[:count]] + 0.5) * a
    write_data(name, [0] * 3, [side] * 3, where + rng.uniform(-jitter, jitter, where.shape), seed)
    return side


def pore_picture(nx=800, ny=600, seed=3):
    """Irregular grains (perturbed discs on a shaken lattice), True = grain, 1 um a pixel."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(nx) + 0.5, np.arange(ny) + 0.5)
    grain = np.zeros((ny, nx), bool)
    for row, cy in enumerate(np.arange(50, ny, 100)):
        for cx in np.arange(70 + 55 * (row % 2), nx - 50, 110):
            dx, dy = x - cx - rng.uniform(-8, 8), y - cy - rng.uniform(-8, 8)
            angle, radius = np.arctan2(dy, dx), rng.uniform(30, 38)
            for wave, size in ((2, 0.1), (3, 0.05), (4, 0.05)):
                radius = radius * (1 + size * rng.random() * np.cos(wave * angle + 6.3 * rng.random()))
            grain |= np.hypot(dx, dy) < radius
    return grain


def write_stl(name, grain):
    """Side walls of the extruded grains from the level set of the blurred picture at 2 um."""
    from scipy import ndimage
    pixel, pad, level = 2e-6, 6, 0.5
    field = np.pad(ndimage.zoom(grain.astype(float), 0.5, order=1), pad, mode="edge")
    field = ndimage.gaussian_filter(field, 1.0)
    triangles = 0
    with open(name, "w") as out:
        out.write("solid grains\n")
        for j in range(field.shape[0] - 1):
            for i in range(field.shape[1] - 1):
                corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                value = [field[c[1], c[0]] for c in corners]
                cuts = []
                for e in range(4):
                    a, b = value[e], value[(e + 1) % 4]
                    if (a > level) != (b > level):
                        t, p, q = (level - a) / (b - a), corners[e], corners[(e + 1) % 4]
                        cuts.append(tuple((p[k] + t * (q[k] - p[k]) - pad + 0.5) * pixel for k in (0, 1)))
                for p, q in zip(cuts[::2], cuts[1::2]):
                    if np.hypot(p[0] - q[0], p[1] - q[1]) < 2e-7:
                        continue
                    low, high = -1e-6, 1.7e-5
                    for corner in (((*p, low), (*q, low), (*q, high)), ((*p, low), (*q, high), (*p, high))):
                        triangles += 1
                        out.write(" facet normal 0 0 0\n  outer loop\n")
                        out.writelines("   vertex %.9g %.9g %.9g\n" % c for c in corner)
                        out.write("  endloop\n endfacet\n")
        out.write("endsolid grains\n")
    return triangles


def pore(folder, count, seed=3):
    """Spheres in the open part of the picture; pore.data, pore.pgm, pore.stl."""
    from scipy import ndimage
    grain = pore_picture()
    far = ndimage.distance_transform_edt(~grain)
    ny, nx = grain.shape
    sites = [(x, y, z) for x in np.arange(4, nx - 4, 5.3) for y in np.arange(4, ny - 4, 5.3)
             for z in (2.7, 8.0, 13.3) if far[int(y), int(x)] > 4]
    where = np.array(sites)[np.random.default_rng(seed).permutation(len(sites))[:count]] * 1e-6
    write_data(f"{folder}/pore.data", [-15e-6, -15e-6, -4e-6], [8.15e-4, 6.15e-4, 2e-5], where, seed)
    with open(f"{folder}/pore.pgm", "wb") as out:
        out.write(b"P5\n%d %d\n255\n" % (nx, ny) + (grain * 255).astype(np.uint8).tobytes())
    return write_stl(f"{folder}/pore.stl", grain)

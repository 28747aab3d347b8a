"""Sample meshes for the reference numbers: positions (n, 3) in double precision, faces as index triples."""

import numpy as np
from scipy.spatial import Delaunay


def icosahedron():
    """Regular icosahedron with circumradius 1."""
    g = (1 + 5**0.5) / 2
    points = [(s, t * g, 0) for s in (1, -1) for t in (1, -1)]
    points = np.array([p[k:] + p[:k] for k in range(3) for p in points], float)
    points /= np.hypot(1, g)
    edge = 2 / np.hypot(1, g)
    near = np.abs(np.linalg.norm(points[:, None] - points[None], axis=2) - edge) < 1e-9
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b) if near[a, b] and near[b, c] and near[c, a]]
    return points, outward(points, faces)


def octahedron():
    points = np.vstack([np.eye(3), -np.eye(3)])
    faces = [(a, b, c) for a in (0, 3) for b in (1, 4) for c in (2, 5)]
    return points, outward(points, faces)


def tetrahedron():
    points = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / 3**0.5
    return points, outward(points, [(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)])


def outward(points, faces):
    """Faces of a convex body about the origin, turned to look outwards."""
    return [f if np.linalg.det(points[list(f)]) > 0 else (f[0], f[2], f[1]) for f in faces]


def subdivide(points, faces):
    """Each triangle into four by its edge midpoints; no smoothing."""
    points, middle = [np.asarray(p) for p in points], {}

    def mid(a, b):
        key = (min(a, b), max(a, b))
        if key not in middle:
            middle[key] = len(points)
            points.append((points[a] + points[b]) / 2)
        return middle[key]

    out = []
    for a, b, c in faces:
        ab, bc, ca = mid(a, b), mid(b, c), mid(c, a)
        out += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    return np.array(points), out


def linear_subdivision(solid, levels):
    points, faces = solid
    for _ in range(levels):
        points, faces = subdivide(points, faces)
    return points, faces


def icosphere(levels, noise, seed):
    points, faces = linear_subdivision(icosahedron(), levels)
    points /= np.linalg.norm(points, axis=1)[:, None]
    return points + noise * np.random.default_rng(seed).standard_normal(points.shape), faces


def grid(rows, columns, point, seed, noise, wrap_rows=False, twist=False):
    """Grid of quads, closed along its columns, each cut by a random diagonal.

    `twist` glues the last column to the first upside down: Möbius strip, or Klein bottle with `wrap_rows`.
    """
    random = np.random.default_rng(seed)
    points = np.array([point(r, c) for c in range(columns) for r in range(rows)])
    points += noise * random.standard_normal(points.shape)

    def at(r, c):
        if wrap_rows:
            r %= rows
        if c == columns:
            c, r = 0, ((-r) % rows if wrap_rows else rows - 1 - r) if twist else r
        return c * rows + r

    faces = []
    for c in range(columns):
        for r in range(rows if wrap_rows else rows - 1):
            p, q, s, t = at(r, c), at(r + 1, c), at(r + 1, c + 1), at(r, c + 1)
            faces += [(p, q, s), (p, s, t)] if random.random() < 0.5 else [(p, q, t), (q, s, t)]
    return points, faces


def bumpy_torus(seed=2):
    def point(r, c):
        u, v = 2 * np.pi * c / 15, 2 * np.pi * r / 10
        tube = 0.4 * (1 + 0.1 * np.sin(3 * u + v))
        return ((1 + tube * np.cos(v)) * np.cos(u), (1 + tube * np.cos(v)) * np.sin(u), tube * np.sin(v))

    return grid(10, 15, point, seed, 0.015, wrap_rows=True)


def mobius_strip(seed=5):
    def point(r, c):
        u, w = 2 * np.pi * c / 24, 0.12 * (r - 2)
        return ((1 + w * np.cos(u / 2)) * np.cos(u), (1 + w * np.cos(u / 2)) * np.sin(u), w * np.sin(u / 2))

    return grid(5, 24, point, seed, 0.01, twist=True)


def klein_bottle(seed=6):
    """Figure-8 immersion."""

    def point(r, c):
        u, v = 2 * np.pi * c / 18, 2 * np.pi * r / 9
        x = 0.5 * (np.cos(u / 2) * np.sin(v) - np.sin(u / 2) * np.sin(2 * v))
        z = 0.5 * (np.sin(u / 2) * np.sin(v) + np.cos(u / 2) * np.sin(2 * v))
        return ((1 + x) * np.cos(u), (1 + x) * np.sin(u), z)

    return grid(9, 18, point, seed, 0.01, wrap_rows=True, twist=True)


def annulus(seed=4):
    def point(r, c):
        u, s = 2 * np.pi * c / 22, 0.5 + 0.14 * r
        return (s * np.cos(u), s * np.sin(u), 0.12 * np.cos(2 * u) + 0.3 * s * s)

    return grid(6, 22, point, seed, 0.012)


def disc(seed=3):
    """Delaunay triangulation of well-spaced random points in the unit disc, lifted to a saddle, with noise."""
    random = np.random.default_rng(seed)
    u = 2 * np.pi * np.arange(34) / 34
    plane = [np.array([np.cos(t), np.sin(t)]) for t in u]
    while len(plane) < 122:
        trials = random.uniform(-0.93, 0.93, (60, 2))
        trials = trials[np.hypot(*trials.T) < 0.93]
        gaps = [min(np.hypot(*(p - q)) for q in plane) for p in trials]
        plane.append(trials[int(np.argmax(gaps))])
    plane = np.array(plane)
    height = 0.35 * plane[:, 0] ** 2 - 0.25 * plane[:, 1] ** 2 + 0.1 * plane[:, 0]
    points = np.column_stack([plane, height]) + 0.012 * random.standard_normal((len(plane), 3))
    faces = Delaunay(plane).simplices
    faces = [tuple(int(v) for v in f) for f in faces]
    det = lambda f: np.linalg.det(np.column_stack([plane[list(f)], np.ones(3)]))
    return points, [f if det(f) > 0 else (f[0], f[2], f[1]) for f in faces]

"""Reference numbers for the circle-angle Willmore energy (Bobenko & Schröder 2005). See README.md.

Every quantity is found by a route that differs from the printed closed formulas:
the angles by inversion at a vertex, the gradient by central differences of them,
the matrix K as a Laplacian whose weights are derivatives by squared distances.
Boundary loops are closed by a vertex at infinity that takes part as a point.
The functions run in double precision or, on arrays of mpmath numbers, in 50 digits.
"""

import mpmath as mp
import numpy as np

mp.mp.dps = 50
_sqrt, _atan2 = np.frompyfunc(mp.sqrt, 1, 1), np.frompyfunc(mp.atan2, 2, 1)


def sqrt(x):
    return _sqrt(x) if x.dtype == object else np.sqrt(x)


def atan2(y, x):
    return _atan2(y, x) if x.dtype == object else np.arctan2(y, x)


def exact(x):
    """Doubles as 50-digit numbers of the same value."""
    return np.vectorize(mp.mpf, otypes=[object])(np.asarray(x, float))


def number(x, like):
    return mp.mpf(x) if like.dtype == object else float(x)


def pi(like):
    return mp.pi() if like.dtype == object else np.pi


def norm2(x):
    return (x * x).sum(-1)


class Surface:
    """Connectivity, the diamonds of its energy with their weights, and the held vertices.

    boundary: "closed", "free", "fixed" (both: closed by one vertex at infinity a loop)
    or "clamped" (interior edges only, each weighing its number of interior ends).
    """

    def __init__(self, n, faces, boundary="closed", fixed=()):
        self.n, self.faces, self.boundary = n, [tuple(f) for f in faces], boundary
        sides = edge_sides(self.faces)
        self.edges = np.array(list(sides))
        self.loops = boundary_loops([e for e, o in sides.items() if len(o) == 1])
        rim = {v for loop in self.loops for v in loop}
        self.rim = np.array([v in rim for v in range(n)])
        ring = rim | {v for e in sides for v in e if rim & set(e)}
        held = set(fixed) | {"fixed": rim, "clamped": ring}.get(boundary, set())
        self.held = sorted(held)
        self.free = np.array([v for v in range(n) if v not in held])

        if boundary == "clamped":
            inner = {e: o for e, o in sides.items() if len(o) == 2}
            self.weight = np.array([sum(v not in rim for v in e) for e in inner])
            sides, self.total = inner, n + 1
        else:
            caps = [(a, b, n + k) for k, loop in enumerate(self.loops) for a, b in zip(loop, loop[1:] + loop[:1])]
            sides = edge_sides(self.faces + caps)
            self.total = n + len(self.loops)
            self.weight = np.full(len(sides), 2)
        # Corners i, j, k, l of each diamond; an infinite end goes second, so that i is always finite.
        self.corners = np.array([sorted(e) + o for e, o in sides.items()])
        self.infinite = self.corners >= n
        assert not self.infinite[:, 0].any()

    def take(self, x):
        """Corner positions (m, 4, 3); at infinity stands a finite point that is never used, one unit from corner i."""
        finite = x[np.where(self.infinite, 0, self.corners)]
        return np.where(self.infinite[..., None], finite[:, :1] + number(1, x), finite)

    def vertex_count(self):
        return self.n - int(self.rim.sum()) if self.boundary == "clamped" else self.total


def edge_sides(faces):
    """Edge -> opposite corners of its faces."""
    sides = {}
    for f in faces:
        for a, b, c in (f, f[1:] + f[:1], f[2:] + f[:2]):
            sides.setdefault((min(a, b), max(a, b)), []).append(c)
    assert all(len(o) <= 2 for o in sides.values())
    return sides


def boundary_loops(edges):
    """Closed walks through the boundary edges. No orientation is needed."""
    near = {}
    for a, b in edges:
        near.setdefault(a, []).append(b)
        near.setdefault(b, []).append(a)
    assert all(len(v) == 2 for v in near.values())
    loops, seen = [], set()
    for start in sorted(near):
        if start not in seen:
            loop = [start]
            while (step := [v for v in near[loop[-1]] if v not in loop[-2:]]) and step[0] != start or len(loop) < 3:
                loop.append(step[0])
            loops.append(loop)
            seen.update(loop)
    return loops


# Angles, energy, gradient, matrix ------------------------------------------------


def angles(corners, infinite):
    """beta of each diamond: inversion at corner i turns both circumcircles into lines that meet at the image of j."""
    offset = corners[:, 1:] - corners[:, :1]
    image = offset / norm2(offset)[..., None]
    image = np.where(infinite[:, 1:, None], image[:1, :1] * 0, image)
    j, k, l = image[:, 0], image[:, 1], image[:, 2]
    u, v = j - k, l - j
    cross = np.stack([u[:, a] * v[:, b] - u[:, b] * v[:, a] for a, b in ((1, 2), (2, 0), (0, 1))], -1)
    return atan2(sqrt(norm2(cross)), (u * v).sum(-1))


def phi(beta, epsilon):
    return beta if epsilon == 0 else sqrt(beta * beta + number(epsilon, beta) ** 2) - number(epsilon, beta)


def energies(surface, x, epsilon=0.0):
    """Energy and the W_i of every vertex, vertices at infinity last. Clamped: W_i of interior vertices only."""
    values = phi(angles(surface.take(x), surface.infinite), epsilon)
    per = np.full(surface.total, number(0, x), dtype=x.dtype) - 2 * pi(x)
    np.add.at(per, surface.corners[:, 0], values)
    np.add.at(per, surface.corners[:, 1], values)
    total = (values * surface.weight).sum() - 2 * pi(x) * surface.vertex_count()
    return total, per


def gradient_by_differences(surface, x, epsilon=0.0, step="1e-16"):
    """Central differences of each angle by each coordinate; diamonds with |sin beta| < 1e-6 are skipped when epsilon = 0."""
    h, base = mp.mpf(step), surface.take(x)
    used = used_diamonds(angles(base, surface.infinite), epsilon)
    out = np.full((surface.total, 3), mp.mpf(0), dtype=object)
    for corner in range(4):
        for axis in range(3):
            ends = []
            for sign in (1, -1):
                moved = base.copy()
                moved[:, corner, axis] += sign * h
                ends.append(phi(angles(moved, surface.infinite), epsilon))
            slope = surface.weight * used * (ends[0] - ends[1]) / (2 * h)
            np.add.at(out[:, axis], surface.corners[:, corner], np.where(surface.infinite[:, corner], mp.mpf(0), slope))
    return out[: surface.n]


def used_diamonds(beta, epsilon):
    return np.ones(len(beta), int) if epsilon else (np.sin(beta.astype(float)) >= 1e-6).astype(int)


PAIRS = ((2, 3), (0, 1), (2, 1), (3, 0), (1, 3), (0, 2))  # kl ij | kj li | jl ik: opposite pairs of a diamond


def cosine(d):
    """cos beta of squared distances d (m, 6) in the order PAIRS.

    Inversion gives the triangle k'j'l' the sides kj·li, jl·ik, kl·ij (up to a common factor);
    beta is its exterior angle at j'. A vertex at infinity leaves its distances out (1).
    """
    p, q, r = d[:, 0] * d[:, 1], d[:, 2] * d[:, 3], d[:, 4] * d[:, 5]
    return (p - q - r) / (2 * sqrt(q * r))


def squared_distances(surface, x):
    """(m, 6) in the order PAIRS, 1 where a corner is infinite; and where that is."""
    corners = surface.take(x)
    gone = np.stack([surface.infinite[:, a] | surface.infinite[:, b] for a, b in PAIRS], -1)
    return np.where(gone, number(1, x), np.stack([norm2(corners[:, a] - corners[:, b]) for a, b in PAIRS], -1)), gone


def distance_weights(surface, x, epsilon=0.0):
    """omega = 2 dW/d(d²) of each pair of each diamond, (m, 6); 0 for infinite pairs and skipped diamonds."""
    beta = angles(surface.take(x), surface.infinite)
    used = used_diamonds(beta, epsilon)
    d, gone = squared_distances(surface, x)
    p, q, r = d[:, 0] * d[:, 1], d[:, 2] * d[:, 3], d[:, 4] * d[:, 5]
    c, mean = cosine(d), 2 * sqrt(q * r)
    # d cos beta / d log of each of the three products.
    logs = np.stack([p / mean, p / mean, -q / mean - c / 2, -q / mean - c / 2, -r / mean - c / 2, -r / mean - c / 2], -1)
    sine = np.frompyfunc(mp.sin, 1, 1)(beta) if x.dtype == object else np.sin(beta)
    slope = 1 if epsilon == 0 else beta / sqrt(beta * beta + number(epsilon, x) ** 2)
    scale = -2 * surface.weight * used * slope / np.where(used == 1, sine, number(1, x))
    return np.where(gone, number(0, x), scale[:, None] * logs / d)


def distance_weights_by_differences(surface, x, epsilon=0.0):
    """The same by central differences of acos(cosine) in each squared distance."""
    beta = angles(surface.take(x), surface.infinite)
    used = used_diamonds(beta, epsilon)
    d, gone = squared_distances(surface, x)
    h, columns = mp.mpf("1e-16"), []
    for s in range(6):
        ends = []
        for sign in (1, -1):
            moved = d.copy()
            moved[:, s] *= 1 + sign * h
            ends.append(phi(np.frompyfunc(mp.acos, 1, 1)(cosine(moved)), epsilon))
        columns.append((ends[0] - ends[1]) / (h * d[:, s]))
    return np.where(gone, number(0, x), np.stack(columns, -1) * (surface.weight * used)[:, None])


def apply_laplacian(surface, omega, y):
    """(K y)_p = sum_q omega_pq (y_p - y_q)."""
    out = np.full((surface.total, 3), number(0, y), dtype=y.dtype)
    padded = np.vstack([y, out[: surface.total - surface.n]])
    for s, (a, b) in enumerate(PAIRS):
        p, q = surface.corners[:, a], surface.corners[:, b]
        flux = omega[:, s, None] * (padded[p] - padded[q])
        np.add.at(out, p, flux)
        np.add.at(out, q, -flux)
    return out[: surface.n]


def matrix(surface, omega):
    """K in double precision, dense."""
    k, w = np.zeros((surface.total, surface.total)), omega.astype(float)
    for s, (a, b) in enumerate(PAIRS):
        p, q = surface.corners[:, a], surface.corners[:, b]
        for r, c, sign in ((p, p, 1), (q, q, 1), (p, q, -1), (q, p, -1)):
            np.add.at(k, (r, c), sign * w[:, s])
    return k[: surface.n, : surface.n]


def angle_defects(surface, x):
    """2 pi (interior) or pi (boundary vertex) minus the angles of the triangles at the vertex."""
    out = np.where(surface.rim, pi(x), 2 * pi(x))
    f = np.array(surface.faces)
    for t in range(3):
        a, b, c = (f[:, (t + s) % 3] for s in range(3))
        u, v = x[b] - x[a], x[c] - x[a]
        dot = (u * v).sum(-1)
        np.add.at(out, a, -atan2(sqrt(norm2(u) * norm2(v) - dot * dot), dot))
    return out


# The paper's scheme --------------------------------------------------------------


def paper_step(surface, x, dt):
    """(I/dt + K) dx = -gradient over the free vertices. Returns the new positions and the lowest eigenvalue of I + dt K.

    50 digits: the double-precision Cholesky factor is refined until the residual is below 1e-38 of the gradient.
    """
    omega = distance_weights(surface, x)
    gradient = apply_laplacian(surface, omega, x)
    k = matrix(surface, omega)[np.ix_(surface.free, surface.free)]
    system = np.eye(len(k)) / dt + k
    np.linalg.cholesky(system)  # raises when the system is not positive definite
    inverse = np.linalg.inv(system)
    lowest = float(np.linalg.eigvalsh(dt * system)[0])
    move = x * 0
    size = max(abs(gradient[surface.free]).ravel())
    for _ in range(20 if x.dtype == object else 2):
        residual = -gradient - move / number(dt, x) - apply_laplacian(surface, omega, move)
        residual = residual[surface.free]
        if x.dtype == object and max(abs(residual).ravel()) < size * mp.mpf("1e-38"):
            break
        if x.dtype == object:
            worst = max(abs(residual).ravel())
            move[surface.free] += exact(inverse @ (residual / worst).astype(float)) * worst
        else:
            move[surface.free] += inverse @ residual
    else:
        assert x.dtype != object, "refinement did not converge"
    return x + move, lowest


def paper_trace(surface, x, dt, steps=10):
    """Energy after each step, lowest eigenvalue of I + dt K in each, final positions, smallest sin beta met."""
    trace, sines = [], []
    for _ in range(steps):
        sines.append(np.sin(angles(surface.take(x), surface.infinite).astype(float)).min())
        x, lowest = paper_step(surface, x, dt)
        trace.append({"energy": float(energies(surface, x)[0]), "lowest_eigenvalue": lowest})
    return trace, x, min(sines)


def mean_edge_length(surface, x):
    e = surface.edges
    return float(sqrt(norm2(x[e[:, 0]] - x[e[:, 1]])).sum() / len(e))


# The printed formulas, only to compare -------------------------------------------


def printed(surface, x):
    """Gradient and entries (p, q) of K by equation (1) of the paper, or by the angle between edges beside infinity.

    Both are rows of coefficients: d beta / d v_p = sum_q row_q v_q.
    """
    gradient, entries = np.full((surface.n, 3), mp.mpf(0), dtype=object), {}
    for ids, points, gone, weight in zip(surface.corners, surface.take(x), surface.infinite, surface.weight):
        around = [2, 1, 3, 0]  # k j l i
        for t in range(4):
            turned = around[t:] + around[:t]
            if not gone.any():
                row = equation_1(*points[turned])
            elif gone[turned[3]]:
                row = [*corner_row_end(*points[turned[:3]]), mp.mpf(0)]
            elif gone[turned[1]]:
                first = corner_row_end(*points[[turned[0], turned[3], turned[2]]])
                row = [first[0], mp.mpf(0), first[2], first[1]]
            elif gone[turned[2]]:
                row = corner_row_middle(points[turned[3]], points[turned[0]], points[turned[1]])
                row = [row[1], row[2], mp.mpf(0), row[0]]
            else:
                continue
            p = int(ids[turned[0]])
            for c, q in zip(row, turned):
                if ids[q] < surface.n:
                    gradient[p] += int(weight) * c * points[q]
                    entries[p, int(ids[q])] = entries.get((p, int(ids[q])), 0) + int(weight) * c
    return gradient, entries


def length(v):
    return mp.sqrt(norm2(v))


def corner(p, v, n):
    u, z = v - p, n - v
    lu, lz = length(u), length(z)
    c = (u * z).sum() / (lu * lz)
    return lu, lz, c, mp.sqrt(1 - c * c)


def corner_row_end(p, v, n):
    """Of the exterior angle at v on the path p v n, by p: (z/|z| - c u/|u|) / (|u| sin)."""
    lu, lz, c, sine = corner(p, v, n)
    a, b = c / (lu * lu * sine), 1 / (lu * lz * sine)
    return [a, -a - b, b]


def corner_row_middle(p, v, n):
    """By v."""
    (a, _, b), (c, _, d) = corner_row_end(p, v, n), corner_row_end(n, v, p)
    return [-a - d, a + b + c + d, -b - c]


def equation_1(vk, vj, vl, vi):
    """Coefficients of v_k, v_j, v_l, v_i in d beta / d v_k; zero where |sin beta| < 1e-6."""
    edges = [vj - vk, vl - vj, vi - vl, vk - vi]
    a, b, c, d = (length(v) for v in edges)
    A, B, C, D = (v / s for v, s in zip(edges, (a, b, c, d)))
    AB, AC, AD, BC, BD, CD = ((s * t).sum() for s, t in ((A, B), (A, C), (A, D), (B, C), (B, D), (C, D)))
    cosine_beta = AC * BD - AB * CD - BC * AD
    sine = mp.sqrt(max(1 - cosine_beta * cosine_beta, mp.mpf(0)))
    if sine < 1e-6:
        return [mp.mpf(0)] * 4
    of_a, of_b = cosine_beta / a**2 - BC / (a * d), AC / (b * d) + CD / (a * b)
    of_c, of_d = -AB / (c * d) - BD / (a * c), BC / (a * d) - cosine_beta / d**2
    return [-t / sine for t in (of_d - of_a, of_a - of_b, of_b - of_c, of_c - of_d)]

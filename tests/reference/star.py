"""Semi-implicit scheme with the matrix made positive semi-definite vertex star by vertex star, double precision.

K is a sum over vertices i of K_i, the matrix of W_i alone, which couples only i and its neighbours.
Each K_i is replaced by its positive part. A vertex at infinity gives one 3 x 3 block an incident edge instead.
"""

import numpy as np
from scipy.sparse import coo_matrix, diags
from scipy.sparse.linalg import splu

from circle import PAIRS, apply_laplacian, distance_weights, energies


def half_diamonds(surface, omega):
    """(end, diamond, factor): each edge contributes to W_i of its finite or infinite ends that are counted."""
    for m, (i, j, *_), w in zip(range(len(omega)), surface.corners, surface.weight):
        for end in (i, j):
            if surface.boundary != "clamped" or not surface.rim[end]:
                yield end, m, 1 / w


def blocks(surface, omega):
    """Vertex lists and matrices of each star."""
    stars = {}
    for end, m, factor in half_diamonds(surface, omega):
        key = (end, m) if end >= surface.n else (end, -1)
        stars.setdefault(key, []).append((m, factor))
    for members in stars.values():
        ids = sorted({v for m, _ in members for v in surface.corners[m] if v < surface.n})
        at = {v: s for s, v in enumerate(ids)}
        k = np.zeros((len(ids), len(ids)))
        for m, factor in members:
            for s, (a, b) in enumerate(PAIRS):
                p, q = surface.corners[m, a], surface.corners[m, b]
                if p < surface.n and q < surface.n:
                    w, p, q = factor * omega[m, s], at[p], at[q]
                    k[p, p] += w
                    k[q, q] += w
                    k[p, q] -= w
                    k[q, p] -= w
        yield ids, k


def star_matrix(surface, x, epsilon, project=True):
    """K* (sparse); without projection, K itself."""
    rows, columns, values = [], [], []
    for ids, k in blocks(surface, distance_weights(surface, x, epsilon)):
        if project:
            value, vector = np.linalg.eigh(k)
            k = (vector * np.maximum(value, 0)) @ vector.T
        ids = np.array(ids)
        rows.append(np.repeat(ids, len(ids)))
        columns.append(np.tile(ids, len(ids)))
        values.append(k.ravel())
    entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
    return coo_matrix(entries, shape=(surface.n, surface.n)).tocsc()


def gradient(surface, x, epsilon):
    g = apply_laplacian(surface, distance_weights(surface, x, epsilon), x)
    g[surface.held] = 0
    return g


def star_step(surface, x, dt, epsilon, k=None, g=None):
    """x + dx with (I/dt + K*) dx = -gradient over the free vertices."""
    k = star_matrix(surface, x, epsilon) if k is None else k
    g = gradient(surface, x, epsilon) if g is None else g
    system = k[surface.free][:, surface.free] + diags(np.full(len(surface.free), 1 / dt))
    move = np.zeros_like(x)
    move[surface.free] = splu(system.tocsc()).solve(-g[surface.free])
    return x + move


def star_trace(surface, x, dt, epsilon, steps=10):
    """Smoothed and exact energy after each step of constant dt, and the final positions."""
    trace = []
    for _ in range(steps):
        x = star_step(surface, x, dt, epsilon)
        trace.append({"objective": energies(surface, x, epsilon)[0], "energy": energies(surface, x)[0]})
    return trace, x

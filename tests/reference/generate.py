"""Writes the JSON fixtures beside this file and prints a table of them. See README.md."""

import json
from pathlib import Path

import mpmath as mp
import numpy as np
from scipy.sparse import coo_matrix, identity
from scipy.sparse.linalg import splu

import circle
import meshes
from circle import PAIRS, Surface, apply_laplacian, distance_weights, energies, exact, mean_edge_length, norm2
from star import star_matrix, star_trace

HERE = Path(__file__).parent
ISLANDS = [0, 1, 2, 3, 40, 41, 57, 58, 59, 60, 99, 100, 101, 130, 131, 132, 133]

# name: mesh, boundary, listed fixed vertices, tau = dt / h² of the trace, whether to store K
EXACT = {
    "closed_icosphere": (lambda: meshes.icosphere(2, 0.05, 1), "closed", [], 0.02, True),
    "closed_torus": (meshes.bumpy_torus, "closed", [], 0.003, True),
    "closed_tetrahedron_2": (lambda: meshes.linear_subdivision(meshes.tetrahedron(), 2), "closed", [], 0.05, False),
    "closed_octahedron_2": (lambda: meshes.linear_subdivision(meshes.octahedron(), 2), "closed", [], 0.1, False),
    "free_disc": (meshes.disc, "free", [], 0.05, False),
    "free_annulus": (meshes.annulus, "free", [], 0.01, True),
    "fixed_disc": (meshes.disc, "fixed", [], 0.01, False),
    "fixed_annulus": (meshes.annulus, "fixed", [], 0.01, False),
    "fixed_disc_islands": (meshes.disc, "fixed", [50, 51, 52, 90, 115], 0.01, False),
    "clamped_disc": (meshes.disc, "clamped", [], 0.1, False),
    "clamped_annulus": (meshes.annulus, "clamped", [], 0.02, False),
    "free_mobius": (meshes.mobius_strip, "free", [], 0.01, False),
    "fixed_mobius": (meshes.mobius_strip, "fixed", [], 0.01, False),
    "closed_klein": (meshes.klein_bottle, "closed", [], 0.003, False),
    "closed_islands": (lambda: meshes.icosphere(2, 0.05, 7), "closed", ISLANDS, 0.02, False),
}
# name: mesh, boundary, epsilon, tau of the star-projected trace
SMOOTHED = {
    "smoothed_torus": (meshes.bumpy_torus, "closed", 0.1, 0.01),
    "smoothed_annulus": (meshes.annulus, "free", 0.1, 0.01),
}


def doubles(x):
    return np.asarray(x).astype(float).tolist()


def largest(x):
    return float(max(abs(np.asarray(x)).ravel()))


def write(name, data):
    lines = [f"{json.dumps(k)}: {json.dumps(v, separators=(',', ':'))}" for k, v in data.items()]
    (HERE / f"{name}.json").write_text("{\n" + ",\n".join(lines) + "\n}\n")


def closed_image(surface, x):
    """W after an inversion of the capped surface that brings the vertices at infinity to the origin."""
    centre = exact([0.3, -0.2, 3.1])
    image = (x - centre) / norm2(x - centre)[:, None]
    whole = np.vstack([image, np.zeros((surface.total - surface.n, 3), float) * mp.mpf(0)])
    everywhere = Surface.__new__(Surface)
    everywhere.__dict__.update(surface.__dict__)
    everywhere.infinite = surface.infinite & False
    return energies(everywhere, whole)[0]


def checks(surface, x, gradient, epsilon):
    """What must vanish; all in 50 digits. Raises when it does not."""
    full = circle.gradient_by_differences(surface, x, epsilon)
    omega = distance_weights(surface, x, epsilon)
    scale = largest(omega)
    found = {"gradient = K x": largest(full - apply_laplacian(surface, omega, x))}
    found["omega by differences"] = largest(omega - circle.distance_weights_by_differences(surface, x, epsilon)) / scale
    if epsilon == 0:
        printed_gradient, printed_entries = circle.printed(surface, x)
        table = weights(surface, omega)
        found["gradient = equation (1)"] = largest(full - printed_gradient)
        found["K = equation (1)"] = largest([v + table.get((min(k), max(k)), 0) for k, v in printed_entries.items() if k[0] != k[1]])
    cross = [(x[:, a] * full[:, b] - x[:, b] * full[:, a]).sum() for a, b in ((1, 2), (2, 0), (0, 1))]
    radial = (x * full).sum(1)
    found["force, moment, dilation"] = largest(np.concatenate([full.sum(0), cross, [radial.sum()]]))
    if surface.boundary == "closed":
        found["inversion"] = largest((norm2(x)[:, None] * full - 2 * radial[:, None] * x).sum(0))
    if surface.boundary != "clamped" and epsilon == 0:
        found["W of a Möbius image"] = largest([energies(surface, x)[0] - closed_image(surface, x)])
    euler = surface.n - len(surface.edges) + len(surface.faces)
    found["Gauss-Bonnet"] = largest([circle.angle_defects(surface, x).sum() - 2 * mp.pi() * euler])
    assert all(v < 1e-20 for v in found.values()), found
    per, defect = energies(surface, x)[1], circle.angle_defects(surface, x)
    inner = ~surface.rim
    assert min(per[: surface.n][inner]) > -1e-14 and min((per[: surface.n] + defect)[inner]) > -1e-14
    return max(found.values())


def describe(name, surface, points, fixed, epsilon):
    """The fields all fixtures share; returns them with the worst identity."""
    x = exact(points)
    total, per = energies(surface, x, epsilon)
    gradient = circle.gradient_by_differences(surface, x, epsilon)
    worst = checks(surface, x, gradient, epsilon)
    gradient[surface.held] = mp.mpf(0)
    counted = lambda v: not (surface.boundary == "clamped" and surface.rim[v])
    return {
        "name": name,
        "boundary": surface.boundary,
        "epsilon": epsilon,
        "fixed": fixed,
        "held": [int(v) for v in surface.held],
        "positions": doubles(points),
        "faces": [[int(v) for v in f] for f in surface.faces],
        "mean_edge_length": mean_edge_length(surface, x),
        "energy": float(total),
        "vertex_energy": [float(w) if counted(v) else None for v, w in enumerate(per[: surface.n])],
        "infinity_energy": doubles(per[surface.n :]) if surface.boundary != "clamped" else [],
        "angle_defect": doubles(circle.angle_defects(surface, x)),
        "gradient": doubles(gradient),
    }, worst


def weights(surface, omega):
    """(p, q) -> omega_pq with p < q, of the whole surface."""
    table = {}
    for s, (a, b) in enumerate(PAIRS):
        for p, q, w in zip(surface.corners[:, a], surface.corners[:, b], omega[:, s]):
            if max(p, q) < surface.n:
                key = (int(min(p, q)), int(max(p, q)))
                table[key] = table.get(key, 0) + w
    return table


def stiffness(surface, points, epsilon=0.0):
    table = weights(surface, distance_weights(surface, exact(points), epsilon))
    return [[p, q, float(w)] for (p, q), w in sorted(table.items())]


def exact_fixture(name, make, boundary, fixed, tau, store):
    points, faces = make()
    surface = Surface(len(points), faces, boundary, fixed)
    data, worst = describe(name, surface, points, fixed, 0.0)
    dt = float(f"{tau * data['mean_edge_length'] ** 2:.3g}")
    trace, final, sine = circle.paper_trace(surface, exact(points), dt)
    assert sine > 1e-4, "a diamond comes near the skip rule"
    rough, rough_final, _ = circle.paper_trace(surface, points, dt)
    data |= {
        "dt": dt,
        "tau": dt / data["mean_edge_length"] ** 2,
        "trace": trace,
        "final_positions": doubles(final),
        "roundoff": {
            "energy": max(abs(a["energy"] - b["energy"]) for a, b in zip(trace, rough)),
            "positions": largest(final - rough_final),
        },
    }
    if store:
        data["stiffness"] = stiffness(surface, points)
    write(name, data)
    lowest = min(t["lowest_eigenvalue"] for t in trace)
    ends = f"{trace[0]['energy']:.9g} {trace[-1]['energy']:.9g}"
    print(
        f"{name:21} v {len(points):3} f {len(faces):3} free {len(surface.free):3} loops {len(surface.loops)} W {data['energy']:.15g}"
        f" |g| {np.linalg.norm(data['gradient']):.12g} dt {dt} tau {data['tau']:.4f} W(1,10) {ends} low {lowest:.3f}"
        f" sin {sine:.1e} identities {worst:.0e} roundoff {data['roundoff']['energy']:.0e} {data['roundoff']['positions']:.0e}"
    )


def smoothed_fixture(name, make, boundary, epsilon, tau):
    points, faces = make()
    surface = Surface(len(points), faces, boundary)
    data, worst = describe(name, surface, points, [], epsilon)
    dt = float(f"{tau * data['mean_edge_length'] ** 2:.3g}")
    trace, final = star_trace(surface, points, dt, epsilon)
    nudged = points * (1 + 1e-15 * np.random.default_rng(1).standard_normal(points.shape))
    rough, rough_final = star_trace(surface, nudged, dt, epsilon)
    plain, star = (star_matrix(surface, points, epsilon, p).toarray() for p in (False, True))
    assert largest(plain - circle.matrix(surface, distance_weights(surface, points, epsilon))) < 1e-9
    assert np.linalg.eigvalsh(star)[0] > -1e-12
    data |= {
        "dt": dt,
        "tau": dt / data["mean_edge_length"] ** 2,
        "trace": trace,
        "final_positions": doubles(final),
        "roundoff": {
            "energy": max(abs(a["objective"] - b["objective"]) for a, b in zip(trace, rough)),
            "positions": largest(final - rough_final),
        },
        "stiffness": stiffness(surface, points, epsilon),
        "star_diagonal": doubles(np.diag(star)),
    }
    write(name, data)
    change = np.linalg.norm(star - plain) / np.linalg.norm(plain)
    print(
        f"{name:21} objective {data['energy']:.15g} |g| {np.linalg.norm(data['gradient']):.12g} dt {dt} tau {data['tau']:.4f}"
        f" objective(1,10) {trace[0]['objective']:.9g} {trace[-1]['objective']:.9g} |K*-K|/|K| {change:.4f}"
        f" lowest eigenvalue of K {np.linalg.eigvalsh(plain)[0]:.3f} identities {worst:.0e}"
        f" roundoff {data['roundoff']['energy']:.0e} {data['roundoff']['positions']:.0e}"
    )


def figure_6():
    """Icosahedron (circumradius 1) subdivided linearly four times, constant dt."""
    points, faces = meshes.linear_subdivision(meshes.icosahedron(), 4)
    surface, dt, x = Surface(len(points), faces), 0.0345, points
    h = mean_edge_length(surface, x)
    sequence = [energies(surface, x)[0]]
    for _ in range(24):
        omega = distance_weights(surface, x)
        rows, columns, values = [], [], []
        for s, (a, b) in enumerate(PAIRS):
            p, q, w = surface.corners[:, a], surface.corners[:, b], omega[:, s]
            rows += [p, q, p, q]
            columns += [p, q, q, p]
            values += [w, w, -w, -w]
        entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
        k = coo_matrix(entries, shape=(len(x), len(x)))
        x = x + splu((identity(len(x)) / dt + k).tocsc()).solve(-apply_laplacian(surface, omega, x))
        sequence.append(energies(surface, x)[0])
    write("figure_6", {"name": "figure_6", "dt": dt, "tau": dt / h**2, "mean_edge_length": h, "vertices": len(x), "energy": sequence})
    print(f"figure_6 h {h:.6f} tau {dt / h**2:.4f}", " ".join(f"{w:.3g}" for w in sequence))


def closed_forms():
    """Values known in closed form, and a torus sent to infinity at one of its vertices."""
    solids = []
    for name in ("tetrahedron", "octahedron", "icosahedron"):
        for level in range(4):
            points, faces = meshes.linear_subdivision(getattr(meshes, name)(), level)
            energy = energies(Surface(len(points), faces), exact(points))[0]
            gap = float(energy - 4 * mp.pi() * (2**level - 1))
            assert abs(gap) < 1e-11
            solids.append({"solid": name, "level": level, "vertices": len(points), "energy": float(4 * mp.pi() * (2**level - 1))})
            print(f"{name} level {level} W {float(energy):.15g} minus 4 pi (2^k - 1): {gap:.1e}")
    points, faces = meshes.bumpy_torus()
    whole, centre = energies(Surface(len(points), faces), exact(points)), 37
    x = exact(np.delete(points, centre, 0)) - exact(points[centre])
    image = (x / norm2(x)[:, None]).astype(float)
    down = lambda v: v - (v > centre)
    rest = [[int(down(v)) for v in f] for f in faces if centre not in f]
    energy, per = energies(Surface(len(image), rest, "free"), exact(image))
    inverted = {
        "centre": centre,
        "closed_energy": float(whole[0]),
        "closed_vertex_energy": float(whole[1][centre]),
        "positions": doubles(image),
        "faces": rest,
        "energy": float(energy),
        "infinity_energy": [float(per[-1])],
    }
    print(f"torus at infinity: W {float(whole[0])!r} -> {float(energy)!r}, W_v {float(whole[1][centre])!r} -> {float(per[-1])!r}")
    write("closed_forms", {"name": "closed_forms", "linear_subdivision": solids, "vertex_at_infinity": inverted})


if __name__ == "__main__":
    for fixture, recipe in EXACT.items():
        exact_fixture(fixture, *recipe)
    for fixture, recipe in SMOOTHED.items():
        smoothed_fixture(fixture, *recipe)
    figure_6()
    closed_forms()

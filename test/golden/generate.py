#!/usr/bin/python3
"""Computes the golden values that the tests compare the C++ code with, from the papers' equations alone.

    generate.py             writes values.txt
    generate.py --check     compares what it computes with values.txt; exit status 77 if NumPy is not installed

Nothing here is fast or clever: each function is one equation, written as in its paper.
"""

import os
import pathlib
import sys

# The threads of its linear algebra wait for each other, which takes minutes on a busy machine.
for variable in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")
try:
    import numpy as np
except ImportError:
    print("NumPy is not installed (Debian: python3-numpy)", file=sys.stderr)
    sys.exit(77)

VALUES = pathlib.Path(__file__).with_name("values.txt")
TOLERANCE = 1e-8


def z_normalised(values):
    """Less the mean, over the population standard deviation."""
    return (values - values.mean()) / values.std()


# NN-STNE: Xian, Chaudhary, Bock: Making Sense of Touch, ICRA 2020 workshop.


def best_match(shapelet, series, flat_deviation=0.0):
    """max_j max_w CC_w (equation 2), its j and w, and by how much it is ahead of the second largest."""
    length = len(shapelet)
    found = []
    for window in range(len(series) - length + 1):
        part = series[window:window + length]
        if part.std() <= flat_deviation:
            continue
        # correlate(t, s)[i] is the sum of t[m + w] s[m] over m, w = i - (M - 1).
        values = np.correlate(z_normalised(part), z_normalised(shapelet), mode="full") / length
        found += [(value, window, index - (length - 1)) for index, value in enumerate(values)]
    found.sort(reverse=True)
    return found[0] + (found[0][0] - found[1][0],)


def distances(shapelets, all_series, flat_fraction=0.0):
    """F (equation 3 and min-pooling) [N, K]."""
    return np.array([[1.0 - best_match(shapelet, series, flat_fraction * series.std())[0] for shapelet in shapelets]
                     for series in all_series])


def membership(features, alpha=1.0):
    """q (equation 4) [N, K]."""
    kernel = (1.0 + features / alpha) ** (-(alpha + 1.0) / 2.0)
    return kernel / kernel.sum(axis=1, keepdims=True)


def gaussian_similarity(all_series):
    """G [N, N], sigma^2 being the median squared distance of different series."""
    squared = np.array([[((a - b) ** 2).sum() for b in all_series] for a in all_series])
    return np.exp(-squared / np.median(squared[np.triu_indices(len(all_series), 1)]))


def paper_weights(similarity):
    return similarity - np.eye(len(similarity))


def contrastive_weights(similarity, repulsion):
    others = 1.0 - np.eye(len(similarity))
    like = similarity * others
    unlike = (1.0 - similarity) * others
    return like / like.sum() - repulsion * unlike / unlike.sum()


def spectral(q, weights):
    """Equation 5 in its first form."""
    return 0.5 * sum(weights[i, j] * ((q[i] - q[j]) ** 2).sum() for i in range(len(q)) for j in range(len(q)))


def diversity(shapelets):
    """||H||_F^2, sigma^2 being half the shapelets' length."""
    variance = 0.5 * shapelets.shape[1]
    return sum(np.exp(-((a - b) ** 2).sum() / variance) ** 2 for a in shapelets for b in shapelets)


def objective(shapelets, all_series, weights, diversity_weight):
    """Equation 6 without its L1 term, lambda being diversity_weight / K^2."""
    q = membership(distances(shapelets, all_series))
    return spectral(q, weights) + diversity_weight / len(shapelets) ** 2 * diversity(shapelets)


def numerical_gradient(function, point, step=1e-5):
    """Central differences."""
    gradient = np.empty_like(point)
    for index in np.ndindex(point.shape):
        above, below = point.copy(), point.copy()
        above[index] += step
        below[index] -= step
        gradient[index] = (function(above) - function(below)) / (2.0 * step)
    return gradient


# k-Shape: Paparrizos, Gravano: k-Shape, SIGMOD 2015.


def shape_distance(x, y):
    """SBD, and the samples by which y moves right to lie on x."""
    correlation = np.correlate(x, y, mode="full") / (np.linalg.norm(x) * np.linalg.norm(y))
    return 1.0 - correlation.max(), int(correlation.argmax()) - (len(x) - 1)


# UDFS: Yang, Shen, Ma, Huang, Zhou: l2,1-Norm Regularized Discriminative Feature Selection, IJCAI 2011.


def udfs(points, clusters, neighbours, ridge, sparsity, rounds):
    """The objective after each round, and the length of each feature's row of W after the last."""
    columns = points.T  # X, one point per column
    size = neighbours + 1
    centring = np.eye(size) - np.ones((size, size)) / size
    scores = np.zeros((len(columns), len(columns)))
    for point in points:
        order = np.argsort(((points - point) ** 2).sum(axis=1), kind="stable")[:size]
        selection = np.eye(len(points))[:, order]
        local = columns @ selection
        inner = np.linalg.inv(centring.T @ local.T @ local @ centring + ridge * np.eye(size))
        scores += columns @ selection @ centring @ inner @ centring.T @ selection.T @ columns.T
    diagonal = np.eye(len(columns))
    objectives = []
    for _ in range(rounds):
        projection = np.linalg.eigh(scores + sparsity * diagonal)[1][:, :clusters]
        lengths = np.linalg.norm(projection, axis=1)
        objectives.append(np.trace(projection.T @ scores @ projection) + sparsity * lengths.sum())
        diagonal = np.diag(1.0 / (2.0 * lengths))
    return objectives, lengths


# Inputs, and what comes of them.


def single(values):
    """Values that single precision, in which C++ is given them, holds exactly."""
    return np.asarray(values).astype(np.float32).astype(np.float64)


def walks(random, count, length):
    return single(np.cumsum(random.randn(count, length), axis=1))


def matching_values(random):
    series = walks(random, 4, 30)
    # A quiet end, whose windows are flat.
    series[3, 14:] = single(series[3, 14] + 0.05 * random.randn(16))
    shapelets = walks(random, 3, 8)
    matches = [[best_match(shapelet, one) for shapelet in shapelets] for one in series]
    assert min(match[3] for row in matches for match in row) > 1e-4, "a best match is not the only one"
    flat_fraction = 0.3
    features = distances(shapelets, series)
    gated = distances(shapelets, series, flat_fraction)
    assert np.abs(features - gated).max() > 0.01, "no flat window would have won"
    return {
        "matching.series": series,
        "matching.shapelets": shapelets,
        "matching.distances": features,
        "matching.windows": [[match[1] for match in row] for row in matches],
        "matching.shifts": [[match[2] for match in row] for row in matches],
        "matching.memberships": membership(features),
        "matching.flat_fraction": flat_fraction,
        "matching.distances_without_flat_windows": gated,
    }


def objective_values(random):
    series = single([z_normalised(one) for one in walks(random, 6, 24)])
    shapelets = 0.7 * walks(random, 4, 7) / 2.0
    shapelets = single(shapelets)
    assert min(best_match(shapelet, one)[3] for one in series for shapelet in shapelets) > 2e-4, "a match may change"
    similarity = gaussian_similarity(series)
    repulsion, diversity_weight = 3.0, 0.05
    values = {
        "objective.series": series,
        "objective.shapelets": shapelets,
        "objective.repulsion": repulsion,
        "objective.diversity_weight": diversity_weight,
        "objective.similarity": similarity,
        "objective.diversity": diversity(shapelets),
    }
    features = distances(shapelets, series)
    values["objective.distances"] = features
    for name, weights in (("paper", paper_weights(similarity)),
                          ("contrastive", contrastive_weights(similarity, repulsion))):
        values[f"objective.{name}.weights"] = weights
        values[f"objective.{name}.spectral"] = spectral(membership(features), weights)
        values[f"objective.{name}.spectral_gradient_by_distances"] = numerical_gradient(
            lambda point, fixed=weights: spectral(membership(point), fixed), features)
        values[f"objective.{name}.value"] = objective(shapelets, series, weights, diversity_weight)
        values[f"objective.{name}.gradient"] = numerical_gradient(
            lambda point, fixed=weights: objective(point, series, fixed, diversity_weight), shapelets)
    return values


def shape_values(random):
    series = random.randn(5, 13)
    pairs = [[shape_distance(x, y) for y in series] for x in series]
    return {
        "shapes.series": series,
        "shapes.distances": [[pair[0] for pair in row] for row in pairs],
        "shapes.shifts": [[pair[1] for pair in row] for row in pairs],
    }


def udfs_values(random):
    points = random.randn(14, 6)
    points[:7, [1, 4]] += 2.5
    clusters, neighbours, ridge, sparsity, rounds = 2, 4, 0.1, 4.0, 3
    objectives, weights = udfs(points, clusters, neighbours, ridge, sparsity, rounds)
    return {
        "udfs.points": points,
        "udfs.clusters": clusters,
        "udfs.neighbours": neighbours,
        "udfs.ridge": ridge,
        "udfs.sparsity": sparsity,
        "udfs.objectives": [objectives],
        "udfs.weights": [weights],
    }


def compute():
    """Returns a matrix for each name."""
    # RandomState gives the same numbers with every version of NumPy.
    random = np.random.RandomState(2)
    values = {}
    for part in (matching_values, objective_values, shape_values, udfs_values):
        values.update(part(random))
    return {name: np.atleast_2d(np.asarray(value, dtype=float)) for name, value in values.items()}


def write(values):
    with VALUES.open("w", encoding="ascii") as file:
        file.write("# Written by generate.py. Each entry: its name, its rows and columns, then a line for each row.\n")
        for name, matrix in values.items():
            file.write(f"{name} {matrix.shape[0]} {matrix.shape[1]}\n")
            for row in matrix:
                file.write(" ".join(repr(float(value)) for value in row) + "\n")


def read():
    lines = VALUES.read_text(encoding="ascii").splitlines()[1:]
    values = {}
    while lines:
        name, rows, columns = lines.pop(0).split()
        matrix = np.array([[float(word) for word in lines.pop(0).split()] for _ in range(int(rows))])
        assert matrix.shape == (int(rows), int(columns)), name
        values[name] = matrix
    return values


def check(computed, committed):
    """Returns the names that differ."""
    wrong = sorted(set(computed) ^ set(committed))
    for name in sorted(set(computed) & set(committed)):
        same_shape = computed[name].shape == committed[name].shape
        if not same_shape or not np.allclose(computed[name], committed[name], rtol=TOLERANCE, atol=TOLERANCE):
            wrong.append(name)
    return wrong


def main():
    computed = compute()
    if sys.argv[1:] != ["--check"]:
        write(computed)
        return 0
    wrong = check(computed, read())
    for name in wrong:
        print(f"{VALUES.name}: {name} is not what generate.py computes", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

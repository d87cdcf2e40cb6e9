"""Computes the results of statistics_numbers with SciPy and NumPy, from the same numbers, and compares to 1e-9."""
import json
import math
import sys
import warnings

import numpy as np
from scipy import linalg, optimize, special, stats

ours = json.load(sys.stdin)
compared = 0
worst = 0.0
wrong = 0
shapes = set()


def same(what, mine, theirs, tolerance=1e-9):
    """Compares relative to large values, and absolutely for small ones; p-values also relative to themselves."""
    global compared, worst, wrong
    compared += 1
    error = abs(mine - theirs) / max(abs(theirs), 1e-3)
    worst = max(worst, error * 1e-9 / tolerance)
    if not error <= tolerance:
        wrong += 1
        print(f"{what}: {mine!r}, by SciPy {theirs!r}")


def student_interval(level, df, centre, error):
    """scipy.stats.t.interval is good to 1e-9 only; the inverse of the incomplete beta function to 1e-15."""
    x = special.betaincinv(df / 2, 0.5, 1 - level)
    half = math.sqrt(df * (1 / x - 1)) * error
    return centre - half, centre + half


def groups(values):
    """The two groups on both sides of the widest gap, if values form two: (lower, upper)."""
    x = np.sort(values)
    n = len(x)
    if n < 3 or np.ptp(x) <= 1e-12 * np.abs(x).max():
        return None
    cut = int(np.argmax(np.diff(x))) + 1
    low, high = x[:cut], x[cut:]
    within = low.var() * len(low) + high.var() * len(high)
    repeat = max(np.ptp(low), np.ptp(high)) <= 1e-12 * np.abs(x).max()
    little = 0 if n < 5 else min(0.015 * (n - 4), 0.08)
    return (low, high) if repeat or within < little * x.var() * n else None


def is_skewed(values):
    n = len(values)
    if n < 5:
        return False
    if n < 8:
        return abs(stats.skew(values)) > {5: 1.21, 6: 1.24, 7: 1.23}[n]
    return stats.skewtest(values).pvalue < 0.05


def suited(values, level, is_difference):
    """The interval of the mean that suits the values' shape."""
    n = len(values)
    centre, error = values.mean(), stats.sem(values)
    low, high = student_interval(level, n - 1, centre, error)
    if parts := groups(values):
        lower, upper = parts
        gap = upper.mean() - lower.mean()
        share = len(upper) / n
        exact = stats.binomtest(len(upper), n).proportion_ci(level, "exact")
        unseen = stats.binomtest(0, n).proportion_ci(level, "exact").high if is_difference else 0
        residuals = np.concatenate([lower - lower.mean(), upper - upper.mean()])
        repeat = max(np.ptp(lower), np.ptp(upper)) <= 1e-12 * np.abs(values).max()
        within = 0
        if not repeat:
            within = student_interval(level, n - 2, 0, math.sqrt((residuals**2).sum() / (n - 2) / n))[1]
        ends = []
        for of_share, at_zero in ((share - exact.low, lower), (exact.high - share, upper)):
            opposite = unseen if abs(at_zero.mean()) < 0.1 * gap else 0
            ends.append(math.sqrt((of_share * gap) ** 2 + (opposite * gap) ** 2 + within**2))
        ends = centre - ends[0], centre + ends[1]
        return ends if repeat else (min(low, ends[0]), max(high, ends[1]))
    if is_skewed(values):
        skewness, q = stats.skew(values, bias=False), (high - centre) / error
        more = abs(skewness) * (1 + 2 * q * q) / (6 * math.sqrt(n)) * error
        return (low, high + more) if skewness > 0 else (low - more, high)
    return low, high


def suited_chance(values, end, above):
    """The one-sided p-value at which the suited interval of differences ends there; Student's beyond one half."""
    t = (values.mean() - end) / stats.sem(values) * (1 if above else -1)
    if t <= 0:
        return stats.t.sf(t, len(values) - 1)

    def beyond(p):
        low, high = suited(values, 1 - 2 * p, True)
        return end - low if above else high - end

    least, most = 1e-12, 0.5 - 1e-12
    if beyond(least) <= 0 or beyond(most) >= 0:
        return 0 if beyond(least) <= 0 else 0.5
    return optimize.brentq(beyond, least, most, xtol=1e-15)


def tost(difference, error, df, margin):
    return stats.t.sf((difference + margin) / error, df), stats.t.cdf((difference - margin) / error, df)


def exact(d):
    """The p-value over all choices of signs, and the smallest possible one; zeros unless differences repeat or group."""
    if len(np.unique(np.abs(d).round(12))) == len(d) and not groups(d):
        return 0, 0
    zero = np.zeros(len(d))
    test = stats.permutation_test((d, zero), lambda a, b, axis: (a - b).mean(axis), permutation_type="samples",
                                  vectorized=True, n_resamples=np.inf)
    return test.pvalue, 2.0 ** (1 - len(d))


def check_samples(number, case):
    a, b = np.array(case["a"]), np.array(case["b"])
    n = len(a)
    at = f"sample {number} of {n}"
    d = a - b
    shapes.update([shape(d), shape(a), shape(b)])
    paired, welch = stats.ttest_rel(a, b), stats.ttest_ind(a, b, equal_var=False)
    ea, eb = a.var(ddof=1) / n, b.var(ddof=1) / n
    dfs = {"paired": n - 1, "unpaired": (ea + eb) ** 2 / (ea**2 / (n - 1) + eb**2 / (n - 1))}
    errors = {"paired": d.std(ddof=1) / math.sqrt(n), "unpaired": math.sqrt(ea + eb)}
    for kind, test in (("paired", paired), ("unpaired", welch)):
        same(f"{at}: {kind} t", case[kind]["t"], test.statistic)
        p, smallest = exact(d) if kind == "paired" else (0, 0)
        if kind == "paired" and not groups(d) and is_skewed(d):
            p = 2 * suited_chance(d, 0, d.mean() > 0)
        same(f"{at}: {kind} p", case[kind]["p"], max(test.pvalue, p))
        same(f"{at}: {kind} df", case[kind]["df"], dfs[kind])
        equivalent = case["tost_" + kind]
        margin = equivalent["margin"]
        if kind == "paired":
            interval, interval90 = suited(d, 0.95, True), suited(d, 0.9, True)
            chances = suited_chance(d, -margin, True), suited_chance(d, margin, False)
        else:
            interval, interval90 = (student_interval(level, dfs[kind], d.mean(), errors[kind]) for level in (0.95, 0.9))
            chances = tost(d.mean(), errors[kind], dfs[kind], margin)
        above, below = (max(p, smallest / 2) for p in chances)
        # With groups the program finds p by halving, to 6e-8.
        near = 1e-4 if kind == "paired" and groups(d) else 1e-9
        for mine, theirs in zip(case[kind]["interval"], interval):
            same(f"{at}: {kind} interval", mine, theirs)
        same(f"{at}: {kind} TOST, above", equivalent["above"], above, near)
        same(f"{at}: {kind} TOST, below", equivalent["below"], below, near)
        for mine, theirs in zip(equivalent["interval"], interval90):
            same(f"{at}: {kind} TOST, interval", mine, theirs)
    # The same tests by SciPy's own t tests
    if not groups(d) and not is_skewed(d):
        same(f"{at}: paired TOST by ttest_rel", case["tost_paired"]["above"],
             stats.ttest_rel(a + case["tost_paired"]["margin"], b, alternative="greater").pvalue)
    same(f"{at}: unpaired TOST by ttest_ind", case["tost_unpaired"]["below"],
         stats.ttest_ind(a - case["tost_unpaired"]["margin"], b, equal_var=False, alternative="less").pvalue)
    pooled = d.mean() / math.sqrt((a.var(ddof=1) + b.var(ddof=1)) / 2)
    df = 2 * (n - 1)
    same(f"{at}: d_z", case["dz"], d.mean() / d.std(ddof=1))
    same(f"{at}: d", case["d"], pooled)
    same(f"{at}: g", case["g"], pooled * math.exp(special.gammaln(df / 2) - special.gammaln((df - 1) / 2)) / math.sqrt(df / 2))
    for mine, theirs in zip(case["mean"], suited(a, 0.95, False)):
        same(f"{at}: interval of the mean", mine, theirs)
    for mine, theirs in zip(case["mean90"], suited(b, 0.9, False)):
        same(f"{at}: interval of the mean at 90 %", mine, theirs)


def residual(y, columns):
    """The residual sum of squares of a least-squares fit of these columns."""
    x = np.column_stack(columns)
    fit, *_ = np.linalg.lstsq(x, y, rcond=None)
    return float(((y - x @ fit) ** 2).sum())


def indicator(codes):
    return [(codes == level).astype(float) for level in np.unique(codes)]


def check_factorial(number, case):
    """Sums of squares by fits with and without an effect; errors by orthonormal contrasts of each seed's values."""
    levels, y = case["levels"], np.array(case["values"])
    cells = int(np.prod(levels))
    n = len(y) // cells
    cell = np.repeat(np.arange(cells), n)
    factor = [np.unravel_index(cell, levels)[f] for f in range(len(levels))]
    one = [np.ones(len(y))]
    total = residual(y, one)
    by_seed = np.moveaxis(y.reshape(*levels, n), -1, 0)
    for effect in case["effects"]:
        f = effect["factors"]
        lower = sum((indicator(factor[i]) for i in f), []) if len(f) > 1 else []
        joint = np.ravel_multi_index([factor[i] for i in f], [levels[i] for i in f])
        squares = residual(y, one + lower) - residual(y, one + lower + indicator(joint))
        df = int(np.prod([levels[i] - 1 for i in f]))
        contrasts = by_seed.mean(axis=tuple(i + 1 for i in range(len(levels)) if i not in f))
        for place, i in enumerate(f):
            contrasts = np.moveaxis(np.tensordot(contrasts, linalg.helmert(levels[i]), ([place + 1], [1])), -1, place + 1)
        contrasts = contrasts.reshape(n, df)
        spread = np.atleast_2d(np.cov(contrasts.T))
        variances = linalg.eigvalsh(spread)
        ratio = n * (contrasts.mean(0) ** 2).sum() / variances.sum()
        error = squares / ratio * (n - 1)
        low = variances.sum() ** 2 / (df * (variances**2).sum())
        high = min(1.0, (n * df * low - 2) / (df * (n - 1 - df * low))) if n - 1 > df * low else 1.0
        epsilon = 0.25 * low + 0.75 * high
        at = f"factorial {number}, effect {f}"
        same(f"{at}: squares", effect["squares"], squares)
        same(f"{at}: df", effect["df"], df)
        same(f"{at}: df of the error", effect["error_df"], df * (n - 1))
        same(f"{at}: eta squared", effect["share"], squares / total)
        same(f"{at}: partial eta squared", effect["partial"], squares / (squares + error))
        same(f"{at}: F", effect["f"], ratio)
        same(f"{at}: epsilon", effect["epsilon"], epsilon)
        same(f"{at}: p", effect["p"], stats.f.sf(ratio, epsilon * df, epsilon * df * (n - 1)))
        if df == 1 and len(f) == 1:
            a, b = np.moveaxis(by_seed, f[0] + 1, 1).reshape(n, 2, -1).mean(-1).T
            same(f"{at}: p by ttest_rel", effect["p"], stats.ttest_rel(a, b).pvalue)


def check_holm(case):
    p = np.array(case["p"])
    order = np.argsort(p, kind="stable")
    corrected = np.minimum(1, np.maximum.accumulate(p[order] * (len(p) - np.arange(len(p)))))
    for place, value in zip(order, corrected):
        same("Holm", case["corrected"][place], value)


def shape(values):
    return "two groups" if groups(values) else "skewed" if is_skewed(values) else "plain"


warnings.simplefilter("ignore")
for number, case in enumerate(ours["samples"]):
    check_samples(number, case)
for value in ours["distributions"]:
    at = f"t = {value['t']}, df = {value['df']}"
    for what, mine, theirs in (("Student", value["above"], stats.t.sf(value["t"], value["df"])),
                               ("Fisher", value["f"], stats.f.sf(value["t"] ** 2, 3, value["df"]))):
        same(f"{what} {at}", mine, theirs)
        if theirs > 1e-200:  # tails are compared by their ratio, too
            same(f"{what} {at}, relative", mine / theirs, 1.0)
for share, student in ours["quantiles"]:
    same("Student quantile", student, stats.t.ppf(share, 9))
check_holm(ours["holm"])
for number, case in enumerate(ours["factorial"]):
    check_factorial(number, case)
if shapes != {"plain", "skewed", "two groups"}:
    wrong += 1
    print(f"only these shapes: {shapes}")
print(f"{compared} numbers, {wrong} of them wrong; the largest difference is {worst:.1e}")
sys.exit(1 if wrong or compared < 400 else 0)

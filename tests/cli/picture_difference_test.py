#!/usr/bin/python3
"""Compares the difference of two pictures with other code, by NumPy and SciPy: CIEDE2000 after a Gaussian.

  picture_difference_test.py MORULA

Exit codes: 0 both agree, 1 they do not, 77 NumPy, SciPy or Matplotlib is not there.
"""
import json
import os
import subprocess
import sys
import tempfile

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.image
    import numpy as np
    from scipy.ndimage import gaussian_filter
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)


def lab(levels):
    """CIELAB of sRGB levels, smoothed in linear light."""
    c = levels / 255
    linear = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    linear = np.stack([gaussian_filter(linear[..., k], 1.5, truncate=4, mode="nearest") for k in range(3)], -1)
    to_xyz = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750],
                       [0.0193339, 0.1191920, 0.9503041]])
    xyz = linear @ to_xyz.T / np.array([0.95047, 1, 1.08883])
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz / (3 * (6 / 29) ** 2) + 4 / 29)
    return 116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])


def ciede2000(one, other):
    """CIEDE2000 with vectors of hue in place of angles if possible: another way to the same numbers."""
    (l1, a1, b1), (l2, a2, b2) = one, other
    mean_chroma = (np.hypot(a1, b1) + np.hypot(a2, b2)) / 2
    a1, a2 = (a * (1.5 - 0.5 * np.sqrt(mean_chroma**7 / (mean_chroma**7 + 25.0**7))) for a in (a1, a2))
    h1, h2 = a1 + 1j * b1, a2 + 1j * b2
    c1, c2 = abs(h1), abs(h2)
    turn = np.angle(h2 * np.conj(h1))
    mean_hue = np.angle(h1) + turn / 2
    d_l, d_c, d_h = l2 - l1, c2 - c1, 2 * np.sqrt(c1 * c2) * np.sin(turn / 2)
    mean_l, mean_c = (l1 + l2) / 2, (c1 + c2) / 2
    rad = np.radians
    t = (1 - 0.17 * np.cos(mean_hue - rad(30)) + 0.24 * np.cos(2 * mean_hue) + 0.32 * np.cos(3 * mean_hue + rad(6))
         - 0.2 * np.cos(4 * mean_hue - rad(63)))
    s_l = 1 + 0.015 * (mean_l - 50)**2 / np.sqrt(20 + (mean_l - 50)**2)
    s_c, s_h = 1 + 0.045 * mean_c, 1 + 0.015 * mean_c * t
    degrees = np.degrees(mean_hue) % 360
    rotation = (-2 * np.sqrt(mean_c**7 / (mean_c**7 + 25.0**7))
                * np.sin(rad(60 * np.exp(-((degrees - 275) / 25)**2))))
    return np.sqrt((d_l / s_l)**2 + (d_c / s_c)**2 + (d_h / s_h)**2 + rotation * (d_c / s_c) * (d_h / s_h))


def pictures():
    """Pairs of pictures that differ by a pixel's move, by noise, by a patch of another hue, and in everything."""
    random = np.random.default_rng(7)
    y, x = np.mgrid[0:90, 0:120]
    hills = np.stack([128 + 100 * np.sin(x / 13 + k) * np.cos(y / (9 + k)) for k in range(3)], -1)
    hills[20:50, 30:70] = (200, 60, 20)
    yield hills, np.roll(hills, 1, axis=1)
    yield hills, hills + random.integers(-2, 3, hills.shape)
    patch = hills.copy()
    patch[60:75, 80:100] = patch[60:75, 80:100][..., ::-1]
    yield hills, patch
    yield random.integers(0, 256, hills.shape), random.integers(0, 256, hills.shape)


def main(morula):
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        files = [os.path.join(folder, name) for name in ("one.png", "other.png")]
        for number, pair in enumerate(pictures()):
            levels = [np.clip(np.round(p), 0, 255).astype(np.uint8) for p in pair]
            for file, image in zip(files, levels):
                matplotlib.image.imsave(file, image)
            command = [morula, "render", files[0], "--compare", files[1], "--json"]
            answer = json.loads(subprocess.run(command, capture_output=True, text=True).stdout)
            expected = ciede2000(*(lab(image.astype(float)) for image in levels))
            row, column = np.unravel_index(np.argmax(expected), expected.shape)
            for what, theirs, ours in (("most", expected.max(), answer["most"]), ("mean", expected.mean(), answer["mean"]),
                                       ("share", (expected > answer["threshold"]).mean(), answer["share"]),
                                       ("x", column, answer["x"]), ("y", row, answer["y"])):
                if abs(theirs - ours) > 1e-6 * max(1, abs(theirs)):  # the order of sums differs
                    print(f"pair {number}: {what}: {ours} here, {theirs} there")
                    wrong += 1
    print(f"{number + 1} pairs, {wrong} numbers differ")
    return wrong > 0


sys.exit(main(sys.argv[1]))

"""The order of painting: whatever crosses whatever, the nearest is painted last."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from playwright.sync_api import Page

from chr_notes.demos.base import SOURCES

Array = NDArray[np.float64]

ORDERED = """async ([address, triangles, eye]) => {
  const { flat, fromBehind, partition } = await import(address);
  const order = [];
  const polygons = triangles.map((points, id) => flat({ points, id }));
  fromBehind(partition(polygons), eye, ({ points, id }) => order.push({ points, id }));
  return order;
}"""


def hit(points: Array, eye: Array, ray: Array) -> float:
    """How far along a ray a convex polygon lies, infinity if the ray misses it."""
    normal = np.cross(points[1] - points[0], points[2] - points[0])
    distance = float(np.dot(points[0] - eye, normal) / np.dot(ray, normal))
    at = eye + distance * ray
    edges = np.roll(points, -1, axis=0) - points
    sides = np.cross(edges, at - points) @ normal
    inside = np.all(sides > 0) or np.all(sides < 0)
    return distance if inside and distance > 0 else np.inf


def test_last_painted_is_nearest(visit: Callable[..., Page], serve: Callable[[Path], str]) -> None:
    random = np.random.default_rng(6)
    triangles = random.normal(size=(12, 3, 3))
    eye = np.array([-8.0, 1.0, 2.0])
    address = serve(SOURCES)
    page = visit(address + "demos.css")
    painted = page.evaluate(ORDERED, [address + "draw.js", triangles.tolist(), eye.tolist()])
    assert len(painted) > len(triangles), "nothing was cut: the test has lost its point"
    seen = 0
    for target in random.normal(size=(100, 3)):
        ray = target - eye
        distances = [hit(triangle, eye, ray) for triangle in triangles]
        hits = [each["id"] for each in painted if hit(np.array(each["points"]), eye, ray) < np.inf]
        if np.isfinite(min(distances)):
            seen += 1
            assert hits[-1] == int(np.argmin(distances))
        else:
            assert hits == []
    assert seen > 30

"""The order of painting: whatever crosses whatever, the nearest is painted last."""

import json
import subprocess
from collections.abc import Callable, Sequence

import numpy as np
import pytest
from numpy.typing import NDArray

from chr_notes.demos.base import SOURCES

Array = NDArray[np.float64]

PAINTED = """
let path = [];
const order = [];
const context = {
  beginPath: () => (path = []),
  moveTo: (...point) => path.push(point),
  lineTo: (...point) => path.push(point),
  closePath() {},
  fill() { order.push({ points: path, id: this.fillStyle }); },
  stroke() {},
};
const { triangles, eye, radii } = JSON.parse(process.argv[1]);
const polygons = triangles.map((points, id) => ({ points, fill: [id, 0, 0], unlit: true, open: true }));
paint(context, polygons, { eye, project: (point) => point, light: [1, 0, 0] }, radii);
process.stdout.write(JSON.stringify(order));
"""  # noqa: E501 - JavaScript


def painted(node: str, triangles: Array, eye: Array, radii: list[float]) -> list[tuple[int, Array]]:
    """Each part of a triangle in the order of painting, with the number of its triangle."""
    code = (SOURCES / "draw.js").read_text(encoding="utf-8") + PAINTED
    given = json.dumps({"triangles": triangles.tolist(), "eye": eye.tolist(), "radii": radii})
    done = subprocess.run(
        [node, "--input-type=module", "--eval", code, given],
        check=True,
        capture_output=True,
        text=True,
    )
    return [
        (int(each["id"].removeprefix("rgb(").split()[0]), np.array(each["points"]))
        for each in json.loads(done.stdout)
    ]


def distances(polygons: Sequence[Array], eye: Array, ray: Array) -> Array:
    """How far along a ray each convex polygon lies, infinity where the ray misses it."""
    corners = np.array([len(points) for points in polygons])
    result = np.full(len(polygons), np.inf)
    for count in np.unique(corners):
        points = np.array([polygons[place] for place in np.flatnonzero(corners == count)])
        normal = np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
        distance = np.sum((points[:, 0] - eye) * normal, axis=1) / (normal @ ray)
        at = eye + distance[:, None] * ray
        edges = np.roll(points, -1, axis=1) - points
        sides = np.sum(np.cross(edges, at[:, None] - points) * normal[:, None], axis=2)
        inside = np.all(sides > 0, axis=1) | np.all(sides < 0, axis=1)
        result[corners == count] = np.where(inside & (distance > 0), distance, np.inf)
    return result


def anywhere(random: np.random.Generator) -> Array:
    """Triangles that cut each other."""
    return random.normal(size=(12, 3, 3))


def shells(random: np.random.Generator) -> Array:
    """Triangles with their corners on the spheres of radius 2.6, 1.9, 1.3 and 0.7."""
    places = random.normal(size=(120, 1, 3))
    corners = places / np.linalg.norm(places, axis=2, keepdims=True)
    corners = corners + random.uniform(-0.25, 0.25, size=(120, 3, 3))
    return (
        corners
        / np.linalg.norm(corners, axis=2, keepdims=True)
        * np.repeat([2.6, 1.9, 1.3, 0.7], 30)[:, None, None]
    )


@pytest.mark.parametrize(("made", "radii"), [(anywhere, []), (shells, [2.2, 1.6, 1.0])])
def test_last_painted_is_nearest(
    program: Callable[[str], str],
    made: Callable[[np.random.Generator], Array],
    radii: list[float],
) -> None:
    random = np.random.default_rng(6)
    triangles = made(random)
    eye = np.array([-8.0, 1.0, 2.0])
    order = painted(program("node"), triangles, eye, radii)
    if not radii:
        assert len(order) > len(triangles), "nothing was cut: the test has lost its point"
    numbers, parts = np.array([number for number, _ in order]), [points for _, points in order]
    covered = 0
    for target in random.normal(size=(100, 3)):
        ray = target - eye
        whole = distances(triangles, eye, ray)
        hits = numbers[np.isfinite(distances(parts, eye, ray))].tolist()
        covered += len(hits) > 1
        assert hits[-1:] == ([int(np.argmin(whole))] if np.isfinite(np.min(whole)) else [])
    assert covered > 3

"""What a rate of a gyro is in rad/s, by how a vector that stands still in the room turns.

In the body's axes such a vector, as gravity or the Earth's field, changes as dv/dt = v × ω. A
recording that holds both sides of this equation tells the factor between what the gyro reads and
rad/s, unless the body hardly turns or is shaken more than it turns.
"""

import numpy as np

from chr_notes._arrays import Floats
from chr_notes._rows import Rows
from chr_notes._samples import complete
from chr_notes.generated.arrays import sensors as generated

_vector_rate = Rows(generated.vector_rate)

_RATE = 50.0  # Hz, enough for how a body turns
_BLOCK = 0.25  # seconds that are averaged: vibration and noise come through less
_ROWS, _PARTS = 6144, 6  # of a long recording no more is looked at, in parts of rows in a row
_FEWEST = 12  # blocks
_LEAST = 1e-6  # seconds from sample to sample
_GAP = 3.0  # a step of so many usual ones is not integrated over
_EXPLAINED = 0.2
"""Share of the changes, at least. Where noise in the rates makes the factor smaller by some number,
it leaves no more than the inverse of that number explained, so this cannot make 1/57 out of 1."""
_CERTAIN = 5.0  # standard deviations
_NEAR = 2.5  # by how much the factor may be off
_MOSTLY = 0.5  # share, for a factor that a lever arm under vibration may feign
_WILD = 3.0  # times what one in fifty is at least


def in_doubt(rates: Floats, vector: Floats, steps: Floats) -> str | None:
    """Ask what rates are in that turn a vector clearly better in °/s, or converted to them.

    Parameters
    ----------
    rates
        What the gyro reads, shape (N, 3).
    vector
        What an accelerometer or a magnetometer reads, any unit, shape (N, 3).
    steps
        Seconds, shape () or (N,).
    """
    some = steps[:: 1 + steps.size // 1000] if steps.ndim else steps
    usual = float(np.median(some))
    if not _LEAST < usual < _BLOCK:
        return None
    every = max(1, round(1 / (usual * _RATE)))
    width = max(1, round(_BLOCK / (usual * every)))
    count = len(rates) // every // width
    if count < _FEWEST:
        return None
    parts = 1 if count * width <= _ROWS else _PARTS
    count = min(count, _ROWS // width) // parts  # blocks of a part
    if count < 2:  # noqa: PLR2004 (of two a difference)
        return None
    length = count * width * every
    starts = np.linspace(0, len(rates) - length, parts).astype(int).tolist()

    def cut(values: Floats) -> Floats:
        return np.concatenate([values[at : at + length : every] for at in starts])

    read, turned = cut(rates), cut(vector)
    passed = cut(steps) if steps.ndim else np.full(len(read), usual)
    with np.errstate(all="ignore"):
        usable = complete(read) & complete(turned) & turned.any(axis=1) & (passed <= _GAP * usual)
        read, turned = (np.where(usable[:, np.newaxis], each, 0.0) for each in (read, turned))
        flow = _vector_rate(turned, read) * (every * passed[:, np.newaxis])
        blocks = (parts, count, width, 3)
        flow = flow.reshape(parts, -1, 3).cumsum(axis=1)
        means, told = turned.reshape(blocks).mean(axis=2), flow.reshape(blocks).mean(axis=2)
        whole = np.asarray(usable.reshape(blocks[:3]).all(axis=2))
        whole = whole[:, 1:] & whole[:, :-1]
        changes, terms = np.diff(means, axis=1)[whole], np.diff(told, axis=1)[whole]
        return _told(changes, terms, ((means[:, 1:] + means[:, :-1]) / 2)[whole])


def _told(changes: Floats, terms: Floats, means: Floats) -> str | None:
    """Solve for the factor, apart from what any bias of the gyro explains."""
    if len(terms) < _FEWEST:
        return None
    sizes = np.linalg.norm(terms, axis=1)
    kept = np.flatnonzero(sizes <= _WILD * np.quantile(sizes, 0.98))
    changes, terms, means = changes[kept], terms[kept], means[kept]
    by_bias = np.stack([_vector_rate(means, axis) for axis in np.eye(3)], axis=2)
    base = by_bias.reshape(-1, 3)
    both = np.stack([changes.reshape(-1), terms.reshape(-1)], axis=1)
    # einsum runs in one thread: for so little several cost more than they save.
    normal, mixed = (np.einsum("ni,nj->ij", base, each) for each in (base, both))
    both -= np.einsum("ni,ik->nk", base, np.einsum("ij,jk->ik", np.linalg.pinv(normal), mixed))
    changed, told = both.T
    power, along, all_of_it = (
        float(np.einsum("n,n->", *each))
        for each in ((told, told), (told, changed), (changed, changed))
    )
    if not (power > 0 and 0 < all_of_it < np.inf):
        return None
    factor = along / power
    explained = factor * along / all_of_it
    misfits = ((changed - factor * told) * told).reshape(-1, 3).sum(axis=1)
    sure = _CERTAIN * float(np.sqrt((misfits**2).sum())) / power
    degree = np.pi / 180
    if explained > _EXPLAINED and min(factor, 1 - factor) > sure:
        return "are they in °/s?" * (1 / _NEAR < factor / degree < _NEAR) or None
    if explained > _MOSTLY and factor - 1 > sure:
        return "were they rad/s before?" * (1 / _NEAR < factor * degree < _NEAR) or None
    return None

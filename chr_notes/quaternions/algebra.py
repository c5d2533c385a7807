"""Products, conjugates and inverses of quaternions, and the vectors that they turn.

Each function takes array-likes, broadcasts over the leading axes, and returns new float64 arrays.
Products, conjugates and inverses are those of the algebra, sign and norm included.
"""

from numpy.typing import ArrayLike

from chr_notes._arrays import Floats
from chr_notes._rows import Rows
from chr_notes.generated.arrays import quaternions as generated

_quaternion_multiply = Rows(generated.quaternion_multiply, spreads=True)
_quaternion_conjugate = Rows(generated.quaternion_conjugate)
_quaternion_inverse = Rows(generated.quaternion_inverse, scaled="refused", degree=-1)
_rotate_to_inertial = Rows(generated.rotate_to_inertial, scaled="refused", spreads=True)
_rotate_to_body = Rows(generated.rotate_to_body, scaled="refused", spreads=True)


def quaternion_multiply(p: ArrayLike, q: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Hamilton's product `p q`: the turn p after the turn q, both about fixed axes.

    Parameters
    ----------
    p, q
        Quaternions, shape (..., 4).
    out
        An array for the result.

    Returns
    -------
    ndarray
        The product as it is, with its own sign and norm, shape (..., 4).

    Raises
    ------
    ValueError
        If a last axis is not of size 4 or the leading axes do not broadcast.

    See Also
    --------
    rotate_to_body

    Notes
    -----
    Ledger: quaternions.3.2.

    Examples
    --------
    >>> quaternion_multiply([0, 1, 0, 0], [0, 0, 1, 0])  # i j = k
    array([0., 0., 0., 1.])
    >>> quaternion_multiply([0, 0, 1, 0], [0, 1, 0, 0])  # j i = -k
    array([ 0.,  0.,  0., -1.])
    """
    return _quaternion_multiply.compute(p, q, out)


def quaternion_conjugate(q: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Negate the vector part: for a unit quaternion, the turn back.

    Parameters
    ----------
    q
        Quaternions, shape (..., 4).
    out
        An array for the result.

    Returns
    -------
    ndarray
        `q*`, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis is not of size 4.

    See Also
    --------
    quaternion_inverse

    Notes
    -----
    Ledger: quaternions.3.c.

    Examples
    --------
    >>> quaternion_conjugate([0.5, 0.1, -0.2, 0.3])
    array([ 0.5, -0.1,  0.2, -0.3])
    """
    return _quaternion_conjugate.compute(q, out)


def quaternion_inverse(q: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Inverse of a quaternion: `q` times it is 1.

    Parameters
    ----------
    q
        Quaternions of any norm but zero, shape (..., 4).
    out
        An array for the result.

    Returns
    -------
    ndarray
        `q* / (q q*)`, shape (..., 4).

    Raises
    ------
    ValueError
        If the last axis is not of size 4, or a quaternion is zero; it names the first one.

    See Also
    --------
    quaternion_conjugate

    Notes
    -----
    Ledger: quaternions.3.a.

    Examples
    --------
    >>> from chr_notes import quaternion_multiply
    >>> q = [2.0, 0.0, 1.0, 1.0]
    >>> quaternion_multiply(q, quaternion_inverse(q)).round(12)
    array([1., 0., 0., 0.])
    """
    return _quaternion_inverse.compute(q, out)


def rotate_to_inertial(q: ArrayLike, v_body: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Components in the inertial frame of vectors given in the body frame: `q v q*`.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).
    v_body
        Vectors in the body frame, any unit, shape (..., 3).
    out
        An array for the result.

    Returns
    -------
    ndarray
        The vectors in the inertial frame, same unit, shape (..., 3).

    Raises
    ------
    ValueError
        If a last axis has another size, the leading axes do not broadcast, or a quaternion is
        zero; it names the first one.

    See Also
    --------
    rotate_to_body

    Notes
    -----
    Ledger: quaternions.3.1.

    Examples
    --------
    >>> from chr_notes import quaternion_from_euler
    >>> east = quaternion_from_euler([0, 0, 1.5707963267948966])
    >>> rotate_to_inertial(east, [1, 0, 0]).round(6)  # ahead is east
    array([0., 1., 0.])
    """
    return _rotate_to_inertial.compute(q, v_body, out)


def rotate_to_body(q: ArrayLike, v_inertial: ArrayLike, *, out: Floats | None = None) -> Floats:
    """Components in the body frame of vectors given in the inertial frame: `q* v q`.

    Parameters
    ----------
    q
        Attitude quaternions of any norm but zero, shape (..., 4).
    v_inertial
        Vectors in the inertial frame, any unit, shape (..., 3).
    out
        An array for the result.

    Returns
    -------
    ndarray
        The vectors in the body frame, same unit, shape (..., 3).

    Raises
    ------
    ValueError
        If a last axis has another size, the leading axes do not broadcast, or a quaternion is
        zero; it names the first one.

    See Also
    --------
    rotate_to_inertial

    Notes
    -----
    Ledger: quaternions.3.1, quaternions.3.4.

    Examples
    --------
    >>> from chr_notes import quaternion_from_euler
    >>> east = quaternion_from_euler([0, 0, 1.5707963267948966])
    >>> rotate_to_body(east, [0, 1, 0]).round(6)  # what lies east, lies ahead
    array([1., 0., 0.])
    """
    return _rotate_to_body.compute(q, v_inertial, out)

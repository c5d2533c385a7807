"""What numbers that stand for an attitude mean: a description, and those of known systems.

An attitude relates two frames, that of navigation (the room, the world) and that of the body. Each
field of a `Convention` settles one of the things on which systems differ.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from chr_notes._arrays import Floats
from chr_notes.sequences import SEQUENCES

Direction = Literal["to body", "to navigation"]

_ALONG = {
    "body": {"f": (0, 1.0), "b": (0, -1.0), "r": (1, 1.0), "l": (1, -1.0)},
    "navigation": {"n": (0, 1.0), "s": (0, -1.0), "e": (1, 1.0), "w": (1, -1.0)},
}
_VERTICAL = {"d": (2, 1.0), "u": (2, -1.0)}


@dataclass(frozen=True)
class Convention:
    """What the numbers of a system mean. The defaults are this package's own conventions.

    Active or passive is not a field: a matrix that turns vectors as the body has turned has the
    elements of the one that takes components from the body's axes to those of navigation.

    Parameters
    ----------
    sequence
        Axes of the turns from navigation to body, as SciPy writes them: "ZYX" about rotating axes,
        "zyx" about fixed ones.
    written
        The axes in the order in which the angles are written; as the sequence if empty, which it
        must be where an axis comes twice.
    negated
        Axes about which angles count against the rule of the hand, such as "xz".
    degrees
        Whether angles are in degrees.
    matrix
        Where the matrix takes components: "to body" or "to navigation".
    row_vectors
        Whether vectors are rows that stand to the left of the matrix.
    scalar_first
        Whether a quaternion begins with its scalar part.
    quaternion
        "to navigation" if `q v q*` takes components from the body's axes to those of navigation.
    product
        "Hamilton" (ij = k), or "JPL" (ij = -k).
    vectors
        Where a pair of vectors leads, before and after.
    accelerometer
        What it reads along the z-axis of navigation, level and at rest, in units of gravity: -1
        with z down, 1 with z up, and the reverse for a sensor that reports gravity instead.
    navigation, body
        Axes: letters of north, south, east, west, up, down; and of forward, back, left, right, up,
        down.
        A left-handed pair of frames turns by the left-hand rule.

    Raises
    ------
    ValueError
        If a field is none of these, or one frame is right-handed and the other left-handed.

    See Also
    --------
    chr_notes.systems.converting.convert
    chr_notes.systems.detective.find_conventions

    Examples
    --------
    >>> import chr_notes
    >>> chr_notes.Convention(sequence="xyz", navigation="enu", body="flu").handedness
    'right'
    """

    sequence: str = "xyz"
    written: str = ""
    negated: str = ""
    degrees: bool = False
    matrix: Direction = "to body"
    row_vectors: bool = False
    scalar_first: bool = True
    quaternion: Direction = "to navigation"
    product: Literal["Hamilton", "JPL"] = "Hamilton"
    vectors: Direction = "to body"
    accelerometer: Literal[-1, 1] = -1
    navigation: str = "ned"
    body: str = "frd"

    def __post_init__(self) -> None:
        """Refuse what is no description."""
        choices = {
            "sequence": SEQUENCES,
            "matrix": ("to body", "to navigation"),
            "quaternion": ("to body", "to navigation"),
            "vectors": ("to body", "to navigation"),
            "product": ("Hamilton", "JPL"),
            "accelerometer": (-1, 1),
        }
        for name, known in choices.items():
            if getattr(self, name) not in known:
                msg = f"{name}: expected one of {known}, got {getattr(self, name)!r}"
                raise ValueError(msg)
        if self.written and sorted(self.written) != sorted(self.sequence.lower()):
            msg = f"written: expected the axes of {self.sequence!r}, got {self.written!r}"
            raise ValueError(msg)
        if not set(self.negated) <= set(self.sequence.lower()):
            msg = f"negated: expected some of the axes of {self.sequence!r}, got {self.negated!r}"
            raise ValueError(msg)
        if np.linalg.det(self.axes("navigation")) * np.linalg.det(self.axes("body")) < 0:
            msg = (
                "expected axes of navigation and body of one handedness, got "
                f"{self.navigation!r} and {self.body!r}"
            )
            raise ValueError(msg)

    def axes(self, frame: Literal["navigation", "body"]) -> Floats:
        """Axes of a frame, as columns in north-east-down or forward-right-down."""
        letters = getattr(self, frame)
        known = _ALONG[frame] | _VERTICAL
        places = [known[letter] for letter in letters if letter in known]
        if len(letters) != 3 or sorted(place for place, _ in places) != [0, 1, 2]:  # noqa: PLR2004
            msg = f"{frame}: expected three of {', '.join(known)} at right angles, got {letters!r}"
            raise ValueError(msg)
        columns = np.zeros((3, 3))
        for column, (row, sign) in enumerate(places):
            columns[row, column] = sign
        return columns

    @property
    def handedness(self) -> Literal["right", "left"]:
        """By which rule the frames are made and turned."""
        return "right" if np.linalg.det(self.axes("body")) > 0 else "left"

    @property
    def matrix_is_transposed(self) -> bool:
        """Whether the elements are those of the transpose of a matrix to the body."""
        return (self.matrix == "to navigation") != self.row_vectors

    @property
    def quaternion_is_conjugated(self) -> bool:
        """Whether the elements are those of the conjugate of this package's quaternion."""
        return (self.quaternion == "to body") != (self.product == "JPL")

    @property
    def order(self) -> list[int]:
        """Place, among the angles as written, of each angle in the order of the sequence."""
        if not self.written:
            return [0, 1, 2]
        return [self.written.index(letter) for letter in self.sequence.lower()]

    @property
    def signs(self) -> list[int]:
        """Sign of each angle in the order of the sequence, -1 where it counts the other way."""
        return [-1 if letter in self.negated else 1 for letter in self.sequence.lower()]


_ROOM = {"navigation": "enu", "body": "flu"}
_PHONE = {"matrix": "to navigation", "accelerometer": 1, "navigation": "enu", "body": "rfu"}
PRESETS: dict[str, Convention] = {
    "this book": Convention(),
    "CHR": Convention(degrees=True),
    "ROS": Convention(matrix="to navigation", scalar_first=False, accelerometer=1, **_ROOM),  # type: ignore[arg-type]
    "ROS (local frame)": Convention(
        matrix="to navigation", scalar_first=False, accelerometer=1, navigation="nwu", body="flu"
    ),
    "SciPy": Convention("ZYX", matrix="to navigation", scalar_first=False, vectors="to navigation"),
    "PX4": Convention(matrix="to navigation"),
    "MATLAB": Convention("ZYX"),
    "three.js": Convention(
        "XYZ", matrix="to navigation", scalar_first=False, navigation="eus", body="rub"
    ),
    "browser": Convention("ZXY", degrees=True, **_PHONE),  # type: ignore[arg-type]
    "Android": Convention("ZXY", negated="xz", **_PHONE),  # type: ignore[arg-type]
    "Fusion": Convention(
        degrees=True, matrix="to navigation", accelerometer=1, navigation="nwu", body="flu"
    ),
}
"""Conventions of known systems, each held by a worked number of that system in a test.

- `this book`: roll, pitch, yaw in radians, the matrix to the body.
- `CHR`: the sensors UM6 and UM7; the same in degrees.
- `ROS`: REP 103, east-north-up and forward-left-up; quaternions x, y, z, w.
- `ROS (local frame)`: the same from where the robot started (odom, map without a compass): x ahead,
  y left, z up; ahead stands for north.
- `SciPy`: `Rotation`, with yaw, pitch, roll of "ZYX"; it leaves the axes open.
- `PX4`: the matrix and the quaternion lead from body to navigation.
- `MATLAB`: `angle2dcm` and `angle2quat`: yaw, pitch, roll, the matrix to the body.
- `three.js`: `Euler` in its own order, `Quaternion`, `Matrix4`; a camera looks along -z, y is up.
- `browser`: the event `deviceorientation`; alpha, beta, gamma.
- `Android`: `getRotationMatrix` and `getOrientation`; azimuth and pitch count the other way.
- `Fusion`: x-io's library by Madgwick, where z points up and x north.

:meta hide-value:
"""
DOCUMENTED: dict[str, Convention] = {
    "ArduPilot": Convention(matrix="to navigation"),
    "Eigen": Convention("ZYX", matrix="to navigation", scalar_first=False),
    "Blender": Convention(matrix="to navigation", navigation="enu", body="lbu"),
    "Unity": Convention(
        "zxy",
        written="xyz",
        degrees=True,
        matrix="to navigation",
        scalar_first=False,
        navigation="eun",
        body="ruf",
    ),
    "Unreal": Convention(
        "ZYX",
        written="yzx",
        negated="xy",
        degrees=True,
        scalar_first=False,
        navigation="neu",
        body="fru",
    ),
    "iOS": Convention("ZXY", scalar_first=False, navigation="nwu", body="rfu"),
    "Madgwick": Convention("ZYX", navigation="nwu", body="flu", accelerometer=1),
    "JPL": Convention("ZYX", scalar_first=False, quaternion="to body", product="JPL"),
}
"""By their documentation alone; no number of theirs is held by a test.

- `Unreal`: `FRotator` is pitch, yaw, roll; pitch raises the nose and roll lowers the right side,
  both against the left hand's rule. An `FMatrix` stands to the right of its vectors.
- `iOS`: Core Motion, with x towards magnetic north. Apple's pages tell neither the order of the
  angles nor what matrix and quaternion take to what: these parts are unconfirmed.
- `Madgwick`: his report of 2010. His formulas for Euler angles are for the conjugate of the
  quaternion that his filter has, as his own programs say.

:meta hide-value:
"""

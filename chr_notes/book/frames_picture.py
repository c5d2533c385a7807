"""The picture of the two frames and of the right-hand rule, on the page on conventions."""

import numpy as np
from matplotlib import pyplot as plt

from chr_notes.euler import matrix_from_euler
from chr_notes.palette import PALETTE
from chr_notes.plots import Picture, draw_aircraft, draw_frame, draw_label, draw_turn, show, world
from chr_notes.plots.frames import AXES

__all__ = ["generated"]

ATTITUDE = np.radians([0.0, 10.0, -57.0])
"""Roll, pitch and yaw of the aircraft that is drawn: seen well from the side, no axis hidden."""
ROOM = ("north", "east", "down")
BODY = ("forward\nroll ϕ", "right\npitch θ", "down\nyaw ψ")
REACH = ((1.6, 1.4), (1.45, 1.5), (1.3, 1.3))
"""How far out the words of an axis stand, of room and body: clear of its tip."""
ALT = (
    "Above, the inertial frame: x north, y east, z down. Below, an aircraft with its body frame: x "
    "forward out of the nose, y out of the right wing, z out of the bottom. Around each body axis "
    "an arrow shows the positive turn: roll takes y towards z, pitch z towards x, yaw x towards y."
)
CAPTION = (
    "Right thumb along an axis, and the fingers curl the way of a positive turn: roll puts the "
    "right wing down, pitch the nose up, yaw the nose to the right. x is drawn solid, y dashed, z "
    "dotted."
)


def generated() -> dict[str, str]:
    """Return the text of the part by its file name."""
    return {"frames.md": f'<div class="curves">{picture()._repr_html_()}</div>\n'}


def picture() -> Picture:
    """Draw the inertial frame, and below it the body's with a turn about each axis."""
    figure = plt.figure(figsize=(4.2, 4.6))
    room = world(figure.add_axes((0, 0.6, 0.8, 0.42), projection="3d"))
    body = world(figure.add_axes((-0.06, 0, 1, 0.76), projection="3d"))
    for axes in (room, body):
        axes.view_init(elev=25, azim=-70)
        axes.set_box_aspect((1, 1, 1), zoom=1.3)
        axes.patch.set_visible(False)  # else the lower hides what the upper writes
    draw_frame(room, np.eye(3), unlabelled="xyz")
    attitude = matrix_from_euler(ATTITUDE)
    draw_frame(draw_aircraft(body, attitude), attitude, unlabelled="xyz")
    for letter, axis, of_room, of_body, (in_room, out) in zip(
        AXES, np.eye(3), ROOM, BODY, REACH, strict=True
    ):
        draw_label(room, in_room * axis, f"{letter} {of_room}", colour=letter)
        draw_turn(body, attitude, letter, f"{letter} {of_body}", reach=out)
    for height, name in ((0.93, "inertial frame"), (0.56, "body frame")):
        figure.text(0.02, height, name, color=PALETTE["ink"].light, fontsize=12)
    return show(figure, ALT, CAPTION)

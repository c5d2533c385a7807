"""What functions compute of which no document has the formula: by SciPy, NumPy and closed forms.

Nothing of `chr_notes` stands here. Each reference takes the arguments of its function, one by one,
and gives the elements of its result, a flag included.
"""

import math
from collections.abc import Callable, Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

Row = tuple[float, ...]
Reference = Callable[..., Iterable[float]]
Floats = NDArray[np.float64]
UP, G, STEP = np.array([0.0, 0.0, -1.0]), 9.80665, 1e-5


def attitude(q: ArrayLike) -> Rotation:
    """Rotation from body to inertial frame."""
    return Rotation.from_quat(q, scalar_first=True)


def near(turn: Rotation, q: Sequence[float]) -> Floats:
    """Of the two quaternions of a rotation, times the norm of q, the one nearer q."""
    found = turn.as_quat(scalar_first=True) * np.linalg.norm(q)
    return np.asarray(math.copysign(1, found @ q) * found)


def turned(q: ArrayLike, rates: ArrayLike, dt: float) -> Rotation:
    """Turn about axes of the body, at constant rates."""
    return attitude(q) * Rotation.from_rotvec(np.multiply(rates, dt))


def towards(vector: Floats, aim: Floats, share: float = 1.0) -> Rotation:
    """Turn a vector towards another, the shortest way."""
    across = np.cross(vector, aim)
    length = np.linalg.norm(across)
    return Rotation.from_rotvec(share * np.arctan2(length, vector @ aim) * across / length)


def slopes(function: Callable[[Floats], Floats], at: Row) -> Floats:
    """Differentiate by each argument, a row each, by differences."""
    steps = STEP * np.eye(len(at))
    return np.array([(function(at + h) - function(at - h)) / (2 * STEP) for h in steps])


def sequence(numbers: Sequence[float]) -> str:
    return "".join(" XYZ"[int(number)] for number in numbers)


def rotation_defect(*elements: float) -> Row:
    matrix = np.reshape(elements, (3, 3))
    off = matrix @ matrix.T - np.eye(3)
    return math.sqrt(np.mean(off**2)), float(np.linalg.det(matrix))


def angles_from_matrix(*given: float) -> Row:
    turn = Rotation.from_matrix(np.reshape(given[:9], (3, 3)).T)
    return (*turn.as_euler(sequence(given[9:])), 0)


def euler_from_matrix(*elements: float) -> Row:
    yaw, pitch, roll, flag = angles_from_matrix(*elements, 3, 2, 1)
    return roll, pitch, yaw, flag


def axes_after(second: float, third: float, *axes: float) -> Floats:
    """Axes of three turns, as the columns of a matrix, in the frame after the last one."""
    names, units = sequence(axes), np.eye(3)[[int(axis) - 1 for axis in axes]]
    later = Rotation.from_euler(names[1:], (second, third)), Rotation.from_euler(names[2], third)
    moved = (turn.inv().apply(unit) for turn, unit in zip(later, units[:2], strict=True))
    return np.column_stack([*moved, units[2]])


def gyro_turn(*given: float) -> Floats:
    return near(turned(given[:4], given[4:7], given[7]), given[:4])


def quaternion_rates(*given: float) -> Floats:
    q, rates = given[:4], given[4:]
    return slopes(lambda dt: near(turned(q, rates, dt[0]), q), (0.0,))[0]


def norm_misfit(*given: float) -> Row:
    place = [[0, 1, 2], [1, 3, 4], [2, 4, 5]]

    def misfit(unknown: Floats) -> Floats:
        return np.linalg.norm(unknown[place] @ (given[9:] - unknown[6:])) - 1

    return float(misfit(np.array(given[:9]))), *slopes(misfit, given[:9])


def levelled(turn: Rotation, force: ArrayLike, gain: float) -> Rotation:
    """Turn an attitude by a share of what its up is off a reading at rest."""
    return towards(turn.apply(force), UP, gain) * turn


def observer_turn(*given: float) -> Floats:
    q, rates, force, (dt, gain) = given[:4], given[4:7], given[7:10], given[10:]
    return near(levelled(turned(q, rates, dt), force, gain), q)


def observer_step(*given: float) -> Floats:
    q = Rotation.from_euler("ZYX", given[2::-1]).as_quat(scalar_first=True)
    return attitude(observer_turn(*q, *given[3:])).as_euler("ZYX")[::-1]


def heading_off(field: Floats, north: float, east: float) -> float:
    """Find the turn about the vertical after which a field points to where the reference does."""
    return (math.atan2(east, north) - math.atan2(field[1], field[0]) + math.pi) % math.tau - math.pi


def about_down(angle: float) -> Rotation:
    return Rotation.from_rotvec([0, 0, angle])


def observer_heading_turn(*given: float) -> Floats:
    q, mag, (dt, gain, heading_gain, *reference) = given[:4], given[10:13], given[13:]
    turn = attitude(observer_turn(*given[:10], dt, gain))
    return near(about_down(heading_gain * heading_off(turn.apply(mag), *reference)) * turn, q)


def averaging_turn(*given: float) -> Row:
    q, length, slope, (averaged, settled) = given[:4], given[4], given[5:8], given[8:10]
    rates, force, (dt, tau, _) = given[10:13], given[13:16], given[16:]
    turn = turned(q, rates, dt)
    force = turn.apply(force)
    if settled:
        # tau²/2 m'' + tau m' + m = f, as a system in m, tau m' and f
        system = np.array([[0, 1, 0], [-2, -2, 2], [0, 0, 0]]) / tau
        mean, slope, _ = expm(system * dt) @ [length * UP, slope, force]
        averaged = 1 / (1 / tau + (1 / averaged - 1 / tau) * math.exp(-dt / tau))
    else:
        mean, slope = (averaged * length * UP + dt * force) / (averaged + dt), np.zeros(3)
        averaged += dt
    level = towards(mean, UP)
    after = near(level * turn, q)
    return *after, float(np.linalg.norm(mean)), *level.apply(slope), averaged, settled


def averaging_heading_turn(*given: float) -> Row:
    (heading_averaged, length, down, known), mag = given[10:14], np.array(given[20:23])
    dt, tau, longest, heading_tau, north, east, tolerance, _ = given[23:]
    state = averaging_turn(*given[:10], *given[14:20], dt, tau, longest)
    field, size = attitude(state[:4]).apply(mag), np.linalg.norm(mag)
    off = abs(size - length) / length, abs(field[2] / size - down)
    if max(off) > tolerance:  # another field: gyros alone, by a small bias
        left = 1 / (1 / heading_averaged + 0.005 * dt * G / 2)
        return *state, left, length, down, known - dt
    share = max(dt / (heading_averaged + dt), 1 - math.exp(-dt / heading_tau))
    turn = about_down(share * heading_off(field, north, east))
    part = dt / (known + dt)
    return (
        *near(turn * attitude(state[:4]), given[:4]),
        state[4],
        *turn.apply(state[5:8]),
        *state[8:],
        min(heading_averaged + dt, heading_tau),
        length + part * (size - length),
        down + part * (field[2] / size - down),
        known + dt,
    )


def bias_at_rest(*given: float) -> Row:
    means, still, learnt = np.array(given[:6]), given[6], given[7:10]
    now, (dt, rest, _) = np.array(given[10:16]), given[16:]
    off = np.abs(now - means)
    if off[:3].sum() > 0.035 or off[3:].sum() > 0.05 * np.abs(means[3:]).sum():
        return *now, 0, *learnt
    means = (still * means + dt * now) / (still + dt)
    return *means, still + dt, *(means[:3] if still + dt >= rest else learnt)


def averaging_bound(averaged: float, tau: float, speed: float, bias: float) -> Row:
    if averaged < tau:
        return (2 * speed / averaged / G + bias * tau,)
    age = np.linspace(0, 40, 400_001)
    up_and_down = np.abs(np.diff(2 * np.exp(-age) * np.sin(age))).sum()
    return (speed * up_and_down / tau / G + bias * tau,)


def monitor_gain(above: float, patience: float, gain: float, low: float, high: float) -> Row:
    asked = [gain, *[high] * int(patience), *[low] * int(patience)]
    return (asked[int(above)] if above < len(asked) else gain,)


def monitor_count(above: float, factor: float, threshold: float) -> Row:
    return (above if math.isnan(factor) else (above + 1) * (factor > threshold),)


def monitored_turn(*given: float) -> Row:
    q, above, mag, (dt, down, threshold, *gains) = given[:4], given[4], given[11:14], given[14:]
    after = observer_turn(*q, *given[5:11], dt, *monitor_gain(above, *gains))
    factor = abs(down - attitude(after).apply(mag)[2] / np.linalg.norm(mag))
    return *after, *monitor_count(above, factor, threshold)


def position_errors(*given: float) -> Row:
    tilt, bias, gyro_bias, scale, moving, accel_noise, gyro_noise, t, g = given
    constant = [each * t**2 / 2 for each in (g * math.sin(tilt), bias, scale * moving)]
    noises = accel_noise**2 * t**3 / 3, gyro_noise**2 * g**2 * t**5 / 20
    return constant[0], constant[1], gyro_bias * g * t**3 / 6, constant[2], *noises


def of_angles(given: Row) -> Rotation:
    """Make three turns about rotating axes."""
    return Rotation.from_euler(sequence(given[3:]), given[:3])


def quaternion_from_angles(*given: float) -> Floats:
    return of_angles(given).as_quat(canonical=True, scalar_first=True)


def angles_from_quaternion(*given: float) -> Row:
    return (*attitude(given[:4]).as_euler(sequence(given[4:])), 0)


REFERENCES: dict[str, Reference] = {
    "euler_from_matrix": euler_from_matrix,
    "rotation_defect": rotation_defect,
    "euler_rates_determinant": lambda pitch: [1 / math.cos(pitch)],
    "euler_rates_condition": lambda pitch: [np.linalg.cond(axes_after(pitch, 0, 3, 2, 1))],
    "wrap_angle": lambda angle: [(angle + math.pi) % math.tau - math.pi],
    "inclination_from_quaternion": lambda *q: [math.acos(attitude(q).as_matrix()[2, 2])],
    "quaternion_after_constant_rates": gyro_turn,
    "quaternion_rates": quaternion_rates,
    "matrix_from_angles": lambda *given: of_angles(given).as_matrix().T.ravel(),
    "angles_from_matrix": angles_from_matrix,
    "quaternion_from_angles": quaternion_from_angles,
    "angles_from_quaternion": angles_from_quaternion,
    "angle_rates_matrix": lambda *given: np.linalg.inv(axes_after(*given)).ravel(),
    "vector_rate": lambda *given: np.cross(given[:3], given[3:]),
    "norm_misfit": norm_misfit,
    "gyro_turn": gyro_turn,
    "observer_turn": observer_turn,
    "observer_step": observer_step,
    "gain_from_time_constant": lambda tau, dt: [1 - math.exp(-dt / tau)],
    "time_constant_from_gain": lambda gain, dt: [-dt / math.log(1 - gain)],
    "averaging_turn": averaging_turn,
    "averaging_heading_turn": averaging_heading_turn,
    "observer_heading_turn": observer_heading_turn,
    "bias_at_rest": bias_at_rest,
    "averaging_bound": averaging_bound,
    "monitor_gain": monitor_gain,
    "monitor_count": monitor_count,
    "monitored_turn": monitored_turn,
    "position_errors": position_errors,
    "position_at_last_velocity": lambda tilt, t, g: [g * math.sin(tilt) * t**2],
}

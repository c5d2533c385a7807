"""Columns of logs, as the tests of reading them want them."""

import numpy as np
from numpy.typing import NDArray

Log = dict[str, NDArray[np.float64]]
G = 9.80665
GYRO = ("gyro_x_dps", "gyro_y_dps", "gyro_z_dps")
ACCEL = ("acc_x_g", "acc_y_g", "acc_z_g")
MAG = ("mag_x_uT", "mag_y_uT", "mag_z_uT")


def renamed(log: Log, **names: str) -> Log:
    """Replace parts of names."""
    result = {}
    for name, values in log.items():
        for old, new in names.items():
            name = name.replace(f"_{old}", new)  # noqa: PLW2901
        result[name] = values
    return result


def still(count: int = 300, up: tuple[float, float, float] = (0.0, 0.0, -G)) -> Log:
    """A sensor that lies still, in SI units, with a little noise."""
    generator = np.random.default_rng(3)
    rates, force = generator.normal(0, 0.001, (count, 3)), generator.normal(up, 0.01, (count, 3))
    columns = {"t_s": np.arange(count) * 0.01}
    columns |= {f"g{axis}_rad_s": rates[:, n] for n, axis in enumerate("xyz")}
    return columns | {f"a{axis}_m_s2": force[:, n] for n, axis in enumerate("xyz")}

"""A simulated log with all vices."""

import pytest

from chr_notes.sensors.simulated_log import SimulatedLog, simulated_log

from .columns_of_logs import Log


@pytest.fixture(scope="module")
def simulated() -> SimulatedLog:
    return simulated_log()


@pytest.fixture
def log(simulated: SimulatedLog) -> Log:
    return dict(simulated.columns)

"""Derivations told step by step, as the chapters show them.

The ledger tells those of what a document prints; here are the others.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Basic

from chr_notes.derivations.steps import Step


@dataclass(frozen=True)
class Told:
    """Steps that a chapter shows one after the other.

    Parameters
    ----------
    steps
        In the order in which they are told.
    stands
        What each name in the steps stands for, from the derivations. A step holds if it is true of
        these; a test compares both sides of each in many digits, where no angle is special.
    """

    steps: tuple[Step, ...]
    stands: Mapping[Basic, Basic]

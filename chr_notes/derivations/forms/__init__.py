"""Derived formulas in the form in which to compute them.

Mathematics does not mind in which order a formula is worked out; rounding does, and so does time.
Each function here takes a derived formula, names what occurs in it, and adds what a computer has
to decide: which of several equal forms loses no digits, and what to return at gimbal lock. The
tests prove that each form is the derived formula again.
"""

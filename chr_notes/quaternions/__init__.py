"""Quaternions: conversions, and the algebra that turns vectors and adds turn to turn.

They are Hamilton's, scalar first, and an attitude satisfies `v_I = q v_B q*`. A quaternion that
stands for an attitude may have any norm but zero.
"""

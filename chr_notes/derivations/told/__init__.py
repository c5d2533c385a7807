"""Derivations told step by step, as the chapters show them; see `telling.Told`.

The ledger tells those of what a document prints. Here are the others.
"""

"""Generated code; `python -m chr_notes.codegen` writes it."""

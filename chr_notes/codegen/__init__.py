"""From derived formulas to committed source code: targets, lowering, one printer a language."""

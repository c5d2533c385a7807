"""Pure functions from definitions to formulas; nothing here has seen a printed result."""

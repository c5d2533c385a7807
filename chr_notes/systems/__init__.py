"""How other systems write attitudes: descriptions of conventions, conversion, and a detective."""

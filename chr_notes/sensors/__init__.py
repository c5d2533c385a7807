"""What sensors read: their models, calibration, and simulated errors."""

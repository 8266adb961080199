"""The paper: mechanical systems, kinematic laws, sliding-mode control."""

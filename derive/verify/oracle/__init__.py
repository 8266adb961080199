"""What counts as true: the paper in 130 digits and in CasADi, and nothing else of ours."""

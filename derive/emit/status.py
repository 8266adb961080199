"""The status values of the emitted code, the same in C and numpy."""

STATUSES = (
    ("OK", 0, "the command is good"),
    ("SATURATED", 1, "a force limit was reached"),
    ("NEAR_CUT_LOCUS", 2, "the error is close to where the law jumps; a limit may be reached too"),
    ("NOT_ON_GROUP", 16, "the error is off the group by more than max_drift"),
    ("OUT_OF_RANGE", 17, "a velocity, a rate or the error beyond its MAX, or a pole of the law"),
    ("NONFINITE_INPUT", 18, "an input, or what it leads to, is not finite"),
    ("BAD_PARAMS", 19, "found by check_params"),
)

FIRST_BAD = 16
"""From this status on the whole command is zero."""

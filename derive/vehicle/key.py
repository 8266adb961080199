"""The keys of a vehicle file by table, and where one belongs that stands in another table."""

from derive.control.table import CONTROLLERS

TOP_KEYS = (
    *("schema", "name", "group", "law", "shortest", "hysteresis", "controller", "inertia", "body"),
    *("options", "gains", "limits", "emit", "reference", "simulate"),
)
GROUP_KEYS = ("name", "basis", "units", "law")
BODY_KEYS = ("mass", "center", "moments", "added_mass")
OPTION_KEYS = ("momentum", "external", "added_mass")
REFERENCE_KEYS = ("kind", "g_r", "nu_r", "along", "duration", "file")
SIMULATE_KEYS = (
    *("duration", "rate", "step", "turn", "nu", "momentum", "external", "disturbance", "wave"),
    *("hertz", "noise_g", "noise_nu", "force_limit", "inertia_error"),
)
LIMIT_KEYS = ("force", "saturation", "drift")
EMIT_KEYS = ("scalars", "targets")

# TOML puts every key below [gains] into it, so a key of the top is easily lost there.
HOMES = {
    **dict.fromkeys(GROUP_KEYS, "below [group]"),
    **dict.fromkeys(BODY_KEYS, "below [body]"),
    **dict.fromkeys(OPTION_KEYS, "below [options]"),
    "added_mass": "below [body] as a matrix, or below [options] as true",
    **{gain: "below [gains]" for one in CONTROLLERS.values() for gain in one.names},
    **dict.fromkeys(LIMIT_KEYS, "below [limits]"),
    **dict.fromkeys(EMIT_KEYS, "below [emit]"),
    **dict.fromkeys(SIMULATE_KEYS, "below [simulate]"),
    **dict.fromkeys(REFERENCE_KEYS, "below [reference]"),
    "duration": "below [simulate], or below [reference] for a slew",
    "momentum": "below [options] as true, or below [simulate] as numbers",
    "external": "below [options] as true, or below [simulate] as numbers",
    **dict.fromkeys(TOP_KEYS, "to the top of the file, above the first [table]"),
}

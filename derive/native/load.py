"""Decides how compiled C is called: one contiguous array of structs per argument, row by row."""

import importlib.util
from collections.abc import Callable, Mapping
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

import cffi
import numpy as np
from numpy.typing import ArrayLike

from derive.native.header import Parameter, Routine, parse
from derive.native.layout import Array, Record, batch, field, record, shaped

Arrays = dict[str, Array]
Fields = Mapping[str, ArrayLike]

KEPT = "side"
"""What a caller keeps from call to call: it is read and written."""


class Library:
    """The emitted routines of one prefix, batched over the leading axes of their inputs.

    `header` is the emitted header, `library` what `compile.build` made of the source, `prefix`
    the C prefix, such as `paper_so3_f64`. Shapes and the scalar are read from the header: a
    float library takes and gives numpy float32. Raises OSError when the library cannot be
    loaded and ValueError when the header is not of the emitted kind.
    """

    def __init__(self, header: Path, library: Path, prefix: str) -> None:
        self.prefix = prefix
        self._header = parse(header.read_text(encoding="utf-8"))
        self._ffi = cffi.FFI()
        self._ffi.cdef(self._header.declarations)
        self._library = self._ffi.dlopen(str(library.resolve()))

    @cached_property
    def constants(self) -> dict[str, float]:
        """Numeric macros of the header; `PAPER_SO3_F64_MAX_NU` is `MAX_NU`."""
        start = self.prefix.upper() + "_"
        return {name.removeprefix(start): value for name, value in self._header.constants.items()}

    @cached_property
    def statuses(self) -> dict[str, int]:
        """The status enumeration; `PAPER_SO3_F64_OUT_OF_RANGE` is `OUT_OF_RANGE`."""
        start = self.prefix.upper() + "_"
        values = self._ffi.typeof(self._symbol("status")).relements
        return {name.removeprefix(start): int(value) for name, value in values.items()}

    @cached_property
    def routines(self) -> dict[str, Routine]:
        """The routines of this prefix by short name: `control`, `tracking`, `plant`, …."""
        start = self.prefix + "_"
        declared = self._header.routines.items()
        return {name.removeprefix(start): it for name, it in declared if name.startswith(start)}

    @cached_property
    def scalar(self) -> np.dtype[np.floating]:
        """float32 or float64: what the numbers of `state` are."""
        return field(self.layout("state"), "nu").base

    @cached_property
    def defaults(self) -> Arrays:
        """The default parameters, field by field; a scalar field has shape ()."""
        struct = getattr(self._library, self._symbol("defaults"))
        raw = bytes(self._ffi.buffer(self._ffi.addressof(struct)))
        row = np.frombuffer(raw, dtype=self.layout("params"))[0]
        return {name: np.array(row[name]) for name in row.dtype.names}

    def layout(self, struct: str) -> Record:
        """The numpy record of a struct by short name: `params`, `state`, `command`, …."""
        return record(self._ffi, self._ffi.typeof(self._symbol(struct)))

    def call(self, routine: str, **given: Fields | ArrayLike | None) -> Arrays:
        """Call a routine once per row; its outputs by name, and an enum result as `status`.

        A struct is given as a mapping of its fields, a plain array as itself. Each has the
        shape of the C field after any leading axes, which broadcast; so have the outputs.
        Fields of `params` left out, or all of it, are the defaults. What is read and written,
        KEPT, may be given as well, and is zero otherwise. Raises KeyError for an unknown routine,
        TypeError for wrong arguments or fields, ValueError for a wrong shape.
        """
        declared = self.routines[routine]
        layouts = {one.name: self.argument(one) for one in declared.parameters}
        inputs = [one.name for one in declared.parameters if one.is_input]
        if wrong := ({*given} ^ {*inputs}) - {"params", KEPT}:
            raise TypeError(f"{routine} takes {inputs}; missing or unknown: {sorted(wrong)}")
        filled = [*inputs, *(name for name in (KEPT,) if name in layouts and name in given)]
        fields = {name: self._fields(name, layouts[name], given.get(name)) for name in filled}
        shape = batch(
            (array, len(field(layouts[name], key).shape))
            for name in filled
            for key, array in fields[name].items()
        )
        buffers = {name: np.zeros(shape, dtype=layout) for name, layout in layouts.items()}
        for name in filled:
            for key, array in fields[name].items():
                buffers[name][key] = array
        status = self._run(declared, buffers, int(np.prod(shape, dtype=int)))
        outputs = [buffers[name] for name in layouts if name not in inputs]
        results = {key: rows[key].copy() for rows in outputs for key in rows.dtype.names or ()}
        return results if status is None else {**results, "status": status.reshape(shape)}

    def control(
        self,
        g: ArrayLike,
        nu: ArrayLike,
        g_r: ArrayLike | None = None,
        nu_r: ArrayLike | None = None,
        nu_r_dot: ArrayLike | None = None,
        params: Fields | None = None,
        **extras: ArrayLike,
    ) -> Arrays:
        """Guarded law: force, s, nu_u, nu_u_dot, (…, n), and status, (…); SI units.

        A baseline has no nu_u_dot, here and below.

        extras, here and below: `momentum` and `external`, (…, n), where the state holds them.
        """
        state = {"g": g, "nu": nu, **extras}
        if g_r is None or nu_r is None or nu_r_dot is None:
            return self.call("control", params=params, state=state)
        reference = {"g": g_r, "nu": nu_r, "nu_dot": nu_r_dot}
        return self.call("control", params=params, state=state, reference=reference)

    def tracking(
        self,
        g: ArrayLike,
        nu: ArrayLike,
        g_r: ArrayLike,
        nu_r: ArrayLike,
        nu_r_dot: ArrayLike,
        params: Fields | None = None,
        **extras: ArrayLike,
    ) -> Arrays:
        """Bare law with a reference: force, s, nu_u, nu_u_dot, (…, n); eqs. (TckCtrl), (Ctrls2)."""
        state = {"g": g, "nu": nu, **extras}
        reference = {"g": g_r, "nu": nu_r, "nu_dot": nu_r_dot}
        return self.call("tracking", params=params, state=state, reference=reference)

    def reaching(
        self, g: ArrayLike, nu: ArrayLike, params: Fields | None = None, **extras: ArrayLike
    ) -> Arrays:
        """Bare law without a reference: force, s, nu_u, nu_u_dot, (…, n); eq. (Ctrl2)."""
        return self.call("reaching", params=params, state={"g": g, "nu": nu, **extras})

    def plant(
        self,
        g: ArrayLike,
        nu: ArrayLike,
        force: ArrayLike,
        params: Fields | None = None,
        **extras: ArrayLike,
    ) -> Array:
        """Acceleration nu_dot, (…, n), under a force, (…, n); eq. (EulerP)."""
        state = {"g": g, "nu": nu, **extras}
        return self.call("plant", params=params, state=state, force=force)["nu_dot"]

    def check_params(self, params: Fields | None = None) -> Array:
        """Status of the parameters, (…): OK or BAD_PARAMS."""
        return self.call("check_params", params=params)["status"]

    def bound(self, prototype: str, symbol: str, *given: Any) -> Callable[[], None]:
        """A call of a further function of the library: of numbers, and of arrays by address."""
        self._ffi.cdef(f"{prototype};", override=True)
        function = getattr(self._library, symbol)
        types = self._ffi.typeof(function).args
        cast = self._ffi.cast
        fixed = [cast(kind, one.ctypes.data) if isinstance(one, np.ndarray) else one
                 for kind, one in zip(types, given, strict=True)]  # fmt: skip
        return lambda: function(*fixed)

    def _symbol(self, name: str) -> str:
        return f"{self.prefix}_{name}"

    def argument(self, parameter: Parameter) -> Record:
        """A struct as it is; a plain array as a record with one field, named like itself."""
        ctype = self._ffi.typeof(parameter.type)
        if ctype.kind == "struct":
            return record(self._ffi, ctype)
        number = record(self._ffi, ctype)
        own = () if parameter.size is None else (parameter.size,)
        return np.dtype([(parameter.name, number, own)])

    def _fields(self, name: str, layout: Record, given: Fields | ArrayLike | None) -> Arrays:
        """The arrays of one argument by field, their last axes checked."""
        mapping: dict[str, ArrayLike] = {}
        if given is not None:
            mapping = {**given} if isinstance(given, Mapping) else {name: given}
        if name == "params":
            mapping = {**self.defaults, **mapping}
        if wrong := set(mapping) ^ set(layout.names or ()):
            raise TypeError(f"{name} has {layout.names}; missing or unknown: {sorted(wrong)}")
        shapes = {key: field(layout, key).shape for key in mapping}
        return {key: shaped(value, shapes[key], key) for key, value in mapping.items()}

    def _run(self, routine: Routine, buffers: Arrays, rows: int) -> Array | None:
        """Call `routine` on each row in place; the results when it has any, (rows,)."""
        function = getattr(self._library, routine.symbol)
        arguments = []
        for one, ctype in zip(routine.parameters, self._ffi.typeof(function).args, strict=True):
            first = self._ffi.cast(ctype, buffers[one.name].ctypes.data)
            arguments.append((first, one.size or 1))
        results = [
            function(*(first + row * step for first, step in arguments)) for row in range(rows)
        ]
        return None if routine.result == "void" else np.array(results, dtype=np.int64)


def load_module(path: Path) -> ModuleType:
    """Execute the Python file at `path` as a fresh module, without touching `sys.modules`.

    Raises FileNotFoundError, or whatever the file raises.
    """
    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None or spec.loader is None:
        raise FileNotFoundError(path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module

"""The public names: each resolves, and importing the package costs nothing."""

import subprocess
import sys

import pytest

import derive


@pytest.mark.parametrize("name", derive.__all__)
def test_public_names_resolve(name: str) -> None:
    assert getattr(derive, name) is not None
    assert name in dir(derive)


def test_public_names_are_the_lazy_table() -> None:
    assert set(derive.__all__) == {"__version__", *derive._HOME}


def test_unknown_names_are_refused() -> None:
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        _ = derive.nonsense


def test_import_loads_nothing_heavy() -> None:
    heavy = "{'sympy', 'casadi', 'numpy', 'mpmath', 'jinja2', 'click', 'cffi'}"
    script = f"import sys, derive; print(sorted({heavy} & set(sys.modules)))"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"

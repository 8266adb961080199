"""The tangent bundle as the paper's Lie group, Lemmas 1 and 2, written as derivations.

A state h = (g, nu) has k stored numbers and n coordinates; star needs a group and a law, and
the gain lambda. H is where s vanishes.
"""

from __future__ import annotations

from sympy import Expr, Matrix, zeros

from derive.control.law import KinematicLaw
from derive.lie.group import Group, marked
from derive.routine.derivation import Derivation, Quantity


def star(group: Group, law: KinematicLaw) -> Derivation:
    """h1 star h2; eq. (BnyOp)."""
    d = Derivation("star", "product of two states", "eq. (BnyOp)")
    gain = _gain(d)
    (g1, nu1), (g2, nu2) = _state(d, group, "1"), _state(d, group, "2")
    product = group.store(group.embed(g1) * group.embed(g2))
    g = d.let("g", product, "1", "product of the configurations")
    laws = [
        d.let(f"nu_u{mark}", law.write(marked(d.let, mark), group, at).value, group.log_unit,
              f"kinematic law at {where}", law.source)
        for mark, at, where in (("1", g1, "g1"), ("2", g2, "g2"), ("12", g, "g1 g2"))
    ]  # fmt: skip
    value = nu1 + nu2 + gain * (laws[0] + laws[1] - laws[2])
    return _given(d, group, g, d.let("nu", value, group.unit, "its velocity", d.source))


def inverse(group: Group) -> Derivation:
    """h^-1 = (g^-1, -nu); lem. (LieGroup)."""
    d = Derivation("inverse", "inverse of a state", "lem. (LieGroup)")
    g, nu = _state(d, group)
    back = group.store(group.inverse(group.embed(g)))
    back = d.let("g_back", back, "1", "inverse of the configuration")
    return _given(d, group, back, -nu)


def identity(group: Group) -> Derivation:
    """f = (e, 0); lem. (LieGroup). It has no inputs."""
    d = Derivation("identity", "the state of rest at the identity", "lem. (LieGroup)")
    return _given(d, group, Matrix(group.identity), zeros(group.dim, 1))


def sliding(group: Group, law: KinematicLaw) -> Derivation:
    """s(h) = nu + lambda nu_u(g), (n, 1); eq. (sldS)."""
    d = Derivation("sliding", "sliding variable of a state", "eq. (sldS)")
    gain = _gain(d)
    g, nu = _state(d, group)
    s = d.let("s", nu + gain * _law(d, group, law, g), group.unit, "sliding variable", d.source)
    d.give(_velocity("s", group, "sliding variable"), s)
    return d.pruned()


def above(group: Group, law: KinematicLaw) -> Derivation:
    """The state of H above g: (g, -lambda nu_u(g)); eq. (slidingsurfaceH)."""
    d = Derivation("above", "the state of H above a configuration", "eq. (slidingsurfaceH)")
    gain = _gain(d)
    g = d.take(_configuration("g", group))
    nu = d.let("nu", -gain * _law(d, group, law, g), group.unit, "the velocity that slides")
    return _given(d, group, g, nu)


def kinematics(group: Group, law: KinematicLaw) -> Derivation:
    """g -> nu_u and the clearance from its cut; def. (KctrLaw)."""
    d = Derivation("kinematics", f"kinematic law, {law.doc}", law.source)
    g = d.take(_configuration("g", group))
    written = law.write(d.let, group, g)
    d.give(_velocity("nu_u", group, "kinematic law", group.log_unit), written.value)
    near = "distance from the cut locus of the law"
    d.give(Quantity("clearance", 1, "1", near, is_scalar=True, place="clearance"),
           written.clearance)  # fmt: skip
    return d.pruned()


def _law(d: Derivation, group: Group, law: KinematicLaw, g: Matrix) -> Matrix:
    value = law.write(d.let, group, g).value
    found: Matrix = d.let("nu_u", value, group.log_unit, f"kinematic law, {law.doc}", law.source)
    return found


def _gain(d: Derivation) -> Expr:
    gain: Expr = d.take(Quantity("rate_gain", 1, "1/s", "lambda", is_scalar=True, place="lambda"))
    return gain


def _state(d: Derivation, group: Group, mark: str = "") -> tuple[Matrix, Matrix]:
    return d.take(_configuration(f"g{mark}", group)), d.take(_velocity(f"nu{mark}", group))


def _configuration(name: str, group: Group) -> Quantity:
    return Quantity(name, group.size, "1", f"configuration: {group.storage}", place=name)


def _velocity(name: str, group: Group, doc: str = "body velocity", unit: str = "") -> Quantity:
    return Quantity(name, group.dim, unit or group.unit, doc, place=name)


def _given(d: Derivation, group: Group, g: Matrix, nu: Matrix) -> Derivation:
    d.give(_configuration("g", group), g)
    d.give(_velocity("nu", group), nu)
    return d.pruned()

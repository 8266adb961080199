"""The static stack is the longest path of the call graph, and has a bound or is refused."""

import pytest

from derive.evidence.stack import Depth, Graph, Unbounded, graph

CI = r"""graph: { title: "a.c"
node: { title: "a.c:law" label: "law\na.c:41:13\n80 bytes (static)" }
node: { title: "a.c:small" label: "small\na.c:7:1\n16 bytes (static)" }
node: { title: "control" label: "control\na.c:9:1\n56 bytes (static)" }
edge: { sourcename: "control" targetname: "a.c:small" label: "a.c:10:1" }
edge: { sourcename: "control" targetname: "a.c:law" label: "a.c:11:1" }
edge: { sourcename: "control" targetname: "a.c:law" label: "a.c:12:1" }
node: { title: "memset" label: "__builtin_memset\n<built-in>" shape : ellipse }
edge: { sourcename: "a.c:small" targetname: "memset" }
}
"""


def test_the_deepest_path_counts_and_what_is_outside_is_named() -> None:
    found = graph(CI).depth("control")
    assert found == Depth(136, ("control", "law"), frozenset({"memset"}))
    assert graph(CI).depth("a.c:law") == Depth(80, ("law",))


def test_recursion_has_no_bound() -> None:
    around = Graph({"a": 8, "b": 8}, {"a": ("b",), "b": ("a",)})
    with pytest.raises(Unbounded, match="a -> b -> a: recursion"):
        around.depth("a")


@pytest.mark.parametrize("kind", ["dynamic", "dynamic,bounded"])
def test_a_frame_of_unknown_size_has_no_bound(kind: str) -> None:
    with pytest.raises(Unbounded, match=f"law: its frame is {kind}"):
        graph(CI.replace("80 bytes (static)", f"80 bytes ({kind})"))

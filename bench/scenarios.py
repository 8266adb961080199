"""Pictures and the tables of docs/simulations.md and README.md: python -m bench.scenarios."""

from __future__ import annotations

import re
from pathlib import Path

from derive import comparison, folder, pipeline
from derive.simulate import claim_table
from derive.vehicle import load

ROOT = Path(__file__).parents[1]
DOCS = ROOT / "docs"
VEHICLE = ROOT / "vehicles" / "paper_so3.toml"
SHOWN = re.compile(r"scenario1(_s|_axis)?\.svg")
TABLE = re.compile(r"(?<=<!-- claims -->\n).*?(?=<!-- end of claims -->)", re.DOTALL)


def main() -> None:
    """Fly the paper's scenarios, and write what the documentation shows of them."""
    found = comparison.scenarios(
        load(VEHICLE), pipeline.cache_folder(), (1, 2, 3), "f64", lambda _: None
    )
    print(found.table())
    files = comparison.documents(found, lambda _: None)
    shown = {name: content for name, content in files.items() if SHOWN.fullmatch(name)}
    whole = renewed(DOCS / "simulations.md", claim_table.markdown(found.claims))
    folder.save_all(DOCS, {**shown, "simulations.md": whole.encode()})
    folder.save(ROOT / "README.md", renewed(ROOT / "README.md", claim_table.brief(found.claims)))


def renewed(page: Path, table: str) -> str:
    """The text of a page with another table between its marks."""
    return TABLE.sub(lambda _: f"\n{table}\n", page.read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()

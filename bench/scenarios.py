"""Pictures and the table of docs/simulations.md, made anew: python -m bench.scenarios."""

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
    page = DOCS / "simulations.md"
    table = f"\n{claim_table.markdown(found.claims)}\n"
    told = TABLE.sub(lambda _: table, page.read_text(encoding="utf-8"))
    folder.save_all(DOCS, {**shown, page.name: told.encode()})


if __name__ == "__main__":
    main()

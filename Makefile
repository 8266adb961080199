# make        set up .venv, hold generated/ to the vehicles, verify the paper's controller
# make test   set up the test tools and run everything that can fail
# make emit   derive and write generated/ for every vehicle
# make bench  operations, instructions and throughput
# make clean  remove what the above made, but for generated/

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check --quiet
VEHICLES := $(sort $(wildcard vehicles/*.toml))

.DEFAULT_GOAL := verify
.DELETE_ON_ERROR:
.PHONY: verify test emit evidence bench clean

verify: $(VENV)/core.stamp
	$(BIN)/derive check $(VEHICLES)
	$(BIN)/derive verify vehicles/paper_so3.toml
	$(BIN)/derive verify vehicles/paper_s3.toml

test: $(VENV)/test.stamp
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy
	$(BIN)/python -m pytest --numprocesses auto --dist worksteal

emit: $(VENV)/core.stamp
	$(BIN)/derive emit $(VEHICLES)

evidence: $(VENV)/evidence.stamp
	$(BIN)/derive evidence $(VEHICLES)

bench: $(VENV)/test.stamp
	$(BIN)/python -m bench

clean:
	rm -rf $(VENV) build dist report .hypothesis .mypy_cache .pytest_cache .ruff_cache
	find derive tests bench -name __pycache__ -prune -exec rm -rf {} + 2>/dev/null || true

# One environment; a stamp says which of its extras are installed, and from which lists.
$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo 'Python 3.11 or newer is needed: make PYTHON=/path/to/python3' >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' || \
		{ echo 'the venv module is missing; on Debian: apt install python3-venv' >&2; exit 1; }
	@echo 'setting up $(VENV)'
	@$(PYTHON) -m venv $(VENV)

$(VENV)/core.stamp: pyproject.toml constraints.txt | $(BIN)/python
	@echo 'installing derive'
	@$(PIP) install --constraint constraints.txt --editable .
	@touch $@

$(VENV)/test.stamp: pyproject.toml constraints.txt | $(BIN)/python
	@echo 'installing derive and its test tools'
	@$(PIP) install --constraint constraints.txt --editable '.[test]'
	@touch $@ $(VENV)/core.stamp

$(VENV)/evidence.stamp: pyproject.toml constraints.txt | $(BIN)/python
	@echo 'installing derive and the tools of its evidence'
	@$(PIP) install --constraint constraints.txt --editable '.[evidence]'
	@touch $@ $(VENV)/core.stamp

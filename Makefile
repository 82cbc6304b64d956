# Everything below sets itself up: a machine with Python 3.11 and make is enough.
NEW_ENOUGH = import sys; sys.exit(sys.version_info < (3, 11))
PYTHON ?= $(shell for python in python3.11 python3 python3.12 python3.13 python3.14 python; do \
	$$python -c '$(NEW_ENOUGH)' 2>/dev/null && { echo $$python; break; }; done)
BIN = .venv/bin
RUNS = .venv/.run
SITE = .venv/.site
READY = .venv/.ready
TOOLS = .venv/.release
MODULES = node_modules/.package-lock.json
RELEASE = $(TOOLS)/bin/python release.py
LAWS = setup.py $(wildcard pointpred/laws/*.[ch])
OBSERVERS_LAWS = $(wildcard observers/pointpred_observers/laws/*.[ch])
INSTALL = -m pip install --quiet --disable-pip-version-check -c constraints.txt --editable

.PHONY: run demo test check format bench load load-short soak faults observers sanitize npm container laws package release release-again release-check strangers docs results train sample inputs audit fuzz fuzz-inputs clean help

help:  ## show these lines
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## /\t/' | expand -t 16

run: $(RUNS)  ## set up and serve the live page on 127.0.0.1
	$(BIN)/pointpred serve

demo: $(RUNS)  ## write the page for a static host into FOLDER (demo)
	$(BIN)/pointpred demo --force --out '$(or $(FOLDER),demo)'

test: $(READY)  ## set up and run every test
	$(BIN)/python -m pytest -n 3 --dist loadfile -q --durations=10

check: $(READY) $(MODULES)  ## lint, format and types
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	if test -d node_modules; then npm run --silent check; fi

format: $(READY) $(MODULES)  ## format the code
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .
	if test -d node_modules; then npm run --silent format; fi

$(MODULES): package-lock.json
	if command -v npm >/dev/null; then npm ci --silent --no-audit --no-fund && touch $@; \
		else echo "no npm: the JavaScript is not checked"; fi

bench: $(READY)  ## measure the cost of each pipeline, and of the service
	$(BIN)/python -m evidence costs per_event
	$(BIN)/python -m evidence costs service $(if $(BEFORE),--before '$(BEFORE)')
	$(BIN)/python -m evidence

load: $(READY)  ## measure delays under load, in ten minutes; BEFORE=COMMIT adds a build
	$(BIN)/python -m evidence costs load $(if $(BEFORE),--before '$(BEFORE)')
	$(BIN)/python -m evidence

load-short: $(READY)  ## print the same tables in two minutes, from shorter runs; writes nothing
	$(BIN)/python -m evidence costs load --short $(if $(BEFORE),--before '$(BEFORE)')

soak: $(READY)  ## mixed clients against a real service for MINUTES (60), every prediction compared
	$(BIN)/python -m evidence costs soak $(MINUTES)
	$(BIN)/python -m evidence

faults: $(READY)  ## inject faults: full, read-only and slow disks, clocks, cut networks, signals, limits
	$(BIN)/python -m pytest -q -m '' tests/faults tests/server/test_recorder_killed.py tests/server/test_rolling_restart.py \
		tests/server/test_study_page.py tests/unit/test_batch.py

observers: $(READY)  ## the longer tests of observers: random plants in other units, every figure of the sources
	$(BIN)/python -m pytest -q -m slow observers/tests tests/reproduction

npm: $(READY)  ## install, build and drive the npm package with bundlers, frameworks and drivers, in some minutes
	$(BIN)/python -m pytest -q -m slow tests/intent

sanitize: $(READY)  ## run the laws in C under the sanitizers of addresses and undefined behaviour, with gcc
	$(BIN)/python -m pytest -q -m slow tests/architecture

container: $(READY)  ## build the image pointpred with docker or podman, run it alone and behind a proxy; BASE, PROXY name other images
	BASE='$(BASE)' PROXY='$(or $(PROXY),haproxy:2.6)' $(BIN)/python -m pytest -q -s -m slow tests/operations/test_container.py

laws:  ## after a change of a law: write its C and JavaScript, compile what changed (FORCE=--force: all)
	test -x $(BIN)/python || $(MAKE) $(READY)
	$(BIN)/python -m translation
	for folder in . observers; do (cd "$$folder" && '$(CURDIR)/$(BIN)/python' setup.py -q build_ext --inplace $(FORCE)) || exit; done
	touch $(RUNS) $(READY)

package: $(MODULES)  ## pack the npm package, with its files for a script tag, into dist
	mkdir -p dist
	cd server/pointpred_server/web/lib && npm pack --silent --pack-destination '$(CURDIR)/dist'

release: $(TOOLS)  ## build every file of the release into dist, and say what is left to do
	$(RELEASE) build

release-again: $(TOOLS)  ## build the release a second time, elsewhere, and compare every byte with dist
	$(RELEASE) again

release-check: $(TOOLS)  ## compare dist with the version, the tag and the changelog
	$(RELEASE) check

strangers:  ## install what lies in dist into empty environments, and use it as its users do
	'$(PYTHON)' tests/strangers.py dist

docs: $(READY)  ## write the pages made from code and from the measured numbers in evidence/
	$(BIN)/python -m evidence

.PHONY: site site-check
site: $(SITE)  ## build the site of all pages, with search and the live page, into FOLDER (site)
	$(if $(FOLDER),,rm -rf site)
	$(BIN)/python -m sphinx -q -W --keep-going -E -d .venv/.site-read -c evidence/site . '$(or $(FOLDER),site)'
	$(BIN)/pointpred demo --force --out '$(or $(FOLDER),site)/demo'

site-check: $(READY)  ## build the site, check every link, and look at it in Chromium
	$(BIN)/python -m pytest -q -m slow tests/contract/test_site.py

results: $(READY)  ## score every predictor on the recordings in POINTPRED_RECORDINGS and the sample
	$(BIN)/python -m evidence results
	$(BIN)/python -m evidence

train: $(READY)  ## fit kinematic's coefficients to the recordings in POINTPRED_RECORDINGS
	$(BIN)/python -m evidence results train

sample: $(READY)  ## generate the embedded sample again (same bytes)
	$(BIN)/python -m pointpred.datasets.generate

fuzz: $(READY)  ## fuzz every parser, FUZZ_SECONDS (240) each; the inputs that reach most are kept
	$(BIN)/python -m pip install --quiet --disable-pip-version-check 'atheris>=3.0'
	$(BIN)/python -m tests.fuzz.campaign $(FUZZ_TARGETS)
	$(BIN)/python -m evidence

audit: $(READY)  ## check the licences of all packages, and look for known weaknesses in their versions
	$(BIN)/python -m pytest -q tests/architecture/test_licences.py
	'$(PYTHON)' -m venv .venv/.audit
	.venv/.audit/bin/python -m pip install --quiet --disable-pip-version-check 'pip-audit>=2.9'
	.venv/.audit/bin/pip-audit --strict --no-deps --disable-pip --requirement constraints.txt

inputs: $(READY)  ## read the public recordings in FOLDER twice, and compare
	$(BIN)/python -m evidence inputs '$(FOLDER)'
	$(BIN)/python -m evidence

fuzz-inputs: $(READY)  ## read damaged copies of the public recordings in FOLDER
	$(BIN)/python -m tests.fuzz.inputs '$(FOLDER)'

clean:  ## remove the environment and every cache
	rm -rf .venv .mypy_cache .ruff_cache .pytest_cache .hypothesis build dist site *.egg-info
	rm -rf server/build server/*.egg-info observers/build observers/*.egg-info
	rm -f pointpred/_laws.* observers/pointpred_observers/_laws.*
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# What running needs, and nothing that only tests, reports, cameras or observers do.
$(RUNS): pyproject.toml server/pyproject.toml constraints.txt $(LAWS)
	@'$(PYTHON)' -c '$(NEW_ENOUGH)' 2>/dev/null || { echo "pointpred needs Python 3.11 or later," \
		"and '$(PYTHON)' is not: name another with make PYTHON=/path/to/python3.11" >&2; exit 1; }
	@echo 'installing what running needs into .venv, about half a minute' >&2
	'$(PYTHON)' -m venv .venv
	$(BIN)/python $(INSTALL) '.[live,client]' --editable server
	$(BIN)/python -m compileall -q pointpred server
	touch $(RUNS)

# An environment of its own: a release needs a compiler of 400 MB, and nothing that the tests need.
$(TOOLS): setup.py constraints.txt
	'$(PYTHON)' -m venv --clear $(TOOLS)
	$(TOOLS)/bin/python -m pip install --quiet --disable-pip-version-check -c constraints.txt setuptools
	$(TOOLS)/bin/python -m pip install --quiet --disable-pip-version-check cyclonedx-bom==7.5.0 \
		"$$($(TOOLS)/bin/python -c 'import setup; print(setup.ZIGLANG)')"
	touch $(TOOLS)

$(SITE): evidence/site/requirements.txt constraints.txt | $(RUNS)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -r evidence/site/requirements.txt
	touch $(SITE)

$(READY): $(RUNS) observers/pyproject.toml $(OBSERVERS_LAWS)
	@echo 'installing what the tests need into .venv, about a minute' >&2
	$(BIN)/python $(INSTALL) '.[dev]' \
		--editable observers
	touch $(READY)

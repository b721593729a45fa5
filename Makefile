# Raywalk. `make` builds the site, `make test` tests it; `make help` lists the rest.

PYTHON := .venv/bin/python
# Files below .venv and node_modules that say "these locked packages are installed".
PYTHON_READY := .venv/.ready
TEST_READY := .venv/.ready-for-tests
NODE_READY := node_modules/.ready
# In an environment of its own: its 28 packages must not decide which versions the tests run with.
MUTANTS := .venv/mutants

# Several targets are also names of folders (build/ is our source, dist/ our output): without
# .PHONY make would look at the folder's date and do nothing.
.PHONY: all packages site slides teacher kiosk package test test-busy check serve bench stress mutants clean distclean help versions
.DEFAULT_GOAL := all

all: site
	@echo
	@echo "Open dist/index.html in a browser: it needs no server. Or: make serve"

# Python keeps its bytecode, whatever the shell says: without it each command would compile 560 modules first, for as
# long again as a check of a scene takes.
unexport PYTHONDONTWRITEBYTECODE

# With TIMES=1 a command says how long it took, into a file that the build's table begins with.
TIMES_OF_MAKE := .work/times-of-make.jsonl
timed = $(if $(TIMES),python3 build/setup/timed.py $(TIMES_OF_MAKE) "$(1)")

site: packages ## trace the scenes and build the site into dist/; TIMES=1 tells where the time goes
	@$(PYTHON) -m raywalk site $(if $(TIMES),--times $(TIMES_OF_MAKE))

# Python's and npm's at the same time. What else needs them waits for this target, not for their files: so only this one
# make ever installs them, whatever -j says.
packages:
	@$(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,-j2) $(PYTHON_READY) $(NODE_READY)

# Another shape or other colours than the site's are made on demand: they would double what it weighs.
SLIDES_AS := $(if $(ASPECT),--aspect $(ASPECT)) $(if $(PALETTE),--palette $(PALETTE))
SLIDES_TO := slides/$(subst :,x,$(or $(ASPECT),16:9))$(if $(PALETTE),-$(PALETTE))

slides: site ## slides of all lessons: dist/slides/; also make slides ASPECT=4:3 PALETTE=print
ifeq ($(strip $(SLIDES_AS)),)
	@ls dist/slides
else
	@for scene in scenes/*/scene.toml; do \
		$(PYTHON) -m raywalk slides $$scene $(SLIDES_AS) --out $(SLIDES_TO) \
			--format decks,handouts || exit 1; done
	@$(PYTHON) -m raywalk slides course $(SLIDES_AS) --format pdf,pptx --out $(SLIDES_TO)
endif

teacher: packages ## guide, answers, assignments, quizzes for teachers: dist-teacher/raywalk-teacher.zip
	@$(PYTHON) -m raywalk teacher

kiosk: site ## one zip for a locked touch screen: dist-kiosk/raywalk-kiosk.zip
	@$(PYTHON) -m raywalk kiosk

package: packages ## what `pip install` takes, a wheel and an sdist: dist-package/
	@rm -rf dist-package
	@$(PYTHON) build/setup/package.py

test: site $(TEST_READY) ## check types and style, run the tests, in a real browser too
	@sh build/setup/browser.sh
	@$(PYTHON) -m tests.run_all

test-busy: site $(TEST_READY) ## the same beside eight busy processes: slowness alone must fail nothing
	@sh build/setup/browser.sh
	@sh tests/busy.sh $(PYTHON) -m tests.run_all --once

check: $(PYTHON_READY) ## validate the scenes without tracing them
	@$(PYTHON) -m raywalk check

serve: packages ## the site at http://127.0.0.1:8000/, built anew whenever a file is saved
	@$(PYTHON) -m raywalk serve

bench: site $(TEST_READY) ## measure run time against error, beside peers (about half an hour, on a machine that does nothing else)
	@$(PYTHON) -m raywalk bench

stress: site $(TEST_READY) ## every case of each test; the hardest ones against their bounds; a kiosk for half an hour (about 70 minutes)
	@sh build/setup/browser.sh firefox
	@$(PYTHON) -m tests.run_all --every
	@$(PYTHON) -m raywalk stress

mutants: $(TEST_READY) $(MUTANTS)/.ready ## change sources and see that a test fails: SAMPLE=200 SEED=1 ONLY=optics JOBS=2; all of them take a night
	@$(MUTANTS)/bin/python tests/mutants/run.py $(if $(SAMPLE),--sample $(SAMPLE)) $(if $(SEED),--seed $(SEED)) \
		$(if $(JOBS),--jobs $(JOBS)) $(if $(ONLY),--only $(ONLY))

clean: ## remove what was built; keeps installed packages
	rm -rf dist dist-kiosk dist-package dist-teacher dist.*.partial .work test-output
	@# compiled kernels too: each state of their sources has left a folder
	find build tests -name __pycache__ -prune -exec rm -rf {} +

distclean: clean ## remove installed packages too
	rm -rf .venv node_modules

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /\1|/p' Makefile | while IFS='|' read -r verb words; do \
		printf 'make %-10s %s\n' "$$verb" "$$words"; done

versions:
	@sh build/setup/versions.sh

# --no-deps: the lock file already names everything, with hashes. Wheels only, and no script of a package's: installing
# runs nobody's code.
PIP_INSTALL := $(PYTHON) -m pip install --quiet --disable-pip-version-check --no-compile --no-deps
$(PYTHON_READY): requirements.lock pyproject.toml build/setup/venv.sh | versions
	@$(call timed,make .venv) sh build/setup/venv.sh
	$(call timed,install Python's packages) $(PIP_INSTALL) --require-hashes --only-binary=:all: -r requirements.lock
	$(call timed,install this one) $(PIP_INSTALL) --no-build-isolation --editable .
	@touch $@

$(TEST_READY): requirements-test.lock requirements.lock pyproject.toml | packages
	$(PIP_INSTALL) --require-hashes --only-binary=:all: -r requirements-test.lock
	@touch $@

$(MUTANTS)/.ready: requirements-mutants.lock | packages
	$(PYTHON) -m venv --clear $(MUTANTS)
	$(MUTANTS)/bin/python -m pip install --quiet --disable-pip-version-check --require-hashes --no-deps --only-binary=:all: -r requirements-mutants.lock
	@touch $@

$(NODE_READY): package-lock.json | versions
	$(call timed,install npm's packages) npm ci --prefer-offline --ignore-scripts --no-audit --no-fund --loglevel=error
	@touch $@

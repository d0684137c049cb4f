"""What the commands do: each takes the parsed options and returns its exit status (see `status`).

The module of a command is imported only when the command runs, so that `--help` and `validate` are quick.
"""

from __future__ import annotations

import argparse

from testbed.cli import completion
from testbed.cli.catalogue import TABLE as CATALOGUE
from testbed.cli.status import MET, NOT_MET
from testbed.cli.working import working


def fly(options: argparse.Namespace) -> int:
    from testbed.cli import flight

    return MET if flight.fly(options) else NOT_MET


def sweep(options: argparse.Namespace) -> int:
    from testbed.cli import sweep

    return sweep.fly(options)


def search(options: argparse.Namespace) -> int:
    from testbed.cli import search

    return search.search(options)


def report(options: argparse.Namespace) -> int:
    from testbed.api.load import is_search_folder, is_sweep_folder, names_kept_log

    if names_kept_log(options.folder):
        from testbed.cli import sweep

        return sweep.report_run(options.folder)
    if is_search_folder(options.folder):
        from testbed.cli import search

        return search.report(options.folder)
    if is_sweep_folder(options.folder):
        from testbed.cli import sweep

        return sweep.report(options.folder)
    from testbed.cli import flight

    return flight.report(options.folder)


def compare(options: argparse.Namespace) -> int:
    from testbed.cli import comparing

    return comparing.compare(options.runs, options.out)


def export(options: argparse.Namespace) -> int:
    from testbed.cli import export

    export.export(options.run, options.to, options.out, options.origin)
    return MET


def validate(options: argparse.Namespace) -> int:
    from testbed.cli import checked

    with working("checking"):
        checked.validate(options.files)
    return MET


def identify(options: argparse.Namespace) -> int:
    from testbed.cli import aircraft

    with working("identifying"):
        same = aircraft.identify(options.aircraft, check=options.check)
    return MET if same else NOT_MET


def design(options: argparse.Namespace) -> int:
    from testbed.cli import design

    return MET if design.design(options) else NOT_MET


def adopt(options: argparse.Namespace) -> int:
    from testbed.cli import adopt

    with working("adopting"):
        adopt.adopt(options.model, options.out)
    return MET


def certify(options: argparse.Namespace) -> int:
    from testbed.cli import certify

    certify.certify(options)
    return MET


def schema(options: argparse.Namespace) -> int:
    from testbed.cli import schema

    schema.write(options.kind, options.out)
    return MET


def init(options: argparse.Namespace) -> int:
    from testbed.cli import project

    project.make(options.folder, options.aircraft or project.USUAL)
    return MET


def list_names(options: argparse.Namespace) -> int:
    for what in [options.what] if options.what else CATALOGUE:
        print(what)
        entries = CATALOGUE[what]()
        width = max((len(name) for name, _ in entries), default=0) + 2
        for name, meaning in entries:
            print(f"  {name:<{width}}{meaning}")
    return MET


def print_completion(options: argparse.Namespace) -> int:
    print(completion.script(options.shell), end="")
    return MET

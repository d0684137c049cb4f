"""`testbed adopt`: make an aircraft of a JSBSim model, and print its card."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from testbed.cli.command import add_out
from testbed.cli.ending import MET
from testbed.cli.terminal import working

PURPOSE = "make an aircraft of a JSBSim model, in a folder of its own, and print its card"
EXAMPLES = ("testbed adopt c172p", "testbed adopt ./my_model --out aircraft/mine")


def arguments(command: ArgumentParser) -> None:
    meaning = "name of a model in the jsbsim package, such as c172p, or a model's folder"
    command.add_argument("model", help=meaning)
    add_out(command, "DIR", "folder to make (default: the model's name, here)")


def run(options: Namespace) -> int:
    """Adopt a model into a folder; raises BadInput with what is missing."""
    from testbed.adoption import entry
    from testbed.adoption.files import FILE

    with working("adopting"):
        folder, card = entry.adopt(options.model, options.out)
    print(card)
    print(f"\nwrote {folder}; break it with: testbed run {folder / FILE}")
    return MET

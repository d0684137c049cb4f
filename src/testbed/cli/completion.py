"""`testbed completion`: commands, options and shipped scenarios in a shell, by argcomplete (the `completion` extra)."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace

from testbed.cli.ending import MET
from testbed.inputs.problems import BadInput, Problem

PURPOSE = "print the completion script of a shell"
EXAMPLES = ("testbed completion bash > ~/.local/share/bash-completion/completions/testbed",)

SHELLS = ("bash", "zsh", "fish")
_ZSH_HEAD = "#compdef "


def arguments(command: ArgumentParser) -> None:
    command.add_argument("shell", choices=SHELLS)


def run(options: Namespace) -> int:
    """Print the script that a shell has to source; raises BadInput if argcomplete is not installed."""
    try:
        from argcomplete.shell_integration import shellcode
    except ImportError:
        what = "completion needs argcomplete"
        raise BadInput([Problem(what, expected="pip install 'testbed[completion]'")]) from None
    lines = shellcode(["testbed"], shell=options.shell).splitlines(keepends=True)
    if options.shell != "zsh" and lines[0].startswith(_ZSH_HEAD):  # bash and zsh share a script
        lines = lines[1:]
    print("".join(lines), end="")
    return MET

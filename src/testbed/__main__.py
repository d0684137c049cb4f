"""The command line, as `python -m testbed`."""

import sys

from testbed.cli.commands import main

if __name__ == "__main__":
    sys.exit(main())

"""`derive` and `python -m derive`: so small that Ctrl-C ends it quietly while all else loads."""

import signal
import sys

INTERRUPTED = 130


def main() -> None:
    """Run the command line; Ctrl-C and SIGTERM end it alike, with all that it began undone."""
    try:
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        from derive import cli

        cli.main()
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        sys.exit(INTERRUPTED)


if __name__ == "__main__":
    main()

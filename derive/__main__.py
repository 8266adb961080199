"""`python -m derive`: the same command as the installed `derive`."""

from derive.cli import main

if __name__ == "__main__":
    main()

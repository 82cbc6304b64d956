"""``python -m pointpred`` is the ``pointpred`` command."""

from pointpred.cli import main

if __name__ == "__main__":
    main()

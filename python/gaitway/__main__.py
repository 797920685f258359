"""`python -m gaitway` is the command `gaitway`."""

from gaitway._command import main

main()

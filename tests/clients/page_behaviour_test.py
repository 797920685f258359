"""Runs the test of the behaviour on the page in a browser (page_behaviour_test.mjs): the page against a robot of the test's own, which has the
description that the real module serves."""
from module_alone import module_alone, run_in_browser

with module_alone() as port:
    run_in_browser("page_behaviour_test.mjs", port)

"""Runs the tests of the twin's part of the simulator's page in a browser (page_twin_test.mjs, page_twin_stop_test.mjs): the page against a
simulator of the test's own, which has a twin, and the description that the real module serves."""
from module_alone import module_alone, run_in_browser

with module_alone() as port:
    for script in ("page_twin_test.mjs", "page_twin_stop_test.mjs"):
        run_in_browser(script, port, timeout_s=140)

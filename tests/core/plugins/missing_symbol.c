/* A shared library, but no plug-in. */
const int gaitway_plugin_entries = 1;

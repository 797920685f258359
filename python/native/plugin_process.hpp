// The process of a plug-in in Python, as its interpreter sees it: what the plug-in is offered over the C ABI,
// and the ABI's functions made of its methods.
#pragma once

#include <nanobind/nanobind.h>

namespace gaitway::python {

void bind_plugin_process(nanobind::module_& module);

}  // namespace gaitway::python

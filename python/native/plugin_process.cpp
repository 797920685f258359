// The C ABI in both directions. The interpreter's lock is held in the plug-in's code alone, so that its
// threads run while it waits for the manager.
#include "plugin_process.hpp"

#include <fmt/format.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/plugin/detail/plugin_border.hpp"
#include "isolation/child_program.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace gaitway::python {
namespace {

class SetupRefusal : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Throws SetupRefusal with what the manager says, which it recognises when it comes back.
template <class Function>
void ask(const Function& function) {
  detail::ErrorBuffer text;
  const gaitway_text error = text.text();
  if (function(&error) != GAITWAY_OK) throw SetupRefusal(text.message());
}

// A topic that the plug-in has opened, with the memory of its value: arrays lie over it.
class PluginPort {
 public:
  PluginPort(const gaitway_host& host, gaitway_port* port, std::string topic, std::uint32_t bytes,
             gaitway_access access)
      : host_(&host),
        port_(port),
        topic_(std::move(topic)),
        bytes_(bytes),
        writes_(access == GAITWAY_WRITE),
        words_((bytes + 7U) / 8U) {}

  // False: there has never been a value.
  bool refresh() {
    if (host_->read(host_->context, port_, words_.data(), &sample_) == GAITWAY_FAILED) {
      throw std::logic_error(fmt::format("topic '{}': has no values before activate()", topic_));
    }
    return sample_.sequence != 0;
  }
  void publish() {
    if (host_->publish(host_->context, port_, words_.data()) != GAITWAY_OK) {
      throw std::logic_error(fmt::format("topic '{}': publish() is for step() only", topic_));
    }
  }
  [[nodiscard]] std::uint64_t sequence() const noexcept { return sample_.sequence; }
  [[nodiscard]] std::int64_t stamp_ns() const noexcept { return sample_.stamp_ns; }
  int fill(PyObject* self, Py_buffer* buffer, int flags) {
    return PyBuffer_FillInfo(buffer, self, words_.data(), bytes_, writes_ ? 0 : 1, flags);
  }

 private:
  const gaitway_host* host_;
  gaitway_port* port_;
  std::string topic_;
  std::uint32_t bytes_;
  bool writes_;
  std::vector<std::uint64_t> words_;  // never resized
  gaitway_sample sample_{};
};

int get_port_buffer(PyObject* self, Py_buffer* buffer, int flags) {
  PluginPort* port = nullptr;
  if (!nb::try_cast(nb::handle(self), port) || port == nullptr) {
    PyErr_SetString(PyExc_BufferError, "a port of nothing: ports come from a plug-in's set-up");
    return -1;
  }
  return port->fill(self, buffer, flags);
}

PyType_Slot port_slots[] = {{Py_bf_getbuffer, reinterpret_cast<void*>(&get_port_buffer)}, {0, nullptr}};

nb::object as_object(const gaitway_value& value) {
  switch (value.kind) {
    case GAITWAY_INTEGER:
      return nb::int_(value.integer);
    case GAITWAY_FLAG:
      return nb::bool_(value.integer != 0);
    case GAITWAY_TEXT:
      return nb::str(value.text);
    default:
      return nb::float_(value.number);
  }
}

// `text` keeps a text's bytes.
gaitway_value as_value(nb::handle object, std::string& text) {
  if (nb::isinstance<nb::bool_>(object))
    return {GAITWAY_FLAG, 0, 0.0, nb::cast<bool>(object) ? 1 : 0, nullptr};
  if (nb::isinstance<nb::int_>(object))
    return {GAITWAY_INTEGER, 0, 0.0, nb::cast<std::int64_t>(object), nullptr};
  if (nb::isinstance<nb::float_>(object)) return {GAITWAY_NUMBER, 0, nb::cast<double>(object), 0, nullptr};
  if (!nb::isinstance<nb::str>(object)) {
    throw nb::type_error("a parameter's default is a float, an int, a bool or a str");
  }
  text = nb::cast<std::string>(object);
  return {GAITWAY_TEXT, 0, 0.0, 0, text.c_str()};
}

// What the manager offers to the plug-in.
class PluginHost {
 public:
  explicit PluginHost(const gaitway_host& host) : host_(&host) {}

  // Of a field: name, offset, count, bytes of a number, rows, lowest and highest.
  using Field =
      std::tuple<std::string, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, double, double>;
  PluginPort open_topic(const std::string& name, const std::string& type, std::uint64_t hash,
                        std::uint32_t bytes, const std::vector<Field>& fields, gaitway_access access) const {
    std::vector<gaitway_float_field> floats;
    for (const auto& [field, offset, count, size, rows, lowest, highest] : fields) {
      floats.push_back({field.c_str(), offset, count, size, rows, lowest, highest});
    }
    const gaitway_topic topic{.name = name.c_str(),
                              .type_name = type.c_str(),
                              .type_hash = hash,
                              .size = bytes,
                              .float_field_count = static_cast<std::uint32_t>(floats.size()),
                              .float_fields = floats.data()};
    gaitway_port* port = nullptr;
    ask([&](const gaitway_text* error) {
      return host_->open_topic(host_->context, &topic, access, &port, error);
    });
    return {*host_, port, name, bytes, access};
  }
  nb::object parameter(const std::string& name, const std::string& unit, const std::string& doc,
                       nb::handle fallback, double lowest, double highest, bool live) const {
    std::string text;
    const gaitway_parameter wanted{.name = name.c_str(),
                                   .unit = unit.c_str(),
                                   .doc = doc.c_str(),
                                   .fallback = as_value(fallback, text),
                                   .lowest = lowest,
                                   .highest = highest,
                                   .live = live ? 1U : 0U,
                                   .reserved = 0};
    gaitway_value value{};
    ask([&](const gaitway_text* error) { return host_->parameter(host_->context, &wanted, &value, error); });
    return as_object(value);
  }
  void set_period(gaitway_period period) const {
    ask([&](const gaitway_text* error) { return host_->set_period(host_->context, period, error); });
  }
  [[nodiscard]] std::string robot_directory() const { return host_->robot_directory(host_->context); }
  void report(gaitway_severity severity, const std::string& text) const {
    host_->report(host_->context, severity, text.c_str());
  }

 private:
  const gaitway_host* host_;
};

// The one plug-in of this process: what its file gave, and what describes an exception. Lives until the
// process ends.
struct PluginFile {
  std::string name, version, description;
  nb::object create, describe;

  [[nodiscard]] std::string text_of(const nb::python_error& error) const {
    return nb::cast<std::string>(describe(error.value()));
  }
};
PluginFile* file = nullptr;

// No exception leaves it.
template <class Function>
gaitway_status guarded(const gaitway_text* error, const Function& function) noexcept {
  const nb::gil_scoped_acquire hold;
  try {
    try {
      function();
      return GAITWAY_OK;
    } catch (const nb::python_error& problem) {
      detail::write_text(error, file->text_of(problem).c_str());
    }
  } catch (const std::exception& problem) {
    detail::write_text(error, problem.what());
  }
  return GAITWAY_FAILED;
}

// The instance that `create` of the file made, as the ABI has one.
struct PluginObject {
  nb::object methods, step, live;
  std::uint32_t state_version = 0;

  static PluginObject& of(void* context) noexcept { return *static_cast<PluginObject*>(context); }

  static gaitway_status create(const gaitway_host* host, gaitway_instance* instance,
                               const gaitway_text* error) noexcept {
    return guarded(error, [&] {
      auto made = std::make_unique<PluginObject>();
      made->methods = file->create(PluginHost(*host));
      made->step = made->methods.attr("step");
      made->live = made->methods.attr("live");
      made->state_version = nb::cast<std::uint32_t>(made->methods.attr("state_version"));
      *instance = {made.release(), &activate,      &run_step,     &deactivate,
                   &destroy,       &set_parameter, &get_extension};
    });
  }
  static gaitway_status activate(void* context, const gaitway_text* error) noexcept {
    return guarded(error, [&] { of(context).methods.attr("activate")(); });
  }
  static gaitway_status run_step(void* context, const gaitway_tick* tick,
                                 const gaitway_text* error) noexcept {
    return guarded(error, [&] { of(context).step(*tick); });
  }
  static gaitway_status deactivate(void* context, const gaitway_text* error) noexcept {
    return guarded(error, [&] { of(context).methods.attr("deactivate")(); });
  }
  static void destroy(void* context) noexcept {
    const nb::gil_scoped_acquire hold;
    delete &of(context);
  }
  static gaitway_status set_parameter(void* context, const char* name, const gaitway_value* value,
                                      const gaitway_text* error) noexcept {
    return guarded(error, [&] {
      const nb::object live = of(context).live;
      if (!nb::cast<bool>(live.attr("__contains__")(name))) {
        throw std::runtime_error("this parameter does not change while the plug-in runs");
      }
      nb::setattr(live[name], "value", as_object(*value));
    });
  }
  static const void* get_extension(void* context, const char* name) noexcept {
    static constexpr gaitway_state_functions kState{&save_state, &restore_state};
    return of(context).state_version != 0 && std::strcmp(name, GAITWAY_STATE_EXTENSION) == 0 ? &kState
                                                                                             : nullptr;
  }
  static gaitway_status save_state(void* context, gaitway_state* state, const gaitway_text* error) noexcept {
    return guarded(error, [&] {
      const auto bytes = nb::cast<nb::bytes>(of(context).methods.attr("save_state")());
      if (bytes.size() > state->capacity) {
        throw StateError("the state is larger than what a plug-in may hand on");
      }
      std::memcpy(state->data, bytes.c_str(), bytes.size());
      state->size = static_cast<std::uint32_t>(bytes.size());
      state->version = of(context).state_version;
    });
  }
  static gaitway_status restore_state(void* context, const gaitway_state* state,
                                      const gaitway_text* error) noexcept {
    return guarded(error, [&] {
      if (of(context).state_version != state->version) {
        throw StateError(fmt::format("takes over state of version {}, but was handed version {}",
                                     of(context).state_version, state->version));
      }
      of(context).methods.attr("restore_state")(nb::bytes(state->data, state->size));
    });
  }
};

// `load`: (file) -> (name, version, description, create). Throws PluginError.
const gaitway_plugin& load_file(const std::filesystem::path& path, const nb::object& load) {
  static gaitway_plugin entry{};
  const nb::gil_scoped_acquire hold;
  try {
    const nb::tuple loaded = nb::cast<nb::tuple>(load(path.string()));
    file->name = nb::cast<std::string>(loaded[0]);
    file->version = nb::cast<std::string>(loaded[1]);
    file->description = nb::cast<std::string>(loaded[2]);
    file->create = loaded[3];
  } catch (const nb::python_error& error) {
    throw core::PluginError(file->text_of(error));
  } catch (const std::exception& error) {  // a cast that fails
    throw core::PluginError(fmt::format("{}: {}", path.string(), error.what()));
  }
  entry = {GAITWAY_PLUGIN_HEAD, file->name.c_str(), file->version.c_str(), file->description.c_str(),
           &PluginObject::create};
  return entry;
}

// The rest of the process's life. Returns its exit code; what then remains of the interpreter must not be
// taken down.
int run_plugin(const std::vector<std::string>& words, const nb::object& load, const nb::object& describe) {
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  file = new PluginFile{.name = {}, .version = {}, .description = {}, .create = {}, .describe = describe};
  const nb::gil_scoped_release free;
  return core::run_child(arguments, [&load](const std::string& library, const std::filesystem::path& base,
                                            const core::SearchPath& path) {
    const std::filesystem::path found =
        std::filesystem::absolute(core::find_plugin_file(library, base, path));
    return core::PluginCode{load_file(found, load), found};
  });
}

}  // namespace

void bind_plugin_process(nb::module_& module) {
  nb::exception<SetupRefusal>(module, "SetupError", PyExc_RuntimeError);
  nb::class_<gaitway_tick>(module, "Tick")
      .def_ro("now_ns", &gaitway_tick::now_ns)
      .def_ro("batch_start_ns", &gaitway_tick::batch_start_ns)
      .def_ro("batch_sequence", &gaitway_tick::batch_sequence)
      .def_ro("tick", &gaitway_tick::tick)
      .def_prop_ro("batch", [](const gaitway_tick& tick) { return tick.batch != 0; });
  nb::class_<PluginPort>(module, "PluginPort", nb::type_slots(port_slots))
      .def("refresh", &PluginPort::refresh)
      .def("publish", &PluginPort::publish)
      .def_prop_ro("sequence", &PluginPort::sequence)
      .def_prop_ro("stamp_ns", &PluginPort::stamp_ns);
  nb::class_<PluginHost>(module, "PluginHost")
      .def("open_topic", &PluginHost::open_topic, "name"_a, "type_name"_a, "type_hash"_a, "size"_a,
           "float_fields"_a, "access"_a)
      .def("parameter", &PluginHost::parameter, "name"_a, "unit"_a, "doc"_a, "fallback"_a.none(), "lowest"_a,
           "highest"_a, "live"_a)
      .def("set_period", &PluginHost::set_period, "period"_a)
      .def("robot_directory", &PluginHost::robot_directory)
      .def("report", &PluginHost::report, "severity"_a, "text"_a);
  module.def("run_plugin", &run_plugin, "words"_a, "load"_a, "describe"_a);
}

}  // namespace gaitway::python

// The module gaitway._native: what Python sees of a run, as few calls as possible. The package gaitway
// around it is what people use.
#include <fmt/format.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <exception>
#include <stdexcept>

#include "gaitway/input/complaint.hpp"
#include "gaitway/instance/configuration.hpp"
#include "gaitway/msgclient/topic.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/installation.hpp"
#include "held_run.hpp"
#include "outside.hpp"
#include "plugin_process.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace gaitway::python {

void bind(nb::module_& module);

namespace {

constexpr std::int64_t kLongestAdvance_ms = 86'400'000;

// A Python buffer for the length of a call.
class Bytes {
 public:
  Bytes(nb::handle object, bool writable, std::size_t size) {
    if (PyObject_GetBuffer(object.ptr(), &buffer_, writable ? PyBUF_WRITABLE : PyBUF_SIMPLE) != 0) {
      throw nb::python_error();
    }
    if (static_cast<std::size_t>(buffer_.len) != size) {
      const auto found = buffer_.len;
      PyBuffer_Release(&buffer_);
      throw std::invalid_argument(fmt::format("{} bytes where the topic's type has {}", found, size));
    }
  }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;
  ~Bytes() { PyBuffer_Release(&buffer_); }
  [[nodiscard]] std::span<std::byte> value() const {
    return {static_cast<std::byte*>(buffer_.buf), static_cast<std::size_t>(buffer_.len)};
  }

 private:
  Py_buffer buffer_{};
};

const StandardTopic& topic_at(std::size_t topic) {
  if (topic >= kStandardTopics.size()) throw std::out_of_range("there is no topic of this number");
  return kStandardTopics[topic];
}

// Memory of a view as a read-only buffer, for NumPy.
struct HeldView {
  std::shared_ptr<TopicView> view;
};

int get_view_buffer(PyObject* self, Py_buffer* buffer, int flags) {
  HeldView* held = nullptr;
  if (!nb::try_cast(nb::handle(self), held) || held == nullptr || !held->view) {
    PyErr_SetString(PyExc_BufferError, "a view of nothing: views come from Robot.view()");
    return -1;
  }
  const std::span<std::byte> value = held->view->value();
  return PyBuffer_FillInfo(buffer, self, value.data(), static_cast<Py_ssize_t>(value.size()), 1, flags);
}

PyType_Slot view_slots[] = {{Py_bf_getbuffer, reinterpret_cast<void*>(&get_view_buffer)}, {0, nullptr}};

nb::list topics() {
  nb::list list;
  for (const StandardTopic& topic : kStandardTopics) {
    nb::list fields;
    for (const FieldDescriptor& field : topic.type->fields) {
      nb::list extents;
      for (std::uint32_t i = 0; i < field.rank; ++i) extents.append(field.extents[i]);
      fields.append(nb::make_tuple(std::string(field.name), std::string(scalar_name(field.type)),
                                   nb::tuple(extents), field.offset, std::string(field.unit),
                                   std::string(field.frame), std::string(field.doc), field.lowest,
                                   field.highest));
    }
    list.append(nb::make_tuple(std::string(topic.name), std::string(topic.type->name), topic.type->size,
                               topic.type->hash, std::string(topic.type->doc), std::string(topic.writer),
                               topic.period_ns, nb::tuple(fields)));
  }
  return list;
}

void check_duration(std::int64_t milliseconds) {
  if (milliseconds < 0 || milliseconds > kLongestAdvance_ms) {
    throw std::invalid_argument(fmt::format("{} ms: a run goes on by 0 to 86400 s", milliseconds));
  }
}

// Whatever changes runs is done without the interpreter's lock; views change with them, also where an
// exception ends it, so that no code of Python sees half a value.
template <class Work>
void change(std::span<HeldRun* const> held, const Work& work) {
  const Use use(held);
  std::exception_ptr thrown;
  {
    Outside outside;
    try {
      work(use.runs(), outside);
    } catch (...) {
      thrown = std::current_exception();
    }
  }
  for (RobotRun* const run : use.runs()) {
    if (run->is_whole()) run->refresh_views();
  }
  if (thrown) std::rethrow_exception(thrown);
}

using Runs = std::vector<RobotRun*>;

void advance(HeldRun& held, std::int64_t milliseconds) {
  check_duration(milliseconds);
  HeldRun* const one = &held;
  change(std::span(&one, 1), [milliseconds](const Runs& runs, const Outside& outside) {
    runs.front()->advance(milliseconds, [&outside] { outside.require_interpreter(); });
  });
}

void restart(HeldRun& held, std::uint64_t seed) {
  HeldRun* const one = &held;
  change(std::span(&one, 1), [seed](const Runs& runs, const Outside&) { runs.front()->restart(seed); });
}

void restore(HeldRun& held, const Snapshot& snapshot) {
  HeldRun* const one = &held;
  change(std::span(&one, 1), [&snapshot](const Runs& runs, Outside& outside) {
    runs.front()->restore(snapshot, [&outside] { outside.answer_signals(); });
  });
}

// Runs that an interpreter named, which live as long as this.
struct NamedRuns {
  explicit NamedRuns(const nb::sequence& sequence) {
    for (const nb::handle run : sequence) {
      held.push_back(nb::cast<HeldRun*>(run));
      kept.push_back(nb::borrow(run));
    }
  }
  std::vector<nb::object> kept;
  std::vector<HeldRun*> held;
};

void advance_all(RunPool& pool, const nb::sequence& runs, std::int64_t milliseconds) {
  check_duration(milliseconds);
  const NamedRuns named(runs);
  change(named.held, [&](const Runs& all, const Outside& outside) {
    pool.each(all.size(), [&](std::size_t i) {
      all[i]->advance(milliseconds, [&outside] { outside.require_interpreter(); });
    });
  });
}

void restart_all(RunPool& pool, const nb::sequence& runs, const std::vector<std::uint64_t>& seeds) {
  const NamedRuns named(runs);
  if (named.held.size() != seeds.size()) throw std::invalid_argument("as many seeds as robots are wanted");
  change(named.held, [&](const Runs& all, const Outside&) {
    pool.each(all.size(), [&](std::size_t i) { all[i]->restart(seeds[i]); });
  });
}

nb::list events(HeldRun& held) {
  nb::list list;
  for (const ToldEvent& event : held.get().events()) {
    list.append(nb::make_tuple(event.time_s, event.kind, event.source, event.text));
  }
  return list;
}

nb::list plugins(HeldRun& held) {
  nb::list list;
  for (const core::PluginTiming& plugin : held.get().cosimulation().main_controller().plugins().timings()) {
    list.append(nb::make_tuple(plugin.name, plugin.steps, plugin.faults));
  }
  return list;
}

// Where a topic has been claimed: its writer; empty: nobody writes it.
std::string writer_of(HeldRun& held, const std::string& topic) {
  return held.get().writer_of(topic);
}

nb::tuple batches(HeldRun& held) {
  const simulator::Cosimulation& run = held.get().cosimulation();
  const NetworkState& network = run.message_controller().state();
  const core::MainControllerStatistics statistics = run.main_controller().statistics();
  return nb::make_tuple(network.handed_over, network.late, network.refused + statistics.refused_locally,
                        network.tail_played, network.repaired);
}

std::vector<double> whereabouts(HeldRun& held) {
  const Whereabouts where = held.get().whereabouts();
  std::vector<double> numbers;
  for (const auto& part : {where.base_m, where.base_rpy_rad, where.com_m, where.cop_m}) {
    numbers.insert(numbers.end(), part.begin(), part.end());
  }
  numbers.push_back(where.tilt_rad);
  return numbers;
}

std::vector<double> copied(std::span<const double> numbers) {
  return {numbers.begin(), numbers.end()};
}

std::vector<std::string> names_of_joints(const RobotSetup& setup) {
  std::vector<std::string> names;
  for (const urdf::Joint& joint : setup.robot().joints) names.push_back(joint.name);
  return names;
}

// Lowest and highest angle, largest speed.
std::vector<std::tuple<double, double, double>> limits_of_joints(const RobotSetup& setup) {
  std::vector<std::tuple<double, double, double>> limits;
  for (const urdf::Joint& joint : setup.robot().joints) {
    limits.emplace_back(joint.lower_rad, joint.upper_rad, joint.velocity_limit_rad_per_s);
  }
  return limits;
}

std::vector<std::string> names_of_links(const RobotSetup& setup) {
  std::vector<std::string> names;
  for (const urdf::Link& link : setup.robot().links) names.push_back(link.name);
  return names;
}

void bind_errors(nb::module_& module) {
  // What is wrong with a file or value that people wrote; a plug-in; who may write a topic.
  static PyObject* input_error = nullptr;
  input_error = nb::exception<input::InputError>(module, "InputError", PyExc_ValueError).ptr();
  nb::exception<core::PluginError>(module, "PluginError", PyExc_RuntimeError);
  nb::exception<msgclient::TopicError>(module, "TopicError", PyExc_RuntimeError);
  nb::exception<ClosedError>(module, "ClosedError", PyExc_RuntimeError);
  nb::exception<ForkError>(module, "ForkError", PyExc_RuntimeError);
  nb::exception<BusyError>(module, "BusyError", PyExc_RuntimeError);
  nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
    try {
      std::rethrow_exception(thrown);
    } catch (const core::ConfigurationError& error) {
      PyErr_SetString(input_error, error.what());
    } catch (const InterpreterEnds& ends) {
      PyErr_SetString(PyExc_SystemExit, ends.what());
    }
  });
}

void bind_setup(nb::module_& module) {
  nb::class_<RobotSetup>(module, "Setup")
      .def(
          "__init__",
          [](RobotSetup* self, const std::string& robot, const std::string& configuration,
             const std::string& profile, bool accept_unproven, const std::vector<std::string>& libraries,
             const std::vector<std::tuple<std::string, std::string, std::string>>& parameters,
             const std::optional<std::string>& world, std::optional<std::uint64_t> world_seed,
             const std::string& conditions, bool navigation, bool localization, double mismatch,
             const std::vector<std::string>& writes) {
            RobotChoice choice{.robot = robot,
                               .configuration = configuration,
                               .profile = profile,
                               .accept_unproven = accept_unproven,
                               .libraries = libraries,
                               .parameters = {},
                               .world = world,
                               .world_seed = world_seed,
                               .conditions = conditions,
                               .navigation = navigation,
                               .localization = localization,
                               .mismatch = mismatch,
                               .writes = writes};
            for (const auto& [plugin, name, text] : parameters)
              choice.parameters.push_back({plugin, name, text});
            const Outside outside;
            new (self) RobotSetup(choice);
          },
          "robot"_a, "configuration"_a, "profile"_a, "accept_unproven"_a, "libraries"_a, "parameters"_a,
          "world"_a.none(), "world_seed"_a.none(), "conditions"_a, "navigation"_a, "localization"_a,
          "mismatch"_a, "writes"_a)
      .def_prop_ro("name", [](const RobotSetup& self) { return self.robot().name; })
      .def_prop_ro("directory", [](const RobotSetup& self) { return self.robot().directory.string(); })
      .def_prop_ro("joints", &names_of_joints)
      .def_prop_ro("joint_limits", &limits_of_joints)
      .def_prop_ro("links", &names_of_links)
      .def_prop_ro("hip_height_m", [](const RobotSetup& self) { return self.robot().hip_height_m; })
      .def_prop_ro("mass_kg", [](const RobotSetup& self) { return self.robot().total_mass_kg(); })
      .def_prop_ro("plugins_taken_out", &RobotSetup::plugins_taken_out);
}

void bind_run(nb::module_& module) {
  nb::class_<Snapshot>(module, "Snapshot")
      .def_prop_ro("now_ns", [](const Snapshot& self) { return self.now_ns; })
      .def_prop_ro("seed", [](const Snapshot& self) { return self.seed; })
      .def_prop_ro("digest", [](const Snapshot& self) { return self.digest; })
      .def_prop_ro("entries", [](const Snapshot& self) { return self.journal.size(); });
  nb::class_<HeldView>(module, "View", nb::type_slots(view_slots))
      .def_prop_ro("sequence", [](const HeldView& self) { return self.view->sequence; });
  nb::class_<HeldRun>(module, "Run")
      .def(
          "__init__",
          [](HeldRun* self, const std::shared_ptr<RobotSetup>& setup, std::uint64_t seed) {
            const Outside outside;
            new (self) HeldRun(setup, seed);
          },
          "setup"_a, "seed"_a)
      .def("advance", &advance, "milliseconds"_a)
      .def("restart", &restart, "seed"_a)
      .def("snapshot", [](HeldRun& self) { return self.get().snapshot(); })
      .def("restore", &restore, "snapshot"_a)
      .def("close", &HeldRun::close)
      .def_prop_ro("closed", &HeldRun::closed)
      .def(
          "apply", [](HeldRun& self, const std::string& action) { self.get().apply(action); }, "action"_a)
      .def(
          "write",
          [](HeldRun& self, std::size_t topic, nb::handle value) {
            RobotRun& run = self.get();
            run.write(topic, Bytes(value, false, topic_at(topic).type->size).value());
          },
          "topic"_a, "value"_a)
      .def(
          "sequence",
          [](HeldRun& self, std::size_t topic) {
            topic_at(topic);
            return self.get().sequence(topic);
          },
          "topic"_a)
      .def(
          "read",
          [](HeldRun& self, std::size_t topic, nb::handle value) {
            RobotRun& run = self.get();
            return run.read(topic, Bytes(value, true, topic_at(topic).type->size).value());
          },
          "topic"_a, "value"_a)
      .def(
          "stamp_ns",
          [](HeldRun& self, std::size_t topic) {
            topic_at(topic);
            return self.get().stamp_ns(topic);
          },
          "topic"_a)
      .def(
          "view",
          [](HeldRun& self, std::size_t topic) {
            topic_at(topic);
            return HeldView{self.get().view(topic)};
          },
          "topic"_a)
      .def("writer_of", &writer_of, "topic"_a)
      .def_prop_ro("now_ns", [](HeldRun& self) { return self.get().now_ns(); })
      .def_prop_ro("seed", [](HeldRun& self) { return self.get().seed(); })
      .def_prop_ro("digest", [](HeldRun& self) { return self.get().digest(); })
      .def_prop_ro("fallen", [](HeldRun& self) { return self.get().fallen(); })
      .def_prop_ro("positions",
                   [](HeldRun& self) { return copied(self.get().cosimulation().plant().positions()); })
      .def_prop_ro("velocities",
                   [](HeldRun& self) { return copied(self.get().cosimulation().plant().velocities()); })
      .def("whereabouts", &whereabouts)
      .def("events", &events)
      .def_prop_ro("events_lost", [](HeldRun& self) { return self.get().events_lost(); })
      .def("plugins", &plugins)
      .def("batches", &batches);
  nb::class_<RunPool>(module, "Pool")
      .def(nb::init<int>(), "threads"_a)
      .def_prop_ro("threads", &RunPool::threads)
      .def("advance", &advance_all, "runs"_a, "milliseconds"_a)
      .def("restart", &restart_all, "runs"_a, "seeds"_a);
}

}  // namespace

void bind(nb::module_& module) {
  module.attr("__version__") = GAITWAY_VERSION;
  module.def("topics", &topics);
  module.def("installation_root", [] { return process::installation_root().string(); });
  bind_errors(module);
  bind_setup(module);
  bind_run(module);
  bind_plugin_process(module);
  nb::module_::import_("atexit").attr("register")(nb::cpp_function(&wait_for_those_outside));
}

}  // namespace gaitway::python

NB_MODULE(_native, module) {
  gaitway::python::bind(module);
}

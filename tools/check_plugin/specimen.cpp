// Calls over the border to the plug-in under check.
#include "tools/check_plugin/specimen.hpp"

#include <alloca.h>
#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "gaitway/plugin/detail/plugin_border.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::size_t kFilledStack = 32768;
int stack_fill = 0;

[[gnu::noinline]] void fill_stack() noexcept {
  void* const room = alloca(kFilledStack);
  std::memset(room, stack_fill, kFilledStack);
  asm volatile("" : : "r"(room) : "memory");  // NOLINT(hicpp-no-assembler): the fill must stay
}

}  // namespace

void set_stack_fill(int fill) noexcept {
  stack_fill = fill;
}

SpecimenLibrary::SpecimenLibrary(const std::filesystem::path& file, Board& board) : board_(board) {
  board.enter(Call::load);
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr) {
    throw std::runtime_error(dlerror());
  }
  entry_ = static_cast<const gaitway_plugin*>(dlsym(handle_, "gaitway_plugin_entry"));
  if (entry_ == nullptr) {
    throw std::runtime_error("has no symbol 'gaitway_plugin_entry'");
  }
  board.enter(Call::none);
}

void SpecimenLibrary::unload() noexcept {
  if (handle_ != nullptr) {
    board_.enter(Call::unload);
    dlclose(handle_);
    handle_ = nullptr;
    board_.enter(Call::none);
  }
}

gaitway_text Specimen::error_text() noexcept {
  error_[0] = '\0';
  return {error_.data(), static_cast<std::uint32_t>(error_.size()), 0};
}

void Specimen::set_error(std::string_view text) noexcept {
  *std::copy_n(text.begin(), std::min(text.size(), error_.size() - 1), error_.begin()) = '\0';
}

// The call over the border, noted on the board.
template <class Function>
bool Specimen::call(Call what, const Function& function) noexcept {
  const gaitway_text text = error_text();
  board().enter(what);
  const bool fine = function(&text) == GAITWAY_OK;
  board().enter(Call::none);
  return fine;
}

bool Specimen::create() noexcept {
  fill_stack();
  created_ = call(Call::create, [this](const gaitway_text* error) {
    return library_.entry().create(host_.table(), &instance_, error);
  });
  host_.set_phase(ReplayHost::Phase::idle);
  if (created_ && (instance_.activate == nullptr || instance_.step == nullptr ||
                   instance_.deactivate == nullptr || instance_.destroy == nullptr)) {
    created_ = false;
    set_error("create left out one of activate, step, deactivate and destroy");
  }
  return created_;
}

bool Specimen::activate() noexcept {
  fill_stack();
  return call(Call::activate,
              [this](const gaitway_text* error) { return instance_.activate(instance_.context, error); });
}

bool Specimen::deactivate() noexcept {
  return call(Call::deactivate,
              [this](const gaitway_text* error) { return instance_.deactivate(instance_.context, error); });
}

void Specimen::destroy() noexcept {
  if (created_) {
    created_ = false;
    board().enter(Call::destroy);
    instance_.destroy(instance_.context);
    board().enter(Call::none);
  }
}

bool Specimen::set_parameter(const char* name, const gaitway_value& value) noexcept {
  if (instance_.set_parameter == nullptr) {
    set_error("has no set_parameter");
    return false;
  }
  return call(Call::set_parameter, [&](const gaitway_text* error) {
    return instance_.set_parameter(instance_.context, name, &value, error);
  });
}

bool Specimen::save_state(core::PluginState& state, std::uint32_t capacity) noexcept {
  error_[0] = '\0';
  state.size = state.version = 0;
  const gaitway_state_functions* const functions = detail::state_functions(instance_);
  if (functions == nullptr) {
    return true;
  }
  gaitway_state plain{state.bytes.data(), capacity, 0, 0, 0};
  const bool fine = call(Call::save_state, [&](const gaitway_text* error) {
    return functions->save_state(instance_.context, &plain, error);
  });
  state.size = plain.size;
  state.version = plain.version;
  return fine;
}

bool Specimen::restore_state(const core::PluginState& state) noexcept {
  const gaitway_state_functions* const functions = detail::state_functions(instance_);
  if (functions == nullptr) {
    set_error("has no restore_state");
    return false;
  }
  const gaitway_state plain{const_cast<std::byte*>(state.bytes.data()), core::PluginState::kCapacity,
                            state.size, state.version, 0};
  return call(Call::restore_state, [&](const gaitway_text* error) {
    return functions->restore_state(instance_.context, &plain, error);
  });
}

bool Specimen::prepare_step(const NominalRecord& record, std::uint64_t n, const InputFault& fault) noexcept {
  const RecordPosition position = record.position(n);
  const Tick tick = record.tick(position);
  for (Port& port : host_.ports()) {
    port.published = false;
  }
  host_.feed(position, fault);
  if (host_.period() == Period::batch && !tick.batch) {
    return false;
  }
  tick_ = core::abi_tick(tick);
  error_[0] = '\0';
  fill_stack();
  board().enter_tick(tick.tick);
  host_.set_phase(ReplayHost::Phase::stepping);
  return true;
}

bool Specimen::run_step() noexcept {
  const gaitway_text text{error_.data(), static_cast<std::uint32_t>(error_.size()), 0};
  const bool fine = instance_.step(instance_.context, &tick_, &text) == GAITWAY_OK;
  host_.set_phase(ReplayHost::Phase::idle);
  board().page().call.store(Call::none);
  for (Port& port : host_.ports()) {
    port.published = port.published && fine;
  }
  return fine;
}

bool Specimen::step(const NominalRecord& record, std::uint64_t n, const InputFault& fault) noexcept {
  return !prepare_step(record, n, fault) || run_step();
}

}  // namespace gaitway::plugin_check

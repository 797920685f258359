// The plug-in's life in its own process: creation over the socket, everything after it over the segment.
#include "child_program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "bounds.hpp"
#include "gaitway/plugin/detail/plugin_border.hpp"

namespace gaitway::core {
namespace {

constexpr std::size_t kErrorBytes = sizeof ChildReply::text;

// From now on the kernel ends this process when the manager's end of the socket closes. Until here it was the
// end of the thread that started us; a thread may come and go while its process lives.
void end_with_manager(int socket) noexcept {
  fcntl(socket, F_SETSIG, SIGKILL);
  fcntl(socket, F_SETOWN, getpid());
  fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) | O_ASYNC);
  prctl(PR_SET_PDEATHSIG, 0, 0, 0, 0);
  char byte = 0;
  if (recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0) {
    _exit(0);  // it went before we listened
  }
}

}  // namespace

int run_child(std::span<const char* const> words, const LoadCode& load) {
  constexpr int kExitBadInput = 1;
  if (words.size() != 4 || fcntl(kChildSocket, F_GETFD) < 0) {
    std::fprintf(stderr,
                 "gaitway_plugin_child is started by the main controller, for plug-ins with `isolation: "
                 "process` in its configuration\n");
    return kExitBadInput;
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  if (getppid() != static_cast<pid_t>(std::strtol(words[0], nullptr, 10))) {
    return 0;  // it is gone already
  }
  const ChildBounds bounds{.memory_limit_bytes = std::strtoull(words[1], nullptr, 10),
                           .descriptor_limit = std::strtoull(words[2], nullptr, 10),
                           .local_sockets = std::string_view(words[3]) == kLocalSockets};
  enter_child_bounds(bounds, kChildSocket + 1);
  try {
    // Never destroyed: threads of the plug-in may be in it until the process ends, which waits for none of
    // them.
    auto* const program = new ChildProgram(process::FileDescriptor(kChildSocket), load);
    return program->run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gaitway_plugin_child: %s\n", error.what());
    return kExitBadInput;
  }
}

int ChildProgram::run() {
  if (!create() || !attach()) {
    return 0;  // the manager knows why, or is gone
  }
  serve();
  return 0;
}

bool ChildProgram::create() {
  std::vector<std::byte> bytes;
  if (receive_packet(socket_, bytes, Wait::yes) != Receipt::packet) {
    return false;
  }
  PacketReader packet(bytes);
  packet.number<ChildMessage>();
  const std::string file = packet.text();
  const std::filesystem::path base = packet.text();
  robot_directory_ = packet.text();
  memory_socket_ = packet.text();
  SearchPath path;
  for (auto left = packet.number<std::uint32_t>(); left > 0; --left) {
    path.emplace_back(packet.text());
  }
  return load(file, base, path) && construct();
}

bool ChildProgram::load(const std::string& file, const std::filesystem::path& base, const SearchPath& path) {
  try {
    code_.emplace(load_(file, base, path));
  } catch (const PluginError& error) {
    tell(PacketWriter(ChildMessage::library_failed).text(error.what()));
    return false;
  }
  describe_deaths_in(code_->entry);
  return true;
}

bool ChildProgram::construct() {
  std::array<char, kErrorBytes> text{};
  const gaitway_status status = instance_.create(code_->entry, {text.data(), kErrorBytes, 0});
  static_cast<void>(take_refused_call());
  if (status != GAITWAY_OK) {
    text.back() = '\0';
    tell(PacketWriter(ChildMessage::constructor_failed).text(text.data()));
    return false;
  }
  const gaitway_plugin& entry = code_->entry;
  PacketWriter created(ChildMessage::created);
  created.text(entry.name).text(entry.version).text(entry.description);
  return tell(created.text(std::filesystem::absolute(code_->file).lexically_normal().native()));
}

bool ChildProgram::attach() {
  std::vector<std::byte> bytes;
  process::FileDescriptor memory;
  if (receive_packet(socket_, bytes, Wait::yes, &memory) != Receipt::packet || !memory) {
    return false;
  }
  std::vector<std::uint32_t> sizes;
  for (const Port& port : ports_) {
    sizes.push_back(port.size);
  }
  const ExchangeLayout layout(sizes);
  segment_ = std::make_unique<msgclient::Segment>(
      msgclient::Segment::map(std::move(memory), layout.bytes, msgclient::Access::read_write));
  auto* const begin = static_cast<std::byte*>(segment_->data());
  exchange_ = reinterpret_cast<ExchangeHeader*>(begin);
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    ports_[i].area = reinterpret_cast<PortArea*>(begin + layout.port_offset[i]);
  }
  leave_last_words_in(exchange_->last_words);
  if (!tell(PacketWriter(ChildMessage::attached))) {
    return false;
  }
  end_with_manager(socket_.get());
  return true;
}

void ChildProgram::serve() {
  Spin spin;
  ChildRequest request;
  std::uint32_t answered = 0;
  for (;;) {
    while (exchange_->call.number.load() == answered) {
      if (!spin.sees_change(exchange_->call, answered)) {
        sleep_on(exchange_->call, answered, -1);
      }
    }
    answered = exchange_->call.number.load();
    request = exchange_->request;
    if (request.call == ChildCall::end) {
      instance_.destroy();
      return;
    }
    answer(request, exchange_->reply);
    ring(exchange_->answer, answered);
  }
}

void ChildProgram::answer(const ChildRequest& request, ChildReply& reply) noexcept {
  reply.exhausted = 0;
  reply.state_size = reply.state_version = 0;
  reply.reports = 0;
  reply.text[0] = '\0';
  const gaitway_text error{reply.text, kErrorBytes, 0};
  reply.status = call(request, reply, error);
  posts_.collect();
  passed_on_ = std::max(passed_on_, posts_.first());  // after a burst the oldest are gone
  for (; passed_on_ < posts_.total() && reply.reports < kExchangeReports; ++passed_on_) {
    const Event& post = posts_[passed_on_];
    put_report(static_cast<gaitway_severity>(post.kind), post.text());
  }
  if (reply.status != GAITWAY_OK && request.call == ChildCall::step) {
    reply.exhausted = static_cast<std::uint32_t>(exhausted_resource());
  }
}

// In the answer: also those that come before a crash are read there.
void ChildProgram::put_report(gaitway_severity severity, std::string_view text) noexcept {
  const std::uint32_t at = exchange_->reply.reports++;
  if (at < kExchangeReports) {
    ChildReport& report = exchange_->reply.report[at];
    report.severity = severity;
    copy_text(text.substr(0, kLongestReport), report.text);
  }
}

gaitway_status ChildProgram::call(const ChildRequest& request, ChildReply& reply,
                                  const gaitway_text& error) noexcept {
  switch (request.call) {
    case ChildCall::step:
      return step(request, reply, error);
    case ChildCall::activate:
      return instance_.activate(error);
    case ChildCall::deactivate:
      return instance_.deactivate(error);
    case ChildCall::save_state:
      return save_state(reply, error);
    case ChildCall::restore_state:
      return instance_.restore_state(
          {exchange_->state, PluginState::kCapacity, request.state_size, request.state_version, 0}, error);
    case ChildCall::set_parameter:
      return set_parameter(request, error);
    case ChildCall::end:
      break;
  }
  return GAITWAY_FAILED;
}

gaitway_status ChildProgram::step(const ChildRequest& request, ChildReply& reply,
                                  const gaitway_text& error) noexcept {
  for (const Port& port : ports_) {
    port.area->staged = 0;
  }
  gaitway_status status = instance_.step(request.tick, error);
  const std::string refused = take_refused_call();
  if (!refused.empty()) {
    detail::write_text(&error, ("called " + refused +
                                ", which a plug-in in a process of its own may not: it starts no processes, "
                                "signals nobody and opens no connections")
                                   .c_str());
    status = GAITWAY_FAILED;
  }
  if (status == GAITWAY_OK && request.keep_state != 0 && hands_state_on_) {
    std::array<char, kErrorBytes> problem{};
    hands_state_on_ =
        save_state(reply, {problem.data(), kErrorBytes, 0}) == GAITWAY_OK && reply.state_version != 0;
    if (problem[0] != '\0') {
      put_report(GAITWAY_WARNING, "hands no state on any more: " + std::string(problem.data()));
    }
  }
  return status;
}

gaitway_status ChildProgram::save_state(ChildReply& reply, const gaitway_text& error) noexcept {
  gaitway_state state{exchange_->state, PluginState::kCapacity, 0, 0, 0};
  const gaitway_status status = instance_.save_state(state, error);
  reply.state_size = state.size;
  reply.state_version = state.version;
  return status;
}

gaitway_status ChildProgram::set_parameter(const ChildRequest& request, const gaitway_text& error) noexcept {
  gaitway_value value = request.parameter;
  if (value.kind == GAITWAY_TEXT) {
    value.text = texts_.emplace(request.parameter_text).first->c_str();
  }
  return instance_.set_parameter(request.parameter_name, value, error);
}

std::vector<std::byte> ChildProgram::ask(const PacketWriter& question) {
  if (!tell(question)) {
    throw PluginError("declares more than a message to its manager holds");
  }
  std::vector<std::byte> answer;
  if (receive_packet(socket_, answer, Wait::yes) != Receipt::packet) {
    _exit(0);  // the manager is gone
  }
  PacketReader packet(answer);
  if (packet.number<ChildMessage>() == ChildMessage::refused) {
    throw PluginError(packet.text());
  }
  return answer;
}

gaitway_port* ChildProgram::open_topic(const gaitway_topic& topic, gaitway_access access) {
  PacketWriter question(ChildMessage::open_topic);
  question.text(topic.name).text(topic.type_name).number(topic.type_hash).number(topic.size).number(access);
  question.number(topic.float_field_count);
  for (std::uint32_t i = 0; i < topic.float_field_count; ++i) {
    const gaitway_float_field& field = topic.float_fields[i];
    question.text(field.name).number(field.offset).number(field.count).number(field.bytes).number(field.rows);
    question.number(field.lowest).number(field.highest);
  }
  static_cast<void>(ask(question));
  return reinterpret_cast<gaitway_port*>(
      &ports_.emplace_back(Port{static_cast<Access>(access), topic.size, nullptr}));
}

gaitway_value ChildProgram::declare_parameter(const gaitway_parameter& parameter) {
  PacketWriter question(ChildMessage::parameter);
  question.text(parameter.name).text(parameter.unit).text(parameter.doc).value(parameter.fallback);
  question.number(parameter.lowest).number(parameter.highest).number(parameter.live);
  const std::vector<std::byte> answer = ask(question);
  PacketReader packet(answer);
  packet.number<ChildMessage>();
  std::string text;
  gaitway_value value = packet.value(text);
  if (value.text != nullptr) {
    value.text = texts_.insert(text).first->c_str();
  }
  return value;
}

void ChildProgram::set_period(gaitway_period period) {
  static_cast<void>(ask(PacketWriter(ChildMessage::set_period).number(period)));
}

gaitway_status ChildProgram::read(gaitway_port& port, void* value, gaitway_sample& sample) noexcept {
  const auto& from = reinterpret_cast<const Port&>(port);
  if (from.area == nullptr || from.access == Access::write) {
    return GAITWAY_FAILED;
  }
  if (from.area->sequence != sample.sequence) {
    std::memcpy(value, from.value(), from.size);
    sample = {from.area->sequence, from.area->stamp_ns};
  }
  return sample.sequence == 0 ? GAITWAY_NO_VALUE : GAITWAY_OK;
}

gaitway_status ChildProgram::publish(gaitway_port& port, const void* value) noexcept {
  const auto& to = reinterpret_cast<const Port&>(port);
  if (to.access != Access::write) {
    return GAITWAY_FAILED;
  }
  std::memcpy(to.value(), value, to.size);
  to.area->staged = 1;
  return GAITWAY_OK;
}

void ChildProgram::report(gaitway_severity severity, std::string_view text) noexcept {
  if (std::this_thread::get_id() != caller_) {  // goes out with the next answer
    posts_.post(static_cast<EventKind>(severity), {}, text);
  } else if (exchange_ == nullptr) {
    tell(PacketWriter(ChildMessage::report).number(severity).text(text));
  } else {
    put_report(severity, text);
  }
}

}  // namespace gaitway::core

// Keeping, shifting and handing on of recorded topics.
#include "tools/check_plugin/nominal_record.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::plugin_check {
namespace {

template <class T>
void add_to_number(std::byte* at, T change) noexcept {
  T number;
  std::memcpy(&number, at, sizeof number);
  if (number != 0) {  // 0: not set
    number = static_cast<T>(number + change);
    std::memcpy(at, &number, sizeof number);
  }
}

bool counts_cycles(std::string_view field) noexcept {
  return field == "sequence" || field == "accepted_sequence" || field == "cycle";
}

void write_all(int fd, const void* data, std::size_t bytes) {
  const char* at = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t written = write(fd, at, bytes);
    if (written <= 0) {
      throw std::runtime_error("the recorded walk cannot be kept");
    }
    at += written;
    bytes -= static_cast<std::size_t>(written);
  }
}

template <class T>
void write_list(int fd, const std::vector<T>& list) {
  const std::uint64_t size = list.size();
  write_all(fd, &size, sizeof size);
  write_all(fd, list.data(), size * sizeof(T));
}

class Cursor {
 public:
  Cursor(int fd, off_t& at) : fd_(fd), at_(at) {}
  template <class T>
  std::vector<T> list() {
    std::uint64_t size = 0;
    read(&size, sizeof size);
    std::vector<T> list(size);
    read(list.data(), size * sizeof(T));
    return list;
  }

 private:
  void read(void* to, std::size_t bytes) {
    if (pread(fd_, to, bytes, at_) != static_cast<ssize_t>(bytes)) {
      throw std::runtime_error("the recorded walk is cut off");
    }
    at_ += static_cast<off_t>(bytes);
  }
  int fd_;
  off_t& at_;
};

}  // namespace

void RecordedTopic::add(std::uint32_t tick, std::span<const std::byte> value, std::int64_t stamp) {
  values.insert(values.end(), value.begin(), value.end());
  stamp_ns.push_back(stamp);
  std::fill(newest_at.begin() + tick, newest_at.end(), static_cast<std::uint32_t>(stamp_ns.size()));
}

RecordedTopic& NominalRecord::add_topic(const std::string& name, const TypeDescriptor& type) {
  topics_.push_back({name, &type, std::vector<std::uint32_t>(ticks_), {}, {}});
  return topics_.back();
}

const RecordedTopic* NominalRecord::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(topics_, name, &RecordedTopic::name);
  return found == topics_.end() ? nullptr : &*found;
}

std::int64_t NominalRecord::shift_ns(std::uint32_t pass) const noexcept {
  return std::int64_t{pass} * ticks_ * facts::kSlot_ns;
}

Tick NominalRecord::tick(const RecordPosition& position) const noexcept {
  return core::tick_at(position.tick * facts::kSlot_ns + core::kTickPhase_ns + shift_ns(position.pass));
}

void NominalRecord::copy(const RecordedTopic& topic, std::uint32_t index, std::uint32_t pass,
                         std::span<std::byte> to) const noexcept {
  const std::size_t size = topic.type->size;
  std::memcpy(to.data(), topic.values.data() + index * size, size);
  if (pass == 0) {
    return;
  }
  const auto slots = static_cast<std::uint32_t>(ticks_ * pass);
  for (const FieldDescriptor& field : topic.type->fields) {
    for (std::uint32_t i = 0; i < field.elements(); ++i) {
      std::byte* const at = to.data() + field.offset + i * scalar_size(field.type);
      if (field.type == ScalarType::int64_value && field.unit == "ns") {
        add_to_number<std::int64_t>(at, shift_ns(pass));
      } else if (field.type == ScalarType::uint32_value && counts_cycles(field.name)) {
        add_to_number<std::uint32_t>(at, slots / static_cast<std::uint32_t>(facts::kSlotsPerCycle));
      } else if (field.name == "slot" && topic.name == "joint_states") {
        add_to_number<std::uint32_t>(at, slots);
      }
    }
  }
}

void NominalRecord::save(int fd) const {
  write_list(fd, std::vector<std::uint32_t>{ticks_, static_cast<std::uint32_t>(topics_.size())});
  for (const RecordedTopic& topic : topics_) {
    write_list(fd, std::vector<char>(topic.name.begin(), topic.name.end()));
    write_list(fd, std::vector<char>(topic.type->name.begin(), topic.type->name.end()));
    write_list(fd, topic.newest_at);
    write_list(fd, topic.stamp_ns);
    write_list(fd, topic.values);
  }
}

NominalRecord NominalRecord::load(int fd) {
  off_t at = 0;
  Cursor cursor(fd, at);
  const std::vector<std::uint32_t> head = cursor.list<std::uint32_t>();
  NominalRecord record(head.at(0));
  for (std::uint32_t i = 0; i < head.at(1); ++i) {
    const std::vector<char> name = cursor.list<char>();
    const std::vector<char> type_name = cursor.list<char>();
    const auto* const type = std::ranges::find_if(kStandardTypes, [&](const TypeDescriptor* known) {
      return std::ranges::equal(type_name, known->name);
    });
    if (type == kStandardTypes.end()) {
      throw std::runtime_error("the recorded walk has a topic of an unknown type");
    }
    RecordedTopic& topic = record.add_topic(std::string(name.begin(), name.end()), **type);
    topic.newest_at = cursor.list<std::uint32_t>();
    topic.stamp_ns = cursor.list<std::int64_t>();
    topic.values = cursor.list<std::byte>();
  }
  return record;
}

}  // namespace gaitway::plugin_check

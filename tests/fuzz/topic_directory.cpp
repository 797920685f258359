// The directory segment of a memory block as its readers see it (msgclient/directory.hpp). Whatever stands in
// the memory: it is refused with TopicError or read, with no more rows than there is room for, names that
// end, and a name for every kind; and what the owner writes is what readers read.
#include "msgclient/directory.hpp"

#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "fuzz_input.hpp"
#include "gaitway/msgclient/topic.hpp"

namespace gaitway::fuzz {
namespace {

using namespace msgclient;

TopicInfo take_row(Input& input) {
  TopicInfo row;
  // Names as the registry lets them through: no zeros.
  const auto name = [&input] { return std::string(input.choose(kMaxNameLength + 1), 'a'); };
  row.descriptor = {name(),
                    name(),
                    input.take<std::uint64_t>(),
                    input.take<std::uint32_t>(),
                    static_cast<TopicKind>(input.choose(4)),
                    input.take<std::uint32_t>()};
  row.writer = name();
  row.reader = name();
  row.generation = input.take<std::uint32_t>();
  row.storage_bytes = input.take<std::uint64_t>();
  return row;
}

bool same(const TopicInfo& one, const TopicInfo& other) {
  const TopicDescriptor &a = one.descriptor, &b = other.descriptor;
  return a.name == b.name && a.type_name == b.type_name && a.type_hash == b.type_hash && a.size == b.size &&
         a.kind == b.kind && a.capacity == b.capacity && one.writer == other.writer &&
         one.reader == other.reader && one.generation == other.generation &&
         one.storage_bytes == other.storage_bytes;
}

void read(const Directory& directory) {
  try {
    directory.check();
  } catch (const TopicError&) {
  }
  const auto rows = directory.rows();
  require(rows.size() <= kMaxTopics, "no more rows than there is room for");
  for (const TopicInfo& row : rows) {
    require(row.descriptor.name.size() <= kMaxNameLength + 1, "names end");
    require(!kind_name(row.descriptor.kind).empty(), "every kind has a name");
  }
}

}  // namespace

void topic_directory(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const Segment segment = Segment::create("gaitway_fuzz", Directory::bytes());
  Directory directory(segment);
  directory.format(input.take<std::uint32_t>());
  const std::size_t written = input.choose(8);
  for (std::size_t index = 0; index < written; ++index) {
    const TopicInfo row = take_row(input);
    directory.store_row(index, row);
    const auto rows = directory.rows();
    require(rows.size() == index + 1 && same(rows.back(), row), "readers read what the owner wrote");
  }
  // Anything into the header and the rows that are in use, and one more.
  const std::size_t words = Directory::bytes() / 8 / kMaxTopics * (written + 1);
  while (!input.empty()) {
    const std::size_t word = input.take<std::uint16_t>() % words;
    const auto value = input.take<std::uint64_t>();
    std::memcpy(static_cast<std::byte*>(segment.data()) + word * 8, &value, sizeof value);
  }
  read(directory);
}

}  // namespace gaitway::fuzz

// Built from another schema: its Correction has the same name and size, but another unit, and so another
// hash.
#include <array>
#include <span>

#include "gaitway/plugin/plugin.hpp"

namespace {

struct InMillimetres {
  gaitway::Correction value;
};

}  // namespace

template <>
struct gaitway::TopicType<InMillimetres> {
  static constexpr std::string_view name = "Correction";
  static constexpr std::uint64_t hash = TopicType<Correction>::hash ^ 1;
  static constexpr std::array<FieldDescriptor, 1> kFields{
      {{"com_offset_mm", ScalarType::float64_value, 1, {2}, "mm", "base", "", 8}}};
  static constexpr std::span<const FieldDescriptor> fields{kFields};
};

namespace {

class OtherTypeHash final : public gaitway::Plugin {
 public:
  explicit OtherTypeHash(gaitway::Setup& setup) : input_(setup.reads<InMillimetres>("out")) {}
  void step(const gaitway::Tick&) override {}

 private:
  gaitway::Input<InMillimetres> input_;
};

}  // namespace

GAITWAY_PLUGIN(OtherTypeHash, "other_type_hash", "1.0.0", "Means something else")

// Behaviour trees as users write them (behaviour/read.hpp), and what is run and drawn of them. Whatever the
// text: it is refused with behaviour::BadTree, all complaints telling where and what, or gives a tree within
// its bounds, whose picture is well-formed XML, whose leaves are called by contract, and which can be halted.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "behaviour/xml_document.hpp"
#include "fuzz_input.hpp"
#include "gaitway/behaviour/draw.hpp"
#include "gaitway/behaviour/read.hpp"
#include "gaitway/behaviour/tree.hpp"

namespace gaitway::fuzz {
namespace {

using behaviour::Action;
using behaviour::Call;
using behaviour::Condition;
using behaviour::Outcome;

// Bytes in place of chance: they are read again and again.
class Answers {
 public:
  explicit Answers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  unsigned next() { return bytes_.empty() ? 0U : bytes_[place_++ % bytes_.size()]; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t place_ = 0;
};

class Watched final : public Action {
 public:
  Watched(Answers& answers, bool& kept) : answers_(answers), kept_(kept) {}

  Outcome on_start(Call& call) noexcept override {
    expect(State::idle);
    (void)call.set(1, call.value(0));
    return answer();
  }
  Outcome on_running(Call&) noexcept override {
    expect(State::running);
    return answer();
  }
  Halt on_halt(Call&) noexcept override {
    expect(State::running);
    return end();
  }
  Halt on_halting(Call&) noexcept override {
    expect(State::halting);
    return end();
  }

 private:
  enum class State : std::uint8_t { idle, running, halting };

  void expect(State state) { kept_ = kept_ && state_ == state; }
  Outcome answer() {
    const auto outcome = static_cast<Outcome>(1 + answers_.next() % 4);
    state_ = outcome == Outcome::running ? State::running : State::idle;
    return outcome;
  }
  Halt end() {
    const bool more = answers_.next() % 2 == 0;
    state_ = more ? State::halting : State::idle;
    return more ? Halt::ending : Halt::ended;
  }

  Answers& answers_;
  bool& kept_;
  State state_ = State::idle;
};

class Asked final : public Condition {
 public:
  explicit Asked(Answers& answers) : answers_(answers) {}
  bool holds(Call&) noexcept override { return answers_.next() % 2 == 0; }

 private:
  Answers& answers_;
};

behaviour::Registry make_registry(Answers& answers, bool& kept) {
  using behaviour::PortDirection;
  using behaviour::ValueKind;
  behaviour::Registry registry;
  const behaviour::ValueType metres{.kind = ValueKind::number, .unit = "m", .lowest = -5.0, .highest = 5.0};
  registry.add_action(
      {.id = "GoTo",
       .ports = {{.name = "x", .type = metres},
                 {.name = "gone", .type = metres, .direction = PortDirection::output},
                 {.name = "gait",
                  .type = {.kind = ValueKind::choice, .choices = {"slow", "fast"}},
                  .standard = "slow"},
                 {.name = "within", .type = {.kind = ValueKind::duration}, .standard = "5 s"}}},
      [&] { return std::make_unique<Watched>(answers, kept); });
  registry.add_condition(
      {.id = "IsUpright",
       .ports = {{.name = "since", .type = {.kind = ValueKind::integer}, .standard = "0"}}},
      [&] { return std::make_unique<Asked>(answers); });
  return registry;
}

void check_complaints(const behaviour::BadTree& bad) {
  require(!bad.complaints().empty() && bad.complaints().size() <= behaviour::kMostComplaints,
          "complaints are bounded");
  int line = 1;
  for (const behaviour::TreeComplaint& complaint : bad.complaints()) {
    require(complaint.line >= line, "complaints tell their lines, in order");
    line = complaint.line;
    require(!complaint.rule.empty() && complaint.file == "fuzz.xml", "complaints tell file and rule");
  }
}

void check_run(const behaviour::Description& description, const behaviour::Registry& registry,
               const bool& kept) {
  constexpr std::int64_t kTick_ns = 10'000'000;
  behaviour::Tree tree(description, registry);
  std::int64_t now_ns = 0;
  for (int tick = 0; tick < 20; ++tick) (void)tree.tick(now_ns += kTick_ns);
  const behaviour::Change change = tree.change(description, registry);
  require(change.done() && change.kept == description.nodes.size(), "a tree can be changed into itself");
  for (int tick = 0; tick < 5; ++tick) (void)tree.tick(now_ns += kTick_ns);
  require(behaviour::parse_xml(behaviour::draw(description, tree.statuses()), "picture").size() >
              description.nodes.size(),
          "a picture holds every node");
  for (int tick = 0; tick < 3; ++tick) (void)tree.halt(now_ns += kTick_ns);
  for (const behaviour::NodeStatus status : tree.statuses()) {
    require(status == behaviour::NodeStatus::idle || status == behaviour::NodeStatus::halting,
            "a halt ends everything");
  }
  require(kept, "leaves are called by contract");
}

}  // namespace

void behaviour_tree(std::span<const std::uint8_t> bytes) {
  Answers answers(bytes);
  bool kept = true;
  const behaviour::Registry registry = make_registry(answers, kept);
  behaviour::Description description;
  try {
    description = behaviour::parse_tree(Input(bytes).rest_as_text(), "fuzz.xml", registry);
  } catch (const behaviour::BadTree& bad) {
    check_complaints(bad);
    return;
  }
  require(!description.nodes.empty() && description.nodes.size() <= behaviour::kMostNodes,
          "trees are bounded");
  for (const behaviour::DescribedNode& node : description.nodes) {
    require(node.depth < static_cast<std::int32_t>(behaviour::kMostDepth), "depth is bounded");
  }
  constexpr std::size_t kQuick = 1000;  // larger ones take longer than a fuzzer should wait
  if (description.nodes.size() <= kQuick) check_run(description, registry, kept);
}

}  // namespace gaitway::fuzz

// Gives the tests of real clients something to compare with: `codec_frames values PROFILE NODES SEED` prints
// frames with random bits and what our codecs read in them, one JSON object a line; `codec_frames log FILE`
// writes a bus log with every kind of line.
#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"

namespace {

using namespace gaitway::can;
using Values = std::vector<std::int64_t>;

template <class Array>
void append(Values& values, const Array& more) {
  values.insert(values.end(), more.begin(), more.end());
}

// The fields of a frame in the order of the message table, as the codec's structs have them; nothing where
// the codec refuses the frame.
std::optional<Values> decode(const Profile& profile, MessageKind kind, const Frame& frame) {
  switch (kind) {
    case MessageKind::emergency_stop:
      if (const auto m = decode_emergency_stop(profile, frame)) {
        return Values{static_cast<int>(m->mode)};
      }
      break;
    case MessageKind::user_command:
      if (const auto m = decode_user_command(profile, frame)) {
        return Values{m->node, m->target_count, m->duration_slots};
      }
      break;
    case MessageKind::sync:
      if (const auto m = decode_sync(profile, frame)) {
        return Values{m->cycle,    m->slot,        m->batch_committed ? 1 : 0, m->toggle ? 1 : 0,
                      m->softness, m->tail_points, m->tail_toggle ? 1 : 0};
      }
      break;
    case MessageKind::trim:
      if (const auto m = decode_trim(profile, frame)) {
        return Values(m->count.begin(), m->count.end());
      }
      break;
    case MessageKind::feedback:
      if (const auto m = decode_feedback(profile, frame)) {
        return Values{m->position,
                      m->current,
                      m->reference_low,
                      m->executing_toggle ? 1 : 0,
                      m->pending_toggle ? 1 : 0,
                      static_cast<int>(m->state),
                      m->channel[0],
                      m->channel[1]};
      }
      break;
    case MessageKind::fault_report:
      if (const auto m = decode_fault_report(profile, frame)) {
        return Values{m->faults};
      }
      break;
    case MessageKind::trajectory:
      if (const auto m = decode_trajectory(profile, frame)) {
        return Values(m->delta.begin(), m->delta.end());
      }
      break;
    case MessageKind::resynchronisation:
      if (const auto m = decode_resynchronisation(profile, frame)) {
        Values values{m->count, m->slot, m->toggle ? 1 : 0};
        append(values, m->delta);
        return values;
      }
      break;
    case MessageKind::heartbeat:
      if (const auto m = decode_heartbeat(profile, frame)) {
        return Values{m->mode, m->cycle};
      }
      break;
    case MessageKind::tail:
      if (const auto m = decode_tail(profile, frame)) {
        return Values(m->delta.begin(), m->delta.end());
      }
      break;
  }
  return std::nullopt;
}

void print_random(const Profile& profile, MessageKind kind, std::uint32_t id, std::mt19937& random) {
  constexpr int kFrames = 20;
  Frame frame{.id = id, .size = layout(kind).size};
  for (int printed = 0; printed < kFrames;) {
    for (std::size_t byte = 0; byte < frame.size; ++byte) {
      frame.data[byte] = static_cast<std::uint8_t>(random());
    }
    if (kind == MessageKind::emergency_stop) {
      frame.data[0] &= 1U;  // else it takes long to find one of the two modes
    }
    const auto values = decode(profile, kind, frame);
    if (!values) {
      continue;
    }
    nlohmann::ordered_json fields = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < values->size(); ++i) {
      fields.push_back({layout(kind).fields[i].first_bit, (*values)[i]});
    }
    fmt::print("{}\n", nlohmann::ordered_json{{"id", frame.id},
                                              {"data", std::vector<int>(frame.data.begin(),
                                                                        frame.data.begin() + frame.size)},
                                              {"fields", fields}}
                           .dump());
    ++printed;
  }
}

void print_values(const Profile& profile, int nodes, unsigned seed) {
  std::mt19937 random(seed);
  for (const MessageLayout& message : kMessageLayouts) {
    const IdRule rule = profile.row(message.kind).rule;
    if (rule == IdRule::unused) {
      continue;
    }
    for (int node = rule == IdRule::one ? 0 : 1; node <= (rule == IdRule::one ? 0 : nodes); ++node) {
      for (int part = 0; part < profile.parts(message.kind); ++part) {
        for (const bool toggle : {false, true}) {
          if (!toggle || has_toggle(rule)) {
            print_random(profile, message.kind,
                         profile.id_of(message.kind, static_cast<NodeId>(node), toggle, part), random);
          }
        }
      }
    }
  }
}

void write_log(const char* file) {
  CandumpWriter writer(file);
  writer.write(1'000'001'000, {.id = 0x123, .size = 8, .data = {1, 2, 3, 4, 5, 6, 7, 0xFF}});
  writer.write(1'000'202'000, {.id = 0x7FF});
  writer.write(1'000'303'000, {.id = 0x123, .size = 2, .data = {0xAB, 0xCD}, .extended = true});
  writer.write(1'000'404'000, {.id = 0x1FFFFFFF, .extended = true});
  writer.write(1'000'505'000, {.id = 0x45, .size = 8, .remote = true});
  writer.write(1'000'606'000, {.id = 0x46, .remote = true});
  writer.write(1'000'707'000, {.id = 0x12345, .size = 3, .extended = true, .remote = true});
  writer.write_error(2'000'808'000, 0x88, {0, 0, 4, 0, 0, 0, 7, 9});
  writer.close();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> arguments(argv, argv + argc);
  if (arguments.size() == 3 && arguments[1] == "log") {
    write_log(argv[2]);
    return 0;
  }
  if (arguments.size() == 5 && arguments[1] == "values") {
    print_values(arguments[2] == "paper" ? kPaperProfile : kFullProfile, std::stoi(argv[3]),
                 static_cast<unsigned>(std::stoul(argv[4])));
    return 0;
  }
  fmt::print(stderr, "usage: codec_frames values full|paper NODES SEED | codec_frames log FILE\n");
  return 1;
}

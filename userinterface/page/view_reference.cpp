// The view's table as documentation, as the page's decoder wants it, and as an example.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gaitway/page/view_frame.hpp"

namespace gaitway::page {
namespace {

constexpr std::array<std::string_view, 5> kTypeNames{"uint8", "int16", "uint16", "int32", "uint32"};

std::string_view type_name(ViewType type) {
  return kTypeNames[static_cast<std::size_t>(type)];
}

// No two values of it are alike.
ViewState example() {
  ViewState state;
  state.frame = 0x01020304;
  state.robot_time_s = 12.345;
  state.mode = 1.0;
  state.activity = Activity::walks;
  state.contact = {1.0, 0.0};
  state.age_s = {0.004, 0.014, 0.024, 80.0, kUnknown};
  state.round_trip_s = 0.0021;
  state.base_place_m = {1234.5678, -0.0042};
  state.base_height_m = 0.4321;
  state.base_turn = {0.0, -0.6, 0.0, 0.8};
  state.com_m = {0.0123, -0.0456, 0.3789};
  state.zmp_m = {-0.0311, 0.0522};
  state.planned_zmp_m = {kUnknown, 9.9};
  state.foot_force_N = {66.6, 0.4};
  state.velocity = {0.21, -0.05, 1.5};
  state.joint_trouble[0] = state.joint_trouble[9] = state.joint_trouble[39] = true;
  state.batches_late = 65'537;
  state.batches_refused = 3;
  state.tails_played = 258;
  state.footstep_count = 2;
  state.footsteps[0] = {0.11, -0.05, 0.1};
  state.footsteps[1] = {0.21, 0.05, -0.2};
  state.commander = "page é7";
  state.joint_count = 3;
  state.joints_rad[0] = -1.5708;
  state.joints_rad[1] = 0.25;
  state.joints_rad[2] = 7.0;
  return state;
}

}  // namespace

std::string view_reference() {
  std::string text =
      "<!-- Made by `./dev gaitway api document`; change "
      "userinterface/page/include/gaitway/page/view_layout.hpp, "
      "not this file. -->\n"
      "# The view: one frame for a page\n\n"
      "A WebSocket at `/view`, on the port of the robot API. Thirty times a second at most it gives one "
      "binary message with all that a "
      "page draws,\n"
      "so that a page needs to subscribe to nothing for its picture. Frames do not queue: who is slow gets "
      "fewer of them, and "
      "each is the newest.\n"
      "The client acknowledges each by its four bytes `frame`, as they came, in a binary message; while "
      "eight are not "
      "acknowledged, none is sent.\n"
      "Where the robot wants a token that the handshake did not bring, the first message of the client is "
      "that token, as "
      "text.\n\n";
  text += fmt::format(
      "Numbers are little-endian and follow one another without gaps: {} bytes with 22 joints, {} at most. A "
      "value is the raw "
      "number times its unit. A row with unit 0\n"
      "is a counter that begins anew after its highest number, or bits, or letters. In the others, what is "
      "not known is the lowest "
      "number of a signed type, and the highest of an unsigned one.\n\n"
      "| from byte | field | type | unit | what |\n|---|---|---|---|---|\n",
      view_bytes(22), kMostViewBytes);
  std::size_t offset = 0;
  for (const ViewRow& row : kViewRows) {
    const std::string count =
        row.count == 1 ? "" : fmt::format("[{}]", row.count == 0 ? "joint_count" : std::to_string(row.count));
    text += fmt::format("| {} | `{}` | {}{} | {:.6g}{} | {} |\n", offset, row.name, type_name(row.type),
                        count, row.scale, row.unit.empty() ? "" : fmt::format(" {}", row.unit), row.doc);
    offset += bytes_of(row.type) * row.count;
  }
  return text;
}

std::string view_layout_ts() {
  std::string text =
      "// The layout of the view's frame. Made by `./dev gaitway api document` from the robot's own table; "
      "not to be "
      "edited.\n"
      "export type ViewType = \"uint8\" | \"int16\" | \"uint16\" | \"int32\" | \"uint32\";\n"
      "export interface ViewRow {\n"
      "  readonly name: string;\n"
      "  readonly type: ViewType;\n"
      "  readonly count: number; // 0: one a joint\n"
      "  readonly scale: number; // 0: counters, bits, letters\n"
      "}\n";
  text += fmt::format("export const viewVersion = {};\n", kViewVersion);
  text += "export const viewRows = [\n";
  for (const ViewRow& row : kViewRows) {
    text += fmt::format("  {{ name: \"{}\", type: \"{}\", count: {}, scale: {} }},\n", row.name,
                        type_name(row.type), row.count, row.scale);
  }
  return text + "] as const satisfies readonly ViewRow[];\n";
}

std::string view_golden() {
  const ViewState state = example();
  nlohmann::ordered_json golden;
  std::string hex;
  for (const char byte : encode_view(state)) {
    hex += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  }
  golden["bytes"] = hex;
  for (const ViewRow& row : kViewRows) {
    nlohmann::ordered_json values = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < (row.count > 0 ? row.count : state.joint_count); ++i) {
      const double value = row.value(state, i);
      values.push_back(std::isnan(value) ? nlohmann::ordered_json() : nlohmann::ordered_json(value));
    }
    golden["values"][std::string(row.name)] = values;
  }
  return golden.dump(1) + "\n";
}

}  // namespace gaitway::page

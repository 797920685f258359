// The operations of the protocol with an example each, for the reference and for whoever tries them all.
#pragma once

#include <array>
#include <string_view>

#include "gaitway/api/message_definition.hpp"

namespace gaitway::api {

struct OperationRow {
  std::string_view name;
  Sender sender = Sender::client;
  std::string_view doc;
  std::string_view fields;   // one a line: name, type, meaning, between bars
  std::string_view example;  // a message, as JSON
  std::string_view answer;   // what the first message in answer holds, among others; empty: there is none
};

inline constexpr std::array kOperations{
    OperationRow{
        "auth", Sender::client,
        "Show the token, where one is wanted and the handshake did not bring it. The first operation "
        "then.",
        "token|string|the token; `mac` is read, too\n", R"({"op": "auth", "token": "the token"})", ""},
    OperationRow{
        "subscribe", Sender::client,
        "Get a topic's messages from now on; of a latched topic also the last one, at once. The topic is the "
        "robot's, "
        "or one that clients have among themselves, which need not be advertised yet.",
        "topic|string|its name\n"
        "type|string|optional where somebody has told it: its type, refused when it is another\n"
        "id|string or integer|optional: for unsubscribe\n"
        "throttle_rate|integer|optional: ms between messages, at least\n"
        "queue_length|integer|optional: how many messages wait when you are slow; the oldest are dropped\n"
        "fragment_size|integer|optional: bytes above which messages come in fragments\n"
        "compression|string|optional: \"none\" for JSON, \"cbor\", or, of the robot's topics, \"cbor-raw\" "
        "for CBOR around CDR\n",
        R"({"op": "subscribe", "topic": "/joint_states", "type": "sensor_msgs/msg/JointState", )"
        R"("throttle_rate": 50, "queue_length": 1})",
        R"({"op": "publish", "topic": "/joint_states"})"},
    OperationRow{"unsubscribe", Sender::client, "End a subscription.",
                 "topic|string|its name\nid|string or integer|optional: only the one with this id\n",
                 R"({"op": "unsubscribe", "topic": "/joint_states"})", ""},
    OperationRow{
        "advertise", Sender::client,
        "Say that you will publish a topic: the robot's velocity, where that is not needed, or one of "
        "the clients' own, whose type the first who uses it tells.",
        "topic|string|one that the robot takes, or one of the clients' own\n"
        "type|string|its type; of clients' own topics any, refused when others use it with another\n"
        "latch|bool|optional, of clients' own topics: your last message is kept for who subscribes later\n"
        "id|string or integer|optional: for unadvertise\n",
        R"({"op": "advertise", "topic": "/operator/notes", "type": "std_msgs/msg/String", "latch": true})",
        ""},
    OperationRow{
        "publish", Sender::client,
        "Send a message to the robot, or to all clients that subscribe to a topic of the clients' own. To "
        "the robot: "
        "fields that are left out are zero; a field that does not exist, a wrong type and a number out of "
        "range are "
        "refused by name. To clients: passed on as it is. Who has not advertised such a topic does so by "
        "this.",
        "topic|string|one that the robot takes, or one of the clients' own\nmsg|object|the message\n"
        "type|string|optional: as in advertise\n",
        R"({"op": "publish", "topic": "/cmd_vel", "msg": {"linear": {"x": 0.1}, "angular": {"z": 0.05}}})",
        ""},
    OperationRow{"unadvertise", Sender::client,
                 "Say that you will publish no more. What was kept of you is forgotten.",
                 "topic|string|its name\nid|string or integer|optional: only the one with this id\n",
                 R"({"op": "unadvertise", "topic": "/operator/notes"})", ""},
    OperationRow{
        "call_service", Sender::client, "Call a service.",
        "service|string|its name\n"
        "args|object or array|optional: the request's fields, by name or in order\n"
        "id|string or integer|optional: the answer bears it\n"
        "timeout|number|optional: s after which you wait no longer\n"
        "fragment_size|integer|optional: bytes above which the answer comes in fragments\n"
        "compression|string|optional: \"none\" for JSON, \"cbor\"\n",
        R"({"op": "call_service", "id": "time", "service": "/rosapi/get_time", "args": {}})",
        R"({"op": "service_response", "id": "time", "service": "/rosapi/get_time", "result": true})"},
    OperationRow{"set_level", Sender::client, "Say which status messages you want.",
                 "level|string|\"none\", \"error\", \"warning\" or \"info\"\n",
                 R"({"op": "set_level", "level": "warning"})", ""},
    OperationRow{
        "advertise_service", Sender::client,
        "Offer a service to other clients. Calls of it come to you as `call_service`. One client offers a "
        "name; those of the robot's services cannot be taken.",
        "service|string|its name\ntype|string|its type, any\n",
        R"({"op": "advertise_service", "type": "std_srvs/srv/Trigger", "service": "/operator/confirm"})", ""},
    OperationRow{
        "service_response", Sender::client,
        "Answer a call that came to you, once. Without an answer in time, or when you go, the call fails.",
        "service|string|as in the call\nid|string|as in the call\n"
        "result|bool|false: it could not be carried out\n"
        "values|object|the response; when `result` is false it may be a text that says why\n",
        R"({"op": "service_response", "service": "/operator/confirm", "id": "call:1", )"
        R"("values": {"success": true, "message": "yes"}, "result": true})",
        R"({"op": "status", "level": "warning"})"},
    OperationRow{"unadvertise_service", Sender::client,
                 "Offer the service no more. Calls that wait for you fail.", "service|string|its name\n",
                 R"({"op": "unadvertise_service", "service": "/operator/confirm"})", ""},
    OperationRow{
        "publish", Sender::robot, "A message of a topic that you subscribed to.",
        "topic|string|its name\nmsg|object|the message\n",
        R"({"op": "publish", "topic": "/clock", "msg": {"clock": {"sec": 12, "nanosec": 340000000}}})", ""},
    OperationRow{"call_service", Sender::robot, "A call of a service that you offer.",
                 "service|string|its name, as you advertised it\nid|string|for your `service_response`\n"
                 "args|object or array|the request, as the caller wrote it\n",
                 R"({"op": "call_service", "service": "/operator/confirm", "id": "call:1", "args": {}})", ""},
    OperationRow{
        "service_response", Sender::robot, "The answer to a call.",
        "service|string|its name\nid|string or integer|as in the call, if there was one\n"
        "result|bool|false: the call could not be carried out, and `values` is a text that says why\n"
        "values|object|the response\n",
        R"({"op": "service_response", "service": "/stand", "id": 7, )"
        R"("values": {"success": true, "message": "stands"}, "result": true})",
        ""},
    OperationRow{
        "status", Sender::robot, "What went wrong, for people: names the field, its value and the rule.",
        "level|string|\"error\", \"warning\" or \"info\"\nmsg|string|the text\n"
        "id|string or integer|of the operation that it is about, if that had one\n",
        R"({"op": "status", "level": "error", "msg": "linear.x is null, but must be a finite number"})", ""},
    OperationRow{"fragment", Sender::robot, "A part of a message that was too long for your `fragment_size`.",
                 "id|string|the same of all parts\ndata|string|the part\nnum|integer|from 0\n"
                 "total|integer|how many parts\n",
                 R"({"op": "fragment", "id": "1", "data": "{\"op\": \"publ", "num": 0, "total": 150})", ""},
};

}  // namespace gaitway::api

// Facts with numbers come from the tables, not from here: what stands here is why.
#include "tools/bus/network_document_text.hpp"

namespace gaitway::tools {

const std::string_view kHowTheNetworkWorks =
    R"(One CAN bus at 1 Mb/s connects the message controller with one local controller a joint. Frames are classic CAN with 11-bit
identifiers and at most 8 data bytes. A lower identifier wins the bus, so an identifier is a priority; identifiers follow the
deadlines, the shortest first.

**Time.** A cycle is 80 ms: eight time slots of 10 ms. At every slot's edge the message controller sends SYNC with the number of
the cycle and the slot. Every joint takes its place in time from it, answers with one feedback frame, and moves to the point of
this slot; by the slot's end it has reached that point. A joint that misses a SYNC goes on by its own clock for the rest of the
batch and is realigned by the next SYNC.

**Batches.** A trajectory frame holds eight points for one joint, one byte each: what is executed in one cycle. A point is the
change of the joint's reference in counts since the point before (the count's size is in the robot's network file). The message
controller rounds absolute references and sends their differences, so rounding errors never add up; a change that a signed byte
cannot hold is refused before it comes here, by name, and never clipped. Frames of the next batch are sent while the
current one runs. Nothing moves on their arrival: the SYNC of slot 0 says whether a batch was committed and which toggle it has, and
every joint that holds it starts together with all others.

**Revisions.** Where the network file says `network: {revision_slot: 4}` (or another slot from 2 to 6; the shipped robot's says none), the batch
that runs may be revised once, from that slot on. The frames of a revision bear all eight changes of their batch, those before that slot
as they were played, and the other toggle; the SYNC of the slot names it. So a joint that hears of it late still comes to the same
count: it makes up for what the points differ by in the slots that it has taken. One that does not hold the frame plays its
batch on, and is repaired like any other. A revision is committed once it is accepted; one that is handed over too late to be sent in
time, or to another batch than the running one, is refused, and the batch goes on as it is. Its safe tail replaces the batch's. The
proof counts with the frames of both: from slot 4 on, one of each joint every 40 ms.

**Toggle.** Eight points fill the frame, so nothing in it can number it. Instead each joint has two trajectory identifiers, which
take turns from batch to batch, or revision. A frame that CAN delivers twice, or that is sent again as a repair, bears the same toggle and changes
nothing; only the next batch, or a revision, has the other one.

**Feedback** is position, torque, two sensor channels, and what the joint knows of its batches: the toggle that it plays, the newest
that it holds, and the low four bits of its own reference count. The message controller knows what each of these must be. So a
lost, doubled or stale trajectory frame shows within one time slot, and a missing joint within two: feedback is the heartbeat, too.

**Repair.** The feedback of the last slot says who holds the next batch. To whoever does not, its frame is sent again before the
start. A joint that has a wrong count, or no batch, once the cycle runs gets one absolute frame (resynchronisation): the count that it
must have at the end of the next slot, and the changes of the slots after it. It glides there within that slot; it does not jump.

**Trims** are small corrections for balance, made from the newest sensor values: absolute angles for up to eight joints in one
broadcast frame every slot, added to the references, limited in size and speed by the joint itself, and fading out when none comes
for three slots.

**Faults.** A joint reports a fault when it begins and when it ends. A joint that has restarted stands where its encoder
says, tells so, and is brought back by a resynchronisation. When no new batch is handed over in time, the message controller
plays the safe tail that came with the last one and the robot stands. If the message controller itself is gone, the joints play out
their batch and hold. A frame with an identifier that is not on this page, with another length, or in remote or extended format is
counted under its cause and changes nothing. Classic CAN cannot tell who sent a frame, but the message controller hears them all: one that
bears its own identifier and is not its own is a forgery, what it may have done to the joint is put right, and the robot stops
safely.

**Emergency stop** is the most urgent frame of all, and is sent again in each slot until every joint's feedback shows that it has stopped.
)";

const std::string_view kHowToReadTheFields =
    R"(Bits are counted as in a `.dbc` file with little-endian signals: bit 8·b + i is bit i of byte b, so bits 0 to 7 are the first byte. Numbers
are two's complement where they are signed. Bits that no field has are sent as 0 and not looked at. A frame with another
number of bytes than its message is not that message.
)";

const std::string_view kThePaperProfile =
    R"(The published network has 25 messages and nothing else: twelve leg joints, one trajectory and one sensor message each, and the user
command. There is no SYNC: a batch starts as it arrives, and each joint counts its slots by its own clock. There is no
toggle, no trim and no resynchronisation either, so a joint that lost its batch gets the rest of it as a batch of its own. An
emergency stop is a user command to node 0. Feedback has the same bits as in the full profile, in the place of the published sensor
message. The robot walks slowly with it, and the joints without a local controller are held still. `network: {profile: paper}` in
the robot's network file chooses it.
)";

const std::string_view kWhereElse =
    R"(- [gaitway.dbc](gaitway.dbc) is this page for tools: `./dev gaitway bus dbc --out docs/gaitway.dbc` makes it, and
  `gaitway bus dbc --robot DIR` makes the one of your robot.
- [bus-tools.md](bus-tools.md): how to attach python-can, cantools, can-utils or SavvyCAN to a running robot.
- `can/include/gaitway/can/message_layout.hpp` and `profile.hpp` are the tables that this page, the `.dbc` file, the codecs and the
  scheduler follow. After a change there: `./dev gaitway bus document --out docs/network.md`.
)";

}  // namespace gaitway::tools

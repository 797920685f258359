// The robot's bus as it is meant to be, for a page that draws beside it what was seen.
#pragma once

#include "gaitway/page/asset_table.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::page {

// Adds /bus.json: the messages of the robot's bus, in their order of priority, as message controller and
// proof have them. Times in microseconds.
//
//   profile, slot_us, cycle_slots     of the robot
//   interframe_us                     that follow each frame
//   load                              proven: share of the time that all messages take at most
//   jitter_us, jam_us                 what the worst cases allow for: how late a sender may be, how long the
//   bus is unusable messages[]
//     kind, id, ids, bytes            `ids`: those that are one message: a trajectory has one for each toggle
//     joint, sent_by_joint            index in /robot.json; -1: it is for all joints
//     period_us, on_event             at least so long between two of them; whether it comes when something
//     happens only transmission_us                 of the longest frame released                        by
//     what one sees when it was released: can::ReleaseSign; "" when one does not worst_us from there to its
//     arrival, proven; null: no bound deadline_us
//
// Throws urdf::RobotError when the robot's network file makes no profile.
void add_bus(AssetTable& table, const urdf::RobotModel& robot);

}  // namespace gaitway::page

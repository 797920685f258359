// Finds the pairs of links that may not touch each other, and tells the physics model of them.
#include "gaitway/simulator/self_collision.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "physics_model.hpp"

namespace gaitway::simulator {
namespace {

// Nearer than this is touching: rounding decides whether faces that lie flush are apart.
constexpr double kTouching_m = 0.001;       // of a body like humanoid22
constexpr double kAboveTheWorld_m = 100.0;  // where the robot touches nothing but itself
constexpr int kSignatureBits = 16;          // of a body, in the signature of an excluded pair

int parent_of(const urdf::RobotModel& robot, int link) {
  const int joint = robot.links[static_cast<std::size_t>(link)].parent_joint;
  return robot.joints[static_cast<std::size_t>(joint)].parent_link;
}

bool has_shapes(const urdf::RobotModel& robot, int link) {
  return !robot.links[static_cast<std::size_t>(link)].collision.empty();
}

bool are_neighbours(const urdf::RobotModel& robot, LinkPair pair) {
  return joints_between(robot, pair) <= kNeighbourJoints;
}

// Body i + 1 of the model is link i.
LinkPair links_of(int body, int other_body) {
  const auto [first, second] = std::minmax(body, other_body);
  return {first - 1, second - 1};
}

// At home, far above whatever else the model has.
DataPointer data_at_home(const mjModel& model, const urdf::RobotModel& robot) {
  DataPointer data(mj_makeData(&model));
  data->qpos[2] = kAboveTheWorld_m;
  for (const urdf::Joint& joint : robot.joints) {
    data->qpos[model.jnt_qposadr[model.body_jntadr[joint.child_link + 1]]] = joint.home_rad;
  }
  mj_kinematics(&model, data.get());
  return data;
}

// How near the links' shapes must be for a contact.
void set_margin(mjModel& model, int links, double margin_m) {
  std::fill_n(model.body_margin + 1, links, margin_m);
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const int body = model.geom_bodyid[geom];
    if (body >= 1 && body <= links) model.geom_margin[geom] = margin_m;
  }
}

}  // namespace

// Parents come before children.
int joints_between(const urdf::RobotModel& robot, LinkPair pair) {
  int joints = 0;
  for (; pair.one != pair.other; ++joints) {
    int& further = pair.one > pair.other ? pair.one : pair.other;
    further = parent_of(robot, further);
  }
  return joints;
}

std::vector<LinkPair> neighbouring_links(const urdf::RobotModel& robot) {
  std::vector<LinkPair> pairs;
  const int links = static_cast<int>(robot.links.size());
  for (int one = 0; one < links; ++one) {
    for (int other = one + 1; has_shapes(robot, one) && other < links; ++other) {
      if (has_shapes(robot, other) && are_neighbours(robot, {one, other})) pairs.push_back({one, other});
    }
  }
  return pairs;
}

std::vector<LinkPair> touching_at_home(mjModel& model, const urdf::RobotModel& robot) {
  const int links = static_cast<int>(robot.links.size());
  const double touching_m = kTouching_m * robot.body_scale().factor("m");
  set_margin(model, links, touching_m);
  const DataPointer data = data_at_home(model, robot);
  mj_collision(&model, data.get());
  set_margin(model, links, 0.0);
  std::vector<LinkPair> pairs;
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& contact = data->contact[i];
    const LinkPair pair = links_of(model.geom_bodyid[contact.geom[0]], model.geom_bodyid[contact.geom[1]]);
    const bool is_own = pair.one >= 0 && pair.other < links;
    if (is_own && contact.dist < touching_m && std::ranges::find(pairs, pair) == pairs.end()) {
      pairs.push_back(pair);
    }
  }
  return pairs;
}

void leave_out(mjSpec* spec, const urdf::RobotModel& robot, const std::vector<LinkPair>& pairs) {
  for (const LinkPair& pair : pairs) {
    mjsExclude* const exclude = mjs_addExclude(spec);
    mjs_setString(exclude->bodyname1, robot.links[static_cast<std::size_t>(pair.one)].name.c_str());
    mjs_setString(exclude->bodyname2, robot.links[static_cast<std::size_t>(pair.other)].name.c_str());
  }
}

std::vector<LinkPair> links_touching_at_home(const urdf::RobotModel& robot) {
  ModelMismatch exact;
  exact.mass_factor.assign(robot.links.size(), 1.0);
  const ModelPointer model = build_physics_model(robot, exact, {}, std::nullopt);
  std::vector<LinkPair> pairs;
  for (int i = 0; i < static_cast<int>(model->nexclude); ++i) {
    const int signature = model->exclude_signature[i];
    const LinkPair pair = links_of(signature >> kSignatureBits, signature & ((1 << kSignatureBits) - 1));
    if (!are_neighbours(robot, pair)) pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace gaitway::simulator

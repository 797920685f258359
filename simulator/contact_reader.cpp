// Sorts contacts: soles that stand, links that touch each other, and everything else.
#include "contact_reader.hpp"

#include <algorithm>

namespace gaitway::simulator {
namespace {

// Of the force's direction with the sole's normal: what pushes more from the side than from below does not
// load a sole.
constexpr double kLeastCosine = 0.5;

}  // namespace

Eigen::Isometry3d body_pose(const mjData& data, int body) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.xmat + std::ptrdiff_t{9} * body);
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(data.xpos + std::ptrdiff_t{3} * body);
  return pose;
}

ContactReader::ContactReader(const mjModel& model, const urdf::RobotModel& robot,
                             const std::optional<world::World>& world)
    : links_(static_cast<int>(robot.links.size())),
      trunk_link_(robot.imu.link),
      foot_link_{robot.feet[0].link, robot.feet[1].link},
      sole_in_foot_{robot.feet[0].sole, robot.feet[1].sole},
      link_force_N_(robot.links.size(), 0.0) {
  body_.reserve(robot.links.size() * 4);
  follow(model, world);
}

void ContactReader::follow(const mjModel& model, const std::optional<world::World>& world) {
  has_world_ = world.has_value();
  solid_of_geom_.assign(static_cast<std::size_t>(model.ngeom), BodyContact::kFloor);
  is_ground_.clear();
  body_.clear();
  if (!world) return;
  for (const world::Solid& solid : world->all_solids(true)) {
    const int geom = mj_name2id(&model, mjOBJ_GEOM, world_name(solid).c_str());
    solid_of_geom_[static_cast<std::size_t>(geom)] = static_cast<int>(is_ground_.size());
    is_ground_.push_back(world::is_ground(solid.kind));
  }
}

// The robot's bodies come first, behind the world's.
ContactReader::Links ContactReader::links_in(const mjModel& model, const mjContact& contact) const {
  const auto link_of = [&](int geom) {
    const int body = model.geom_bodyid[geom];
    return body >= 1 && body <= links_ ? body - 1 : BodyContact::kNoLink;
  };
  const auto [lower, higher] = std::minmax({link_of(contact.geom[0]), link_of(contact.geom[1])});
  if (lower == BodyContact::kNoLink) return {.link = higher};
  return {.link = lower, .other_link = higher};
}

// On a plain floor whatever touches a foot loads it.
bool ContactReader::is_on_sole(const mjModel& model, const mjContact& contact, std::size_t foot) const {
  if (!has_world_) return true;
  const bool foot_is_second = model.geom_bodyid[contact.geom[1]] == foot_link_[foot] + 1;
  const Eigen::Vector3d normal = Eigen::Map<const Eigen::Vector3d>(contact.frame);  // from first to second
  const Eigen::Vector3d on_foot = foot_is_second ? normal : Eigen::Vector3d(-normal);
  return on_foot.dot(ground_.sole[foot].linear().col(2)) > kLeastCosine;
}

int ContactReader::link_inside(const mjModel& model, const mjData& data, int solid, double deepest_m) const {
  for (int i = 0; solid >= 0 && i < data.ncon; ++i) {
    const mjContact& contact = data.contact[i];
    const bool is_it = solid_of(contact.geom[0]) == solid || solid_of(contact.geom[1]) == solid;
    const int link = links_in(model, contact).link;
    if (is_it && link >= 0 && contact.dist < -deepest_m) return link;
  }
  return -1;
}

void ContactReader::add_body_contact(const BodyContact& contact) {
  const auto same = std::ranges::find_if(body_, [&](const BodyContact& one) {
    return one.link == contact.link && one.solid == contact.solid && one.other_link == contact.other_link;
  });
  if (same != body_.end()) {
    same->force_N += contact.force_N;
  } else {
    body_.push_back(contact);
  }
}

void ContactReader::add_link_force(int link, double force_N) {
  double& on_link_N = link_force_N_[static_cast<std::size_t>(link)];
  on_link_N += force_N;
  ground_.body_force_N += force_N;
  ground_.trunk_force_N += link == trunk_link_ ? force_N : 0.0;
  ground_.hardest_force_N = std::max(ground_.hardest_force_N, on_link_N);
}

void ContactReader::read(const mjModel& model, const mjData& data) {
  std::array<Eigen::Vector2d, 2> moment{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  ground_.body_force_N = ground_.hardest_force_N = ground_.trunk_force_N = 0.0;
  std::ranges::fill(link_force_N_, 0.0);
  body_.clear();
  for (std::size_t foot = 0; foot < 2; ++foot) {
    ground_.sole[foot] = body_pose(data, foot_link_[foot] + 1) * sole_in_foot_[foot];
    ground_.normal_force_N[foot] = 0.0;
  }
  for (int i = 0; i < data.ncon; ++i) {
    const mjContact& point = data.contact[i];
    const auto [link, other_link] = links_in(model, point);
    if (point.efc_address < 0 || link < 0) continue;
    double force[6];
    mj_contactForce(&model, &data, i, force);
    if (other_link >= 0) {
      add_body_contact({.link = link, .force_N = force[0], .other_link = other_link});
      continue;  // no ground
    }
    const int solid = std::max(solid_of(point.geom[0]), solid_of(point.geom[1]));
    const std::size_t foot = link == foot_link_[0] ? 0 : link == foot_link_[1] ? 1 : 2;
    if (foot == 2) add_link_force(link, force[0]);
    const bool on_sole = foot != 2 && is_on_sole(model, point, foot);
    if (on_sole) {
      const Eigen::Vector3d position = Eigen::Map<const Eigen::Vector3d>(point.pos);
      ground_.normal_force_N[foot] += force[0];
      moment[foot] += force[0] * (ground_.sole[foot].inverse() * position).head<2>();
    }
    const bool stands =
        on_sole && (solid == BodyContact::kFloor || is_ground_[static_cast<std::size_t>(solid)]);
    if (!stands) add_body_contact({.link = link, .solid = solid, .force_N = force[0]});
  }
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const double force = ground_.normal_force_N[foot];
    ground_.foot_cop_m[foot] = force > 0.0 ? Eigen::Vector2d(moment[foot] / force) : Eigen::Vector2d::Zero();
  }
}

}  // namespace gaitway::simulator

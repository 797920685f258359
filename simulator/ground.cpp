// Lays the ground of the physics model: plane, slope, step and tiles.
#include "physics_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "gaitway/facts/random_stream.hpp"

namespace gaitway::simulator {
namespace {

constexpr int kGroundType = 1;  // the ground touches everything of the robot
constexpr double kThickness_m = 0.05;
constexpr double kFarAway_m = 100.0;
constexpr int kTileColumns = 12, kTileRows = 8;  // 1.2 m by 0.8 m: more than the feet reach
constexpr double kFlatAroundStart_m = 0.2;

std::string tile_name(int column, int row) {
  return "tile_" + std::to_string(column) + "_" + std::to_string(row);
}

void add_materials(mjSpec* spec) {
  mjsTexture* const texture = mjs_addTexture(spec, nullptr);
  mjs_setName(texture->element, "checker");
  texture->type = mjTEXTURE_2D;
  texture->builtin = mjBUILTIN_CHECKER;
  texture->width = texture->height = 256;
  for (int i = 0; i < 3; ++i) {
    texture->rgb1[i] = 0.86;
    texture->rgb2[i] = 0.76;
  }
  mjsMaterial* const material = mjs_addMaterial(spec, nullptr);
  mjs_setName(material->element, "ground");
  mjs_setInStringVec(material->textures, mjTEXROLE_RGB, "checker");
  material->texuniform = 1;
  material->texrepeat[0] = material->texrepeat[1] = 5.0F;  // squares of 10 cm
}

mjsGeom* add_shape(mjSpec* spec, const GroundConditions& ground, double friction, const std::string& name,
                   const Eigen::Vector3d& place_m) {
  mjsGeom* const geom = mjs_addGeom(mjs_findBody(spec, "world"), nullptr);
  mjs_setName(geom->element, name.c_str());
  const Eigen::Quaterniond rotation = ground_rotation(ground);
  const Eigen::Vector3d position = rotation * place_m;
  std::copy_n(position.data(), 3, geom->pos);
  geom->quat[0] = rotation.w();
  geom->quat[1] = rotation.x();
  geom->quat[2] = rotation.y();
  geom->quat[3] = rotation.z();
  geom->contype = kGroundType;
  geom->conaffinity = 0;
  geom->friction[0] = friction;
  mjs_setString(geom->material, "ground");
  return geom;
}

void add_box(mjSpec* spec, const GroundConditions& ground, double friction, const std::string& name,
             const Eigen::Vector3d& top_m, const Eigen::Vector3d& size_m) {
  mjsGeom* const box =
      add_shape(spec, ground, friction, name, top_m - Eigen::Vector3d(0.0, 0.0, size_m.z() / 2.0));
  box->type = mjGEOM_BOX;
  for (Eigen::Index i = 0; i < 3; ++i) box->size[i] = size_m[i] / 2.0;
}

}  // namespace

Eigen::Quaterniond ground_rotation(const GroundConditions& ground) {
  const Eigen::Vector3d normal(-std::tan(ground.slope_rad.x()), -std::tan(ground.slope_rad.y()), 1.0);
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal);
}

void add_ground(mjSpec* spec, const GroundConditions& ground, double friction) {
  add_materials(spec);
  // A box lies on the plane where the ground is higher; so the plane is the lower of the two levels.
  const bool tiles = ground.tile_height_m > 0.0;
  const double step_m = ground.step ? ground.step->height_m : 0.0;
  const double plane_m = tiles ? -kThickness_m : std::min(0.0, step_m);
  mjsGeom* const plane = add_shape(spec, ground, friction, "ground", {0.0, 0.0, plane_m});
  plane->type = mjGEOM_PLANE;
  plane->size[0] = plane->size[1] = 0.0;  // endless
  plane->size[2] = kThickness_m;
  if (step_m != 0.0) {
    const double side = step_m > 0.0 ? 0.5 : -0.5;  // the higher ground lies beyond the line, or before it
    add_box(spec, ground, friction, "step",
            {ground.step->at_m + side * kFarAway_m, 0.0, std::max(0.0, step_m)},
            {kFarAway_m, kFarAway_m, std::abs(step_m)});
  }
  for (int column = 0; tiles && column < kTileColumns; ++column) {
    for (int row = 0; row < kTileRows; ++row) {
      add_box(spec, ground, friction, tile_name(column, row), Eigen::Vector3d::Zero(),
              {kTileSide_m, kTileSide_m, kThickness_m});
    }
  }
}

TileField::TileField(const mjModel& model, const GroundConditions& ground, std::uint64_t seed)
    : rotation_(ground_rotation(ground)), largest_m_(ground.tile_height_m), seed_(seed) {
  for (int column = 0; largest_m_ > 0.0 && column < kTileColumns; ++column) {
    for (int row = 0; row < kTileRows; ++row) {
      geoms_.push_back(mj_name2id(&model, mjOBJ_GEOM, tile_name(column, row).c_str()));
    }
  }
}

double TileField::height_m(std::int64_t column, std::int64_t row) const noexcept {
  const auto reach = static_cast<std::int64_t>(std::lround(kFlatAroundStart_m / kTileSide_m));
  if (column >= -reach && column < reach && row >= -reach && row < reach) return 0.0;
  const std::uint64_t place =
      static_cast<std::uint64_t>(column) * 0x1'0000'0001ULL ^ static_cast<std::uint64_t>(row);
  return largest_m_ * facts::RandomStream(seed_, place).uniform();
}

void TileField::follow(mjModel& model, const Eigen::Vector3d& point_m) {
  if (geoms_.empty()) return;
  const Eigen::Vector3d local = rotation_.inverse() * point_m;
  if (!local.allFinite()) return;
  const auto column = static_cast<std::int64_t>(std::floor(local.x() / kTileSide_m));
  const auto row = static_cast<std::int64_t>(std::floor(local.y() / kTileSide_m));
  if (laid_ && column == column_ && row == row_) return;
  laid_ = true;
  column_ = column;
  row_ = row;
  for (std::int64_t c = column - kTileColumns / 2; c < column + kTileColumns / 2; ++c) {
    for (std::int64_t r = row - kTileRows / 2; r < row + kTileRows / 2; ++r) {
      const std::int64_t slot_column = (c % kTileColumns + kTileColumns) % kTileColumns;
      const std::int64_t slot_row = (r % kTileRows + kTileRows) % kTileRows;
      const int geom = geoms_[static_cast<std::size_t>(slot_column * kTileRows + slot_row)];
      const Eigen::Vector3d centre = rotation_ * Eigen::Vector3d((static_cast<double>(c) + 0.5) * kTileSide_m,
                                                                 (static_cast<double>(r) + 0.5) * kTileSide_m,
                                                                 height_m(c, r) - kThickness_m / 2.0);
      std::copy_n(centre.data(), 3, model.geom_pos + std::ptrdiff_t{3} * geom);
    }
  }
}

}  // namespace gaitway::simulator

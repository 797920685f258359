// What links look like and where they touch: boxes, cylinders, spheres and meshes, each as collision and as
// visual; and every way in which a mesh can be wrong is refused with file, line, element, rule and remedy.
#include <limits>

#include "broken_robot.hpp"
#include "robots/mesh_files.hpp"

namespace gaitway::urdf {
namespace {

using gaitway::test::box_triangles;
using gaitway::test::stl_bytes;
using test::BrokenRobot;
using Kind = Shape::Kind;

constexpr const char* kThigh = "<link name=\"left_thigh\"";
constexpr const char* kThighTouches = "<box size=\"0.06 0.06 0.12\"/>";
constexpr const char* kThighLooks = "<box size=\"0.06 0.06 0.11\"/>";
constexpr const char* kMesh = "<mesh filename=\"meshes/thigh.stl\"/>";

class ShapesTest : public ::testing::Test {
 protected:
  // A thigh that touches with `geometry`, and a file for it.
  void touch_with(const std::string& geometry) {
    robot_.replace("robot.urdf", kThigh, kThighTouches, geometry);
  }
  void write_mesh(const std::string& bytes, const std::string& file = "meshes/thigh.stl") {
    gaitway::test::write_file(robot_.folder() / file, bytes);
  }
  [[nodiscard]] Link thigh() const {
    const RobotModel model = robot_.load();
    return model.links[static_cast<std::size_t>(model.link_index("left_thigh"))];
  }
  // With the line and the element of the thigh's mesh.
  void expect_mesh_refused(const std::vector<std::string>& parts) const {
    std::vector<std::string> all{robot_.line_of("robot.urdf", "<mesh "),
                                 "link 'left_thigh' collision mesh = '"};
    all.insert(all.end(), parts.begin(), parts.end());
    robot_.expect_complaint(all);
  }

  const std::string thigh_mesh_ = stl_bytes(box_triangles({0.06F, 0.05F, 0.12F}, {0.0F, 0.01F, -0.09F}));
  BrokenRobot robot_;
};

TEST_F(ShapesTest, CollisionIsABoxACylinderASphereOrAMesh) {
  EXPECT_EQ(thigh().collision.front().kind, Kind::box);
  touch_with("<cylinder radius=\"0.03\" length=\"0.12\"/>");
  EXPECT_EQ(thigh().collision.front().kind, Kind::cylinder);
  EXPECT_EQ(thigh().collision.front().size_m, Eigen::Vector3d(0.06, 0.06, 0.12));
  robot_.replace("robot.urdf", kThigh, "<cylinder radius=\"0.03\" length=\"0.12\"/>",
                 "<sphere radius=\"0.03\"/>");
  EXPECT_EQ(thigh().collision.front().kind, Kind::sphere);
  EXPECT_EQ(thigh().collision.front().size_m, Eigen::Vector3d(0.06, 0.06, 0.06));
}

TEST_F(ShapesTest, AMeshHasTheExtentOfItsPointsAndItsPlaceInTheMiddle) {
  const Eigen::Isometry3d origin = thigh().collision.front().pose;
  write_mesh(thigh_mesh_);
  touch_with(kMesh);
  const Shape shape = thigh().collision.front();
  EXPECT_EQ(shape.kind, Kind::mesh);
  EXPECT_EQ(shape.mesh.file, robot_.folder() / "meshes/thigh.stl");
  EXPECT_LT((shape.size_m - Eigen::Vector3d(0.06, 0.05, 0.12)).norm(), 1e-7);
  EXPECT_LT((shape.pose.translation() - origin * Eigen::Vector3d(0.0, 0.01, -0.09)).norm(), 1e-7);
  EXPECT_LT((shape.mesh.centre_m - Eigen::Vector3d(0.0, 0.01, -0.09)).norm(), 1e-7);
  EXPECT_EQ(robot_.load().mesh_files(), std::vector{shape.mesh.file});
}

TEST_F(ShapesTest, TheScaleTurnsMillimetresIntoMetresAndMirrors) {
  write_mesh(stl_bytes(box_triangles({60.0F, 50.0F, 120.0F}, {0.0F, 10.0F, -90.0F})));
  touch_with("<mesh filename=\"meshes/thigh.stl\" scale=\"0.001 -0.001 0.001\"/>");
  const Shape shape = thigh().collision.front();
  EXPECT_LT((shape.size_m - Eigen::Vector3d(0.06, 0.05, 0.12)).norm(), 1e-7);
  EXPECT_LT((shape.mesh.centre_m - Eigen::Vector3d(0.0, -0.01, -0.09)).norm(), 1e-7);
}

TEST_F(ShapesTest, AVisualMeshKeepsItsColourAndMayBeFlat) {
  std::vector<gaitway::test::Triangle> plate = box_triangles({0.06F, 0.05F, 0.0F});
  write_mesh(stl_bytes(plate));
  robot_.replace("robot.urdf", kThigh, kThighLooks, kMesh);
  const auto seen = thigh().visual;
  const auto mesh =
      std::find_if(seen.begin(), seen.end(), [](const Shape& s) { return s.kind == Kind::mesh; });
  ASSERT_NE(mesh, seen.end());
  EXPECT_EQ(mesh->size_m.z(), 0.0);
  EXPECT_NE(mesh->rgba, Eigen::Vector4d::Ones());
}

TEST_F(ShapesTest, AHeaderThatBeginsLikeTextMakesNoText) {
  std::string bytes = thigh_mesh_;
  bytes.replace(0, 11, "solid facet");
  write_mesh(bytes);
  touch_with(kMesh);
  EXPECT_EQ(robot_.complaint(), "(loaded without complaint)");
}

TEST_F(ShapesTest, AMissingFileIsRefused) {
  touch_with(kMesh);
  expect_mesh_refused({"meshes/thigh.stl': the file is missing", "the path counts from there"});
  std::filesystem::create_directories(robot_.folder() / "meshes/thigh.stl");
  expect_mesh_refused({"the file is missing or cannot be read"});
}

TEST_F(ShapesTest, PackagesAndPathsOutOfTheFolderAreRefused) {
  write_mesh(thigh_mesh_, "../gaitway-elsewhere/thigh.stl");
  const std::filesystem::path elsewhere = robot_.folder().parent_path() / "gaitway-elsewhere";
  std::filesystem::create_symlink(elsewhere / "thigh.stl", robot_.folder() / "link.stl");
  std::string before = kThighTouches;
  for (const std::string& path :
       {std::string("package://biped/meshes/thigh.stl"), std::string("../gaitway-elsewhere/thigh.stl"),
        (elsewhere / "thigh.stl").string(), std::string("link.stl")}) {
    SCOPED_TRACE(path);
    const std::string after = "<mesh filename=\"" + path + "\"/>";
    robot_.replace("robot.urdf", kThigh, before, after);
    before = after;
    expect_mesh_refused({path.starts_with("package") ? "there are no packages" : "leads out of",
                         "Copy the file into the folder"});
  }
  std::filesystem::remove_all(elsewhere);
}

TEST_F(ShapesTest, OtherKindsOfFilesAreRefused) {
  write_mesh(thigh_mesh_, "meshes/thigh.dae");
  touch_with("<mesh filename=\"meshes/thigh.dae\"/>");
  expect_mesh_refused({"must be a binary STL file", "Export the mesh as binary STL"});
}

TEST_F(ShapesTest, FilesThatAreNoBinaryStlAreRefused) {
  touch_with(kMesh);
  write_mesh(
      "solid thigh\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n");
  expect_mesh_refused({"in text form: only the binary one can be read", "Export the mesh as binary STL"});
  for (const std::string& bytes :
       {std::string(), std::string(50, 'x'), std::string(84, '\0'), std::string(84, 'x'), stl_bytes({})}) {
    write_mesh(bytes);
    expect_mesh_refused({"is no binary STL file of 1 to 200000 triangles"});
  }
}

TEST_F(ShapesTest, ATruncatedFileIsRefusedAtLoading) {
  touch_with(kMesh);
  write_mesh(thigh_mesh_.substr(0, thigh_mesh_.size() - 1));
  expect_mesh_refused({"12 triangles take 684 bytes, it has 683"});
  write_mesh(thigh_mesh_ + "x");
  expect_mesh_refused({"12 triangles take 684 bytes, it has 685"});
}

TEST_F(ShapesTest, AFileOfTooManyTrianglesIsRefused) {
  touch_with(kMesh);
  write_mesh(std::string(84 + 50 * 200'001, 'x'));
  expect_mesh_refused({"larger than 200000 triangles", "Simplify the mesh"});
}

TEST_F(ShapesTest, ExtentsThatNoRobotHasAreRefused) {
  touch_with(kMesh);
  write_mesh(stl_bytes(box_triangles({60.0F, 50.0F, 120.0F})));
  robot_.expect_complaint({robot_.line_of("robot.urdf", "<mesh "),
                           "link 'left_thigh' collision = 60 x 50 x 120 m", "Choose the mesh's scale"});
  write_mesh(stl_bytes(box_triangles({6e-5F, 5e-5F, 1e-5F})));
  expect_mesh_refused({"is smaller than 0.1 mm"});
  write_mesh(stl_bytes(box_triangles({0.06F, 0.05F, 0.1F}, {0.0F, 3.0F, 0.0F})));
  robot_.expect_complaint({"link 'left_thigh' collision = ", ", 3.0", "Choose the mesh's scale"});
}

TEST_F(ShapesTest, CornersThatAreNowhereAreRefused) {
  touch_with(kMesh);
  for (const float nowhere :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e9F}) {
    std::vector<gaitway::test::Triangle> triangles = box_triangles({0.06F, 0.05F, 0.12F});
    triangles[7][1][2] = nowhere;
    write_mesh(stl_bytes(triangles));
    expect_mesh_refused({"triangle 8 has a corner that is nowhere"});
  }
}

TEST_F(ShapesTest, WhatHasNoVolumeCannotTouch) {
  touch_with(kMesh);
  write_mesh(stl_bytes(box_triangles({0.06F, 0.05F, 0.0F})));
  expect_mesh_refused({"its points lie in a plane", "Use a thin box"});
  write_mesh(stl_bytes({box_triangles({0.06F, 0.05F, 0.1F}).front()}));
  expect_mesh_refused({"3 different corners: 4 are needed"});
}

TEST_F(ShapesTest, AScaleOfZeroIsRefused) {
  write_mesh(thigh_mesh_);
  touch_with("<mesh filename=\"meshes/thigh.stl\" scale=\"1 0 1\"/>");
  expect_mesh_refused({"none of the three numbers of its scale may be 0"});
}

}  // namespace
}  // namespace gaitway::urdf

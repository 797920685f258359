// Shapes and meshes of links: where they are found, how they are read, written, scaled and mirrored.
#include <sys/stat.h>

#include <cstdlib>
#include <numbers>

#include "maker_folder.hpp"
#include "surface_measures.hpp"

namespace gaitway::importer {
namespace {

using test::box_of;
using test::link;
using test::MakerFolder;
using test::volume_m3;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kPi = std::numbers::pi;

std::string collision(const std::string& shape, const std::string& origin = "") {
  return "<collision>" + origin + "<geometry>" + shape + "</geometry></collision>";
}

std::string mesh(const std::string& uri, const std::string& scale = "") {
  return "<mesh filename=\"" + uri + "\"" + (scale.empty() ? "" : " scale=\"" + scale + "\"") + "/>";
}

Surface shape(const std::string& element) {
  const MakerRobot robot = MakerFolder().read_robot(link("a", collision(element)));
  return robot.links.at(0).collision.at(0);
}

// A tetrahedron with corners at 0 and 1 on each axis, facing outwards; its volume is 1/6.
const std::string kObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string dae(const std::string& asset, const std::string& node = "") {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>)" +
         asset + R"(</asset><library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="f" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common>
<accessor source="#f" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v">
<input semantic="POSITION" source="#p"/></vertices><triangles count="4">
<input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n">)" +
         node +
         R"(<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

struct Expected {
  std::string element;
  double volume_m3;
  Eigen::Vector3d size_m;
};

TEST(Shapes, AreClosedAndFaceOutwards) {
  for (const Expected& expected :
       {Expected{"<box size=\"0.5 1 1.5\"/>", 0.75, {0.5, 1.0, 1.5}},
        Expected{"<cylinder radius=\"0.5\" length=\"1.5\"/>", 0.375 * kPi, {1.0, 1.0, 1.5}},
        Expected{"<sphere radius=\"0.5\"/>", kPi / 6.0, {1.0, 1.0, 1.0}},
        Expected{"<capsule radius=\"0.5\" length=\"0.9\"/>", 0.225 * kPi + kPi / 6.0, {1.0, 1.0, 1.9}}}) {
    const Surface surface = shape(expected.element);
    EXPECT_TRUE(test::is_closed(surface)) << expected.element;
    EXPECT_TRUE(box_of(surface).sizes().isApprox(expected.size_m, 1e-12)) << expected.element;
    EXPECT_TRUE(box_of(surface).center().isZero(1e-12)) << expected.element;
    EXPECT_NEAR(volume_m3(surface) / expected.volume_m3, 1.0, 0.04) << expected.element;
    EXPECT_EQ(surface.source, expected.element.substr(1, expected.element.find(' ') - 1));
  }
}

TEST(Shapes, LieWhereTheirOriginPutsThem) {
  const MakerRobot robot = MakerFolder().read_robot(link(
      "a", collision("<box size=\"0.5 1 1.5\"/>", "<origin xyz=\"1 1 1\" rpy=\"1.5707963267948966 0 0\"/>")));
  const Eigen::AlignedBox3d box = box_of(robot.links[0].collision.at(0));
  EXPECT_TRUE(box.center().isApprox(Eigen::Vector3d(1.0, 1.0, 1.0), 1e-12));
  EXPECT_TRUE(box.sizes().isApprox(Eigen::Vector3d(0.5, 1.5, 1.0), 1e-12));
}

// Whose maker drew it in millimetres.
TEST(Shapes, LargerThanABodyAreLeftOutWithTheRemedy) {
  const MakerFolder folder;
  folder.write("a.obj", kObj);
  const MakerRobot robot = folder.read_robot(
      link("a", collision(mesh("a.obj", "400 400 400")) + collision("<box size=\"0.1 0.1 2.5\"/>")));
  EXPECT_THAT(robot.links[0].collision, IsEmpty());
  EXPECT_THAT(robot.notes,
              ElementsAre(AllOf(HasSubstr("larger than 2 m"), HasSubstr("scale=\"0.001 0.001 0.001\""),
                                HasSubstr("box, 2.5 m long"))));
}

TEST(Shapes, WithoutExtentOrOfUnknownKindAreNoted) {
  const MakerRobot robot = MakerFolder().read_robot(link(
      "a", collision("<box size=\"1 0 1\"/>") + collision("<sphere radius=\"-1\"/>") + collision("") +
               "<visual/>" + collision("<plane normal=\"0 0 1\"/>") + collision(mesh("x.stl", "1 0 1"))));
  EXPECT_THAT(robot.links[0].collision, IsEmpty());
  EXPECT_THAT(
      robot.notes,
      ElementsAre(
          AllOf(HasSubstr("kind that is not known"), HasSubstr("link 'a' collision geometry plane")),
          AllOf(HasSubstr("no extent"), HasSubstr("geometry box"), HasSubstr("geometry sphere"),
                HasSubstr("geometry mesh")),
          AllOf(HasSubstr("no geometry"), HasSubstr("link 'a' visual"), HasSubstr("link 'a' collision"))));
}

TEST(Meshes, AreReadFromObjDaeAndStl) {
  const MakerFolder folder;
  folder.write("a.obj", kObj);
  folder.write("a.dae", dae(""));
  const MakerRobot first = folder.read_robot(link("a", collision(mesh("a.obj")) + collision(mesh("a.dae"))));
  ASSERT_THAT(first.notes, IsEmpty());
  write_stl(folder.path() / "a.STL", first.links[0].collision.at(0));
  const MakerRobot again = folder.read_robot(link("a", collision(mesh("a.STL"))));
  for (const Surface& surface :
       {first.links[0].collision.at(0), first.links[0].collision.at(1), again.links[0].collision.at(0)}) {
    EXPECT_EQ(surface.point_m.size(), 4U) << surface.source;
    EXPECT_EQ(surface.triangle.size(), 4U) << surface.source;
    EXPECT_TRUE(test::is_closed(surface)) << surface.source;
    EXPECT_NEAR(volume_m3(surface), 1.0 / 6.0, 1e-7) << surface.source;
  }
  EXPECT_THAT(again.links[0].collision[0].source, EndsWith("a.STL"));
}

TEST(Meshes, DaeIsInItsUnitButItsUpAxisIsIgnored) {
  const MakerFolder folder;
  for (const char* axis : {"X_UP", "Y_UP", "Z_UP"}) {
    folder.write("a.dae",
                 dae("<unit name=\"centimetre\" meter=\"0.01\"/><up_axis>" + std::string(axis) + "</up_axis>",
                     "<scale>1 2 3</scale>"));
    const MakerRobot robot = folder.read_robot(link("a", collision(mesh("a.dae"))));
    const Eigen::AlignedBox3d box = box_of(robot.links[0].collision.at(0));
    EXPECT_TRUE(box.sizes().isApprox(Eigen::Vector3d(0.01, 0.02, 0.03), 1e-6)) << axis << box.sizes();
    EXPECT_TRUE(box.min().isZero(1e-9)) << axis;
  }
}

TEST(Meshes, AreScaledAndMirrored) {
  const MakerFolder folder;
  folder.write("a.obj", kObj);
  const MakerRobot robot = folder.read_robot(link("a", collision(mesh("a.obj", "1 -1.5 2"))));
  const Surface& surface = robot.links[0].collision.at(0);
  EXPECT_NEAR(volume_m3(surface), 0.5, 1e-6);
  EXPECT_TRUE(box_of(surface).min().isApprox(Eigen::Vector3d(0.0, -1.5, 0.0), 1e-9));
  EXPECT_TRUE(box_of(surface).max().isApprox(Eigen::Vector3d(1.0, 0.0, 2.0), 1e-9));
}

TEST(Meshes, ColourIsTheMeshesUnlessTheUrdfSaysOne) {
  const MakerFolder folder;
  folder.write("a.obj", "mtllib a.mtl\nusemtl green\n" + kObj);
  folder.write("a.mtl", "newmtl green\nKd 0 1 0\n");
  const std::string geometry = "<geometry>" + mesh("a.obj") + "</geometry>";
  const MakerRobot robot =
      folder.read_robot(link("a", "<visual>" + geometry + "</visual><visual>" + geometry +
                                      "<material name=\"m\"><color rgba=\"1 0 0 1\"/></material></visual>"));
  EXPECT_EQ(robot.links[0].visual.at(0).rgba, Eigen::Vector4d(0.0, 1.0, 0.0, 1.0));
  EXPECT_EQ(robot.links[0].visual.at(1).rgba, Eigen::Vector4d(1.0, 0.0, 0.0, 1.0));
}

TEST(Meshes, AreFoundInPackagesAndBesideTheUrdf) {
  const MakerFolder folder, elsewhere;
  folder.write("walker_description/meshes/a.obj", kObj);
  elsewhere.write("renamed/meshes/b.obj", kObj);
  elsewhere.write("walker_description/meshes/c.obj", kObj);
  elsewhere.write("share/walker_description/meshes/d.obj", kObj);
  const std::string absolute = (folder.path() / "walker_description/meshes/a.obj").string();
  const ReadOptions options{{elsewhere.path() / "renamed"}};
  const auto is_found = [&](const std::string& uri) {
    const std::filesystem::path urdf =
        folder.write("walker_description/urdf/walker.urdf",
                     "<robot name=\"r\">" + link("a", collision(mesh(uri))) + "</robot>");
    return read_maker_urdf(urdf, options).notes.empty();
  };
  for (const std::string& uri :
       {std::string("package://walker_description/meshes/a.obj"),
        std::string("model://walker_description/meshes/a.obj"),
        std::string("package:///walker_description/meshes/a.obj"),
        std::string("package://another_name/meshes/a.obj"),
        std::string("package://another_name//meshes/a.obj"), std::string("../meshes/a.obj"),
        "file://" + absolute, absolute, std::string("package://walker_description/meshes/b.obj")}) {
    EXPECT_TRUE(is_found(uri)) << uri;
  }
  for (const char* uri :
       {"package://walker_description/meshes/c.obj", "package://walker_description/meshes/d.obj",
        "package://", "package://walker_description", "a.obj", "http://a.obj", ".."}) {
    EXPECT_FALSE(is_found(uri)) << uri;
  }
  setenv("ROS_PACKAGE_PATH", ("/nowhere::" + elsewhere.path().string()).c_str(), 1);
  EXPECT_TRUE(is_found("package://walker_description/meshes/c.obj"));
  unsetenv("ROS_PACKAGE_PATH");
  setenv("AMENT_PREFIX_PATH", elsewhere.path().c_str(), 1);
  EXPECT_TRUE(is_found("package://walker_description/meshes/d.obj"));
  unsetenv("AMENT_PREFIX_PATH");
}

TEST(Meshes, ThatAreMissingOrBrokenAreNotedOnce) {
  const MakerFolder folder;
  folder.write("broken.obj", "v 0 0\nf 1 2 3 hello there\n");
  folder.write("broken.stl", "nothing");
  folder.write("broken.dae", "<COLLADA>");
  folder.write("empty.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  folder.write("other.blend", "BLENDER");
  std::string surfaces;
  for (const char* name :
       {"none.stl", "none.stl", "broken.obj", "broken.stl", "broken.dae", "empty.obj", "other.blend"}) {
    surfaces += collision(mesh(name));
  }
  const MakerRobot robot = folder.read_robot(link("a", surfaces));
  EXPECT_THAT(robot.links[0].collision, IsEmpty());
  EXPECT_THAT(
      robot.notes,
      ElementsAre(AllOf(HasSubstr("cannot be read"), HasSubstr("broken.obj ("), HasSubstr("broken.stl ("),
                        HasSubstr("broken.dae ("), HasSubstr("empty.obj ("),
                        HasSubstr("other.blend (meshes are read from STL, OBJ and DAE files)")),
                  "Surfaces that name a mesh that was not found are left out: none.stl."));
}

// What is noted of a DAE whose nodes are these.
std::string note_on_dae(const std::string& library, const std::string& node) {
  const MakerFolder folder;
  std::string text = dae("", node);
  text.insert(text.find("<library_visual_scenes>"), "<library_nodes>" + library + "</library_nodes>");
  folder.write("a.dae", text);
  const MakerRobot robot = folder.read_robot(link("a", collision(mesh("a.dae"))));
  return robot.notes.empty() ? "" : robot.notes.front();
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

const std::string kGeometry = "<instance_geometry url=\"#g\"/>";

TEST(Meshes, OfDaeMayInstanceNodes) {
  EXPECT_EQ(
      note_on_dae("<node id=\"x\">" + kGeometry + "</node>", repeated("<instance_node url=\"#x\"/>", 100)),
      "");
}

TEST(Meshes, OfDaeMayCallAnInstanceLikeItsNode) {
  EXPECT_EQ(note_on_dae("<node id=\"x\" name=\"x\">" + kGeometry + "</node>",
                        "<node id=\"first\" name=\"x\"><instance_node url=\"#x\"/></node>"),
            "");
}

TEST(Meshes, OfDaeWhoseNodesHoldThemselvesAreRefused) {
  const std::string x = "<instance_node url=\"#x\"/>", y = "<instance_node url=\"#y\"/>";
  for (const std::string& library :
       {"<node id=\"x\">" + kGeometry + y + "</node><node id=\"y\">" + x + "</node>",
        "<node id=\"z\" name=\"x\"><node><!-- > -->" + x + "</node></node>",
        "<node id='x' name='>'>" + x + "</node>"}) {
    EXPECT_THAT(note_on_dae(library, x), AllOf(HasSubstr("a.dae ("), HasSubstr("hold themselves")))
        << library;
  }
  EXPECT_THAT(note_on_dae("", "<instance_node url=\"#s\"/>"), HasSubstr("hold themselves"));
  EXPECT_THAT(note_on_dae("<node id=\"&#120;\">" + x + "</node>", x), HasSubstr("plain text"));
}

TEST(Meshes, OfDaeWithElementsNestedTooDeepAreRefused) {
  constexpr std::size_t kDeep = 100'000;
  EXPECT_THAT(note_on_dae("", repeated("<node>", kDeep) + kGeometry + repeated("</node>", kDeep)),
              HasSubstr("nested more than 64 deep"));
  std::string chain;
  for (std::size_t i = 0; i < kDeep; ++i)
    chain += "<node id=\"x" + std::to_string(i) + "\"><instance_node url=\"#x" + std::to_string(i + 1) +
             "\"/></node>";
  EXPECT_THAT(note_on_dae(chain, "<instance_node url=\"#x0\"/>"), HasSubstr("nested more than 64 deep"));
}

TEST(Meshes, OfDaeWithMoreInstancesThanARobotNeedsAreRefused) {
  constexpr int kDoublings = 16;
  std::string library = "<node id=\"x" + std::to_string(kDoublings) + "\">" + kGeometry + "</node>";
  for (int i = 0; i < kDoublings; ++i) {
    const std::string next = "<instance_node url=\"#x" + std::to_string(i + 1) + "\"/>";
    library += "<node id=\"x" + std::to_string(i) + "\">" + next + next + "</node>";
  }
  EXPECT_THAT(note_on_dae(library, "<instance_node url=\"#x0\"/>"), HasSubstr("more than 10000 nodes"));
}

TEST(Meshes, OfDaeThatIsNoPlainXmlAreRefused) {
  const MakerFolder folder;
  std::string wide;
  for (const char letter : dae("")) wide += {letter, '\0'};
  folder.write("a.dae", wide);
  folder.write("b.dae", "<!DOCTYPE COLLADA [<!ENTITY a \"<node>\">]>" + dae(""));
  const MakerRobot robot = folder.read_robot(link("a", collision(mesh("a.dae")) + collision(mesh("b.dae"))));
  EXPECT_THAT(robot.notes, ElementsAre(AllOf(HasSubstr("a.dae (its text must be UTF-8"),
                                             HasSubstr("b.dae (a DOCTYPE is not read"))));
}

TEST(Meshes, MaterialsAreReadFromRegularFilesBelowTheMeshAlone) {
  const MakerFolder folder;
  ASSERT_EQ(mkfifo((folder.path() / "fifo").c_str(), 0600), 0);
  folder.write("green.mtl", "newmtl green\nKd 0 1 0\n");
  folder.write("below/a.obj", "mtllib ../green.mtl\nusemtl green\n" + kObj);
  folder.write("b.obj", "mtllib fifo\n" + kObj);
  const MakerRobot robot = folder.read_robot(link(
      "a", "<visual><geometry>" + mesh("below/a.obj") + "</geometry></visual>" + collision(mesh("b.obj"))));
  EXPECT_THAT(robot.notes, IsEmpty());
  EXPECT_EQ(robot.links[0].collision.size(), 1U);
  EXPECT_NE(robot.links[0].visual.at(0).rgba, Eigen::Vector4d(0.0, 1.0, 0.0, 1.0));
}

TEST(Meshes, AreNotedInOneLine) {
  const MakerRobot robot = MakerFolder().read_robot(
      link("a", collision(mesh("x.stl&#10;joints: []&#13;&#9;#")) + "<visual name=\"b&#10;c: 1\"/>"));
  for (const std::string& note : robot.notes) EXPECT_EQ(note.find_first_of("\n\r\t"), note.npos) << note;
  EXPECT_THAT(robot.notes, testing::Contains(HasSubstr("x.stl\\x0Ajoints: []\\x0D\\x09#")));
}

TEST(Meshes, AreOfLimitedSize) {
  const MakerFolder folder;
  const std::filesystem::path large = folder.write("large.stl", "");
  std::filesystem::resize_file(large, (std::uintmax_t{128} << 20U) + 1);
  const MakerRobot robot = folder.read_robot(link("a", collision(mesh("large.stl"))));
  EXPECT_THAT(robot.notes, ElementsAre(HasSubstr("large.stl (the file is larger than 128 MiB)")));
}

TEST(StlFile, ThatCannotBeWrittenIsNamed) {
  try {
    write_stl("/nowhere/a.stl", shape("<box size=\"1 1 1\"/>"));
    FAIL() << "it was written";
  } catch (const std::system_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/a.stl"));
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  }
}

TEST(StlFile, IsBinaryWithNormals) {
  const MakerFolder folder;
  const std::filesystem::path file = folder.path() / "a.stl";
  write_stl(file, shape("<box size=\"1 1 1\"/>"));
  EXPECT_EQ(std::filesystem::file_size(file), 84U + 12U * 50U);
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(84);
  float normal[3];
  stream.read(reinterpret_cast<char*>(normal), sizeof normal);
  EXPECT_EQ(Eigen::Vector3f(normal[0], normal[1], normal[2]), -Eigen::Vector3f::UnitZ());
}

}  // namespace
}  // namespace gaitway::importer

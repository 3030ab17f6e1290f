// A description built like the one Rethink Robotics published for Baxter: packages of meshes, links
// without mass that mark places, mounts, what simulators and transmissions want, fingers that
// mimic.

#include <array>
#include <cstdint>
#include <vector>

#include "program.h"

namespace smile {
namespace {

std::string Numbers(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}

std::string Inertial(double mass, double moment) {
  const std::string i = std::to_string(moment);
  return "<gravity>0</gravity><inertial><origin rpy=\"0 0 0\" xyz=\"0 0 0\"/><mass value=\"" +
         std::to_string(mass) + "\"/><inertia ixx=\"" + i + "\" ixy=\"0\" ixz=\"0\" iyy=\"" + i +
         "\" iyz=\"0\" izz=\"" + i + "\"/></inertial>";
}

/// What only marks a place.
std::string Marker(const std::string& name) {
  return "<link name=\"" + name + "\">" +
         "<inertial><mass value=\"0.0001\"/><inertia ixx=\"1e-08\" ixy=\"0\" ixz=\"0\" "
         "iyy=\"1e-08\" iyz=\"0\" izz=\"1e-08\"/></inertial></link>\n";
}

std::string Mesh(const std::string& element, const std::string& file) {
  return "<" + element + "><origin rpy=\"0 0 0\" xyz=\"0 0 0\"/><geometry><mesh filename=\"" +
         "package://baxter_description/meshes/" + file + "\"/></geometry>" +
         (element == "visual" ? "<material name=\"darkred\"><color rgba=\".5 .1 .1 1\"/></material>"
                              : "") +
         "</" + element + ">";
}

std::string Tube(const std::string& xyz, double length, double radius) {
  return "<collision><origin rpy=\"0 0 0\" xyz=\"" + xyz + "\"/><geometry><cylinder length=\"" +
         std::to_string(length) + "\" radius=\"" + std::to_string(radius) +
         "\"/></geometry></collision>";
}

std::string Fixed(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& xyz, const std::string& rpy = "0 0 0") {
  return "<joint name=\"" + name + "\" type=\"fixed\"><origin" + Numbers("rpy", rpy) +
         Numbers("xyz", xyz) + "/><axis xyz=\"0 0 1\"/><parent link=\"" + parent +
         "\"/><child link=\"" + child +
         "\"/><dynamics damping=\"0.7\" friction=\"0.0\"/></joint>\n";
}

std::string Moving(const std::string& name, const std::string& type, const std::string& parent,
                   const std::string& child, const std::string& xyz, const std::string& rpy,
                   const std::string& limit, const std::string& more = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><origin" + Numbers("rpy", rpy) +
         Numbers("xyz", xyz) + "/><axis xyz=\"" + (type == "prismatic" ? "0 1 0" : "0 0 1") +
         "\"/><parent link=\"" + parent + "\"/><child link=\"" + child + "\"/><limit " + limit +
         "/>" + more +
         "<dynamics damping=\"0.7\" friction=\"0.0\"/></joint>\n<transmission name=\"" + name +
         "_transmission\"><type>transmission_interface/SimpleTransmission</type><joint name=\"" +
         name + "\"/><actuator name=\"" + name + "_motor\"/></transmission>\n<gazebo reference=\"" +
         name + "\"><implicitSpringDamper>1</implicitSpringDamper></gazebo>\n";
}

std::string Limit(const std::string& lower, const std::string& upper, const std::string& velocity,
                  const std::string& effort) {
  return Numbers("effort", effort) + Numbers("lower", lower) + Numbers("upper", upper) +
         Numbers("velocity", velocity);
}

/// One of the seven joints of an arm and the link behind it.
struct Segment {
  const char *joint, *link, *xyz, *rpy, *lower, *upper;
  double mass;
  const char* tube_at;
  double tube;
};

constexpr std::array<Segment, 7> kSegments{{
    {"s0", "upper_shoulder", "0.055695 0 0.011038", "0 0 0", "-1.70167993878", "1.70167993878", 5.7,
     "0 0 0.1361", 0.2722},
    {"s1", "lower_shoulder", "0.069 0 0.27035", "-1.57079632679 0 0", "-2.147", "1.047", 3.2,
     "0 0 0", 0.12},
    {"e0", "upper_elbow", "0.102 0 0", "1.57079632679 0 1.57079632679", "-3.05417993878",
     "3.05417993878", 4.3, "0 0 -0.0535", 0.107},
    {"e1", "lower_elbow", "0.069 0 0.26242", "-1.57079632679 -1.57079632679 0", "-0.05", "2.618",
     2.1, "0 0 0", 0.10},
    {"w0", "upper_forearm", "0.10359 0 0", "1.57079632679 0 1.57079632679", "-3.059", "3.059", 2.2,
     "0 0 -0.044", 0.088},
    {"w1", "lower_forearm", "0.01 0 0.2707", "-1.57079632679 -1.57079632679 0", "-1.57079632679",
     "2.094", 1.6, "0 0 0", 0.10},
    {"w2", "wrist", "0.115975 0 0", "1.57079632679 0 1.57079632679", "-3.059", "3.059", 0.35,
     "0 0 0", 0.165},
}};

std::string Arm(const std::string& side, bool has_gripper) {
  const std::string sign = side == "left" ? "" : "-", at = side + "_";
  std::string text = Marker(at + "arm_mount") +
                     Fixed(at + "torso_arm_mount", "torso", at + "arm_mount",
                           "0.024645 " + sign + "0.219645 0.118588", "0 0 " + sign + "0.7854");
  std::string parent = at + "arm_mount";
  for (const Segment& segment : kSegments) {
    const std::string link = at + segment.link;
    text += "<link name=\"" + link + "\">" + Inertial(segment.mass, 0.02) +
            Mesh("visual", std::string(segment.link) + "/part.DAE") +
            Tube(segment.tube_at, segment.tube, 0.06) + "</link>\n" +
            Moving(at + segment.joint, "revolute", parent, link, segment.xyz, segment.rpy,
                   Limit(segment.lower, segment.upper, "1.5", "50.0"));
    parent = link;
  }
  // Tubes that belong to the next link but are fixed to the one before.
  for (const auto& [name, on, x, length] :
       {std::tuple("upper_elbow_visual", "lower_shoulder", "0.107 0 0", 0.273),
        std::tuple("upper_forearm_visual", "lower_elbow", "0.088 0 0", 0.272)}) {
    text += "<link name=\"" + at + name + "\">" +
            Tube("0 0 " + std::to_string(length / 2), length, 0.06) + "</link>\n" +
            Fixed(at + name + "_fixed", at + on, at + name, x, "1.57079632679 0 1.57079632679");
  }
  text += "<link name=\"" + at + "hand\">" + Inertial(0.19, 0.0002) +
          Tube("0 0 -0.0232", 0.0464, 0.04) + "</link>\n" +
          Fixed(at + "hand", at + "wrist", at + "hand", "0 0 0.11355");
  text += Marker(at + "hand_camera") + Fixed(at + "hand_camera", at + "hand", at + "hand_camera",
                                             "0.03825 0.012 0.015355", "0 0 -1.57079633");
  text += Marker(at + "gripper_base") +
          Fixed(at + "gripper_base", at + "hand", at + "gripper_base", "0 0 0");
  if (!has_gripper) {
    return text + Marker(at + "gripper") +
           Fixed(at + "endpoint", at + "gripper_base", at + "gripper", "0 0 0.025");
  }
  const std::string body = at + "gripper_electric_base", letter = side.substr(0, 1);
  text += "<link name=\"" + body + "\">" + Inertial(0.3, 2e-6) +
          Mesh("collision", "gripper/base.STL") + "</link>\n" +
          Fixed(letter + "_gripper_electric_base_joint", at + "gripper_base", body, "0 0 0.025");
  const std::string left = letter + "_gripper_l_finger_joint";
  for (const std::string finger : {"l", "r"}) {
    const bool is_left = finger == "l";
    const std::string out = is_left ? "" : "-", in = is_left ? "-" : "";
    const std::string link = at + "gripper_" + finger + "_finger";
    text += "<link name=\"" + link + "\">" + Inertial(0.02, 0.01) + "<collision><origin xyz=\"0 " +
            out + "0.01725 0.05635\"/><geometry><box size=\"0.01 0.0135 0.1127\"/></geometry>" +
            "</collision></link>\n" +
            Moving(letter + "_gripper_" + finger + "_finger_joint", "prismatic", body, link,
                   "0.0 " + in + "0.0015 0.02", "0 0 0",
                   is_left ? Limit("0.0", "0.020833", "5.0", "20.0")
                           : Limit("-0.020833", "0.0", "5.0", "20.0"),
                   is_left ? "" : "<mimic joint=\"" + left + "\" multiplier=\"-1.0\"/>");
  }
  return text + "<link name=\"" + at + "gripper_tip\"><inertial><mass value=\"0.0\"/><inertia " +
         "ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0.0\"/></inertial></link>\n" +
         Fixed(letter + "_gripper_tip_joint", body, at + "gripper_tip", "0 0.0 0.1327");
}

std::string Description(bool has_gripper) {
  return "<?xml version=\"1.0\" ?>\n<!-- | autogenerated by xacro | -->\n<robot name=\"baxter\">\n"
         "<link name=\"base\">\n</link>\n<link name=\"torso\">" +
         Mesh("visual", "torso/base_link.DAE") +
         Mesh("collision", "torso/base_link_collision.STL") + Inertial(35, 1.8) + "</link>\n" +
         Fixed("torso_t0", "base", "torso", "0 0 0") +
         "<link name=\"pedestal\"><collision><origin xyz=\"-0.04 0 -0.775\"/><geometry>"
         "<box size=\"0.92 0.83 0.3\"/></geometry></collision></link>\n" +
         Fixed("pedestal_fixed", "torso", "pedestal", "0 0 0") +
         "<link name=\"collision_head_link_1\"><visual><geometry><sphere radius=\"0.001\"/>"
         "</geometry><material name=\"red\"><color rgba=\"0.8 0.3 0.3 0.3\"/></material></visual>"
         "<collision><origin xyz=\"-0.07 -0.04 0.0\"/><geometry><sphere "
         "radius=\"0.22\"/></geometry>"
         "</collision></link>\n" +
         Fixed("collision_head_1", "base", "collision_head_link_1", "0.11 0 0.75") +
         "<link name=\"head\">" + Inertial(0.55, 0.004) +
         "<collision><geometry><sphere radius=\"0.001\"/></geometry></collision></link>\n" +
         Moving("head_pan", "revolute", "torso", "head", "0.06 0 0.686", "0 0 0",
                Limit("-1.57079632679", "1.57079632679", "10000", "50000")) +
         Arm("right", has_gripper) + Arm("left", has_gripper) +
         "<gazebo><plugin name=\"ros_control\" filename=\"libgazebo_ros_control.so\">"
         "<robotNamespace>/robot</robotNamespace></plugin></gazebo>\n</robot>\n";
}

/// A box around the origin, its edges 2 `half` long.
struct BoxMesh {
  std::array<float, 3> half;

  std::array<float, 3> Corner(unsigned i) const {
    return {i & 1 ? half[0] : -half[0], i & 2 ? half[1] : -half[1], i & 4 ? half[2] : -half[2]};
  }
  static constexpr std::array<std::array<unsigned, 3>, 12> kTriangles{{{0, 2, 1},
                                                                       {1, 2, 3},
                                                                       {4, 5, 6},
                                                                       {5, 7, 6},
                                                                       {0, 1, 4},
                                                                       {1, 5, 4},
                                                                       {2, 6, 3},
                                                                       {3, 6, 7},
                                                                       {0, 4, 2},
                                                                       {2, 4, 6},
                                                                       {1, 3, 5},
                                                                       {3, 7, 5}}};

  std::string Stl() const {
    std::string text = "solid box\n";
    for (const auto& triangle : kTriangles) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (unsigned i : triangle) text += "vertex " + Text(Corner(i)) + "\n";
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid box\n";
  }
  std::string Dae() const {
    std::string corners, triangles;
    for (unsigned i = 0; i < 8; ++i) corners += Text(Corner(i)) + " ";
    for (const auto& triangle : kTriangles) {
      for (unsigned i : triangle) triangles += std::to_string(i) + " ";
    }
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<COLLADA "
           "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset><unit "
           "name=\"meter\" meter=\"1\"/><up_axis>Z_UP</up_axis></asset><library_geometries>"
           "<geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"24\">" +
           corners +
           "</float_array><technique_common><accessor source=\"#a\" count=\"8\" "
           "stride=\"3\"><param "
           "name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" "
           "type=\"float\"/></accessor></technique_common></source><vertices id=\"v\"><input "
           "semantic=\"POSITION\" source=\"#p\"/></vertices><triangles count=\"12\"><input "
           "semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>" +
           triangles +
           "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
           "<visual_scene id=\"s\"><node id=\"n\"><instance_geometry url=\"#g\"/></node>"
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/>"
           "</scene></COLLADA>\n";
  }
  static std::string Text(const std::array<float, 3>& p) {
    return std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]);
  }
};

class OfficialBaxter : public ProgramTest {
 protected:
  /// The package as it is checked out.
  void Install(bool has_gripper) {
    const std::string package = "ws/baxter_description/";
    Write(package + "urdf/baxter.urdf", Description(has_gripper));
    for (const Segment& segment : kSegments) {
      Write(package + "meshes/" + segment.link + "/part.DAE",
            BoxMesh{{0.06f, 0.06f, static_cast<float>(segment.tube / 2)}}.Dae());
    }
    Write(package + "meshes/torso/base_link.DAE", BoxMesh{{0.1f, 0.15f, 0.3f}}.Dae());
    Write(package + "meshes/torso/base_link_collision.STL", BoxMesh{{0.1f, 0.15f, 0.3f}}.Stl());
    Write(package + "meshes/gripper/base.STL", BoxMesh{{0.03f, 0.05f, 0.025f}}.Stl());
    Write("pair.xml", PairOfBlocks());
    Write("move.jsonl",
          "{\"do\":\"wait\",\"seconds\":0.5}\n"
          "{\"do\":\"joint_velocities\",\"left\":[0.1,0,0,0,0,0,0],\"grippers\":[-1,-1],"
          "\"head\":0.5}\n{\"do\":\"wait\",\"seconds\":0.5}\n");
  }

  /// Stands, moves, is recorded, and runs again when its files are gone.
  Json MoveAndReplay(const std::string& options) {
    const Answer run = Smile(
        "run pair.xml --commands move.jsonl --json --record demo --no-pictures "
        "--robot ws/baxter_description/urdf/baxter.urdf --path ws " +
        options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    if (run.exit_code != 0) return nullptr;
    std::filesystem::remove_all(directory_ / "ws");
    EXPECT_EQ(Smile("replay demo --verify").exit_code, 0);
    EXPECT_EQ(Smile("render demo --out end.png --size 64x48").exit_code, 0);
    return run.json()["robot"];
  }

  /// The pose it starts in, after half a second of moving the first joint: nothing pushed the arm.
  static void ExpectFreeMotion(const Json& robot) {
    const std::vector<double> expected{0.25 + 0.05, 0, -1.527, 2.618, 1.529, 1.5, 0};
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(robot["left"]["joints"][i].get<double>(), expected[i], 0.01) << i;
    }
    EXPECT_NEAR(robot["head"].get<double>(), 0.25, 0.01);
  }
};

TEST_F(OfficialBaxter, TakesOurGrippers) {
  Install(/*has_gripper=*/false);
  const std::string side_file =
      "--side-file '" + Shipped("robots/rethink_baxter.robot.json") + "' ";
  const Json robot = MoveAndReplay(side_file + "--gripper electric");
  ASSERT_FALSE(robot.is_null());
  ExpectFreeMotion(robot);
  EXPECT_NEAR(robot["left"]["gripper"].get<double>(), 1.3252 - 0.4166, 0.01) << "closed";
}

TEST_F(OfficialBaxter, HasItsOwnGripperWhenItsDescriptionHas) {
  Install(/*has_gripper=*/true);
  const Json robot =
      MoveAndReplay("--side-file '" + Shipped("robots/rethink_baxter_electric.robot.json") + "'");
  ASSERT_FALSE(robot.is_null());
  ExpectFreeMotion(robot);
  EXPECT_NEAR(robot["right"]["gripper"].get<double>(), 0.153, 0.01) << "closed";
}

}  // namespace
}  // namespace smile

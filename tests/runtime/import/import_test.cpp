// URDFs in the style of published ones become robots whose tools are where the URDFs' own numbers
// bring them.

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>

#include "motion/robots/robot_file.h"
#include "runtime/files/files.h"
#include "runtime/import/import_robot.h"
#include "tests/runtime/import/urdf_numbers.h"

namespace rob::runtime {
namespace {

std::string urdf_folder() { return ROB_SOURCE_DIR "/tests/runtime/import/urdfs/"; }
std::string urdf_text(const std::string& name) {
  return read_file(urdf_folder() + name, 1U << 20U);
}

ImportRequest request_of(const std::string& name, const ArmChoice& choice) {
  return {urdf_folder() + name, "arm.toml", choice, ""};
}

motion::RobotModel imported(const std::string& name, const ArmChoice& choice) {
  const ImportedRobot made = import_robot(urdf_text(name), request_of(name, choice));
  return motion::parse_robot_file(made.text, "arm.toml");
}

/// At 1000 joint vectors within the limits: the same position, and the same turn, to 1e-9.
void check_forward(const std::string& name, const std::string& base, const std::string& tip,
                   const std::string& gripper = "") {
  const motion::RobotModel robot = imported(name, {base, tip, gripper});
  const test::UrdfNumbers numbers(urdf_text(name));
  std::mt19937_64 random(7);
  double worst_place = 0;
  double worst_turn = 0;
  for (int i = 0; i < 1000; ++i) {
    motion::JointVector q(robot.axis_count());
    for (int axis = 0; axis < robot.axis_count(); ++axis) {
      const motion::Axis& of = robot.axes[static_cast<std::size_t>(axis)];
      q[axis] = std::uniform_real_distribution<double>(of.min, of.max)(random);
    }
    const motion::Pose pose = robot.kinematics->forward(q);
    const Eigen::Affine3d frame = numbers.forward(base, tip, q);
    worst_place = std::max(worst_place, (pose.position - frame.translation()).norm());
    worst_turn = std::max(
        worst_turn, (pose.orientation.toRotationMatrix() - frame.linear()).cwiseAbs().maxCoeff());
  }
  CHECK(worst_place < 1e-9);
  CHECK(worst_turn < 1e-9);
}

/// Why a URDF is refused.
std::string refusal_of(const std::string& text, const ArmChoice& choice = {}) {
  try {
    static_cast<void>(import_robot(text, {"a.urdf", "a.toml", choice, ""}));
  } catch (const motion::RobotFileError& error) {
    return error.what();
  }
  return "accepted";
}

bool says(const std::string& text, const std::string& part) {
  const bool found = text.find(part) != std::string::npos;
  if (!found) MESSAGE(text);
  return found;
}

std::string with(std::string text, const std::string& old, const std::string& fresh) {
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), fresh);
}

/// One joint, from a to b.
std::string one_joint(const std::string& type, const std::string& inside) {
  return "<robot name='one'><link name='a'/><link name='b'/><joint name='j' type='" + type +
         "'><parent link='a'/><child link='b'/>" + inside + "</joint></robot>";
}
const char* const kLimit = "<limit lower='-1' upper='1' effort='5' velocity='2'/>";

}  // namespace

TEST_CASE("an imported arm has its tool where the numbers of its URDF bring it") {
  check_forward("ur_like.urdf", "world", "tool0");
  check_forward("ur_like.urdf", "base_link", "wrist_3_link");
  check_forward("ur_like.urdf", "upper_arm_link", "wrist_2_link");
  check_forward("puma.urdf", "link1", "link7");
  check_forward("seven.urdf", "fr_link0", "fr_hand_tcp");
  check_forward("five.urdf", "base", "tip_link", "gripper");
  check_forward("scara.urdf", "base_link", "tool");
  check_forward("seven.urdf", "fr_link0", "fr_hand_tcp", "fr_finger_joint1");
}

TEST_CASE("names, limits, speeds and forces are those of the URDF") {
  const motion::RobotModel robot = imported("five.urdf", {"", "tip_link", "gripper"});
  CHECK(robot.name == "desk_arm_5");
  REQUIRE(robot.axis_count() == 6);
  CHECK(robot.axes[0].name == "waist");
  CHECK(robot.axes[3].name == "wrist_pitch");
  CHECK(robot.axes[4].name == "wait_axis");  // WAIT is a word of the language
  CHECK(robot.axes[5].name == "gripper");
  CHECK(robot.axes[0].max == doctest::Approx(20 * 3.14159265358979).epsilon(1e-12));  // ten turns
  CHECK(robot.axes[3].min == doctest::Approx(0.2).epsilon(1e-11));
  CHECK(robot.axes[3].v_max == doctest::Approx(3.1).epsilon(1e-11));
  CHECK(robot.axes[3].drive.force_max == doctest::Approx(1.9));
  CHECK(robot.start[0] == 0);
  CHECK(robot.start[3] == doctest::Approx((0.2 + 3.2) / 2));  // 0 is not within its limits
}

TEST_CASE("what is no axis is listed, and what a URDF lacks") {
  const ImportedRobot made =
      import_robot(urdf_text("five.urdf"), request_of("five.urdf", {"", "tip_link", "gripper"}));
  CHECK(says(made.report, "6 axes from base to tip_link\n"));
  CHECK(says(made.report, "left out: joint gripper_mirror (follows gripper)\n"));
  CHECK(says(made.report, "force_max of gripper: no effort given\n"));
  CHECK(says(made.report, "min, max of waist: it turns without end\n"));
  CHECK(says(made.text, "a_max = "));
  CHECK(says(made.text, "# [choice] it turns without end"));
}

TEST_CASE("a SCARA is told from its axes, with targets x, y, z, c") {
  const motion::RobotModel robot = imported("scara.urdf", {});
  CHECK(robot.coordinates == std::vector<int>{0, 1, 2, 5});
  CHECK(robot.axes[2].kind == motion::AxisKind::Linear);
  CHECK(imported("five.urdf", {"", "elbow", ""}).coordinates.empty());
}

TEST_CASE("five axes leave c to the place; a gripper's is named after them") {
  const motion::RobotModel five = imported("five.urdf", {"", "tip_link", "gripper"});
  CHECK(five.coordinates == std::vector<int>{0, 1, 2, 3, 4});
  CHECK(five.gripper == 5);
  CHECK(five.kinematics->freedom() == motion::Freedom::C);
  CHECK(imported("five.urdf", {"", "tip_link", ""}).gripper == -1);
  // Seven axes and a finger: (x, y, z, a, b, c), and the finger by its name.
  const motion::RobotModel hand =
      imported("seven.urdf", {"fr_link0", "fr_hand_tcp", "fr_finger_joint1"});
  CHECK(hand.coordinates.size() == 6);
  CHECK(hand.gripper == 7);
}

// Places by hand: the tip is 98.1274 mm along −z of the hand and turned by half a turn about y.
TEST_CASE("links that are fixed to the flange are printed as TOOLs, seen from the tip") {
  const std::string camera =
      "<link name='Camera'/><joint name='c' type='fixed'><origin xyz='0.01 0.02 -0.0981274'/>"
      "<parent link='hand'/><child link='Camera'/></joint><link name='lens'/><joint name='l' "
      "type='fixed'><origin xyz='0 0 0.03'/><parent link='Camera'/><child link='lens'/></joint>"
      "<link name='jaw_tip'/><joint name='t' type='fixed'><parent link='jaw_a'/><child "
      "link='jaw_tip'/></joint></robot>";
  const std::string urdf = with(with(urdf_text("five.urdf"), "</robot>", camera),
                                "rpy=\"0 3.14159 0\"", "rpy=\"0 3.14159265358979 0\"");
  const ImportedRobot made =
      import_robot(urdf, request_of("five.urdf", {"", "tip_link", "gripper"}));
  // (0.01 + 0.0079, 0.02 + 0.000218121, 0) turned: x and z the other way.
  CHECK(says(made.report, "TOOL camera = POSE(-17.9mm, 20.218121mm, 0mm, 180deg, 0deg, 180deg)\n"));
  CHECK(says(made.report, "TOOL lens = POSE(-17.9mm, 20.218121mm, -30mm, 180deg, 0deg, 180deg)\n"));
  CHECK(says(made.text, "#   TOOL camera = POSE("));
  CHECK(made.report.find("jaw_tip =") == std::string::npos);  // it moves
  CHECK(made.report.find("TOOL tip_link") == std::string::npos);
}

TEST_CASE("links have their shapes, and what is after the last of them is the flange's") {
  const motion::RobotModel robot = imported("seven.urdf", {"", "fr_hand_tcp", ""});
  const auto shapes_of = [&](const std::string& name) {
    const auto& bodies = robot.collision.bodies;
    const auto found = std::ranges::find(bodies, name, &motion::Body::name);
    return found == bodies.end() ? std::vector<motion::Capsule>() : found->shapes;
  };
  CHECK(shapes_of("fr_link0").size() == 2);
  REQUIRE(shapes_of("fr_link7").size() == 1);
  CHECK(shapes_of("fr_link7")[0].radius == doctest::Approx(0.06));
  // The hand's box and two fingers, seen from the tcp: 33 − 103.4 mm.
  REQUIRE(shapes_of("fr_hand_tcp").size() == 3);
  CHECK(shapes_of("fr_hand_tcp")[0].from.z() == doctest::Approx(-0.0704));
}

TEST_CASE("links that always touch are listed") {
  const ImportedRobot made =
      import_robot(urdf_text("seven.urdf"), request_of("seven.urdf", {"", "fr_hand_tcp", ""}));
  CHECK(says(made.report, "never checked, for they always touch: fr_link5 and fr_link7\n"));
  const motion::RobotModel robot = motion::parse_robot_file(made.text, "a.toml");
  REQUIRE(!robot.collision.apart.empty());
  CHECK(robot.collision.apart[0].first == "fr_link5");
}

TEST_CASE("an arm that may end at several links needs --tip, and the message lists them") {
  const std::string five = urdf_text("five.urdf");
  CHECK(refusal_of(five) ==
        "a.urdf: the arm may end at several links; name one with --tip: jaw_a (6 moving joints), "
        "jaw_b (6 moving joints), tip_link (5 moving joints)");
  CHECK(says(refusal_of(five, {"", "tip_lnk", ""}),
             "there is no link tip_lnk for --tip; did you mean tip_link?"));
  CHECK(says(refusal_of(five, {"bsae", "", ""}), "did you mean base?"));
  CHECK(says(refusal_of(five, {"tip_link", "elbow", ""}), "link elbow does not hang on link"));
  CHECK(says(refusal_of(five, {"hand", "tip_link", ""}), "no joint moves between hand and"));
  CHECK(says(refusal_of(five, {"", "tip_link", "grip"}), "there is no joint grip for --gripper"));
  CHECK(says(refusal_of(five, {"", "tip_link", "gripper_mirror"}), "follows gripper; name that"));
  CHECK(says(refusal_of(five, {"", "jaw_b", ""}), "joint gripper_mirror on the way to jaw_b"));
  CHECK(says(refusal_of(five, {"", "jaw_a", "gripper"}), "is an axis of the arm"));
  CHECK(says(refusal_of(five, {"", "tip_link", "tip_joint"}), "joint tip_joint is fixed"));
}

TEST_CASE("limits, speeds and axes that cannot be are refused with the way out") {
  const auto limited = [](const std::string& limit) {
    return refusal_of(one_joint("revolute", "<axis xyz='0 0 1'/><limit " + limit + "/>"));
  };
  CHECK(limited("lower='-1' upper='1' effort='5' velocity='2'") == "accepted");
  CHECK(says(limited("lower='-1' upper='1' effort='5' velocity='0'"),
             "velocity 0 of joint j must be above 0, at most 100 rad/s; write that of its data "
             "sheet into the URDF"));
  CHECK(says(limited("lower='-1' upper='1' effort='5' velocity='-2'"), "velocity -2 of joint j"));
  CHECK(says(limited("lower='-1' upper='1' effort='5' velocity='1e9'"), "velocity 1e+09"));
  CHECK(says(limited("lower='-1' upper='1' effort='5' velocity='nan'"), "a.urdf: "));
  CHECK(says(limited("lower='-1' upper='1' effort='5' velocity='inf'"), "a.urdf: "));
  CHECK(says(limited("lower='-1' upper='1e999' effort='5' velocity='2'"), "a.urdf: "));
  CHECK(says(limited("lower='1' upper='-1' effort='5' velocity='2'"), "leave no way"));
  CHECK(says(limited("effort='5' velocity='2'"), "leave no way: lower is 0, upper 0 rad"));
  CHECK(says(limited("lower='-1e16' upper='1e16' effort='5' velocity='2'"),
             "write the true ones, or type=\"continuous\" if it turns without end"));
  CHECK(says(limited("lower='-1' upper='1' effort='5'"), "velocity"));
  CHECK(says(refusal_of(one_joint("revolute", "")), "a.urdf: "));
  CHECK(says(refusal_of(one_joint("continuous", "")), "joint j has no <limit>"));
  CHECK(says(refusal_of(one_joint("floating", kLimit)), "is floating or planar"));
  CHECK(says(refusal_of(one_joint("spin", kLimit)), "a.urdf: "));
  CHECK(says(refusal_of(one_joint("fixed", "")), "no joint moves between a and b"));
  CHECK(says(refusal_of(one_joint("revolute", std::string("<axis xyz='0 0 0'/>") + kLimit)),
             "has no direction"));
  CHECK(says(refusal_of(one_joint("revolute", std::string("<origin xyz='500 0 0'/>") + kLimit)),
             "are the origins in m?"));
  CHECK(says(refusal_of(one_joint("revolute", std::string("<origin xyz='0 nan 0'/>") + kLimit)),
             "a.urdf: "));
}

TEST_CASE("what is no URDF is refused, and a xacro is told from one") {
  CHECK(says(refusal_of(""), "is not XML: it has no element"));
  CHECK(says(refusal_of("name = \"arm\"\n"), "is not XML"));
  CHECK(says(refusal_of("<robot name='a'><link name='b'/>"), "some element is not closed"));
  CHECK(says(refusal_of("<robot name='a'></robot></robot>"), "more elements end than begin"));
  CHECK(says(refusal_of("<robot name='a"), "a tag has no >"));
  CHECK(says(refusal_of("<!-- <robot name='a'/>"), "has no --> after it"));
  CHECK(says(refusal_of("<sdf version='1.6'/>"), "is not a valid URDF"));
  CHECK(says(refusal_of("<robot/>"), "is not a valid URDF"));
  CHECK(says(refusal_of("<robot name='a'/>"), "is not a valid URDF"));
  CHECK(says(refusal_of(std::string("<robot\0 name='a'/>", 18)), "is no text in UTF-8"));
  CHECK(says(refusal_of("\xFF\xFE<\0r"), "is no text in UTF-8"));
  CHECK(says(refusal_of("<robot name='a'>\n<xacro:include filename='b'/></robot>"),
             "a.urdf:2: is a xacro, from which a URDF is made; run xacro first"));
  CHECK(says(refusal_of("<robot name='a'><link name='${prefix}l'/></robot>"), "run xacro first"));
  CHECK(says(refusal_of("<robot name='a'>" + std::string(200000, '<') + "</robot>"), "a.urdf"));
  std::string deep;
  for (int i = 0; i < 200000; ++i) deep += "<robot>";
  CHECK(says(refusal_of(deep), "nested more than 100 levels deep"));
}

TEST_CASE("circles and closed loops of joints are refused") {
  const auto joint = [](const std::string& name, const std::string& from, const std::string& to) {
    return "<joint name='" + name + "' type='revolute'><parent link='" + from + "'/><child link='" +
           to + "'/>" + kLimit + "</joint>";
  };
  const std::string links =
      "<robot name='r'><link name='a'/><link name='b'/><link name='c'/><link name='d'/>";
  CHECK(says(refusal_of(links + joint("j", "a", "b") + joint("k", "c", "d") + joint("l", "d", "c") +
                        "</robot>"),
             "hangs in a circle of joints"));
  CHECK(says(refusal_of(links + joint("j", "a", "b") + joint("k", "a", "c") + joint("l", "b", "d") +
                        joint("m", "c", "d") + "</robot>"),
             "link d hangs on two joints, l and m"));
  CHECK(says(refusal_of(links + joint("j", "a", "b") + joint("k", "c", "d") + "</robot>"),
             "a.urdf: is not a valid URDF"));  // two roots
  CHECK(says(refusal_of(links + joint("j", "a", "e") + "</robot>"), "is not a valid URDF"));
  CHECK(says(refusal_of(links + joint("j", "a", "b") + joint("j", "b", "c") + "</robot>"),
             "is not a valid URDF"));
}

TEST_CASE("a <collision> that cannot be read is refused with the link's name") {
  const auto arm = [](const std::string& collisions) {
    return "<robot name='r'><link name='a'/><link\n name = 'b' >" + collisions +
           "</link><joint name='j' type='revolute'><parent link='a'/><child link='b'/>" + kLimit +
           "</joint></robot>";
  };
  const auto collision = [](const std::string& geometry) {
    return "<collision><geometry>" + geometry + "</geometry></collision>";
  };
  const std::string sound = collision("<sphere radius='0.1'/>");
  CHECK(refusal_of(arm(sound + "<!--" + sound + "-->" + sound)) == "accepted");
  for (const std::string& broken :
       {collision("<cylinder radius='nan' length='1'/>"),
        collision("<cylinder radius='0,05' length='1'/>"), collision(""),
        collision("<box size='0.1 0.1'/>"), std::string("<collision/>"),
        std::string("<collision></collision>"), collision("<cone radius='1'/>")}) {
    CAPTURE(broken);
    CHECK(says(refusal_of(arm(sound + broken)), "link b"));
    CHECK(says(refusal_of(arm(broken)), "link b"));
  }
}

TEST_CASE("an arm has at most eight axes") {
  std::string text = "<robot name='r'><link name='l0'/>";
  for (int i = 1; i <= 9; ++i) {
    const std::string number = std::to_string(i);
    text += "<link name='l" + number + "'/><joint name='j" + number +
            "' type='revolute'><parent link='l" + std::to_string(i - 1) + "'/><child link='l" +
            number + "'/>" + kLimit + "</joint>";
  }
  text += "</robot>";
  CHECK(says(refusal_of(text), "9 axes; at most 8 are known"));
  CHECK(refusal_of(text, {"", "l8", ""}) == "accepted");
  CHECK(says(refusal_of(text, {"", "l8", "j9"}), "9 axes; at most 8 are known"));
}

TEST_CASE("names of a URDF cannot write into the robot file") {
  const std::string text =
      with(with(one_joint("revolute", kLimit), "'one'", "'&quot;&#10;law = 1 \\'"), "name='j'",
           "name='&#10;[cell]&#10;'");
  const ImportedRobot made = import_robot(text, {"a\n\".urdf", "a.toml", {}, ""});
  const motion::RobotModel robot = motion::parse_robot_file(made.text, "a.toml");
  CHECK(robot.name == "law___1__");
  CHECK(robot.axes[0].name == "cell__");
}

}  // namespace rob::runtime

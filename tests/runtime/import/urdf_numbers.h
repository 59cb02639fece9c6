#pragma once

#include <Eigen/Geometry>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

/// The joints of a URDF, read a second time: by the letters of its text, with no reader of XML, and
/// multiplied as matrices. It shares no code with what it tests.
namespace rob::test {

struct NumberedJoint {
  std::string type;
  std::string parent;
  std::string child;
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();

  Eigen::Affine3d moved(double q) const {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    Eigen::Affine3d place = Eigen::Translation3d(xyz) * AngleAxisd(rpy.z(), Vector3d::UnitZ()) *
                            AngleAxisd(rpy.y(), Vector3d::UnitY()) *
                            AngleAxisd(rpy.x(), Vector3d::UnitX());
    if (type == "prismatic") return place * Eigen::Translation3d(q * axis.normalized());
    if (type == "fixed") return place;
    return place * AngleAxisd(q, axis.normalized());
  }
};

inline std::string attribute(const std::string& text, const std::string& element,
                             const std::string& name) {
  const std::regex there("<" + element + R"(\s[^>]*\b)" + name + R"(\s*=\s*["']([^"']*)["'])");
  std::smatch found;
  return std::regex_search(text, found, there) ? found[1].str() : "";
}

inline void read_numbers(const std::string& text, Eigen::Vector3d& into) {
  std::istringstream words(text);
  std::string x, y, z;
  if (words >> x >> y >> z) into = {std::stod(x), std::stod(y), std::stod(z)};
}

class UrdfNumbers {
 public:
  explicit UrdfNumbers(const std::string& text) {
    static const std::regex joint(
        R"re(<joint name="[^"]*" type="(\w+)"[^>]*>([\s\S]*?)</joint>)re");
    for (std::sregex_iterator at(text.begin(), text.end(), joint), end; at != end; ++at) {
      const std::string inside = (*at)[2];
      NumberedJoint made;
      made.type = (*at)[1];
      made.parent = attribute(inside, "parent", "link");
      made.child = attribute(inside, "child", "link");
      read_numbers(attribute(inside, "origin", "xyz"), made.xyz);
      read_numbers(attribute(inside, "origin", "rpy"), made.rpy);
      read_numbers(attribute(inside, "axis", "xyz"), made.axis);
      by_child_[made.child] = made;
    }
  }

  /// The frame of `tip` in that of `base`, the moving joints between them at q, in order.
  Eigen::Affine3d forward(const std::string& base, const std::string& tip,
                          const Eigen::VectorXd& q) const {
    std::vector<const NumberedJoint*> way;
    for (std::string at = tip; at != base; at = way.front()->parent)
      way.insert(way.begin(), &by_child_.at(at));
    Eigen::Affine3d frame = Eigen::Affine3d::Identity();
    Eigen::Index next = 0;
    for (const NumberedJoint* joint : way)
      frame = frame * joint->moved(joint->type == "fixed" ? 0 : q[next++]);
    return frame;
  }

 private:
  std::map<std::string, NumberedJoint> by_child_;
};

}  // namespace rob::test

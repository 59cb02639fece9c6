#include "runtime/import/urdf.h"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>

#include "lang/text/visible.h"
#include "motion/robots/robot_file_error.h"
#include "runtime/import/urdf_text.h"

namespace rob::runtime {

namespace {

[[noreturn]] void refuse_urdf(const std::string& file, const std::string& problem) {
  throw motion::RobotFileError(file + ": " + lang::visible(problem));
}

/// The reader's complaints while it reads: its first complaint is the cause of the others.
class Complaints final : public console_bridge::OutputHandler {
 public:
  Complaints() { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/,
           int /*line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = text;
  }
  const std::string& first() const { return first_; }

 private:
  std::string first_;
};

urdf::ModelInterfaceSharedPtr parsed(const std::string& text, const std::string& file) {
  Complaints complaints;
  try {
    if (urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text)) return model;
  } catch (const std::exception& error) {
    refuse_urdf(file, fmt::format("is not a valid URDF: {}", error.what()));
  }
  refuse_urdf(file,
              fmt::format("is not a valid URDF: {}",
                          complaints.first().empty() ? "no reason is known" : complaints.first()));
}

Eigen::Vector3d vector_of(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

motion::Pose pose_of(const urdf::Pose& pose) {
  const urdf::Rotation& r = pose.rotation;
  return {vector_of(pose.position), Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized()};
}

UrdfShape shape_of(const urdf::Collision& collision, const std::string& link,
                   const std::string& file) {
  UrdfShape shape;
  shape.place = pose_of(collision.origin);
  const urdf::Geometry* const body = collision.geometry.get();
  if (body == nullptr)
    refuse_urdf(file, fmt::format("a <collision> of link {} has no shape", link));
  if (const auto* box = dynamic_cast<const urdf::Box*>(body)) {
    shape.size = vector_of(box->dim);
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(body)) {
    shape.kind = UrdfShape::Kind::Cylinder;
    shape.radius = cylinder->radius;
    shape.length = cylinder->length;
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(body)) {
    shape.kind = UrdfShape::Kind::Sphere;
    shape.radius = sphere->radius;
  } else {
    const auto& mesh = dynamic_cast<const urdf::Mesh&>(*body);
    shape.kind = UrdfShape::Kind::Mesh;
    shape.mesh = mesh.filename;
    shape.scale = vector_of(mesh.scale);
  }
  return shape;
}

UrdfJoint::Kind kind_of(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::FIXED:
      return UrdfJoint::Kind::Fixed;
    case urdf::Joint::REVOLUTE:
      return UrdfJoint::Kind::Revolute;
    case urdf::Joint::CONTINUOUS:
      return UrdfJoint::Kind::Continuous;
    case urdf::Joint::PRISMATIC:
      return UrdfJoint::Kind::Prismatic;
    default:
      return UrdfJoint::Kind::Other;
  }
}

UrdfJoint joint_of(const urdf::Joint& from) {
  UrdfJoint joint;
  joint.name = from.name;
  joint.kind = kind_of(from);
  joint.parent = from.parent_link_name;
  joint.child = from.child_link_name;
  joint.place = pose_of(from.parent_to_joint_origin_transform);
  joint.axis = vector_of(from.axis);
  if (from.mimic) joint.mimics = from.mimic->joint_name;
  if (!from.limits) return joint;
  joint.limited = true;
  joint.lower = from.limits->lower;
  joint.upper = from.limits->upper;
  joint.velocity = from.limits->velocity;
  joint.effort = from.limits->effort;
  return joint;
}

/// The reader lets a link have two parents, and links hang together in circles beside the root's.
void check_tree(const Urdf& urdf, const std::string& file) {
  std::map<std::string, const UrdfJoint*> parents;
  for (const UrdfJoint& joint : urdf.joints) {
    const auto [found, fresh] = parents.emplace(joint.child, &joint);
    if (!fresh)
      refuse_urdf(file,
                  fmt::format("link {} hangs on two joints, {} and {}; Rob takes arms without "
                              "closed loops",
                              joint.child, found->second->name, joint.name));
  }
  for (const UrdfLink& link : urdf.links) {
    std::set<std::string> passed;
    std::string at = link.name;
    for (auto up = parents.find(at); up != parents.end(); up = parents.find(at)) {
      if (!passed.insert(at).second)
        refuse_urdf(file, fmt::format("link {} hangs in a circle of joints; Rob takes arms without "
                                      "closed loops",
                                      link.name));
      at = up->second->parent;
    }
  }
}

/// The reader leaves out what it cannot read of the shapes, and says nothing.
void check_shapes(const Urdf& urdf, const std::map<std::string, std::size_t>& written,
                  const std::string& file) {
  std::size_t all_written = 0;
  for (const auto& [link, count] : written) all_written += count;
  std::size_t all_read = 0;
  for (const UrdfLink& link : urdf.links) {
    all_read += link.shapes.size();
    const auto found = written.find(link.name);  // not where it is written with &…;
    if (found == written.end() || found->second == link.shapes.size()) continue;
    refuse_urdf(file, fmt::format("{} of the {} <collision> of link {} cannot be read: a number is "
                                  "none, or the geometry is empty",
                                  found->second - std::min(found->second, link.shapes.size()),
                                  found->second, link.name));
  }
  if (all_written != all_read)
    refuse_urdf(file, fmt::format("{} of {} <collision> cannot be read: a number is none, or the "
                                  "geometry is empty",
                                  all_written - std::min(all_written, all_read), all_written));
}

}  // namespace

const UrdfJoint* Urdf::joint(const std::string& called) const {
  const auto found = std::ranges::find(joints, called, &UrdfJoint::name);
  return found == joints.end() ? nullptr : &*found;
}

const UrdfJoint* Urdf::parent_of(const std::string& link) const {
  const auto found = std::ranges::find(joints, link, &UrdfJoint::child);
  return found == joints.end() ? nullptr : &*found;
}

Urdf read_urdf(const std::string& text, const std::string& file) {
  const std::map<std::string, std::size_t> written = check_urdf_text(text, file);
  const urdf::ModelInterfaceSharedPtr model = parsed(text, file);
  Urdf urdf;
  urdf.name = model->getName();
  if (model->getRoot()) urdf.root = model->getRoot()->name;
  for (const auto& [name, from] : model->links_) {
    UrdfLink link{name, {}};
    for (const auto& collision : from->collision_array)
      link.shapes.push_back(shape_of(*collision, name, file));
    urdf.links.push_back(std::move(link));
  }
  check_shapes(urdf, written, file);
  for (const auto& [name, from] : model->joints_) urdf.joints.push_back(joint_of(*from));
  // Links in a circle would hold each other for ever.
  for (const auto& [name, from] : model->links_) from->child_links.clear();
  check_tree(urdf, file);
  return urdf;
}

}  // namespace rob::runtime

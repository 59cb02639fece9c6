#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace rob::runtime {

/// Where a mesh is that a URDF names: a path beside it, file://…, or package://NAME/…, which is
/// looked for in `packages` (empty: none) and in the folders above the URDF. Throws
/// motion::RobotFileError where it is not.
std::string find_mesh(const std::string& written, const std::string& urdf,
                      const std::string& packages);

/// The vertices of an STL, DAE or OBJ, as the file has them. Throws motion::RobotFileError for
/// what is none, and for one without any.
std::vector<Eigen::Vector3d> mesh_vertices(const std::string& file);

}  // namespace rob::runtime

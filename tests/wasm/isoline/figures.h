#pragma once

// Figures that the quality tests print: what a deformation did to the triangles, and the shared models with their joints.

#include "sessions.h"

#include <map>
#include <string>
#include <vector>

namespace figures {

/// Root mean square over the area of (σ₁ − 1, σ₂ − 1), the stretches of each triangle.
[[nodiscard]] double stretch_rms(const lissom::TriangleMesh& rest, const lissom::Points& moved);

/// Largest angle between neighbouring triangles that were coplanar at rest, degrees.
[[nodiscard]] double crease(const lissom::TriangleMesh& rest, const lissom::Points& moved);

/// Mean angle between the vertex normals of two surfaces, degrees.
[[nodiscard]] double normals_apart(const lissom::TriangleMesh& a, const lissom::Points& b);

/// A model under shared/data/, or one without vertices where it is not there (a message says so).
[[nodiscard]] lissom::TriangleMesh shared(const std::string& name);

/// A person at rest, the same posed, and who gets the pose: shared models.
struct PersonPose {
    std::string rest, pose, onto;
};
[[nodiscard]] std::vector<PersonPose> poses_of_people();

struct Joint {
    Eigen::Vector3d at;
    double radius; ///< 0 for bones of people
};
/// Joints of the skeleton beside a model: of creatures by their name, of people the heads of bones.
[[nodiscard]] std::map<std::string, Joint> joints(const std::string& name);

/// Vertices within a radius of a place.
[[nodiscard]] std::vector<int> ball(const lissom::Points& points, const Eigen::Vector3d& centre, double radius);

/// Handles of a person at rest: hands, feet, head, hips, each a ball; `more`: rings at elbows and knees, too, as points.
[[nodiscard]] std::vector<lissom::DeformHandle> of_person(const lissom::TriangleMesh& mesh, const std::string& name, bool more = false);

/// The rigid motions of handles between two poses of one mesh.
[[nodiscard]] std::vector<Eigen::Affine3d> motions(const std::vector<lissom::DeformHandle>& handles, const lissom::Points& from, const lissom::Points& to);

} // namespace figures

#pragma once

// The shared people: at rest, posed by their bones, with curves along spine, arms and legs.

#include "posing.h"

#include <string>
#include <utility>
#include <vector>

namespace people {

struct Person {
    lissom::TriangleMesh rest; ///< no vertices where there is no such file
    lissom::Points posed;
    std::vector<lissom::CurveSpec> curves; ///< spine, two arms, two legs
    std::vector<lissom::CurveLink> links;
    std::vector<std::vector<Eigen::Vector3d>> joints;   ///< of each curve, posed
    std::vector<std::vector<Eigen::Matrix3d>> rotations; ///< of the bone that begins at each joint
};

/// Names of the person and of the pose.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> poses();
[[nodiscard]] Person posed(const std::string& person, const std::string& pose);
/// The postures that bring the curves to the posed joints, and with `twist` roll them as the bones do.
[[nodiscard]] std::vector<lissom::CurvePosture> postures(const Person& person, const lissom::CurveSession& session, bool twist);

} // namespace people

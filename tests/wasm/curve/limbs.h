#pragma once

// Limbs of the shared creatures with their true bones, and strokes drawn along them.

#include "lissom/curve/stroke.h"
#include "lissom/curve/surface.h"
#include "lissom/mesh/working_mesh.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace limbs {

using Eigen::Vector3d;

struct Limb {
    std::string creature, name;
    std::vector<std::string> joints; ///< along it
    bool slender = false;            ///< a tail, an arm, a tentacle: both ends away from the trunk
};
/// Seventeen limbs of octopus, horse, cactus, critter and loops4.
[[nodiscard]] std::vector<Limb> all();

struct Bone {
    Vector3d a, b;
    double ra, rb;
    /// How far p lies from its surface, negative inside.
    [[nodiscard]] double distance(const Vector3d& p) const;
    /// Share along it of the nearest point.
    [[nodiscard]] double along(const Vector3d& p) const;
};

struct Creature {
    lissom::TriangleMesh mesh; ///< no vertices where there is no such file
    std::shared_ptr<lissom::WorkingMesh> working;
    std::shared_ptr<lissom::CurveSurface> surface;
    std::vector<Bone> others(const Limb& limb) const;
    std::vector<Bone> bones(const Limb& limb) const;
    struct NamedBone {
        std::string a, b;
        Bone bone;
    };
    std::vector<NamedBone> skeleton;
};
/// Read once.
[[nodiscard]] const Creature& creature(const std::string& name);

/// Distance to the nearest bone, in radii there.
[[nodiscard]] double error(const std::vector<Bone>& bones, const Vector3d& p);

/// A parallel view: pixel (x, y) is the ray centre + x right + y up along forward.
struct View {
    Vector3d right, up, forward, centre;
    double pixel = 1; ///< units of a pixel
    [[nodiscard]] Eigen::Vector2d to_screen(const Vector3d& p) const;
};
/// A view of 900 pixels for the whole mesh.
[[nodiscard]] View view_of(const lissom::TriangleMesh& mesh, const Vector3d& forward);

/// A stroke through places on the screen, a place every four pixels, with noise.
[[nodiscard]] lissom::Stroke drawn(const View& view, const std::vector<Vector3d>& through, double noise_pixels, std::uint64_t seed);

/// The stroke that a person would draw along a limb: from where it is seen best.
[[nodiscard]] lissom::Stroke along(const Creature& creature, const Limb& limb, double noise_pixels, std::uint64_t seed);

} // namespace limbs

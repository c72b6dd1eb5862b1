#pragma once

#include "lissom/hair/hair_session.h"

#include <memory>

namespace lissom {

/// What a head's shape decides, all relative to its origin.
struct HeadShape {
    HeadShape(const TriangleMesh& mesh, std::span<const int> scalp_vertices, int resolution, UpAxis up);

    Eigen::Vector3d origin;
    std::vector<int> scalp;
    TriangleMesh whole;
    HairVolume volume;
    HairVolume volume_of_roots; // with all triangles of the head, as roots and painted lengths number them
    ScalpRoots roots;
    std::unique_ptr<HeadDistance> distance;
};

/// What a style decides.
struct StyledField {
    VectorField field;
    PartingGuard partings;
    TailTie tails;
    bool empty;
};

[[nodiscard]] HairStyle moved(HairStyle style, const Eigen::Vector3d& by);

/// @throws InvalidInput `non-finite-stroke`, `bad-option`
[[nodiscard]] std::vector<Finding> check_style(const HairStyle& style, const HeadShape& head);

} // namespace lissom

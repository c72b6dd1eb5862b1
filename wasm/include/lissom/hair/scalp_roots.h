#pragma once

#include "lissom/mesh/types.h"

#include <cstdint>
#include <span>
#include <vector>

namespace lissom {

/// Where a strand starts.
struct Root {
    int triangle;             ///< of the head
    double b, c;              ///< weights of its second and third corner
    Eigen::Vector3d position;
    Eigen::Vector3d normal;   ///< unit, out of the skin
};

/// Roots spread over the scalp by area, as many as asked for: the first n of any number are the same n, and evenly
/// spread themselves, so a prefix of the strands is a thinner head of hair.
///
/// Triangles stand along a space-filling curve (Morton's order); root i lies at the fraction i φ + shift of the area
/// along it, the golden ratio's multiples being even at every length. No randomness but the seed's shift.
class ScalpRoots {
public:
    /// Hair grows on triangles whose three corners are scalp.
    /// @throws InvalidInput `scalp-empty`  there is none with area
    ScalpRoots(const TriangleMesh& head, std::span<const int> scalp);

    [[nodiscard]] Root root(std::uint64_t index, std::uint64_t seed) const;
    [[nodiscard]] double area() const { return area_.back(); }
    [[nodiscard]] const Points& points() const { return scalp_; } ///< of the scalp's vertices

private:
    TriangleMesh head_;
    Points normals_;
    Points scalp_;
    std::vector<int> triangles_;
    std::vector<double> area_; // up to and with each triangle
};

} // namespace lissom

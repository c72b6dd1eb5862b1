#include "loose_bear.h"

#include "lissom/mesh/operators.h"
#include "lissom/mesh/surface_samples.h"
#include "shapes.h"

#include <algorithm>

using namespace lissom;
using Eigen::Vector3d;

double LooseShape::depth(const Vector3d& p) const {
    double most = -1e300;
    for (const Ellipsoid& e : ellipsoids) {
        const Vector3d at = (p - e.middle).cwiseQuotient(e.radii), gradient = at.cwiseQuotient(e.radii);
        const double far = at.norm();
        most = std::max(most, far > 0 ? (1 - far) * far / gradient.norm() : e.radii.minCoeff());
    }
    return most;
}

Points LooseShape::outer_places(int count) const {
    const Points all = sample_surface(mesh, count).on(mesh);
    Points kept(all.rows(), 3);
    Eigen::Index row = 0;
    for (Eigen::Index i = 0; i < all.rows(); ++i)
        if (depth(all.row(i).transpose()) < 1e-3) kept.row(row++) = all.row(i); // facets lie a little inside
    kept.conservativeResize(row, 3);
    return kept;
}

double LooseShape::outer_area() const {
    constexpr int samples = 200000;
    return triangle_areas(mesh).sum() * static_cast<double>(outer_places(samples).rows()) / samples;
}

LooseShape loose_bear(int levels) {
    LooseShape bear;
    bear.ellipsoids = {{{0, 0.62, 0}, {0.34, 0.42, 0.3}}, {{0, 1.22, 0.03}, {0.3, 0.28, 0.29}}, {{0.19, 1.46, 0.02}, {0.12, 0.14, 0.08}}, {{-0.19, 1.46, 0.02}, {0.12, 0.14, 0.08}},
                       {{0, 0.78, 0.08}, {0.64, 0.14, 0.14}}, {{0.2, 0.25, 0.14}, {0.16, 0.17, 0.32}}, {{-0.2, 0.25, 0.14}, {0.16, 0.17, 0.32}}};
    std::vector<TriangleMesh> parts;
    for (const auto& e : bear.ellipsoids) {
        Eigen::Affine3d place = Eigen::Affine3d::Identity();
        place.translate(e.middle).scale(e.radii);
        parts.push_back(shapes::moved(shapes::icosphere(levels), place));
    }
    bear.mesh = shapes::joined(parts);
    return bear;
}

#pragma once

// A head by formula with what grows on it, and how deep a point lies in it, exactly.

#include "lissom/hair/hair_volume.h"
#include "lissom/hair/head_distance.h"
#include "lissom/hair/parting_guard.h"
#include "lissom/hair/scalp_roots.h"
#include "lissom/hair/style.h"
#include "lissom/hair/vector_field.h"
#include "shapes.h"

namespace eggs {

using Eigen::Vector3d;
using lissom::DividingCurve;
using lissom::HairStyle;
using lissom::Ponytail;
using lissom::StreamCurve;
using lissom::TriangleMesh;

/// A closed convex mesh as the half-spaces of its triangles.
class Convex {
public:
    explicit Convex(const TriangleMesh& closed);

    /// How far inside a point lies, 0 outside. Exact: what is nearest to a point in a convex body is one of its faces.
    [[nodiscard]] double depth(const Vector3d& p) const;

private:
    std::vector<Vector3d> normals_;
    std::vector<double> offsets_;
    mutable std::size_t parting_ = 0; // the face that parted the last point: it mostly parts the next one too
};

/// An egg of a head, 24 cm high and somewhere in the world, its upper half scalp.
struct Egg {
    Vector3d place;
    TriangleMesh mesh;
    std::vector<int> scalp;

    static constexpr double height = 0.24;

    explicit Egg(const Vector3d& at = {3, -2, 5}) : place(at) {
        Eigen::Affine3d map(Eigen::Translation3d(at) * Eigen::Scaling(Vector3d(0.09, 0.12, 0.1)));
        mesh = shapes::moved(shapes::icosphere(4), map);
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (mesh.points(v, 1) > at.y() - 0.02 && mesh.points(v, 2) < at.z() + 0.08) scalp.push_back(v);
    }

    [[nodiscard]] Vector3d skin(const Vector3d& way, double above = 0) const {
        const Vector3d u = way.normalized();
        return place + Vector3d(0.09 * u.x(), 0.12 * u.y(), 0.1 * u.z()) + above * u;
    }
    /// Streams from the crown down on all sides.
    [[nodiscard]] HairStyle combed_down() const {
        HairStyle style;
        for (int k = 0; k < 8; ++k) {
            StreamCurve curve;
            const double a = 0.785398 * k;
            for (double t = 0.3; t < 2.2; t += 0.1)
                curve.points.push_back(skin({std::sin(t) * std::sin(a), std::cos(t), std::sin(t) * std::cos(a)}, 0.006));
            style.streams.push_back(curve);
        }
        return style;
    }
    [[nodiscard]] HairStyle parted() const {
        HairStyle style = combed_down();
        DividingCurve parting;
        for (double t = -0.2; t < 0.8; t += 0.05) parting.points.push_back(skin({0, std::cos(t), std::sin(t)}));
        style.partings.push_back(parting);
        return style;
    }
    [[nodiscard]] HairStyle tied() const {
        HairStyle style;
        Ponytail tail;
        const Vector3d knot = skin({0, 0.5, -1}, 0.012);
        for (int k = 0; k < 20; ++k) tail.spine.push_back(knot + 0.006 * k * Vector3d(0, 0.1 - 0.06 * k, -1).normalized());
        for (double a = 0; a < 6.2; a += 0.2) tail.section.push_back(tail.spine[1] + 0.022 * Vector3d(std::cos(a), std::sin(a), 0));
        style.ponytails.push_back(tail);
        for (int k = 0; k < 9; ++k) {
            StreamCurve curve;
            const Vector3d from = Vector3d(std::sin(0.7 * k - 2.8), k % 3 == 1 ? -0.1 : 0.4, std::cos(0.7 * k - 2.8) + 0.4).normalized();
            for (double t = 0; t < 0.9; t += 0.05) curve.points.push_back(skin((1 - t) * from + t * Vector3d(0, 0.5, -1).normalized(), 0.006));
            style.streams.push_back(curve);
        }
        return style;
    }
};

/// What growth needs of an egg at the origin.
struct Grounds {
    Egg egg{{0, 0, 0}};
    lissom::HairVolume volume = lissom::hair_volume(egg.mesh, egg.scalp, 24);
    lissom::HeadDistance head{volume.head, volume.distance};
    lissom::ScalpRoots roots{egg.mesh, egg.scalp};
    lissom::PartingGuard no_partings{{}, head, volume.field.step, 0.1};

    /// The same vector everywhere.
    [[nodiscard]] lissom::VectorField field(const Vector3d& v) const {
        return {volume.field, v.transpose().replicate(volume.field.count(), 1)};
    }
};

} // namespace eggs

#pragma once

// What CurveSession keeps. Prepared by pose_steps.cpp: pose_region.cpp and pose_contour.cpp per curve, pose_owners.cpp and
// pose_influences.cpp for all of them; read by pose.cpp.

#include "lissom/curve/pose.h"
#include "lissom/curve/region.h"
#include "lissom/curve/slabs.h"
#include "lissom/curve/surface.h"
#include "lissom/curve/territory.h"

#include <span>
#include <string>

namespace lissom {

/// Who moves each place, and by how much.
struct Influence {
    int curve;
    float row;
    double weight;
};
struct Influences {
    std::vector<int> offsets{0}; ///< per place, one more at the end
    std::vector<Influence> all;

    [[nodiscard]] std::span<const Influence> operator[](int place) const { return {all.data() + offsets[place], all.data() + offsets[place + 1]}; }
};

/// Vertices that one curve has wholly.
struct SingleVertices {
    std::vector<int> vertices;
    std::vector<float> rows;
};

/// Vertices of several owners, or of one that leaves a part at rest.
struct BlendedVertices {
    std::vector<int> vertices;
    std::vector<int> offsets{0};
    std::vector<int> curves;
    std::vector<float> rows;
    std::vector<double> weights;
};

/// A curve as it is drawn, in the space of its points.
[[nodiscard]] inline SplineCurve rest_spline(const Points& points, const std::vector<int>& rigid) {
    SplineOptions options;
    options.rigid = rigid;
    return SplineCurve(points, options);
}
[[nodiscard]] inline Points less(const Points& points, const Eigen::Vector3d& centre) { return points.rowwise() - centre.transpose(); }

struct CurveSession::State {
    static constexpr double k_last = EncodedCurve::k_rows - 1; ///< the last row

    // What was given. -------------------------------------------------------------------------------------------
    std::shared_ptr<const WorkingMesh> model; ///< none for a cloud
    Points source;                            ///< of a cloud
    std::vector<CurveSpec> specs;
    std::vector<CurveLink> links;
    CurveOptions options;
    LinkOrder order;
    [[nodiscard]] bool is_contour(int curve) const { return model && specs[curve].role == CurveRole::contour; }

    // What it is made of. ---------------------------------------------------------------------------------------
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Points rest; ///< source vertices less the centre
    std::unique_ptr<CurveSurface> surface;
    std::vector<CurveField> fields; ///< per curve, over places: working vertices, or those of a cloud; given up once encoded
    std::vector<EncodedCurve> curves;
    std::vector<std::vector<double>> radii;
    std::vector<std::vector<int>> regions;
    std::vector<std::vector<RowSupport>> supports;

    std::vector<SingleVertices> singles; ///< per curve
    BlendedVertices blended;
    std::vector<int> resting; ///< source vertices that nothing moves
    std::vector<SlabTable> slabs;             ///< per curve, for the slabs only
    std::vector<std::vector<SlabPlace>> single_places; ///< likewise, as singles
    std::vector<SlabPlace> blended_places;

    CurveSeconds seconds;
    std::vector<Finding> warnings;
    int phase = 0;

    [[nodiscard]] const Points& given() const { return model ? model->source : source; }
    /// Places that are told apart: working vertices, or those of the cloud.
    [[nodiscard]] int place_count() const { return model ? model->mesh.vertex_count() : static_cast<int>(source.rows()); }
    [[nodiscard]] Eigen::Vector3d place(int p) const { return rest.row(model ? model->source_of_working[p] : p).transpose(); }

    void begin();
    void find_region(int curve);
    void find_pull(int curve);
    /// What the whole of a contour does: moves, without turning, in the frame of its parent.
    [[nodiscard]] CurveRows pull(int curve, const CurvePosture& posture, const Matrix34& from_parent) const;
    void assign();
    /// From shares to what a pose reads.
    void encode(const OwnerShares& shares, std::span<const int> owner);
    [[nodiscard]] Influences influences_of(const OwnerShares& shares, std::span<const int> owner) const;
    /// The thesis's blend about linked control points, into the last place of `found`.
    void add_gaussian(Influences& found, int place, int owner) const;
    /// What contours pull; the others have as much less.
    void add_contours(Influences& found, int place) const;
    void find_supports(const Influences& influences);
    void lay_out(const Influences& influences);

    /// Postures less the centre, parents' motions done; and the rows of each curve.
    struct Posed {
        std::vector<CurvePosture> postures;
        std::vector<CurveRows> rows;
        std::vector<Matrix34> from_parent;
        CurveStrain strain;
    };
    [[nodiscard]] Posed posed(std::span<const CurvePosture> postures) const;
};

} // namespace lissom

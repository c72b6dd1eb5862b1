#pragma once

// What CurveSession keeps: shared by pose_prepare.cpp and pose.cpp.

#include "lissom/curve/pose.h"
#include "lissom/curve/region.h"
#include "lissom/curve/slabs.h"
#include "lissom/curve/surface.h"
#include "lissom/curve/territory.h"

#include <string>

namespace lissom {

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

struct CurveSession::State {
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
    void encode(const OwnerShares& shares, std::span<const int> owner);

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

#pragma once

#include "lissom/contour/curvature.h"
#include "lissom/mesh/working_mesh.h"

#include <array>
#include <memory>
#include <vector>

namespace lissom {

/// From where a model is looked at, source space.
struct LineView {
    bool perspective = true;
    Eigen::Vector3d eye = Eigen::Vector3d::UnitZ(); ///< the eye; of a parallel view the direction towards it (any length > 0)
};

struct LineOptions {
    bool suggestive = true;
    double strength = 0.1;      ///< a suggestive line is kept where D reaches this share of what is usual in the view (its third quartile), 0 to keep all
    double steepness = 0.03;    ///< least sin²θ between normal and view: looked at straight on, every flat place has some
    double shortest = 0.1;      ///< lines shorter than this share of the model's radius (half its diagonal) are left out; contours are split only into parts twice as long, so that outlines have no gaps
    double corner = 60;         ///< lines are split where they turn by more within `bend`, degrees; 180: nowhere
    double bend = 0.05;         ///< of the model's radius
};

/// A place on the surface that stays the same place when the surface moves.
struct SurfacePlace {
    std::array<int, 3> corners{}; ///< source vertices of its triangle
    Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< of each, summing to 1
};

struct ContourLine {
    enum class Kind { contour, suggestive } kind = Kind::contour;
    bool closed = false;
    std::vector<Eigen::Vector3d> points; ///< source space, where the line crosses the mesh's edges (and where it ends within a triangle)
    std::vector<SurfacePlace> places;    ///< of each point: Σ weight · corner is the point
    double length = 0;                   ///< source units
    double strength = 0;                 ///< mean D R² of a suggestive line
};

/// Contours and suggestive contours of one model for any number of views: tensors once, then a fraction of a second a view.
///
/// With n the normal, v the unit vector towards the eye, w = v − (n·v) n: contours are where n·v = 0; suggestive contours where the
/// radial curvature κ_r = S w·w / |w|² is 0 and grows towards the eye, D = D_w κ_r > 0, on what faces it (DeCarlo, Finkelstein, Rusinkiewicz,
/// Santella, "Suggestive contours for conveying shape", SIGGRAPH 2003, sec. 2). At κ_r = 0, D = ∇(S w·w)·w / |w|³, so that
/// S w·w is what is interpolated: it has no pole where w vanishes. Segments are clipped where D, n·v or sin²θ, linear along them,
/// pass their limits. They are joined by the number of the mesh edge they share (Blanco Alg. 7 joins by equal positions, and its loop ends
/// at once), kept where the joined line is strong somewhere, split at corners.
///
/// Cost: preparing as CurvatureField; a view is linear in vertices and triangles, 50,000 vertices some 10 ms; of a large model it is made in slices.
class ContourSession {
public:
    /// @param sweeps  of diffusion, 0 to 200
    /// @throws InvalidInput `bad-option`
    explicit ContourSession(std::shared_ptr<const WorkingMesh> working, int sweeps = 10);
    ~ContourSession();
    ContourSession(ContourSession&&) noexcept;
    ContourSession& operator=(ContourSession&&) noexcept;

    /// One slice of the preparation; true while there is more.
    bool step();
    [[nodiscard]] double fraction() const;

    /// Starts on a view and forgets the one under way. @throws InvalidInput `bad-view` (not finite, or no direction)
    void look(const LineView& view, const LineOptions& options = {});
    /// One slice of the view; true while there is more.
    bool look_step();
    [[nodiscard]] double look_fraction() const;
    /// The lines of the view, contours first, longer ones first among each kind; for after the last slice.
    [[nodiscard]] const std::vector<ContourLine>& lines() const;

    /// All slices at once.
    [[nodiscard]] const std::vector<ContourLine>& lines(const LineView& view, const LineOptions& options = {});

    [[nodiscard]] double seconds() const; ///< that preparing took
    [[nodiscard]] const CurvatureField& curvature() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom

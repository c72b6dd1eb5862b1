#pragma once

#include "lissom/match/sharp_paths.h"
#include "lissom/match/sharp_tracking.h"

#include "placed_model.h"

#include <optional>
#include <vector>

namespace lissom {

/// The sharp edges of one model, and the edges of its skin that come to lie on them once the skin is fitted (Skins 3.4).
class SharpFinish {
public:
    /// @param picked  chains of vertices of the file. @throws InvalidInput `picked-edges`
    SharpFinish(const PlacedModel& model, double angle, const std::vector<std::vector<int>>& picked);

    [[nodiscard]] bool empty() const { return lines_.empty(); }
    [[nodiscard]] const std::vector<EdgeCurve>& curves() const { return curves_; } ///< along edges of the model
    /// The nearest place of a curve no farther than `reach`; the place itself where there is none.
    [[nodiscard]] Eigen::Vector3d snapped(const Eigen::Vector3d& place, double reach) const;

    /// One slice: first finds paths, then brings them onto the curves. @returns true while there is more
    bool step(TriangleMesh& skin, const FitSurface& surface, const std::vector<int>& marker, double edge_length);
    [[nodiscard]] double fraction() const;

    [[nodiscard]] int lines() const { return static_cast<int>(lines_.size()); }
    [[nodiscard]] int failed() const { return static_cast<int>(found_.failed.size()); }
    [[nodiscard]] const std::vector<SharpPath>& paths() const { return found_.paths; }
    /// The farthest that a path's vertex is from its place.
    [[nodiscard]] double farthest(const Points& skin) const { return tracking_ ? tracking_->farthest(skin) : 0; }
    /// The farthest that any place of a curve is from the paths. 0 without curves, infinite without paths.
    [[nodiscard]] double error(const Points& skin) const;

private:
    std::vector<EdgeCurve> curves_;
    std::vector<SharpLine> lines_;
    SharpPaths found_;
    std::optional<SharpTracking> tracking_;
};

} // namespace lissom

#pragma once

#include "lissom/match/match_session.h"
#include "lissom/match/skin_settling.h"
#include "lissom/match/wrap.h"
#include "lissom/mesh/remesh.h"

#include "placed_model.h"

#include <optional>
#include <vector>

namespace lissom {

/// Makes the first skin over the source, in slices.
class SkinBeginning {
public:
    struct Options {
        FirstSkin kind = FirstSkin::copy;
        int genus = 0;
        double edge_length = 0.02; ///< made longer where it would take too many vertices
        double adapt = 0;
        int most_vertices = 0;     ///< about; not of a copy
    };
    /// @param source  kept by reference. @param curves  sharp ones, along its edges: a copy and a remesh keep them
    SkinBeginning(const PlacedModel& source, const std::vector<EdgeCurve>& curves, const Options& options);

    /// One slice. @returns true while there is more. @throws InvalidInput as `Remesher`, `Wrapper` and `box_around` do
    bool step();
    [[nodiscard]] double fraction() const;

    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }
    [[nodiscard]] const std::vector<EdgeCurve>& curves() const { return curves_; } ///< those of them that the skin has
    /// `genus-missed` (count: what it has), `webs` (count: vertices), `pieces-left-out`, `torus-guessed`, `first-full` (edges are longer than wanted)
    [[nodiscard]] const std::vector<MatchWarning>& warnings() const { return warnings_; }

private:
    void settle(SettlingOptions options);
    void warn(const char* code, int count);

    const PlacedModel& source_;
    TriangleMesh mesh_;
    std::vector<EdgeCurve> curves_;
    std::vector<MatchWarning> warnings_;
    TriangleMesh wrapped_;                ///< what is wrapped, and settled onto, where that is not the source's surface: its points
    std::optional<FitSurface> of_points_;
    std::optional<Remesher> remesher_;
    std::optional<Wrapper> wrapper_;
    std::optional<SkinSettling> settling_;
    int settled_ = 0; ///< slices
};

} // namespace lissom

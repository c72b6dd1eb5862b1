#pragma once

#include "lissom/match/distances.h"
#include "lissom/match/marker_alignment.h"
#include "lissom/match/skin_pair.h"
#include "lissom/mesh/working_mesh.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace lissom {

struct MatchOptions {
    MatchStart start = MatchStart::automatic;
    bool connectivity = true;  ///< false: the skins keep the source's triangles
    double edge_length = 0;    ///< L of the criteria, as a share of the source's size; 0: its mean edge length
    int levels = 3;            ///< node graphs, each with half the radius of the one before, 1 to 4
    int fine_steps = 14;       ///< 1 to 60
    int most_vertices = 0;     ///< of the skins; 0: four times the source's
    std::uint64_t seed = 0;
};

struct MatchSeconds {
    double start = 0, carry = 0, fine = 0, connectivity = 0, report = 0;
    [[nodiscard]] double sum() const { return start + carry + fine + connectivity + report; }
};

/// What a match is worth. Distances are shares of the bounding box diagonal of the model that the skin lies on.
struct MatchReport {
    SurfaceDistances source, target;    ///< of each skin (first) and its model
    double marker_error = 0;            ///< largest distance of a marker's vertex from its place, on either side
    int source_folds = 0, target_folds = 0;          ///< edges with a cosine below −0.2 between their triangles' normals
    int source_crossings = 0, target_crossings = 0;  ///< triangles that meet another without a common vertex
    int flipped = 0;                    ///< triangles of the target's skin that find no place of the model facing as they do within the length of their longest side
    std::vector<float> residuals;       ///< per vertex of the target's skin, its distance from the model
    ConnectivityChange connectivity;
    double flatness = 0;                ///< of the markers
    bool bent = false;                  ///< started by the radial map
    std::vector<Finding> warnings;      ///< `markers-mirrored`, `markers-swapped` (examples: markers), `markers-flat`, `markers-moved` (onto the surface),
                                        ///< `crossings-left` (count: triangles), `step-refused`, `skins-full` (no more splits), `stopped-early`
    MatchSeconds seconds;
};

struct MatchResult {
    SkinPair skins;                  ///< in the models' own spaces
    std::vector<int> marker_vertices; ///< the vertex of both skins that each marker is
    MatchReport report;
};

/// Two skins of one connectivity, one over each of two models, so that marked places correspond and everything between goes along.
///
/// The source model is the first skin. A copy is brought to lie on the target by the markers, carried closer by ever finer node graphs, untangled, and fitted
/// vertex by vertex with a guard against crossings, while edges of both are split, collapsed and swapped. Nothing is asked of
/// the target's connectivity. Models are brought to a common size that neither turning nor triangulation changes; what comes out goes with the models.
///
/// Source: Wang et al., "Duplicate-Skins for Compatible Mesh Modelling" (004). Changed: the first skin is the model instead of a box, which folds between limbs;
/// the fit is global instead of particle by particle (Eq 1), reverse samples keep tips, crossings are refused.
/// Cost: for skins of 15,000 vertices some two hundred factorizations' and crossing tests' worth: about ten seconds.
class MatchSession {
public:
    /// @param source,target   kept by reference: must outlive the session
    /// @param source_markers,target_markers  n×3 places in the models' own spaces, brought onto their surfaces; n may be 0
    /// @throws InvalidInput what `align_markers` says, `bad-option`, `flat-model` (a model without area)
    MatchSession(const WorkingMesh& source, const WorkingMesh& target, const Points& source_markers, const Points& target_markers, const MatchOptions& options = {});
    ~MatchSession();
    MatchSession(MatchSession&&) noexcept;

    /// One slice. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// The skins as they are and what they are worth; before the last step with `stopped-early`.
    [[nodiscard]] MatchResult result() const;

    [[nodiscard]] const MarkerAlignment& alignment() const;
    /// Where the target's skin is now, in the target's space: to look on.
    [[nodiscard]] Points target_positions() const;
    [[nodiscard]] const Triangles& triangles() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom

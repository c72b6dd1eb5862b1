#pragma once

#include "lissom/match/distances.h"
#include "lissom/match/marker_alignment.h"
#include "lissom/match/skin_set.h"
#include "lissom/mesh/working_mesh.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace lissom {

/// One of the models that skins are laid over.
struct MatchModel {
    const WorkingMesh* model = nullptr; ///< kept by reference: must outlive the session
    Points markers = Points(0, 3);      ///< n×3 places in the model's own space, brought onto its surface; n may be 0, the same for all models
    std::vector<int> ignored = {};      ///< vertices of the file: a triangle with all of its corners among them is fitted to by nothing, on a target; what comes from there, on the source, is fitted to nothing
    std::vector<Points> curves = {};    ///< marker curves: polylines of two places or more, in the model's own space; as many for all models, drawn the same way round
    std::vector<std::vector<int>> sharp = {}; ///< sharp edges that are picked: chains of vertices of the file, see `sharp_curves`
};

/// By which way skins come onto their models.
enum class MatchMethod {
    graph, ///< node graphs, then fits of all vertices at once, without crossings
    paper  ///< the paper's own loop, particle by particle (Eq 1, 2), with a tenth of the edges a pass: to compare. Folds and crosses itself at thin parts
};

/// What the first skin is, over the source.
enum class FirstSkin {
    automatic, ///< the source itself where it hangs together, else a wrap
    copy,   ///< the source itself
    remesh, ///< the source in even triangles of the wanted edge length, its sharp edges kept
    wrap,   ///< a closed surface around it: for soups, models with holes and points; see `Wrapper`
    box,    ///< these as the paper has them, settled onto the source: for convex models. They fold, or stay webs, between limbs
    sphere,
    torus
};

struct MatchOptions {
    FirstSkin first = FirstSkin::automatic;
    int genus = 0;             ///< tunnels that a wrap should have
    MatchMethod method = MatchMethod::graph;
    MatchStart start = MatchStart::automatic;
    bool connectivity = true;  ///< false: the skins keep the source's triangles
    double edge_length = 0;    ///< L of the criteria, as a share of the source's size; 0: its mean edge length
    int levels = 3;            ///< node graphs, each with half the radius of the one before, 1 to 4
    int fine_steps = 14;       ///< 1 to 60
    int most_vertices = 0;     ///< of the skins; 0: four times the source's
    double sharp_angle = 0;    ///< degrees, below 180: edges whose triangles' normals differ by more are sharp, and come to lie on edges of the skin; 0: only what is picked
    double adapt = 0;          ///< 0 to 1: how far edges are shorter where any skin is curved, down to a third, and longer where all are flat, up to twice
    std::uint64_t seed = 0;
};

struct MatchSeconds {
    double start = 0, carry = 0, fine = 0, connectivity = 0, sharp = 0, report = 0;
    [[nodiscard]] double sum() const { return start + carry + fine + connectivity + sharp + report; }
};

/// What one skin is worth, but for what masks leave out. Distances are shares of the bounding box diagonal of the model that it lies on.
struct SkinReport {
    SurfaceDistances distances;   ///< of the skin (first) and its model
    int folds = 0;                ///< edges with a cosine below −0.2 between their triangles' normals
    int crossings = 0;            ///< triangles that meet another without a common vertex
    int flipped = 0;              ///< triangles that find no place of the model facing as they do within the length of their longest side
    std::vector<float> residuals; ///< per vertex the larger of its distance from the model and of those places of the model from the skin that are nearest to it; 0 where a mask lies
    std::vector<int> worst;       ///< up to five vertices of large residual, apart from one another, the worst first: where a marker more helps
    int sharp_curves = 0;         ///< the model's sharp edges, chained between corners; and how many of them at least a piece found no edges of the skin
    int sharp_failed = 0;
    double sharp_error = 0;       ///< the farthest that a place of them is from the edges that lie on them; infinite where there are none
    std::vector<std::vector<int>> sharp; ///< these edges, as chains of vertices
    double flatness = 0;          ///< of its markers and the source's; the source's: 0
    bool bent = false;            ///< started by the radial map
};

struct MatchWarning {
    std::string code;
    int model = -1;            ///< which one it is about; −1: all
    int count = 0;             ///< of what it is about, at least 1
    std::vector<int> examples; ///< at most 8, by the code
};

struct MatchReport {
    std::vector<SkinReport> skins;      ///< one per model
    double marker_error = 0;            ///< largest distance of a marker's vertex from its place on any skin, a share as above
    double flatness = 0;                ///< of the flattest markers
    ConnectivityChange connectivity;
    std::vector<MatchWarning> warnings; ///< `markers-mirrored`, `markers-swapped` (examples: markers), `markers-flat`, `markers-moved` (onto the surface), `markers-one-sided`,
                                        ///< `markers-coincide` (examples: pairs; the later of each is left out), `poses-differ` (pose one like the other first), `pieces-differ`, `borders-differ` (one
                                        ///< is open, one closed), `genus-differs`,
                                        ///< `sharp-failed` (count: curves), `sharp-lost` (count: curves; of models matched pair by pair), `sharp-held-back` (count: 1; edges that could not be brought onto their curve without crossings),
                                        ///< `crossings-left` (count: triangles), `step-refused`, `skins-full` (no more splits), `stopped-early`, `not-settled` (the paper's loop after its last pass);
                                        ///< of the first skin `genus-missed` (count: what a wrap has), `webs` (count: vertices), `pieces-left-out`, `torus-guessed`, `first-full`
    MatchSeconds seconds;
};

struct MatchResult {
    SkinSet skins;                    ///< in the models' own spaces
    std::vector<int> marker_vertices; ///< the vertex of all skins that each marker is; of markers that coincide the same
    MatchReport report;
};

/// Skins of one connectivity, one over each of two or more models, so that marked places correspond and everything between goes along.
///
/// The first model, the source, is the first skin. A copy for each other model, a target, is brought to lie on it by the markers, carried closer by ever finer
/// node graphs, untangled, and fitted vertex by vertex with a guard against crossings, while edges of all are split, collapsed and swapped at once. Nothing is asked of
/// a target's connectivity. Models are brought to a common size that neither turning nor triangulation changes; what comes out goes with the models.
///
/// Sharp edges of each model are then found as edges of its skin and brought onto each other; those of the source are kept from the start.
///
/// Source: Wang et al., "Duplicate-Skins for Compatible Mesh Modelling" (004). Changed: the first skin is the model instead of a box, which folds between limbs;
/// the fit is global instead of particle by particle (Eq 1), reverse samples keep tips, crossings are refused; more than two models share one first skin instead of
/// being composed afterwards (4), which would add up their errors.
/// Cost: for two skins of 15,000 vertices some two hundred factorizations' and crossing tests' worth: about ten seconds; for n that times n − 1.
class MatchSession {
public:
    /// @param models  two or more, the source first
    /// @throws InvalidInput what `align_markers` says, `bad-option`, `model-count` (fewer than two), `flat-model` (a model without area), `curve-count` (models differ),
    ///     `picked-edges`, `bad-curve` (fewer than two places, no length, a coordinate that is not finite), `bad-mask` (a vertex that is not there, or the whole model)
    explicit MatchSession(const std::vector<MatchModel>& models, const MatchOptions& options = {});
    ~MatchSession();
    MatchSession(MatchSession&&) noexcept;

    /// One slice: some tenths of a second at most. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// The skins as they are and what they are worth; before the last step with `stopped-early`. @throws InvalidInput `not-begun`: there are none yet
    [[nodiscard]] MatchResult result() const;

    [[nodiscard]] const MarkerAlignment& alignment(int model) const; ///< of the source's markers with those of a target
    /// Where a model's skin is now, in the model's space: to look on. Empty before the first step, and while a first skin other than a copy is made.
    [[nodiscard]] Points positions(int model) const;
    [[nodiscard]] const Triangles& triangles() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom

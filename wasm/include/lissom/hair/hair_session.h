#pragma once

#include "lissom/hair/field_solver.h"
#include "lissom/hair/strand_detail.h"
#include "lissom/mesh/working_mesh.h"

#include <memory>
#include <vector>

namespace lissom {

/// Grown hair, in one block ready to be moved.
struct Strands {
    std::vector<std::uint32_t> offsets{0}; ///< n+1: strand i has points [offsets[i], offsets[i + 1])
    std::vector<float> points;             ///< xyz each, relative to the session's origin, root first
    std::vector<int> root_triangle;        ///< n, of the head that was given
    std::vector<float> root_weights;       ///< 2n: of the triangle's second and third corner
    std::vector<float> root_uvs;           ///< 2n, in [0, 1]: the root seen from the head's middle, angles from the top kept
    std::vector<std::uint32_t> clumps;     ///< n: number of its large clump

    [[nodiscard]] int count() const { return static_cast<int>(offsets.size()) - 1; }
};

/// What came out: the promises of hair as numbers.
struct HairFigures {
    int inside_head = 0;           ///< points deeper in the head than 0.5 % of its height
    int short_strands = 0;         ///< of fewer than three segments
    std::vector<int> reached;      ///< per ponytail: strands that come as near as its capture reaches
    std::vector<int> gathered;     ///< per ponytail: those of them that pass through its first cross-section
};

/// A head being given hair: what its shape decides is prepared once, a style costs what changed of it, and strands
/// are grown in any number.
///
/// The field is solved twice per style: of the style alone, to know where hair would run into the scalp; then with
/// the scalp's own constraints beside it (Fu 4.6, but live). The result depends on head and style alone, never on
/// the styles before: the field is rounded to 2⁻¹⁶, far above what the order of edits can leave.
class HairSession {
public:
    static constexpr int most_strands = 1'000'000;
    static constexpr int dense_limit = 6000; ///< constraints up to which the dual's dense factor is held

    /// Call step() until it returns false before anything else.
    /// @param head   source units, wherever it lies
    /// @param scalp  vertices of it
    /// @throws InvalidInput `scalp-empty`, `scalp-vertex`, `bad-resolution`, `head-empty`, `scalp-too-small`
    HairSession(const TriangleMesh& head, std::span<const int> scalp, int resolution = 48, UpAxis up = UpAxis::y);
    ~HairSession();
    HairSession(HairSession&&) noexcept;

    /// One slice of the preparation; true while there is more.
    bool step();
    [[nodiscard]] double fraction() const;

    /// Takes a style in source units; whatever was grown before stays as it is.
    /// Findings: `stroke-too-short` (examples: its number), `stroke-outside` (wholly outside the volume),
    /// `ponytail-incomplete` (no spine or no section), `ponytail-inside-head`, `style-empty`.
    /// @throws InvalidInput `non-finite-stroke`, `bad-option`
    void set_style(const HairStyle& style);

    /// Strands under way; step() until it returns false, then take().
    class Growth {
    public:
        bool step();
        [[nodiscard]] double fraction() const;
        [[nodiscard]] Strands take() { return std::move(strands_); }
        [[nodiscard]] const HairFigures& figures() const { return figures_; }

    private:
        friend class HairSession;
        Growth() = default;
        void add(const Strand& strand);

        std::shared_ptr<const struct HeadShape> head_; // both kept alive: a later style does not disturb
        std::shared_ptr<const struct StyledField> style_;
        std::unique_ptr<StrandGrowth> growth_;
        std::unique_ptr<StrandDetail> detail_;
        DetailOptions detail_options_;
        std::vector<Strand> guides_;
        int guides_wanted_ = 0, from_ = 0, next_ = 0, end_ = 0;
        Strands strands_;
        HairFigures figures_;
    };

    /// Strands [from, from + count) of the style. They are the same whatever range they are grown in. Without a
    /// style, or where it asks for nothing, there are none.
    /// @throws InvalidInput `too-many-strands`, `bad-option`
    [[nodiscard]] Growth grow(int from, int count, const GrowthOptions& growth, const DetailOptions& detail) const;

    [[nodiscard]] const Eigen::Vector3d& origin() const; ///< what strands are relative to: the middle of the head
    [[nodiscard]] const HairVolume& volume() const;      ///< relative to origin()
    [[nodiscard]] const VectorField& field() const;      ///< of the style
    [[nodiscard]] const std::vector<FieldConstraint>& constraints() const; ///< of the style, then of the scalp
    [[nodiscard]] const std::vector<Finding>& warnings() const;
    [[nodiscard]] double prepare_seconds() const;
    [[nodiscard]] double update_seconds() const; ///< of the last style: both sets of constraints
    [[nodiscard]] double field_seconds() const;  ///< of the last style

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom

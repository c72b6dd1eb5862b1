#pragma once

#include "lissom/mesh/working_mesh.h"
#include "lissom/wear/measures.h"
#include "lissom/wear/part_paste.h"

#include <memory>
#include <span>
#include <vector>

namespace lissom {

struct BlendSeconds {
    double factor = 0;               ///< of the parts
    double measure = 0, blend = 0;   ///< of the last call
};

struct Blended {
    Points positions;
    Eigen::VectorXd weights;     ///< as given, or as wanted measures ask
    std::vector<double> reached; ///< each measure of the shape, parts and all
    int iterations = 0;
    std::vector<Finding> warnings; ///< `measure-missed` (by more than a hundredth; examples: measures), `weights-far` (outside of −0.5 … 1.5; examples: skins)
};

/// Shapes between skins of one connectivity (Skins 5.1): Σ w_k S_k, weights found by measures, parts taken from one of them.
///
/// Cost: parts are factored once; then a sum and a solve for each, so that weights can be dragged.
class BlendSession {
public:
    /// Call step() until it returns false.
    /// @param skins  n×3 each, one or more
    /// @throws InvalidInput `wrong-size`, `no-skins`, `vertex-out-of-range`, `non-finite-position`, `unknown-skin` (of a part), and as `PartPaste`
    BlendSession(const Triangles& triangles, std::vector<Points> skins, const std::vector<PartSpec>& parts);
    ~BlendSession();
    BlendSession(BlendSession&&) noexcept;

    /// One slice. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// @param weights  one for each skin; where a measure is wanted only what is kept to (`synthesised`)
    /// @throws InvalidInput `wrong-size`, `no-weights` (all 0 and no measure wanted, or one not finite), as `Measurer`
    [[nodiscard]] Blended blend(const Eigen::VectorXd& weights, std::span<const Measure> measures = {});

    [[nodiscard]] const BlendSeconds& seconds() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom

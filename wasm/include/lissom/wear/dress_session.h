#pragma once

#include "lissom/mesh/working_mesh.h"
#include "lissom/wear/push_out.h"

#include <memory>
#include <vector>

namespace lissom {

struct DressSeconds {
    double prepare = 0; ///< the map between the skins, the bodies, the factor
    double dress = 0;   ///< the last call of `dress`
};

struct Dressed {
    Points positions;              ///< n×3, per source vertex of the garment; those without a finite position as they are
    Inside before, after;          ///< of the body, before and after pushing out
    int rounds = 0;
    std::vector<Finding> warnings; ///< `body-without-inside` (the skin: nothing could be pushed out), `model-without-inside` (only the skin was minded),
                                   ///< `inside-left` (count: vertices and face centres)
};

/// A garment made for one body, worn by another of which there is a skin of the same connectivity.
///
/// What it is made of is carried from skin to skin (`BodyMap`), what that moves is smoothed along the garment over some 1 cm of a person, and
/// what then lies within the body is pushed out (`push_out`). All lengths are shares of √area of the skin: a doll's dress fits as a giant's.
/// Cost: prepare is dominated by the dense map (1,200³); a garment of 4,000 vertices is then dressed in some 0.1 s, again for every ease.
class DressSession {
public:
    /// Call step() until it returns false.
    /// @param garment  kept by reference: must outlive the session; in the space of the first body
    /// @param from,to  the skins, n×3 each
    /// @param model    the body that the second skin is of, or none; minded beside the skin where it has an inside. Only read here
    /// @throws InvalidInput as `BodyMap`
    DressSession(const WorkingMesh& garment, const Triangles& triangles, const Points& from, const Points& to, const WorkingMesh* model = nullptr);
    ~DressSession();
    DressSession(DressSession&&) noexcept;

    /// One slice. @returns true while there is more. @throws SolverFailure
    bool step();
    [[nodiscard]] double fraction() const;

    /// @param ease  how much farther from the body than on the first, in the second body's unit; less than 0: tighter
    /// @throws InvalidInput `bad-option` (not finite)
    [[nodiscard]] Dressed dress(double ease = 0);

    [[nodiscard]] const DressSeconds& seconds() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lissom

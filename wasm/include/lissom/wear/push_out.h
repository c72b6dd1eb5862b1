#pragma once

#include "lissom/mesh/types.h"
#include "lissom/wear/body.h"

#include <span>

namespace lissom {

/// What of a garment lies within a body.
struct Inside {
    int vertices = 0;
    int face_centres = 0;

    [[nodiscard]] bool none() const { return vertices == 0 && face_centres == 0; }
};

/// @param bodies  within any of them counts
[[nodiscard]] Inside inside(const TriangleMesh& garment, std::span<const Body* const> bodies);

struct PushedOut {
    Inside before, after;
    int rounds = 0;
};

/// Brings a garment out of bodies: vertices and face centres that lie within one go to the nearest place of its surface and a margin
/// beyond, six rings around follow ever less; again until nothing is inside.
/// @param margin  in the garment's unit
/// @param rounds  at most
PushedOut push_out(TriangleMesh& garment, std::span<const Body* const> bodies, double margin, int rings = 6, int rounds = 6);

} // namespace lissom

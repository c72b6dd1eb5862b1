#pragma once

#include "lissom/mesh/types.h"

namespace lissom {

// Simple shapes around a model for a skin to begin as, closed, facing outward and evenly meshed. `SkinSettling` brings them onto the model.
//
// Honestly: none of them knows anything of the model but its extent. A skin that begins as a box or a sphere reaches what can be seen from it; between legs, under chins, in
// armpits and behind ears it folds or stays a web, and no later change of edges unfolds it: measured on a calf and a head, hundreds to thousands of
// folds, or, with the guard, a web that stays. An open border gets a lid. They are good for convex shapes, to look at, and to compare with the paper. For
// anything else begin with the model itself, `remesh`ed, or `wrap` it.
//
// Source: Wang et al. (004), 3.1: bounding boxes for genus 0, a torus for one tunnel.
// Each @throws InvalidInput `bad-option` (no positive edge length, or one that would need more than a million vertices), `flat-model` (a single place)

/// The bounding box along x, y, z, larger by a share of its diagonal on every side.
[[nodiscard]] TriangleMesh box_around(const TriangleMesh& model, double edge_length, double margin = 0.02);

/// A sphere about the middle of the box, as far as the farthest place and a share more; an icosahedron whose sides are cut into equal parts.
[[nodiscard]] TriangleMesh sphere_around(const TriangleMesh& model, double edge_length, double margin = 0.02);

struct TorusAround {
    TriangleMesh mesh;
    bool through = false; ///< its axis goes through the model's hole; false: no line along a principal axis through the middle misses the surface, and the torus is a guess
};
/// A torus about the model's middle: around the principal axis, the shortest first, along which a line through the middle misses the surface, its tube an
/// ellipse around all the model as seen turning about the axis; the model sticks out where the hole would close.
[[nodiscard]] TorusAround torus_around(const TriangleMesh& model, double edge_length, double margin = 0.02);

} // namespace lissom

#pragma once

#include "lissom/isoline/patches.h"
#include "lissom/isoline/reduced_energy.h"

#include <vector>

namespace lissom {

/// Who turns the details, and which triangles tell how far.
struct Carriers {
    struct Sample {
        int triangle;
        double weight; ///< share in its carrier's mean: its area, or l² of Isolines Eq 9
    };
    DetailCarriers details;
    std::vector<std::vector<Sample>> samples; ///< per carrier; none where `handle` tells
    std::vector<int> handle;                  ///< per carrier the region handle whose rotation it has, or −1
    Eigen::MatrixXd fields;                   ///< carriers × fields: their mean in each, for the first guess
    bool normals_only = false;                ///< Eq 9 of triangle normals, not full frames

    /// Takes other fields for the first guess: those without free handles, which have no rotation to tell.
    void guess_by(const Columns& others);
};

/// A carrier a patch.
/// @param ends  one per field; a field whose end is a region has a patch of known rotation
[[nodiscard]] Carriers patch_carriers(const TriangleMesh& mesh, const Columns& fields, const std::vector<int>& handle, std::span<const HandleEnd> ends,
                                      const PatchOptions& options);

/// A carrier an isoline, W_δ of Isolines 4.3: at the abscissae of the basis, the outermost a quarter of a step inside.
/// @param triangles  most triangles sampled on all isolines together (n_tri)
[[nodiscard]] Carriers isoline_carriers(const TriangleMesh& mesh, const Columns& fields, const ControlSets& sets, std::span<const HandleEnd> ends,
                                        int triangles);

} // namespace lissom

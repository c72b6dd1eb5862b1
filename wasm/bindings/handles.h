#pragma once

// How handles and their targets cross: for every session that is dragged by handles.

#include "convert.h"
#include "lissom/deform/deform_session.h"

#include <string>
#include <vector>

namespace bindings {

/// { kind, vertices: Uint32Array }[]
inline std::vector<lissom::DeformHandle> handle_groups(const val& handles) {
    std::vector<lissom::DeformHandle> groups;
    for (const val& handle : emscripten::vecFromJSArray<val>(handles))
        groups.push_back({handle["kind"].as<std::string>() == "point", indices(handle["vertices"])});
    return groups;
}

/// k column-major 4×4 matrices, end to end, as THREE.Matrix4.elements
inline std::vector<Eigen::Affine3d> affine_maps(const val& matrices) {
    const auto flat = emscripten::convertJSArrayToNumberVector<double>(matrices);
    if (flat.size() % 16 != 0)
        throw lissom::InvalidInput("handle-count", "Each handle needs the sixteen numbers of its matrix.");
    std::vector<Eigen::Affine3d> maps(flat.size() / 16);
    for (std::size_t j = 0; j < maps.size(); ++j) {
        const Eigen::Map<const Eigen::Matrix4d> matrix(flat.data() + 16 * j);
        if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
            throw lissom::InvalidInput(matrix.allFinite() ? "not-affine" : "non-finite-target",
                                       "The transformation of handle " + std::to_string(j + 1) +
                                           " is not made of a move, a turn and a scale. Reset the handle.");
        maps[j].matrix() = matrix;
    }
    return maps;
}

} // namespace bindings

#include "convert.h"
#include "lissom/mesh/working_mesh.h"

#include <emscripten/bind.h>

#include <algorithm>
#include <memory>

using namespace emscripten;
using namespace bindings;
using lissom::WorkingMesh;

namespace {

// new WorkingMesh(positions: Float64Array 3n, faceOffsets: Uint32Array m+1, faceVertices: Uint32Array)
std::shared_ptr<WorkingMesh> open(const val& positions, const val& face_offsets, const val& face_vertices) {
    return guarded([&] {
        lissom::PolygonMesh source{points(positions), indices(face_offsets), indices(face_vertices)};
        const std::vector<int>& offsets = source.offsets;
        const bool fits = offsets.empty() || (offsets.front() == 0 && std::is_sorted(offsets.begin(), offsets.end()) &&
                                              offsets.back() <= static_cast<int>(source.corners.size()));
        if (!fits)
            throw lissom::InvalidInput("bad-face-offsets", "The list of faces does not fit its list of corners.");
        return std::make_shared<WorkingMesh>(lissom::make_working_mesh(source));
    });
}

// describe() → OpenedModel of web/kernel/contract.ts, without its id
val describe(const WorkingMesh& working) {
    return guarded([&] {
        val result = val::object();
        result.set("triangles",
                   uint32_array(working.display.data(), static_cast<std::size_t>(working.display.size())));
        result.set("faceOfTriangle",
                   uint32_array(working.polygon_of_display.data(), working.polygon_of_display.size()));
        result.set("welded", int32_array(working.working_of_source));
        result.set("findings", findings(working.findings));
        result.set("components", working.component_count);
        result.set("boundaryLoops", working.boundary_loop_count);
        result.set("eulerCharacteristic", working.euler_characteristic);
        result.set("oriented", working.oriented);
        result.set("closed", working.closed);
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(model) {
    class_<WorkingMesh>("WorkingMesh")
        .smart_ptr_constructor("WorkingMesh", &open)
        .function("describe", &describe);
}

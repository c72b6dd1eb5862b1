#include "convert.h"
#include "lissom/deform/measure.h"

#include <emscripten/bind.h>

using namespace emscripten;
using namespace bindings;

namespace {

// measure(model, positions: Float64Array) → Measured of web/kernel/contract.ts
val measured(const lissom::WorkingMesh& working, const val& positions) {
    return guarded([&] {
        const lissom::Measures found = lissom::measure(working, points(positions));
        val result = val::object();
        result.set("volumeRatio", found.volume_ratio);
        result.set("edgeRms", found.edge_rms);
        result.set("worstStretch", found.worst_stretch);
        result.set("flippedTriangles", found.flipped_triangles);
        result.set("stretch", typed_array(found.vertex_stretch.data(), found.vertex_stretch.size()));
        return result;
    });
}

} // namespace

EMSCRIPTEN_BINDINGS(measure) { function("measure", &measured); }

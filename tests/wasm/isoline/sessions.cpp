#include "sessions.h"

#include "lissom/isoline/taubin.h"
#include "lissom/mesh/operators.h"

namespace sessions {

Prepared::Prepared(const TriangleMesh& mesh, const IsolineModelOptions& options) : working(shapes::working(mesh)), model(working, options) {
    while (model.step()) {
    }
}

lissom::IsolineSession Prepared::session(const std::vector<DeformHandle>& handles, const IsolineOptions& options) const {
    lissom::IsolineSession made(model, handles::everything(working.source), handles, options);
    while (made.step()) {
    }
    return made;
}

Fielded::Fielded(const TriangleMesh& given, const std::vector<DeformHandle>& ends) : mesh(shapes::working(given).mesh) {
    laplacian = lissom::cotangent_laplacian(mesh);
    areas = lissom::ring_areas(mesh);
    handle.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
    for (std::size_t h = 0; h < ends.size(); ++h)
        for (const int v : ends[h].vertices) handle[v] = static_cast<int>(h);
    lissom::HarmonicFields harmonic(mesh, laplacian, handle, static_cast<int>(ends.size()));
    while (harmonic.step()) {
    }
    fields = harmonic.solve();
}

Dragged drag(const TriangleMesh& mesh, const std::vector<DeformHandle>& handles, const std::vector<Eigen::Affine3d>& targets, const IsolineOptions& options,
             int solves) {
    const Prepared prepared(mesh);
    lissom::IsolineSession session = prepared.session(handles, options);
    const lissom::IsolineFrame frame = session.drag(targets, solves, true);
    return {session.positions(), frame.solves, frame.change};
}

std::vector<DeformHandle> axis_caps(const Points& points, int count, double share) {
    std::vector<DeformHandle> caps(static_cast<std::size_t>(count));
    std::vector<char> used(static_cast<std::size_t>(points.rows()), 0);
    for (int h = 0; h < count; ++h) {
        const Eigen::VectorXd along = (h % 2 ? -1.0 : 1.0) * points.col(h / 2);
        const double high = along.maxCoeff(), low = along.minCoeff();
        for (int v = 0; v < points.rows(); ++v)
            if (!used[v] && along[v] >= high - share * (high - low)) {
                caps[h].vertices.push_back(v);
                used[v] = 1;
            }
    }
    return caps;
}

} // namespace sessions

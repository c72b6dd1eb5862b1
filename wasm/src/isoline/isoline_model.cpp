#include "lissom/isoline/isoline_model.h"

#include "lissom/isoline/taubin.h"
#include "lissom/mesh/delaunay.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lissom {
namespace {

/// What three pairs of smoothing steps leave of the bending energy where it was noise. Measured: 0.80 (a body of 12k) to 1.26 on the
/// clean models at hand, 0.24 to 0.70 with normal noise of a twentieth of an edge, 0.16 to 0.45 with a fifth, below 0.15 with triangles turned over.
constexpr double k_noisy = 0.66;
constexpr int k_probing_steps = 3;
/// A proxy must at least save this much, or it is not worth its error.
constexpr double k_worth_a_proxy = 1.2;

} // namespace

struct IsolineModel::State {
    enum class Stage { begin, smooth, simplify, bind, operators, done };

    const WorkingMesh& working;
    IsolineModelOptions options;
    Stage stage = Stage::begin;
    VertexRings fine_rings{};
    Points smooth{};              ///< working vertices, smoothed; empty where they are not
    std::vector<bool> border{};
    int smoothing_done = 0;
    double energy = 0;            ///< bending energy as it came
    Proxy surface{};
    std::optional<SurfaceBinder> binder{};
    SurfaceBinding binding{};
    SparseMatrix L{};
    Eigen::VectorXd areas{};
    VertexRings rings{};
    bool is_proxy = false;
    double seconds = 0;

    [[nodiscard]] const Points& fine_points() const { return smooth.rows() > 0 ? smooth : working.mesh.points; }

    void begin() {
        is_proxy = working.mesh.vertex_count() > k_worth_a_proxy * options.proxy_vertices;
        const bool may_smooth = options.smoothing != Smoothing::never;
        if (may_smooth || is_proxy) fine_rings = vertex_rings(working.mesh);
        if (may_smooth) {
            border = boundary_vertices(working.mesh);
            smooth = working.mesh.points;
            energy = bending_energy(working.mesh, border);
        }
        stage = may_smooth ? Stage::smooth : Stage::simplify;
    }

    void smooth_on() {
        taubin_step(smooth, fine_rings, border);
        ++smoothing_done;
        if (smoothing_done == k_probing_steps && options.smoothing == Smoothing::automatic &&
            !(bending_energy({smooth, working.mesh.triangles}, border) < k_noisy * energy)) {
            smooth = {};
            smoothing_done = 0;
            stage = Stage::simplify;
        }
        if (smoothing_done >= options.smoothing_steps) stage = Stage::simplify;
    }

    /// Halves the triangles at most, so that one slice is short and a cancelled one is heard.
    void simplify() {
        if (surface.fine.empty()) surface = whole({fine_points(), working.mesh.triangles});
        const int target = 2 * options.proxy_vertices, now = surface.mesh.triangle_count();
        if (is_proxy && now > target) {
            surface = simplified(surface, std::max(target, now / 2));
            if (surface.mesh.triangle_count() > target && surface.mesh.triangle_count() < 0.95 * now) return;
        }
        // Collapses leave needles, whose cotangents would outweigh all the rest of the energy.
        if (is_proxy) flip_to_delaunay(surface.mesh);
        if (is_proxy) binder.emplace(fine_points(), fine_rings, surface);
        stage = is_proxy ? Stage::bind : Stage::operators;
    }

    void bind() {
        if (binder->step()) return;
        binding = binder->take();
        binder.reset();
        fine_rings = {};
        stage = Stage::operators;
    }

    void operators() {
        rings = vertex_rings(surface.mesh);
        L = cotangent_laplacian(surface.mesh);
        areas = ring_areas(surface.mesh);
        smooth = {};
        fine_rings = {};
        border = {};
        stage = Stage::done;
    }
};

IsolineModel::IsolineModel(const WorkingMesh& working, IsolineModelOptions options) : state_(new State{.working = working, .options = options}) {
    state_->options.proxy_vertices = std::max(1000, options.proxy_vertices);
}
IsolineModel::~IsolineModel() = default;
IsolineModel::IsolineModel(IsolineModel&&) noexcept = default;

bool IsolineModel::step() {
    Stopwatch watch;
    switch (state_->stage) {
    case State::Stage::begin: state_->begin(); break;
    case State::Stage::smooth: state_->smooth_on(); break;
    case State::Stage::simplify: state_->simplify(); break;
    case State::Stage::bind: state_->bind(); break;
    case State::Stage::operators: state_->operators(); break;
    case State::Stage::done: return false;
    }
    state_->seconds += watch.lap();
    return state_->stage != State::Stage::done;
}

double IsolineModel::fraction() const {
    const State& s = *state_;
    switch (s.stage) { // shares of the time that stages took on a million vertices
    case State::Stage::begin: return 0;
    case State::Stage::smooth: return 0.1 + 0.15 * s.smoothing_done / s.options.smoothing_steps;
    case State::Stage::simplify: {
        const double fine = s.working.mesh.triangle_count(), now = s.surface.fine.empty() ? fine : s.surface.mesh.triangle_count();
        const double target = 2.0 * s.options.proxy_vertices;
        return 0.25 + (fine > target ? 0.45 * std::clamp((fine - now) / (fine - target), 0.0, 1.0) : 0);
    }
    case State::Stage::bind: return 0.7 + 0.25 * s.binder->fraction();
    case State::Stage::operators: return 0.95;
    case State::Stage::done: break;
    }
    return 1;
}

const WorkingMesh& IsolineModel::working() const { return state_->working; }
const Proxy& IsolineModel::surface() const { return state_->surface; }
const SparseMatrix& IsolineModel::laplacian() const { return state_->L; }
const Eigen::VectorXd& IsolineModel::areas() const { return state_->areas; }
const VertexRings& IsolineModel::rings() const { return state_->rings; }
bool IsolineModel::is_proxy() const { return state_->is_proxy; }
bool IsolineModel::smoothed() const { return state_->smoothing_done > 0; }
const SurfaceBinding& IsolineModel::binding() const { return state_->binding; }
double IsolineModel::seconds() const { return state_->seconds; }

Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> IsolineModel::to_working(const Columns& fields) const {
    Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> out;
    out.setZero(state_->working.mesh.vertex_count(), fields.cols());
    if (!state_->is_proxy) {
        for (std::size_t v = 0; v < state_->surface.fine.size(); ++v)
            out.row(state_->surface.fine[v]) = fields.row(static_cast<Eigen::Index>(v)).cast<float>();
        return out;
    }
    const Triangles& T = state_->surface.mesh.triangles;
    for (Eigen::Index v = 0; v < out.rows(); ++v) {
        const int t = state_->binding.triangle[static_cast<std::size_t>(v)];
        if (t < 0) continue;
        const double b = state_->binding.weights(v, 0), c = state_->binding.weights(v, 1);
        out.row(v) = ((1 - b - c) * fields.row(T(t, 0)) + b * fields.row(T(t, 1)) + c * fields.row(T(t, 2))).cast<float>();
    }
    return out;
}

double IsolineModel::memory_bytes() const {
    const State& s = *state_;
    return 8.0 * static_cast<double>(s.surface.mesh.points.size() + s.areas.size()) + 4.0 * static_cast<double>(s.surface.mesh.triangles.size()) +
           12.0 * static_cast<double>(s.L.nonZeros()) + 4.0 * static_cast<double>(s.rings.neighbours.size() + s.rings.offsets.size()) +
           12.0 * static_cast<double>(s.binding.triangle.size());
}

IsolineMemory estimate_isoline_memory(double vertices, double triangles, int handles, int controls, int proxy_vertices, double settle_limit) {
    IsolineMemory memory;
    const bool proxy = vertices > k_worth_a_proxy * proxy_vertices;
    const double surface = proxy ? std::min(vertices, 1.1 * proxy_vertices) : vertices;
    // Sides of triangles sorted for the rings (20 bytes, 3 a triangle) and the edges they make (16, 3 a vertex); then meshoptimizer's own
    // 200 bytes a vertex beside corners and positions.
    const double rings = triangles * 60 + vertices * (48 + 28);
    const double simplifying = vertices * (28 + 24 + 24 + 12 + 200) + triangles * (12 + 24 + 24);
    const double operators = surface * (2 * 60 + 12 * 7 + 16 * 3 + 100);
    memory.model = std::max({rings, proxy ? simplifying : 0, operators}) + (proxy ? vertices * 12 : 0);
    const double sets = handles <= 2 ? 1 : handles, unknowns = 4 * sets * controls, carriers = 3 * (150.0 + handles) + 4 * handles;
    const double fields = surface * handles * (8.0 * 3 + 36) + vertices * handles * (4 + 12);
    const double factor = surface * (30 + 6 * std::log2(std::max(2.0, surface))) * 8; // nested dissection: n log n entries
    const double dense = 8 * (5 * unknowns * unknowns + 3 * unknowns * carriers);
    memory.session = surface * 300 + (proxy ? vertices * 12 : 0) + fields + factor + dense;
    if (vertices <= settle_limit) memory.settle = vertices * (19 * 12 * 2 + (60 + 22 * std::log2(std::max(2.0, vertices))) * 8);
    return memory;
}

} // namespace lissom

#include "lissom/match/wrap.h"

#include "lissom/match/flood_grid.h"
#include "lissom/mesh/errors.h"
#include "lissom/mesh/iso_surface.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/remesh.h"
#include "lissom/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr double k_web_slope = 0.65;       // |∇d| between two sheets that lie more than 99 degrees apart as seen from there; in a right angle it is 0.71
constexpr int k_vertices = 10000;

struct Shell {
    TriangleMesh mesh;
    int left_out = 0, genus = 0;
};

/// The piece with the most triangles.
Shell largest(const TriangleMesh& mesh) {
    const Components parts = components(vertex_rings(mesh));
    std::vector<int> size(static_cast<std::size_t>(parts.count), 0);
    for (int t = 0; t < mesh.triangle_count(); ++t) ++size[parts.of_vertex[mesh.triangles(t, 0)]];
    const int best = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
    Shell shell;
    shell.left_out = parts.count - 1;
    std::vector<int> place(static_cast<std::size_t>(mesh.vertex_count()), -1);
    int count = 0;
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (parts.of_vertex[v] == best) place[v] = count++;
    shell.mesh.points.resize(count, 3);
    for (int v = 0; v < mesh.vertex_count(); ++v)
        if (place[v] >= 0) shell.mesh.points.row(place[v]) = mesh.points.row(v);
    shell.mesh.triangles.resize(size[best], 3);
    int row = 0;
    for (int t = 0; t < mesh.triangle_count(); ++t)
        if (place[mesh.triangles(t, 0)] >= 0) {
            for (int k = 0; k < 3; ++k) shell.mesh.triangles(row, k) = place[mesh.triangles(t, k)];
            ++row;
        }
    shell.genus = (2 - euler_characteristic(shell.mesh)) / 2;
    return shell;
}

} // namespace

TriangleMesh as_triangles(const Points& points) {
    TriangleMesh mesh{points, Triangles(points.rows(), 3)};
    for (int i = 0; i < points.rows(); ++i) mesh.triangles.row(i).setConstant(i);
    return mesh;
}

struct Wrapper::State {
    enum class Stage { flood, genus, mesh, done };

    WrapOptions options;
    FloodGrid flood;
    std::vector<std::pair<int, int>> misses; ///< how far the genus is off, number of the radius
    int candidate = 0;
    bool chosen = false;
    std::optional<Remesher> remesher;
    Wrapped out;
    Stage stage = Stage::flood;

    State(const TriangleMesh& m, const WrapOptions& o) : options(o), flood(m, o.cells) {}

    [[nodiscard]] Shell shell_at(double r) const {
        const std::vector<char> reached = flood.reached(r);
        std::vector<float> values(flood.distances().size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto off = static_cast<float>(flood.distances()[i] - r);
            values[i] = reached[i] ? off : -std::abs(off);
        }
        return largest(iso_surface(flood.grid(), values));
    }

    void try_radius() {
        const std::vector<double>& radii = flood.radii();
        Shell shell = shell_at(radii[static_cast<std::size_t>(candidate)]);
        const int off = std::abs(shell.genus - options.genus);
        misses.emplace_back(off, candidate);
        if (off != 0 && !chosen) {
            if (++candidate < std::ssize(radii)) return;
            candidate = std::min_element(misses.begin(), misses.end())->second;
            chosen = true; // the nearest there is, in a slice of its own
            return;
        }
        out.radius = radii[static_cast<std::size_t>(candidate)];
        out.genus_missed = off != 0;
        out.left_out = shell.left_out;
        const double area = triangle_areas(shell.mesh).sum();
        const double L = options.edge_length > 0 ? options.edge_length : std::sqrt(area / (0.866 * k_vertices));
        remesher.emplace(shell.mesh, std::vector<EdgeCurve>{}, std::vector<int>{}, RemeshOptions{L});
        stage = Stage::mesh;
    }

    /// Where the nearest places lie on different sides, the distance's slope is less than one.
    void find_webs() {
        const auto at = [&](const Vector3d& p) { return flood.tree().nearest_where(p, std::numeric_limits<double>::infinity(), -1, [](int) { return true; }).distance; };
        const double h = 0.5 * out.radius;
        for (int v = 0; v < out.mesh.vertex_count(); ++v) {
            const Vector3d p = out.mesh.points.row(v);
            Vector3d slope;
            for (int k = 0; k < 3; ++k) slope[k] = (at(p + h * Vector3d::Unit(k)) - at(p - h * Vector3d::Unit(k))) / (2 * h);
            if (slope.norm() >= k_web_slope) continue;
            ++out.webs;
            if (out.web_examples.size() < 8) out.web_examples.push_back(v);
        }
    }

    void advance() {
        switch (stage) {
        case Stage::flood:
            if (flood.step()) break;
            candidate = flood.first_sound();
            stage = Stage::genus;
            break;
        case Stage::genus: try_radius(); break;
        case Stage::mesh:
            if (remesher->step()) break;
            out.mesh = remesher->result().mesh;
            out.genus = (2 - euler_characteristic(out.mesh)) / 2;
            remesher.reset();
            find_webs();
            stage = Stage::done;
            break;
        case Stage::done: break;
        }
    }
};

Wrapper::Wrapper(const TriangleMesh& model, const WrapOptions& options) {
    const auto refuse = [](const std::string& sentence) { throw InvalidInput("bad-option", sentence); };
    if (options.genus < 0) refuse("The genus is " + std::to_string(options.genus) + "; it must be 0 or more.");
    check_cells(options.cells);
    if (!(options.edge_length >= 0 && std::isfinite(options.edge_length))) refuse("The edge length must be above 0, or 0 for one that suits.");
    state_ = std::make_unique<State>(model, options);
}
Wrapper::~Wrapper() = default;
Wrapper::Wrapper(Wrapper&&) noexcept = default;

bool Wrapper::step() {
    state_->advance();
    return state_->stage != State::Stage::done;
}

double Wrapper::fraction() const {
    const State& s = *state_;
    constexpr double flooded = 0.6; // share of the time as measured
    switch (s.stage) {
    case State::Stage::flood: return flooded * s.flood.fraction();
    case State::Stage::genus: return flooded;
    case State::Stage::mesh: return flooded + (1 - flooded) * s.remesher->fraction();
    case State::Stage::done: break;
    }
    return 1;
}

const Wrapped& Wrapper::result() const { return state_->out; }

Wrapped wrap(const TriangleMesh& model, const WrapOptions& options) {
    Wrapper wrapper(model, options);
    while (wrapper.step()) {
    }
    return wrapper.result();
}

} // namespace lissom

#include "lissom/match/wrap.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/grid.h"
#include "lissom/mesh/iso_surface.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/point_tree.h"
#include "lissom/mesh/remesh.h"
#include "lissom/mesh/surface_samples.h"
#include "lissom/mesh/topology.h"
#include "lissom/mesh/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

namespace lissom {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr int k_samples = 20000, k_neighbours = 6;
constexpr double k_quantile = 0.95;
constexpr double k_least_cells = 1.5;      // of radius
constexpr double k_first = 0.8, k_raise = 1.2, k_last = 3; // of the spacing
constexpr double k_most_surface_cells = 60000;
constexpr int k_block = 8;                 // nodes along a side
constexpr int k_blocks_a_slice = 60;
/// Growth of the fill from radius to radius, by that of a surface that moves outwards, above which the flood had run inside.
constexpr double k_jump = 2.5;
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
    enum class Stage { distances, radii, mesh, done };

    const TriangleMesh& model;
    WrapOptions options;
    TriangleTree tree;
    double spacing = 0; ///< of samples
    Grid grid;
    std::vector<double> radii;
    std::vector<float> distance; ///< of nodes, no more than the largest radius and a cell
    Vector3i blocks = Vector3i::Zero();
    int block = 0;

    struct Fill {
        double nodes, faces; ///< not reached; between a node that is and one that is not
    };
    std::vector<Fill> fills;
    std::vector<std::pair<int, int>> misses; ///< how far the genus is off, number of the radius
    std::size_t candidate = 0;
    bool chosen = false;
    std::optional<Remesher> remesher;
    Wrapped out;
    Stage stage = Stage::distances;

    State(const TriangleMesh& m, const WrapOptions& o) : model(m), options(o), tree(model) {
        const double area = triangle_areas(model).sum();
        Points samples = model.points;
        if (area > 0) samples = sample_surface(model, k_samples).on(model);
        if (samples.rows() < 2 || !(diagonal(samples) > 0)) throw InvalidInput("flat-model", "There is nothing to wrap: the model is a single place. Choose another model.");
        measure(samples);
        const Eigen::RowVector3d low = samples.colwise().minCoeff(), high = samples.colwise().maxCoeff();
        // Scattered points have the area of the discs that they stand for.
        const double covered = area > 0 ? area : static_cast<double>(samples.rows()) * spacing * spacing * 0.5;
        const double longest = (high - low).maxCoeff();
        grid.step = std::max(longest / options.cells, std::sqrt(covered / k_most_surface_cells));
        const double first = std::max(k_first * spacing, k_least_cells * grid.step);
        for (double r = first; r <= k_last * std::max(spacing, first / k_first) * (1 + 1e-9); r *= k_raise) radii.push_back(r);
        const double margin = radii.back() + 2 * grid.step;
        grid.origin = (low.array() - margin).matrix().transpose();
        for (int k = 0; k < 3; ++k) grid.size[k] = static_cast<int>(std::ceil((high[k] - low[k] + 2 * margin) / grid.step)) + 1;
        for (int k = 0; k < 3; ++k) blocks[k] = (grid.size[k] + k_block - 1) / k_block;
        distance.assign(static_cast<std::size_t>(grid.count()), static_cast<float>(reach()));
    }

    [[nodiscard]] double reach() const { return radii.back() + 1.8 * grid.step; }

    /// The 95 % quantile of the distance to the sixth neighbour.
    void measure(const Points& samples) {
        const PointTree near(samples);
        std::vector<std::pair<int, double>> found;
        std::vector<double> lengths;
        for (Eigen::Index i = 0; i < samples.rows(); ++i) {
            near.nearest(samples.row(i).transpose(), k_neighbours + 1, found);
            lengths.push_back(std::sqrt(found.back().second));
        }
        const auto at = lengths.begin() + static_cast<std::ptrdiff_t>(k_quantile * static_cast<double>(lengths.size() - 1));
        std::nth_element(lengths.begin(), at, lengths.end());
        spacing = *at;
    }

    /// Halves a box of nodes until it is one node or wholly out of reach.
    void ask(const Vector3i& from, const Vector3i& to, int hint) {
        const Vector3i size = to - from;
        if ((size.array() <= 0).any()) return;
        const Vector3d middle = grid.origin + grid.step * (from + to - Vector3i::Ones()).cast<double>() / 2;
        const double around = grid.step * (size - Vector3i::Ones()).cast<double>().norm() / 2;
        const auto found = tree.nearest_where(middle, reach() + around, hint, [](int) { return true; });
        if (found.triangle < 0) return; // out of reach
        if (size.maxCoeff() == 1) {
            distance[grid.node(from.x(), from.y(), from.z())] = static_cast<float>(std::min(found.distance, reach()));
            return;
        }
        int axis = 0;
        size.maxCoeff(&axis);
        Vector3i cut_to = to, cut_from = from;
        cut_to[axis] = cut_from[axis] = from[axis] + size[axis] / 2;
        ask(from, cut_to, found.triangle);
        ask(cut_from, to, found.triangle);
    }

    void ask_blocks() {
        const int all = blocks.prod();
        for (int k = 0; k < k_blocks_a_slice && block < all; ++k, ++block) {
            const Vector3i at(block % blocks.x(), block / blocks.x() % blocks.y(), block / (blocks.x() * blocks.y()));
            ask(k_block * at, (k_block * (at + Vector3i::Ones())).cwiseMin(grid.size), -1);
        }
        if (block == all) stage = Stage::radii;
    }

    /// Nodes farther than r that are reached from the border, over the edges of the tetrahedra.
    [[nodiscard]] std::vector<char> flooded(double r) const {
        std::vector<char> reached(distance.size(), 0);
        std::vector<int> open;
        const auto reach_node = [&](int i) {
            if (reached[i] || !(distance[i] > r)) return;
            reached[i] = 1;
            open.push_back(i);
        };
        for (int i = 0; i < grid.count(); ++i) {
            const Vector3i c = grid.cell(i);
            if ((c.array() == 0).any() || (c.array() == grid.size.array() - 1).any()) reach_node(i);
        }
        while (!open.empty()) {
            const Vector3i c = grid.cell(open.back());
            open.pop_back();
            for (int bits = 1; bits < 8; ++bits)
                for (const int sign : {-1, 1}) {
                    const Vector3i d = c + sign * Vector3i(bits & 1, bits >> 1 & 1, bits >> 2);
                    if ((d.array() >= 0).all() && (d.array() < grid.size.array()).all()) reach_node(grid.node(d.x(), d.y(), d.z()));
                }
        }
        return reached;
    }

    [[nodiscard]] Fill fill_of(const std::vector<char>& reached) const {
        Fill fill{0, 0};
        const int steps[] = {1, grid.size.x(), grid.size.x() * grid.size.y()};
        for (int i = 0; i < grid.count(); ++i) {
            fill.nodes += !reached[i];
            const Vector3i c = grid.cell(i);
            for (int k = 0; k < 3; ++k)
                if (c[k] + 1 < grid.size[k]) fill.faces += reached[i] != reached[i + steps[k]];
        }
        fill.faces /= 1.5; // a surface that lies anyhow has so many more faces of cells than its area
        return fill;
    }

    [[nodiscard]] Shell shell_at(double r) const {
        const std::vector<char> reached = flooded(r);
        std::vector<float> values(distance.size());
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(reached[i] ? distance[i] - r : -std::abs(distance[i] - r));
        return largest(iso_surface(grid, values));
    }

    /// First how much each radius fills, then from the last leak on the genus.
    void try_radius() {
        if (fills.size() < radii.size()) {
            fills.push_back(fill_of(flooded(radii[fills.size()])));
            if (fills.size() < radii.size()) return;
            for (std::size_t i = 0; i + 1 < radii.size(); ++i) {
                const double step = (radii[i + 1] - radii[i]) / grid.step, grown = fills[i + 1].nodes - fills[i].nodes;
                if (grown > k_jump * step * std::max(fills[i].faces, fills[i + 1].faces)) candidate = i + 1;
            }
            return;
        }
        Shell shell = shell_at(radii[candidate]);
        const int off = std::abs(shell.genus - options.genus);
        misses.emplace_back(off, static_cast<int>(candidate));
        if (off != 0 && !chosen) {
            if (++candidate < radii.size()) return;
            candidate = static_cast<std::size_t>(std::min_element(misses.begin(), misses.end())->second);
            chosen = true; // the nearest there is, in a slice of its own
            return;
        }
        out.radius = radii[candidate];
        out.genus_missed = off != 0;
        out.left_out = shell.left_out;
        const double area = triangle_areas(shell.mesh).sum();
        const double L = options.edge_length > 0 ? options.edge_length : std::sqrt(area / (0.866 * k_vertices));
        remesher.emplace(shell.mesh, std::vector<EdgeCurve>{}, std::vector<int>{}, RemeshOptions{L});
        stage = Stage::mesh;
    }

    /// Where the nearest places lie on different sides, the distance's slope is less than one.
    void find_webs() {
        const auto at = [&](const Vector3d& p) { return tree.nearest_where(p, std::numeric_limits<double>::infinity(), -1, [](int) { return true; }).distance; };
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
        case Stage::distances: ask_blocks(); break;
        case Stage::radii: try_radius(); break;
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
    if (options.cells < 20 || options.cells > 400) refuse("The number of cells is " + std::to_string(options.cells) + "; it must be between 20 and 400.");
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
    constexpr double asked = 0.4, tried = 0.6; // shares of the time as measured
    switch (s.stage) {
    case State::Stage::distances: return asked * s.block / s.blocks.prod();
    case State::Stage::radii: return asked + (tried - asked) * static_cast<double>(s.fills.size()) / static_cast<double>(s.radii.size() + 1);
    case State::Stage::mesh: return tried + (1 - tried) * s.remesher->fraction();
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

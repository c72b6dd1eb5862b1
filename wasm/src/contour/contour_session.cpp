#include "lissom/contour/contour_session.h"

#include "line_chains.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/half_edges.h"
#include "lissom/mesh/stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace lissom {

using Eigen::Vector3d;

namespace {

constexpr int k_slice = 60000;    // vertices, then triangles, of a slice of a view
constexpr double k_radius = 0.5;  // of the model in working space, whose diagonal is 1

/// Part [from, to] of a segment on which a function, linear from a to b, is above a limit.
void clip(double a, double b, double limit, double& from, double& to) {
    a -= limit;
    b -= limit;
    if (a <= 0 && b <= 0) {
        from = 1;
        to = 0;
    } else if (a <= 0) {
        from = std::max(from, a / (a - b));
    } else if (b <= 0) {
        to = std::min(to, a / (a - b));
    }
}

} // namespace

struct ContourSession::State {
    std::shared_ptr<const WorkingMesh> working;
    CurvatureField field;
    double seconds = 0;
    // Prepared with the first slice.
    std::vector<int> edge_of_corner;      ///< 3t + k: number of the edge from corner k to the next
    std::vector<int> offsets, around;     ///< triangles at each vertex
    // Of the view.
    LineView view;
    LineOptions options;
    int done_vertices = 0, done_triangles = 0;
    bool finished = true;
    Eigen::VectorXd facing, smooth_facing, radial; ///< n·v raw and diffused, S w·w
    Points w;
    std::vector<double> growth;           ///< D at vertices, where it was asked for
    std::vector<int> growth_stamp;
    int stamp = 0;
    std::vector<LinePiece> contours, suggestives;
    std::vector<ContourLine> lines;

    State(std::shared_ptr<const WorkingMesh> model, int sweeps) : working(std::move(model)), field(working->mesh, sweeps) {}

    [[nodiscard]] const TriangleMesh& mesh() const { return working->mesh; }

    void number_edges() {
        edge_of_corner.assign(3 * static_cast<std::size_t>(mesh().triangle_count()), -1);
        const auto sides = half_edges(mesh());
        int edge = 0;
        for_each_edge(sides, [&](auto first, auto last) {
            for (auto side = first; side != last; ++side) edge_of_corner[3 * side->triangle + side->corner] = edge;
            ++edge;
        });
        const int n = mesh().vertex_count();
        offsets.assign(static_cast<std::size_t>(n) + 1, 0);
        for (const int v : mesh().triangles.reshaped()) ++offsets[v + 1];
        for (int v = 0; v < n; ++v) offsets[v + 1] += offsets[v];
        around.resize(static_cast<std::size_t>(offsets[n]));
        std::vector<int> next(offsets.begin(), offsets.end() - 1);
        for (int t = 0; t < mesh().triangle_count(); ++t)
            for (int k = 0; k < 3; ++k) around[next[mesh().triangles(t, k)]++] = t;
    }

    void start(const LineView& from, const LineOptions& wanted) {
        const Vector3d at = from.eye;
        if (!at.allFinite() || (!from.perspective && at.norm() == 0)) throw InvalidInput("bad-view", "The view has no direction. Reset the view and try again.");
        options = wanted;
        view = from;
        view.eye = from.perspective ? working->to_working(at) : at.normalized();
        done_vertices = done_triangles = 0;
        finished = false;
        const int n = mesh().vertex_count();
        facing.resize(n);
        smooth_facing.resize(n);
        radial.resize(n);
        w.resize(n, 3);
        growth.resize(static_cast<std::size_t>(n));
        growth_stamp.resize(static_cast<std::size_t>(n), 0);
        ++stamp;
        contours.clear();
        suggestives.clear();
        lines.clear();
    }

    void see_vertices(int first, int last) {
        for (int i = first; i < last; ++i) {
            const Vector3d v = view.perspective ? (view.eye - mesh().points.row(i).transpose()).normalized() : view.eye;
            facing[i] = field.normals().row(i).dot(v);
            if (!options.suggestive) continue;
            const Vector3d n = field.smooth_normals().row(i);
            smooth_facing[i] = n.dot(v);
            const Vector3d along = v - smooth_facing[i] * n;
            w.row(i) = along.transpose();
            radial[i] = along.dot(field.tensors()[i] * along);
        }
    }

    /// ∇(S w·w) of a triangle, on which it is linear.
    [[nodiscard]] Vector3d gradient(int t) const {
        const int i = mesh().triangles(t, 0), j = mesh().triangles(t, 1), k = mesh().triangles(t, 2);
        const Vector3d a = mesh().points.row(i), b = mesh().points.row(j), c = mesh().points.row(k);
        const Vector3d n = (b - a).cross(c - a);
        const double squared = n.squaredNorm();
        if (squared <= 0) return Vector3d::Zero();
        return n.cross(radial[i] * (c - b) + radial[j] * (a - c) + radial[k] * (b - a)) / squared;
    }

    /// D R² at a vertex: the gradient averaged over its triangles by area, along w.
    double growth_at(int v) {
        if (growth_stamp[v] == stamp) return growth[v];
        growth_stamp[v] = stamp;
        Vector3d sum = Vector3d::Zero();
        double total = 0;
        for (int i = offsets[v]; i < offsets[v + 1]; ++i) {
            const int t = around[i];
            const Vector3d a = mesh().points.row(mesh().triangles(t, 0)), b = mesh().points.row(mesh().triangles(t, 1)), c = mesh().points.row(mesh().triangles(t, 2));
            const double area = (b - a).cross(c - a).norm();
            sum += area * gradient(t);
            total += area;
        }
        const Vector3d along = w.row(v);
        const double length = along.norm();
        return growth[v] = total > 0 && length > 0 ? k_radius * k_radius * sum.dot(along) / (total * length * length * length) : 0;
    }

    /// Where a function changes its sign on a triangle: two edges and the shares along them.
    struct Crossing {
        std::array<int, 2> corner;
        std::array<double, 2> share;
    };
    template <class Value>
    [[nodiscard]] static bool crosses(const Value& value, Crossing& at) {
        int found = 0;
        for (int k = 0; k < 3; ++k) {
            const double a = value[k], b = value[(k + 1) % 3];
            if ((a > 0) == (b > 0) || found == 2) continue;
            at.corner[found] = k;
            at.share[found++] = a / (a - b);
        }
        return found == 2;
    }

    void see_triangles(int first, int last) {
        for (int t = first; t < last; ++t) {
            const auto corners = mesh().triangles.row(t);
            const auto place = [&](const Crossing& at, int end) -> Vector3d {
                const int k = at.corner[end];
                const double u = at.share[end];
                return (1 - u) * mesh().points.row(corners[k]).transpose() + u * mesh().points.row(corners[(k + 1) % 3]).transpose();
            };
            const auto weights = [](const Crossing& at, int end) -> Vector3d {
                return (1 - at.share[end]) * Vector3d::Unit(at.corner[end]) + at.share[end] * Vector3d::Unit((at.corner[end] + 1) % 3);
            };
            Crossing at;
            if (crosses(Vector3d(facing[corners[0]], facing[corners[1]], facing[corners[2]]), at))
                contours.push_back({t, {edge_of_corner[3 * t + at.corner[0]], edge_of_corner[3 * t + at.corner[1]]}, {place(at, 0), place(at, 1)}, {weights(at, 0), weights(at, 1)}, {}});
            if (!options.suggestive) continue;
            const Vector3d f(radial[corners[0]], radial[corners[1]], radial[corners[2]]), g(smooth_facing[corners[0]], smooth_facing[corners[1]], smooth_facing[corners[2]]);
            if (g.maxCoeff() <= 0 || !crosses(f, at)) continue;
            Vector3d d, s;
            for (int k = 0; k < 3; ++k) {
                d[k] = growth_at(corners[k]);
                s[k] = 1 - g[k] * g[k];
            }
            const auto between = [&](const Vector3d& x, int end) { return (1 - at.share[end]) * x[at.corner[end]] + at.share[end] * x[(at.corner[end] + 1) % 3]; };
            double from = 0, to = 1;
            clip(between(d, 0), between(d, 1), 0, from, to);
            clip(between(g, 0), between(g, 1), 0, from, to);
            clip(between(s, 0), between(s, 1), options.steepness, from, to);
            if (from >= to) continue;
            const Vector3d a = place(at, 0), b = place(at, 1);
            const Vector3d wa = weights(at, 0), wb = weights(at, 1);
            const double da = between(d, 0), db = between(d, 1);
            suggestives.push_back({t,
                                   {from > 0 ? -1 : edge_of_corner[3 * t + at.corner[0]], to < 1 ? -1 : edge_of_corner[3 * t + at.corner[1]]},
                                   {a + from * (b - a), a + to * (b - a)},
                                   {wa + from * (wb - wa), wa + to * (wb - wa)},
                                   {da + from * (db - da), da + to * (db - da)}});
        }
    }

    /// The third quartile of D along all suggestive pieces, by length.
    [[nodiscard]] double usual_growth() const {
        std::vector<std::pair<double, double>> by_value;
        double total = 0;
        for (const LinePiece& piece : suggestives) {
            by_value.emplace_back((piece.values[0] + piece.values[1]) / 2, (piece.ends[1] - piece.ends[0]).norm());
            total += by_value.back().second;
        }
        std::sort(by_value.begin(), by_value.end());
        for (double sum = 0; const auto& [value, length] : by_value)
            if ((sum += length) >= 0.75 * total) return value;
        return 0;
    }

    void add_lines(const std::vector<LinePiece>& pieces, ContourLine::Kind kind, double least) {
        const std::size_t before = lines.size();
        for (const LineChain& whole : chained(pieces)) {
            if (whole.values.empty() || *std::max_element(whole.values.begin(), whole.values.end()) < least) continue;
            if (whole.length() < options.shortest * k_radius) continue;
            const double shortest = options.shortest * k_radius;
            std::vector<LineChain> parts = split_at_corners(whole, options.corner, options.bend * k_radius, 0);
            std::erase_if(parts, [&](const LineChain& part) { return part.length() < shortest; });
            // An outline has no gaps: where some of it is long enough, all of it stays, in fewer and longer parts.
            if (kind == ContourLine::Kind::contour && !parts.empty()) parts = split_at_corners(whole, options.corner, options.bend * k_radius, 2 * shortest);
            for (const LineChain& chain : parts) {
                const double length = chain.length();
                ContourLine line{.kind = kind, .closed = chain.closed, .points = {}, .places = {}, .length = length * working->scale, .strength = 0};
                for (const double value : chain.values) line.strength += value / static_cast<double>(chain.values.size());
                for (const Vector3d& p : chain.points) line.points.push_back(working->to_source(p));
                for (std::size_t i = 0; i < chain.triangles.size(); ++i) {
                    SurfacePlace place{.corners = {}, .weights = chain.weights[i]};
                    for (int k = 0; k < 3; ++k) place.corners[k] = working->source_of_working[mesh().triangles(chain.triangles[i], k)];
                    line.places.push_back(place);
                }
                lines.push_back(std::move(line));
            }
        }
        std::stable_sort(lines.begin() + static_cast<std::ptrdiff_t>(before), lines.end(), [](const ContourLine& a, const ContourLine& b) { return a.length > b.length; });
    }

    bool look_step() {
        if (finished) return false;
        if (done_vertices < mesh().vertex_count()) {
            const int last = std::min(done_vertices + k_slice, mesh().vertex_count());
            see_vertices(done_vertices, last);
            done_vertices = last;
        } else if (done_triangles < mesh().triangle_count()) {
            const int last = std::min(done_triangles + k_slice, mesh().triangle_count());
            see_triangles(done_triangles, last);
            done_triangles = last;
        }
        if (done_vertices == mesh().vertex_count() && done_triangles == mesh().triangle_count()) {
            add_lines(contours, ContourLine::Kind::contour, 0);
            if (options.suggestive) add_lines(suggestives, ContourLine::Kind::suggestive, options.strength * usual_growth());
            finished = true;
        }
        return !finished;
    }
};

ContourSession::ContourSession(std::shared_ptr<const WorkingMesh> working, int sweeps) {
    if (sweeps < 0 || sweeps > 200) throw InvalidInput("bad-option", "Lines are smoothed by 0 to 200 sweeps, not by " + std::to_string(sweeps) + ".");
    state_ = std::make_unique<State>(std::move(working), sweeps);
}
ContourSession::~ContourSession() = default;
ContourSession::ContourSession(ContourSession&&) noexcept = default;
ContourSession& ContourSession::operator=(ContourSession&&) noexcept = default;

bool ContourSession::step() {
    Stopwatch clock;
    if (state_->edge_of_corner.empty()) state_->number_edges();
    const bool more = state_->field.step();
    state_->seconds += clock.lap();
    return more;
}

double ContourSession::fraction() const { return state_->field.fraction(); }

void ContourSession::look(const LineView& view, const LineOptions& options) {
    while (step()) { // of a session that is prepared, nothing
    }
    state_->start(view, options);
}
bool ContourSession::look_step() { return state_->look_step(); }
double ContourSession::look_fraction() const {
    return 0.5 * (static_cast<double>(state_->done_vertices) / std::max(1, state_->mesh().vertex_count()) + static_cast<double>(state_->done_triangles) / std::max(1, state_->mesh().triangle_count()));
}
const std::vector<ContourLine>& ContourSession::lines() const { return state_->lines; }

const std::vector<ContourLine>& ContourSession::lines(const LineView& view, const LineOptions& options) {
    look(view, options);
    while (look_step()) {
    }
    return lines();
}

double ContourSession::seconds() const { return state_->seconds; }
const CurvatureField& ContourSession::curvature() const { return state_->field; }

} // namespace lissom

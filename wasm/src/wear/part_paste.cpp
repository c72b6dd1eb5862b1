#include "lissom/wear/part_paste.h"

#include "lissom/mesh/errors.h"
#include "lissom/mesh/operators.h"
#include "lissom/mesh/similarity.h"
#include "lissom/mesh/smooth.h"
#include "lissom/mesh/surface_paths.h"
#include "lissom/mesh/topology.h"
#include "lissom/solve/sparse_cholesky.h"
#include "lissom/wear/surface_turns.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::RowVector3d;
using Eigen::Vector3d;
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

namespace {

/// ℓ of the low-pass, in shares of √area of the piece: a nose is gone but for a hundredth of its height.
constexpr double k_wave = 1;
/// Edges that a transition needs to turn from one shape into the other.
constexpr double k_room = 2;
/// A feather that nobody asked for, in radii of the part: measured on noses, docs/wear.md.
constexpr double k_feather = 0.7;

} // namespace

struct PartPaste::State {
    State(const TriangleMesh& given, const PartSpec& part) : shape(given), how(part.how), feather(part.feather) {}

    const TriangleMesh& shape;
    PartHow how;
    double feather;
    std::vector<double> share;  ///< per vertex: 1 in the part, falling to 0 across the feather
    std::vector<int> moved;     ///< vertices with a share
    std::vector<int> piece;     ///< per vertex; −1: stays
    std::vector<std::vector<int>> rings; ///< of each piece the vertices around it
    std::vector<int> carried;   ///< moved vertices that the similarity alone places: the part within a feather
    std::vector<int> solved;    ///< the other moved ones
    std::vector<int> unknown;   ///< per vertex its place in `solved`, or −1
    // Rows of L / √a that reach a solved vertex: all columns, and those of solved vertices alone.
    std::vector<int> rows;
    RowMatrix all, free;
    Eigen::VectorXd areas; ///< of solved vertices; for the low-pass, with its weight taken out
    std::optional<SparseCholesky> factor;
    Points smoothed; ///< low-pass: of the part's shape, where it moves

    void find_pieces(const VertexRings& around);
    void assemble();
    [[nodiscard]] Points low_pass(const Points& points) const;
    [[nodiscard]] Similarity fitted(int k, const Points& to) const;
};

namespace {

[[noreturn]] void refuse_whole(bool feathered) {
    throw InvalidInput("whole-part", std::string("A part takes in all of a piece of the surface") + (feathered ? ", with its feather" : "") +
                                         ": nothing is left around it to join. Leave some of it out, or give the model its weight instead.");
}

} // namespace

/// Pieces of what moves, each with the ring of vertices that stay around it.
void PartPaste::State::find_pieces(const VertexRings& around) {
    piece.assign(share.size(), -1);
    std::vector<int> seen(share.size(), -1), open;
    for (const int first : moved) {
        if (piece[first] >= 0) continue;
        const int number = static_cast<int>(rings.size());
        rings.emplace_back();
        piece[first] = number;
        open.assign(1, first);
        while (!open.empty()) {
            const int v = open.back();
            open.pop_back();
            for (const int j : around[v])
                if (!(share[j] > 0)) {
                    if (seen[j] != number) rings.back().push_back(j), seen[j] = number;
                } else if (piece[j] < 0) {
                    piece[j] = number;
                    open.push_back(j);
                }
        }
        if (rings.back().empty()) refuse_whole(feather > 0);
        std::sort(rings.back().begin(), rings.back().end());
    }
}

void PartPaste::State::assemble() {
    const SparseMatrix L = cotangent_laplacian(shape); // symmetric: its columns are its rows
    const Eigen::VectorXd a = vertex_areas(shape);
    std::vector<char> used(unknown.size(), 0);
    for (const int v : solved)
        for (SparseMatrix::InnerIterator entry(L, v); entry; ++entry) used[static_cast<std::size_t>(entry.row())] = 1;
    std::vector<Eigen::Triplet<double>> whole, inner;
    for (int v = 0; v < static_cast<int>(used.size()); ++v) {
        if (!used[v]) continue;
        const int row = static_cast<int>(rows.size());
        rows.push_back(v);
        for (SparseMatrix::InnerIterator entry(L, v); entry; ++entry) {
            const int column = static_cast<int>(entry.row());
            const double value = entry.value() / std::sqrt(a[v]);
            whole.emplace_back(row, column, value);
            if (unknown[column] >= 0) inner.emplace_back(row, unknown[column], value);
        }
    }
    all.resize(std::ssize(rows), shape.vertex_count());
    free.resize(std::ssize(rows), std::ssize(solved));
    all.setFromTriplets(whole.begin(), whole.end());
    free.setFromTriplets(inner.begin(), inner.end());
    SparseMatrix A = free.transpose() * free;
    if (how == PartHow::low_pass) {
        areas.resize(std::ssize(solved));
        double sum = 0;
        for (std::size_t k = 0; k < solved.size(); ++k) sum += areas[static_cast<Eigen::Index>(k)] = a[solved[k]];
        areas /= std::pow(k_wave * k_wave * sum, 2); // by ℓ⁴, so that both methods have the same matrix but for its diagonal
        A.diagonal() += areas;
    }
    Points places(std::ssize(solved), 3);
    for (std::size_t k = 0; k < solved.size(); ++k) places.row(static_cast<Eigen::Index>(k)) = shape.points.row(solved[k]);
    factor.emplace(A, &places);
    factor->begin(A);
}

/// Where solved vertices are once the piece is smoothed away, the vertices around it as they are.
Points PartPaste::State::low_pass(const Points& points) const {
    Points around = points;
    for (const int v : solved) around.row(v).setZero();
    Columns sides = -(free.transpose() * (all * around));
    for (std::size_t k = 0; k < solved.size(); ++k) sides.row(static_cast<Eigen::Index>(k)) += areas[static_cast<Eigen::Index>(k)] * points.row(solved[k]);
    factor->solve(sides);
    return sides;
}

/// The similarity that lays the ring around a piece of the part's shape on that of another.
Similarity PartPaste::State::fitted(int k, const Points& to) const {
    const std::vector<int>& ring = rings[k];
    Points here(std::ssize(ring), 3), there(std::ssize(ring), 3);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        here.row(static_cast<Eigen::Index>(i)) = shape.points.row(ring[i]);
        there.row(static_cast<Eigen::Index>(i)) = to.row(ring[i]);
    }
    return fit_similarity(here, there);
}

PartPaste::PartPaste(const TriangleMesh& shape, const PartSpec& part)
    : state_(new State(shape, part)) {
    State& s = *state_;
    const int n = shape.vertex_count();
    s.share.assign(static_cast<std::size_t>(n), 0);
    if (part.vertices.empty()) throw InvalidInput("empty-part", "A part has no vertices. Paint some, or take it away.");
    for (const int v : part.vertices)
        if (v < 0 || v >= n)
            throw InvalidInput("vertex-out-of-range", "A part names vertex " + std::to_string(v) + "; the skins have " + std::to_string(n) + ", numbered from 0.");
    if (!std::isfinite(part.feather)) throw InvalidInput("bad-option", "The feather of a part is no length.");
    for (const int v : part.vertices) s.share[v] = 1;
    if (part.feather < 0) {
        const Eigen::VectorXd areas = vertex_areas(shape);
        double area = 0;
        for (int v = 0; v < n; ++v)
            if (s.share[v] > 0) area += areas[v];
        s.feather = k_feather * std::sqrt(area / std::numbers::pi);
    }
    const VertexRings around = vertex_rings(shape);
    if (s.feather > 0) {
        const ShortestPaths paths = shortest_paths(edge_graph(shape), part.vertices, s.feather);
        for (int v = 0; v < n; ++v)
            if (paths.distance[v] < s.feather) s.share[v] = smooth(1 - paths.distance[v] / s.feather);
    }
    for (int v = 0; v < n; ++v)
        if (s.share[v] > 0 && !around[v].empty()) s.moved.push_back(v);
    if (s.moved.empty()) throw InvalidInput("empty-part", "No triangle uses a vertex of a part. Paint some, or take it away.");
    // A feather of few edges has no room for a transition of its own: then all of the part gives.
    const bool has_room = part.how == PartHow::paste && s.feather > k_room * mean_edge_length(shape);
    s.unknown.assign(static_cast<std::size_t>(n), -1);
    for (const int v : s.moved)
        if (has_room && s.share[v] >= 1)
            s.carried.push_back(v);
        else
            s.unknown[v] = static_cast<int>(s.solved.size()), s.solved.push_back(v);
    s.find_pieces(around);
}

PartPaste::~PartPaste() = default;
PartPaste::PartPaste(PartPaste&&) noexcept = default;

bool PartPaste::step() {
    State& s = *state_;
    if (!s.factor) return s.assemble(), true;
    if (s.factor->fraction() < 1 && s.factor->step()) return true;
    if (s.how == PartHow::low_pass && s.smoothed.rows() == 0) s.smoothed = s.low_pass(s.shape.points);
    return false;
}

void PartPaste::apply(Points& shape) const {
    const State& s = *state_;
    std::vector<Similarity> maps;
    for (int k = 0; k < std::ssize(s.rings); ++k) maps.push_back(s.fitted(k, shape));
    if (s.how == PartHow::low_pass) {
        const Points smoothed = s.low_pass(shape);
        TriangleMesh before = s.shape;
        Points after = shape;
        for (std::size_t k = 0; k < s.solved.size(); ++k) {
            before.points.row(s.solved[k]) = s.smoothed.row(static_cast<Eigen::Index>(k));
            after.row(s.solved[k]) = smoothed.row(static_cast<Eigen::Index>(k));
        }
        const std::vector<Matrix3d> turns = surface_turns(before, after);
        for (const int v : s.solved) {
            const RowVector3d own = shape.row(v) - after.row(v);
            const Vector3d detail = maps[s.piece[v]].scale * (turns[v] * (s.shape.points.row(v) - before.points.row(v)).transpose());
            shape.row(v) = after.row(v) + s.share[v] * detail.transpose() + (1 - s.share[v]) * own;
        }
        return;
    }
    // What rows ask for: the part's coordinates, in the feather mixed with those of the shape. Rows of vertices that stay ask for the part's where there is no feather.
    const Points part = s.all * s.shape.points, own = s.all * shape;
    for (const int v : s.carried) shape.row(v) = (maps[s.piece[v]].affine() * s.shape.points.row(v).transpose()).transpose();
    Points around = shape;
    for (const int v : s.solved) around.row(v).setZero();
    Points sides = -(s.all * around);
    for (std::size_t i = 0; i < s.rows.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const int v = s.rows[i];
        // A vertex that stays beside several pieces goes with the first.
        int k = s.piece[v];
        for (RowMatrix::InnerIterator entry(s.free, row); entry && k < 0; ++entry) k = s.piece[s.solved[static_cast<std::size_t>(entry.col())]];
        const double t = s.share[v] > 0 || s.feather > 0 ? s.share[v] : 1;
        const Vector3d turned = maps[k].scale * (maps[k].rotation * part.row(row).transpose());
        sides.row(row) += t * turned.transpose() + (1 - t) * own.row(row);
    }
    Columns found = s.free.transpose() * sides;
    s.factor->solve(found);
    for (std::size_t k = 0; k < s.solved.size(); ++k) shape.row(s.solved[k]) = found.row(static_cast<Eigen::Index>(k));
}

const std::vector<int>& PartPaste::moved() const { return state_->moved; }

} // namespace lissom

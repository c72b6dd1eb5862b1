#include "lissom/deform/ring_gradients.h"

#include "lissom/mesh/operators.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace lissom {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double k_degenerate = 2e5;     // cond(V Vᵀ) of a degenerate vertex, Fu 2.4.3
constexpr double k_unusable = 1e10;      // beyond this the inverse of V Vᵀ is noise
constexpr double k_displacement = 0.2;   // s_disp of Eq 2.9

/// V Vᵀ of a ring and what can be told from it.
struct Ring {
    Matrix3d gram;
    Vector3d thin;          ///< direction in which it extends least
    double condition = 0;
    double mean_length = 0; ///< from the vertex to its neighbours
};

class Builder {
public:
    Builder(const TriangleMesh& mesh, const VertexRings& rings, const GradientNeeds& needs)
        : mesh_(mesh), rings_(rings), needs_(needs), normals_(vertex_normals(mesh)), boundary_(boundary_vertices(mesh)),
          rest_(mesh.points), is_displaced_(needs.wanted.size(), 0), wide_(needs.wanted.size(), 0) {}

    RingGradients build() {
        for (const int i : in_order()) make_regular(i);
        return coefficients();
    }

private:
    /// Vertices that want a gradient: those with most neighbours first, for one displacement cures them all; then
    /// by position, on a grid coarse enough to survive a change of units.
    [[nodiscard]] std::vector<int> in_order() const {
        std::vector<int> order;
        for (int i = 0; i < static_cast<int>(needs_.wanted.size()); ++i)
            if (needs_.wanted[i]) order.push_back(i);
        const double size = diagonal(mesh_.points);
        const double cells = size > 0 ? 1e5 / size : 0;
        const Vector3d low = mesh_.points.rows() > 0 ? Vector3d(mesh_.points.colwise().minCoeff()) : Vector3d::Zero();
        std::vector<std::array<int, 3>> cell(needs_.wanted.size());
        for (const int i : order)
            for (int d = 0; d < 3; ++d) cell[i][d] = static_cast<int>((mesh_.points(i, d) - low[d]) * cells + 0.382);
        std::sort(order.begin(), order.end(), [&](int a, int b) {
            if (rings_[a].size() != rings_[b].size()) return rings_[a].size() > rings_[b].size();
            return cell[a] != cell[b] ? cell[a] < cell[b] : a < b;
        });
        return order;
    }

    [[nodiscard]] std::vector<int> support(int i) const {
        const auto ring = rings_[i];
        std::vector<int> result(ring.begin(), ring.end());
        if (!wide_[i]) return result;
        for (const int j : ring)
            for (const int k : rings_[j])
                if (k != i) result.push_back(k);
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    [[nodiscard]] Vector3d centre(const std::vector<int>& ring) const {
        Vector3d sum = Vector3d::Zero();
        for (const int j : ring) sum += rest_.row(j).transpose();
        return sum / static_cast<double>(ring.size());
    }

    [[nodiscard]] Ring look(int i) const {
        Ring result;
        const std::vector<int> ring = support(i);
        const Vector3d c = centre(ring), v = rest_.row(i).transpose();
        result.gram = (v - c) * (v - c).transpose();
        for (const int j : ring) {
            const Vector3d e = rest_.row(j).transpose() - c;
            result.gram += e * e.transpose();
            result.mean_length += (rest_.row(j).transpose() - v).norm() / static_cast<double>(ring.size());
        }
        const double size = result.gram.trace();
        if (!(size > 0)) {
            result.condition = std::numeric_limits<double>::infinity();
            result.thin = Vector3d::UnitX();
            return result;
        }
        const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(Matrix3d(result.gram / size));
        result.thin = eigen.eigenvectors().col(0);
        result.condition = eigen.eigenvalues()[2] / std::max(eigen.eigenvalues()[0], 1e-300);
        return result;
    }

    /// Eq 2.9. The direction is the thin one of ring i, which is the normal where the ring is a plane, to
    /// the normal's side; it exists where no triangle has area.
    void displace(int i, const Vector3d& thin, double mean_length) {
        const double side = normals_.row(i).dot(thin);
        double sign = side < 0 ? -1 : 1;
        if (side == 0) { // no normal: make the choice independent of the eigenvector's arbitrary sign
            int largest = 0;
            thin.cwiseAbs().maxCoeff(&largest);
            sign = thin[largest] < 0 ? -1 : 1;
        }
        rest_.row(i) += (sign * k_displacement * mean_length * thin).transpose();
        is_displaced_[i] = 1;
    }
    void put_back(int i) {
        rest_.row(i) = mesh_.points.row(i);
        is_displaced_[i] = 0;
    }

    [[nodiscard]] bool may_displace(int i) const { return needs_.movable[i] && !is_displaced_[i]; }

    /// Keeps the displacement of j if it cures i. @returns whether it did
    bool try_displacing(int j, int i, const Ring& ring) {
        if (!may_displace(j)) return false;
        displace(j, ring.thin, ring.mean_length);
        if (look(i).condition <= k_degenerate) return true;
        put_back(j);
        return false;
    }

    void make_regular(int i) {
        for (const char wide : {0, 1}) {
            wide_[i] = wide;
            const Ring ring = look(i);
            if (ring.condition <= k_degenerate || try_displacing(i, i, ring)) return;
            for (const bool inner : {true, false}) // Fu 2.4.3: a neighbour that is not on the boundary first
                for (const int j : rings_[i])
                    if (boundary_[j] != inner && try_displacing(j, i, ring)) return;
        }
        // Long thin rings stay above the threshold whatever is displaced; they are still better than none.
        const Ring ring = look(i);
        if (ring.condition <= k_unusable || !may_displace(i)) return;
        displace(i, ring.thin, ring.mean_length);
        if (look(i).condition > k_unusable) put_back(i);
    }

    void append_own(int i, const Matrix3d& gram, RingGradients& out) {
        const std::vector<int> ring = support(i);
        const Vector3d c = centre(ring);
        const Matrix3d inverse = gram.inverse();
        const Vector3d own = inverse * (rest_.row(i).transpose() - c);
        entries_.emplace_back(i, own);
        for (const int j : ring) // the ring's centre moves with its vertices, hence the second term
            entries_.emplace_back(j, inverse * (rest_.row(j).transpose() - c) - own / static_cast<double>(ring.size()));
        out.offsets.push_back(static_cast<int>(entries_.size()));
    }

    RingGradients coefficients() {
        RingGradients out;
        const int n = mesh_.vertex_count();
        std::vector<char> usable(static_cast<std::size_t>(n), 0);
        std::vector<Matrix3d> gram(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) {
            if (!needs_.wanted[i]) continue;
            Ring ring = look(i);
            if (ring.condition > k_degenerate && !wide_[i]) { // spoilt by a neighbour displaced later
                wide_[i] = 1;
                const Ring wide = look(i);
                if (wide.condition < ring.condition) ring = wide;
                else wide_[i] = 0;
            }
            gram[i] = ring.gram;
            usable[i] = ring.condition <= k_unusable;
        }
        const std::vector<int> lender = lenders(usable);
        out.offsets.push_back(0);
        for (int i = 0; i < n; ++i) {
            const int from = needs_.wanted[i] ? lender[i] : -1;
            if (from < 0) {
                out.offsets.push_back(static_cast<int>(entries_.size()));
                continue;
            }
            out.borrowed += from != i;
            append_own(from, gram[from], out);
        }
        out.coefficients.resize(static_cast<Eigen::Index>(entries_.size()), 3);
        for (std::size_t e = 0; e < entries_.size(); ++e) {
            out.vertices.push_back(entries_[e].first);
            out.coefficients.row(static_cast<Eigen::Index>(e)) = entries_[e].second.transpose();
        }
        for (int i = 0; i < n; ++i)
            if (is_displaced_[i]) out.displaced.push_back(i);
        out.rest = std::move(rest_);
        return out;
    }

    /// For each wanted vertex the nearest one (in edges) with a usable ring, itself where it can.
    [[nodiscard]] std::vector<int> lenders(const std::vector<char>& usable) const {
        std::vector<int> lender(usable.size(), -1), front, next;
        for (int i = 0; i < static_cast<int>(usable.size()); ++i)
            if (usable[i]) {
                lender[i] = i;
                front.push_back(i);
            }
        while (!front.empty()) {
            next.clear();
            for (const int i : front)
                for (const int j : rings_[i])
                    if (needs_.wanted[j] && lender[j] < 0) {
                        lender[j] = lender[i];
                        next.push_back(j);
                    }
            front.swap(next);
        }
        return lender;
    }

    const TriangleMesh& mesh_;
    const VertexRings& rings_;
    const GradientNeeds& needs_;
    Points normals_;
    std::vector<bool> boundary_;
    Points rest_;
    std::vector<char> is_displaced_, wide_;
    std::vector<std::pair<int, Vector3d>> entries_;
};

} // namespace

RingGradients ring_gradients(const TriangleMesh& mesh, const VertexRings& rings, const GradientNeeds& needs) {
    return Builder(mesh, rings, needs).build();
}

} // namespace lissom

#include "lissom/isoline/reduced_energy.h"

#include <utility>

namespace lissom {
namespace {

/// Sums over vertices, in all controls, before handles are substituted.
class Assembly {
public:
    Assembly(const TriangleMesh& mesh, const SparseMatrix& L, const Eigen::VectorXd& areas, const Columns& fields, const ControlSets& sets,
             const DetailCarriers& carriers)
        : A(Eigen::MatrixXd::Zero(4 * sets.controls(), 4 * sets.controls())), C(Eigen::MatrixXd::Zero(4 * sets.controls(), 3 * carriers.count)),
          mesh_(mesh), L_(L), areas_(areas), fields_(fields), sets_(sets), carriers_(carriers), place_(static_cast<std::size_t>(sets.controls()), -1) {
        const auto n = static_cast<std::size_t>(mesh.vertex_count());
        offsets_.reserve(n + 1);
        offsets_.push_back(0);
        std::vector<ControlSets::Entry> entries; // kept for all vertices: six numbers each, and each is read by its whole ring
        for (std::size_t v = 0; v < n; ++v) {
            sets.entries_at({fields.data() + static_cast<Eigen::Index>(v) * fields.cols(), static_cast<std::size_t>(fields.cols())}, entries);
            if ((fields.row(static_cast<Eigen::Index>(v)).array() == 0).all()) entries.clear();
            entries_.insert(entries_.end(), entries.begin(), entries.end());
            offsets_.push_back(entries_.size());
        }
    }

    void run() {
        for (int k = 0; k < mesh_.vertex_count(); ++k)
            if (offsets_[k + 1] > offsets_[k]) add_vertex(k);
        A = A.selfadjointView<Eigen::Lower>();
    }

    Eigen::MatrixXd A, C;

private:
    void add_vertex(int k) {
        // p_k = Σ_j L_kj w_j: row k of L W; and δ_k = Σ_j L_kj x_j.
        touched_.clear();
        row_.clear();
        Eigen::Vector3d delta = Eigen::Vector3d::Zero();
        for (SparseMatrix::InnerIterator e(L_, k); e; ++e) { // L is symmetric: its column is its row
            const auto j = static_cast<std::size_t>(e.row());
            const Eigen::Vector3d x = mesh_.points.row(e.row());
            delta += e.value() * x;
            const Eigen::Vector4d homogeneous(x[0], x[1], x[2], 1);
            for (std::size_t s = offsets_[j]; s < offsets_[j + 1]; ++s) {
                int& at = place_[entries_[s].control];
                if (at < 0) {
                    at = static_cast<int>(touched_.size());
                    touched_.push_back(entries_[s].control);
                    row_.emplace_back(Eigen::Vector4d::Zero());
                }
                row_[at] += (e.value() * entries_[s].weight) * homogeneous;
            }
        }
        const double weight = 1 / areas_[k];
        for (std::size_t a = 0; a < touched_.size(); ++a) {
            place_[touched_[a]] = -1;
            const Eigen::Vector4d scaled = weight * row_[a];
            for (std::size_t b = 0; b < touched_.size(); ++b)
                if (touched_[b] <= touched_[a]) A.block<4, 4>(4 * touched_[a], 4 * touched_[b]).noalias() += scaled * row_[b].transpose();
            for (int s = carriers_.offsets[k]; s < carriers_.offsets[k + 1]; ++s)
                C.block<4, 3>(4 * touched_[a], 3 * carriers_.shares[s].carrier).noalias() += (carriers_.shares[s].weight * scaled) * delta.transpose();
        }
    }

    const TriangleMesh& mesh_;
    const SparseMatrix& L_;
    const Eigen::VectorXd& areas_;
    const Columns& fields_;
    const ControlSets& sets_;
    const DetailCarriers& carriers_;
    std::vector<std::size_t> offsets_;
    std::vector<ControlSets::Entry> entries_;
    std::vector<int> place_, touched_; ///< where a control stands in row_
    std::vector<Eigen::Vector4d> row_;
};

/// d = P u + Q h (see HandleEnd).
void substitute(const ControlSets& sets, std::span<const HandleEnd> ends, ReducedEnergy& energy) {
    std::vector<int> field_of_end(static_cast<std::size_t>(sets.controls()), -1);
    for (int f = 0; f < sets.fields; ++f) field_of_end[sets.end_control(f)] = f;
    energy.handle_rows.push_back(0);
    for (const HandleEnd& end : ends) energy.handle_rows.push_back(energy.handle_rows.back() + end.rows());
    std::vector<Eigen::Triplet<double>> p, q;
    int u = 0;
    for (int c = 0; c < sets.controls(); ++c) {
        const HandleEnd end = field_of_end[c] < 0 ? HandleEnd{HandleEnd::Kind::open} : ends[static_cast<std::size_t>(field_of_end[c])];
        const int h = field_of_end[c] < 0 ? 0 : energy.handle_rows[field_of_end[c]];
        if (end.kind == HandleEnd::Kind::region) {
            for (int r = 0; r < 4; ++r) q.emplace_back(4 * c + r, h + r, 1.0);
        } else if (end.kind == HandleEnd::Kind::point) { // t = h − D p: the point goes where h says whatever D is
            for (int r = 0; r < 3; ++r) {
                p.emplace_back(4 * c + r, u, 1.0);
                p.emplace_back(4 * c + 3, u++, -end.at[r]);
            }
            q.emplace_back(4 * c + 3, h, 1.0);
        } else {
            for (int r = 0; r < 4; ++r) p.emplace_back(4 * c + r, u++, 1.0);
        }
    }
    energy.P.resize(4 * sets.controls(), u);
    energy.P.setFromTriplets(p.begin(), p.end());
    energy.Q.resize(4 * sets.controls(), energy.handle_rows.back());
    energy.Q.setFromTriplets(q.begin(), q.end());
}

} // namespace

ReducedEnergy reduced_energy(const TriangleMesh& mesh, const SparseMatrix& L, const Eigen::VectorXd& areas, const Columns& fields, const ControlSets& sets,
                             const DetailCarriers& carriers, std::span<const HandleEnd> ends, double beta) {
    Assembly sums(mesh, L, areas, fields, sets, carriers);
    sums.run();
    const int n = sets.basis.controls();
    const double smoothness = beta * beta * (n - 1);
    for (int set = 0; set < sets.sets(); ++set)
        for (int j = 0; j + 1 < n; ++j)
            for (int r = 0; r < 4; ++r) {
                const int a = 4 * (set * n + j) + r, b = a + 4;
                sums.A(a, a) += smoothness;
                sums.A(b, b) += smoothness;
                sums.A(a, b) -= smoothness;
                sums.A(b, a) -= smoothness;
            }
    ReducedEnergy energy;
    substitute(sets, ends, energy);
    const Eigen::MatrixXd left = energy.P.transpose() * sums.A;
    energy.A = left * energy.P;
    energy.G = left * energy.Q;
    energy.C = energy.P.transpose() * sums.C;
    return energy;
}

Eigen::Vector3d blended(const Eigen::Vector3d& x, std::span<const ControlSets::Entry> entries, const Columns& d) {
    Eigen::RowVector3d offset = Eigen::RowVector3d::Zero();
    for (const ControlSets::Entry& e : entries) {
        const auto r = static_cast<Eigen::Index>(4 * e.control);
        offset += e.weight * (x[0] * d.row(r) + x[1] * d.row(r + 1) + x[2] * d.row(r + 2) + d.row(r + 3));
    }
    return x + offset.transpose();
}

} // namespace lissom

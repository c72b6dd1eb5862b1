#include "lissom/curve/pose.h"

#include "pose_state.h"

#include "lissom/mesh/errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace lissom {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

constexpr int k_rows = EncodedCurve::k_rows;

/// A row and how far it is to the next.
struct Between {
    int row;
    double share;
};
Between between(float row) {
    const int i = std::min(static_cast<int>(row), k_rows - 2);
    return {i, static_cast<double>(row) - i};
}

/// Maps of the rows of a curve laid out for the loop over vertices: four columns of a map (three numbers and a pad), then those of what
/// the next row has more.
using Column = Vector4d;
using Columns4 = std::vector<Column, Eigen::aligned_allocator<Column>>;
Columns4 columns_of(const std::vector<Matrix34>& maps, const Vector3d& moved_by) {
    Columns4 result(8 * k_rows, Column::Zero());
    for (int i = 0; i < k_rows; ++i)
        for (int k = 0; k < 4; ++k) {
            result[8 * i + k].head<3>() = maps[i].col(k);
            if (k == 3) result[8 * i + k].head<3>() += moved_by;
            if (i + 1 < k_rows) result[8 * i + 4 + k].head<3>() = maps[i + 1].col(k) - maps[i].col(k);
        }
    return result;
}

/// What the map between two rows makes of a point.
inline Column moved_between(const Columns4& columns, const Between& at, double x, double y, double z) {
    const Column* c = columns.data() + 8 * at.row;
    return (c[0] + at.share * c[4]) * x + (c[1] + at.share * c[5]) * y + (c[2] + at.share * c[6]) * z + (c[3] + at.share * c[7]);
}

void pose_singles(const SingleVertices& singles, const CurveRows& rows, const Vector3d& centre, const Points& rest, Points& out) {
    const Columns4 columns = columns_of(rows.affine, centre);
    const int count = static_cast<int>(singles.vertices.size());
    for (int i = 0; i < count; ++i) {
        const std::size_t v = 3 * static_cast<std::size_t>(singles.vertices[i]);
        const double* x = rest.data() + v;
        const Column sum = moved_between(columns, between(singles.rows[i]), x[0], x[1], x[2]);
        for (int k = 0; k < 3; ++k) out.data()[v + k] = sum[k];
    }
}

Vector3d moved(const Matrix34& map, const Vector3d& x) { return map.leftCols<3>() * x + map.col(3); }

/// Two numbers that GCC and Clang compute with at once, in WebAssembly too: left to themselves they do with half of the loop below.
using Pair = double __attribute__((vector_size(16)));

/// What blended vertices add up of a row: the motion (real, dual), then the columns of the map before it.
struct BlendNumbers {
    static constexpr int k_motion = 4, k_size = k_motion + 6; ///< pairs
    std::array<Pair, k_size> pairs{};

    [[nodiscard]] double operator[](int k) const { return pairs[k / 2][k % 2]; }
    void add(int k, double x) { pairs[k / 2][k % 2] += x; }
    [[nodiscard]] Vector4d real() const { return {(*this)[0], (*this)[1], (*this)[2], (*this)[3]}; }
    [[nodiscard]] Vector4d dual() const { return {(*this)[4], (*this)[5], (*this)[6], (*this)[7]}; }
    [[nodiscard]] Vector3d column(int c) const {
        const int k = 2 * k_motion + 3 * c;
        return {(*this)[k], (*this)[k + 1], (*this)[k + 2]};
    }
};
/// A row's, and what the next row has more.
struct BlendRow {
    BlendNumbers here, more;
};
using BlendRows = std::vector<BlendRow>;

std::vector<BlendRows> blend_rows(const std::vector<CurveRows>& all) {
    std::vector<BlendRows> result;
    for (const CurveRows& rows : all) {
        BlendRows& of = result.emplace_back(k_rows);
        for (int i = 0; i < k_rows; ++i) {
            for (int k = 0; k < 4; ++k) {
                of[i].here.add(k, rows.rigid[i].real[k]);
                of[i].here.add(4 + k, rows.rigid[i].dual[k]);
            }
            for (int k = 0; k < 12; ++k) of[i].here.add(8 + k, rows.before[i](k % 3, k / 3));
        }
        for (int i = 0; i + 1 < k_rows; ++i)
            for (int k = 0; k < BlendNumbers::k_size; ++k) of[i].more.pairs[k] = of[i + 1].here.pairs[k] - of[i].here.pairs[k];
    }
    return result;
}

/// The blend of a vertex's motions and that of the maps before them.
BlendNumbers blend_of(const BlendedVertices& blended, int i, const std::vector<BlendRows>& rows) {
    BlendNumbers sum;
    double left = 1;
    for (int k = blended.offsets[i]; k < blended.offsets[i + 1]; ++k) {
        const auto [row, share] = between(blended.rows[k]);
        const auto& [here, more] = rows[blended.curves[k]][row];
        const double weight = blended.weights[k];
        std::array<Pair, BlendNumbers::k_size> mixed;
        for (int j = 0; j < BlendNumbers::k_size; ++j) mixed[j] = here.pairs[j] + share * more.pairs[j];
        const Pair along = sum.pairs[0] * mixed[0] + sum.pairs[1] * mixed[1];
        const double sided = along[0] + along[1] < 0 ? -weight : weight; // motions on one hemisphere
        for (int j = 0; j < BlendNumbers::k_motion; ++j) sum.pairs[j] += sided * mixed[j];
        for (int j = BlendNumbers::k_motion; j < BlendNumbers::k_size; ++j) sum.pairs[j] += weight * mixed[j];
        left -= weight;
    }
    if (left > 1e-12) { // rests
        sum.add(3, sum[3] < 0 ? -left : left);
        for (int k = 0; k < 3; ++k) sum.add(8 + 4 * k, left);
    }
    return sum;
}

/// What a blend makes of a vertex. One quaternion turns it, so that no matrix is made of it: x + 2 r × (r × x + w x), and the translation of
/// the dual part. Both are of second degree in the blend, whose length is divided out at the end.
Vector3d moved(const BlendNumbers& blend, const double* x) {
    const Vector3d point = blend.column(0) * x[0] + blend.column(1) * x[1] + blend.column(2) * x[2] + blend.column(3);
    const Vector4d real = blend.real(), dual = blend.dual();
    const Vector3d r = real.head<3>(), d = dual.head<3>();
    return point + 2 / real.squaredNorm() * (r.cross(r.cross(point) + real[3] * point + d) + real[3] * d - dual[3] * r);
}

} // namespace

CurveSession::State::Posed CurveSession::State::posed(std::span<const CurvePosture> given) const {
    const int count = static_cast<int>(specs.size());
    if (static_cast<int>(given.size()) != count)
        throw InvalidInput("curve-count", "There are " + std::to_string(count) + " curves, but " + std::to_string(given.size()) + " postures.");
    Posed result;
    result.postures.assign(given.begin(), given.end());
    result.rows.resize(count);
    Matrix34 identity = Matrix34::Zero();
    identity.leftCols<3>().setIdentity();
    result.from_parent.assign(count, identity);
    for (const int c : order.order) {
        CurvePosture& posture = result.postures[c];
        if (posture.points.rows() == 0) posture.points = specs[c].rest;
        posture.points.rowwise() -= centre.transpose();
        if (const int l = order.link[c]; l >= 0) {
            const CurveLink& link = links[l];
            const Vector3d root = curves[c].curve().point(curves[c].options().anchor == CurveEnd::start ? 0.0 : 1.0);
            const Matrix34 map = curves[link.parent].motion_at(result.rows[link.parent], result.postures[link.parent], link.at, root);
            result.from_parent[c] = map;
            posture.points = ((posture.points * map.leftCols<3>().transpose()).rowwise() + map.col(3).transpose()).eval();
            posture.base = Eigen::Quaterniond(map.leftCols<3>()) * posture.base;
        }
        if (is_contour(c)) {
            result.rows[c] = pull(c, posture, result.from_parent[c]);
            continue;
        }
        result.rows[c] = curves[c].pose(posture, supports[c], options.encoding == CurveEncoding::kernel ? options.guard : CurveGuard::none);
        result.strain.bend = std::max(result.strain.bend, result.rows[c].bend);
        result.strain.tilt = std::max(result.strain.tilt, result.rows[c].tilt);
    }
    return result;
}

int CurveSession::curve_count() const { return static_cast<int>(state_->specs.size()); }

PosedPoints CurveSession::posed(std::span<const CurvePosture> postures) const {
    const State& s = *state_;
    const State::Posed posed = s.posed(postures);
    PosedPoints result{Points(s.rest.rows(), 3), posed.strain};
    Points& out = result.positions;
    for (const int v : s.resting) out.row(v) = s.given().row(v);
    const int count = curve_count();
    if (s.options.encoding == CurveEncoding::slabs) {
        std::vector<SlabTable::Planes> planes;
        for (int c = 0; c < count; ++c) planes.push_back(s.slabs[c].posed(s.curves[c], posed.postures[c]));
        for (int c = 0; c < count; ++c)
            for (std::size_t i = 0; i < s.singles[c].vertices.size(); ++i)
                out.row(s.singles[c].vertices[i]) = (SlabTable::position(planes[c], s.single_places[c][i]) + s.centre).transpose();
        for (std::size_t i = 0; i < s.blended.vertices.size(); ++i) {
            const int v = s.blended.vertices[i];
            Vector3d sum = Vector3d::Zero();
            double left = 1;
            for (int k = s.blended.offsets[i]; k < s.blended.offsets[i + 1]; ++k) {
                sum += s.blended.weights[k] * SlabTable::position(planes[s.blended.curves[k]], s.blended_places[k]);
                left -= s.blended.weights[k];
            }
            out.row(v) = (sum + left * s.rest.row(v).transpose() + s.centre).transpose();
        }
        return result;
    }
    for (int c = 0; c < count; ++c) pose_singles(s.singles[c], posed.rows[c], s.centre, s.rest, out);
    const std::vector<BlendRows> rows = blend_rows(posed.rows);
    for (int i = 0; i < static_cast<int>(s.blended.vertices.size()); ++i) {
        const std::size_t v = 3 * static_cast<std::size_t>(s.blended.vertices[i]);
        const Vector3d sum = moved(blend_of(s.blended, i, rows), s.rest.data() + v) + s.centre;
        for (int k = 0; k < 3; ++k) out.data()[v + k] = sum[k];
    }
    return result;
}

CurveStrain CurveSession::strain(std::span<const CurvePosture> postures) const { return state_->posed(postures).strain; }

CurveTable CurveSession::table(std::span<const CurvePosture> postures) const {
    const State::Posed posed = state_->posed(postures);
    CurveTable result;
    result.strain = posed.strain;
    result.texels.reserve(static_cast<std::size_t>(curve_count()) * k_rows * CurveTable::k_texels * 4);
    const auto put = [&](const auto& four) {
        for (int k = 0; k < 4; ++k) result.texels.push_back(static_cast<float>(four[k]));
    };
    for (const CurveRows& rows : posed.rows)
        for (int i = 0; i < k_rows; ++i) {
            put(rows.rigid[i].real);
            put(rows.rigid[i].dual);
            for (int k = 0; k < 3; ++k) put(Vector4d(rows.before[i].row(k).transpose()));
        }
    return result;
}

CurveAttributes CurveSession::attributes() const {
    const State& s = *state_;
    const std::size_t n = static_cast<std::size_t>(s.rest.rows());
    CurveAttributes result{std::vector<std::uint16_t>(4 * n, 0), std::vector<float>(4 * n, 0), std::vector<float>(4 * n, 0), s.centre, {}, {}};
    for (const EncodedCurve& curve : s.curves)
        for (int i = 0; i < k_rows; ++i) {
            const CurveFrame& frame = curve.frame_at(i);
            const Vector3d origin = frame.origin + s.centre;
            result.frames.insert(result.frames.end(), origin.data(), origin.data() + 3);
            result.frames.insert(result.frames.end(), frame.axes.data(), frame.axes.data() + 9);
            const EncodedCurve::RowSlope& slope = curve.row_slopes()[i];
            for (const Vector3d* part : {&slope.origin, &slope.along, &slope.bend}) result.slopes.insert(result.slopes.end(), part->data(), part->data() + 3);
        }
    const auto put = [&](int vertex, int slot, int curve, float row, double weight) {
        const std::size_t at = 4 * static_cast<std::size_t>(vertex) + static_cast<std::size_t>(slot);
        result.curves[at] = static_cast<std::uint16_t>(curve);
        result.rows[at] = row;
        result.weights[at] = static_cast<float>(weight);
    };
    for (int c = 0; c < curve_count(); ++c)
        for (std::size_t i = 0; i < s.singles[c].vertices.size(); ++i) put(s.singles[c].vertices[i], 0, c, s.singles[c].rows[i], 1);
    for (std::size_t i = 0; i < s.blended.vertices.size(); ++i)
        for (int first = s.blended.offsets[i], k = first; k < s.blended.offsets[i + 1]; ++k)
            put(s.blended.vertices[i], k - first, s.blended.curves[k], s.blended.rows[k], s.blended.weights[k]);
    return result;
}

Points CurveSession::normals(std::span<const CurvePosture> postures, const Points& normals) const {
    const State& s = *state_;
    const State::Posed posed = s.posed(postures);
    Points result = normals;
    const std::vector<BlendRows> blends = blend_rows(posed.rows);

    const auto turned = [&](int v, const Matrix3d& J) {
        Matrix3d cof;
        cof << J.col(1).cross(J.col(2)), J.col(2).cross(J.col(0)), J.col(0).cross(J.col(1));
        const Vector3d n = cof * normals.row(v).transpose();
        if (n.squaredNorm() > 0) result.row(v) = n.normalized().transpose();
    };
    for (int c = 0; c < curve_count(); ++c)
        for (std::size_t i = 0; i < s.singles[c].vertices.size(); ++i) {
            const int v = s.singles[c].vertices[i];
            const float row = s.singles[c].rows[i];
            const auto [at, share] = between(row);
            const Vector3d x = s.rest.row(v).transpose();
            const Matrix34 &here = posed.rows[c].affine[at], &next = posed.rows[c].affine[at + 1];
            const Matrix34 A = (1 - share) * here + share * next;
            turned(v, A.leftCols<3>() + (moved(next, x) - moved(here, x)) * s.curves[c].row_gradient(row, x).transpose());
        }
    for (int i = 0; i < static_cast<int>(s.blended.vertices.size()); ++i) {
        const int v = s.blended.vertices[i];
        const Vector3d x = s.rest.row(v).transpose();
        const BlendNumbers blend = blend_of(s.blended, i, blends);
        Matrix3d along = Matrix3d::Zero();
        for (int k = s.blended.offsets[i]; k < s.blended.offsets[i + 1]; ++k) {
            const int c = s.blended.curves[k];
            const int at = between(s.blended.rows[k]).row;
            const CurveRows& rows = posed.rows[c];
            along += s.blended.weights[k] * (moved(rows.affine[at + 1], x) - moved(rows.affine[at], x)) * s.curves[c].row_gradient(s.blended.rows[k], x).transpose();
        }
        Matrix3d before;
        before << blend.column(0), blend.column(1), blend.column(2);
        turned(v, Eigen::Quaterniond(blend.real().normalized()).toRotationMatrix() * before + along);
    }
    return result;
}

double CurveSession::drag_limit(std::span<const CurvePosture> from, std::span<const CurvePosture> to) const {
    const CurveStrain before = strain(from);
    const bool guarded = state_->options.guard != CurveGuard::none && state_->options.encoding == CurveEncoding::kernel;
    const auto fits = [&](double share) {
        std::vector<CurvePosture> at(from.begin(), from.end());
        for (std::size_t c = 0; c < at.size(); ++c) {
            const Points& rest = state_->specs[c].rest; // stands for points that are not given
            at[c].points = (1 - share) * (from[c].points.rows() ? from[c].points : rest) + share * (to[c].points.rows() ? to[c].points : rest);
            at[c].base = from[c].base.slerp(share, to[c].base);
            for (std::size_t k = 0; k < std::min(from[c].twist.size(), to[c].twist.size()); ++k) at[c].twist[k] = (1 - share) * from[c].twist[k] + share * to[c].twist[k];
            for (std::size_t k = 0; k < std::min(from[c].scale.size(), to[c].scale.size()); ++k)
                for (int a : {0, 1}) at[c].scale[k][a] = (1 - share) * from[c].scale[k][a] + share * to[c].scale[k][a];
        }
        const CurveStrain then = strain(at);
        return guarded ? then.tilt <= std::max(k_tilt, before.tilt) : then.bend <= std::max(k_bend, before.bend);
    };
    if (fits(1)) return 1;
    double low = 0, high = 1;
    for (int i = 0; i < 12; ++i) (fits((low + high) / 2) ? low : high) = (low + high) / 2;
    return low;
}

std::vector<Eigen::Affine3d> CurveSession::parent_motions(std::span<const CurvePosture> postures) const {
    const State::Posed posed = state_->posed(postures);
    std::vector<Eigen::Affine3d> result;
    for (const Matrix34& map : posed.from_parent) { // in source space: c + A (x − c) + b
        Eigen::Affine3d at = Eigen::Affine3d::Identity();
        at.linear() = map.leftCols<3>();
        at.translation() = map.col(3) + state_->centre - map.leftCols<3>() * state_->centre;
        result.push_back(at);
    }
    return result;
}

std::vector<int> CurveSession::region(int curve) const { return state_->regions.at(curve); }
CurveEnd CurveSession::anchor(int curve) const { return state_->curves.at(curve).options().anchor; }
std::vector<double> CurveSession::radii(int curve) const { return state_->radii.at(curve); }
const CurveSeconds& CurveSession::seconds() const { return state_->seconds; }
const std::vector<Finding>& CurveSession::warnings() const { return state_->warnings; }

double CurveSession::memory_bytes() const {
    const State& s = *state_;
    double sum = 24.0 * static_cast<double>(s.rest.rows());
    for (const SingleVertices& single : s.singles) sum += 8.0 * static_cast<double>(single.vertices.size());
    for (const auto& places : s.single_places) sum += static_cast<double>(places.size() * sizeof(SlabPlace));
    sum += 8.0 * static_cast<double>(s.blended.vertices.size()) + 16.0 * static_cast<double>(s.blended.curves.size());
    for (const std::vector<int>& region : s.regions) sum += 4.0 * static_cast<double>(region.size());
    return sum + static_cast<double>(s.curves.size()) * EncodedCurve::k_rows * (EncodedCurve::k_finer * 112.0 + sizeof(RowSupport));
}

} // namespace lissom

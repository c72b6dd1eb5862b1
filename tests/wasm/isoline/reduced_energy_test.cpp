#include "lissom/isoline/reduced_energy.h"

#include "sessions.h"

#include "lissom/isoline/carriers.h"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>

using namespace lissom;
using namespace sessions;

namespace {

struct Case {
    Fielded f;
    std::vector<HandleEnd> ends;
    ControlSets sets;
    Carriers carriers;

    Case(const TriangleMesh& mesh, int handles, std::vector<HandleEnd> given = {})
        : f(mesh, axis_caps(mesh.points, handles)), ends(given.empty() ? std::vector<HandleEnd>(static_cast<std::size_t>(handles)) : std::move(given)),
          sets{FieldBasis(BasisKind::quadratic, 6), handles}, carriers(patch_carriers(f.mesh, f.fields, f.handle, ends, {.count = 20})) {}
    [[nodiscard]] ReducedEnergy energy(double beta = 0.03) const {
        return reduced_energy(f.mesh, f.laplacian, f.areas, f.fields, sets, carriers.details, ends, beta);
    }
};

/// The same energy without any of its structure: W and L as dense matrices.
double direct(const Case& c, const Columns& d, const std::vector<Eigen::Matrix3d>& R, double beta) {
    const int n = c.f.mesh.vertex_count();
    Points moved(n, 3);
    std::vector<ControlSets::Entry> entries;
    for (int v = 0; v < n; ++v) {
        c.sets.entries_at({c.f.fields.data() + v * c.f.fields.cols(), static_cast<std::size_t>(c.f.fields.cols())}, entries);
        moved.row(v) = blended(c.f.mesh.points.row(v), entries, d).transpose();
    }
    const Points left = c.f.laplacian * moved, delta = c.f.laplacian * c.f.mesh.points;
    double sum = 0;
    for (int v = 0; v < n; ++v) {
        const int carrier = c.carriers.details.shares[c.carriers.details.offsets[v]].carrier;
        sum += (left.row(v).transpose() - R[carrier] * delta.row(v).transpose()).squaredNorm() / c.f.areas[v];
    }
    const int controls = c.sets.basis.controls();
    for (int set = 0; set < c.sets.sets(); ++set)
        for (int j = 0; j + 1 < controls; ++j)
            sum += beta * beta * (controls - 1) * (d.middleRows<4>(4 * (set * controls + j)) - d.middleRows<4>(4 * (set * controls + j + 1))).squaredNorm();
    return sum;
}

} // namespace

TEST_CASE("the solution of the assembled system is the least of the energy written out") {
    for (const int handles : {2, 3}) {
        std::vector<HandleEnd> ends(static_cast<std::size_t>(handles));
        if (handles == 3) ends[2] = {HandleEnd::Kind::point, {0.1, 0.2, 0.3}};
        const Case c(shapes::bumpy_sphere(3), handles, ends);
        const double beta = 0.2;
        const ReducedEnergy e = c.energy(beta);
        CHECK((e.A - e.A.transpose()).norm() < 1e-9 * e.A.norm());
        std::vector<Eigen::Matrix3d> R;
        Columns turns(3 * c.carriers.details.count, 3);
        for (int k = 0; k < c.carriers.details.count; ++k) {
            R.push_back(Eigen::AngleAxisd(0.03 * k, Eigen::Vector3d(1, k, 2).normalized()).toRotationMatrix());
            turns.middleRows<3>(3 * k) = (R.back() - Eigen::Matrix3d::Identity()).transpose();
        }
        Columns h = Columns::Zero(e.handle_rows.back(), 3);
        for (Eigen::Index k = 0; k < h.size(); ++k) h.data()[k] = 0.05 * std::sin(3.0 * k);
        const Columns u = e.A.ldlt().solve(e.C * turns - e.G * h);
        const auto at = [&](const Columns& x) { return direct(c, e.P * x + e.Q * h, R, beta); };
        const double least = at(u);
        for (int k = 0; k < 12; ++k) { // a quadratic's least: symmetric rise in every direction
            Columns step(u.rows(), 3);
            for (Eigen::Index i = 0; i < step.size(); ++i) step.data()[i] = std::sin(1.7 * i + k);
            step *= 1e-3;
            const double up = at(u + step) - least, down = at(u - step) - least;
            CHECK(up > 0);
            CHECK(down > 0);
            CHECK(std::abs(up - down) < 1e-6 * (up + down) + 1e-9 * least);
        }
    }
}

TEST_CASE("handles are substituted: a region's control is what it prescribes, a point goes where it is sent") {
    const Eigen::Vector3d p(0.1, -0.2, 0.05);
    const Case c(shapes::bumpy_sphere(2), 3, {{HandleEnd::Kind::region}, {HandleEnd::Kind::point, p}, {HandleEnd::Kind::open}});
    const ReducedEnergy e = c.energy();
    CHECK(e.handle_rows == std::vector<int>{0, 4, 5, 5});
    CHECK(e.unknowns() == 4 * 18 - 4 - 1);
    Columns h = Columns::Zero(5, 3), u(e.unknowns(), 3);
    for (Eigen::Index i = 0; i < u.size(); ++i) u.data()[i] = std::sin(2.0 * i);
    h.row(3) << 1, 2, 3;
    h.row(4) << -4, 5, 6;
    const Columns d = e.P * u + e.Q * h;
    const std::vector<ControlSets::Entry> region{{c.sets.end_control(0), 1, 0}}, point{{c.sets.end_control(1), 1, 0}};
    CHECK((blended(Eigen::Vector3d(7, 7, 7), region, d) - Eigen::Vector3d(8, 9, 10)).norm() < 1e-12);
    CHECK((blended(p, point, d) - (p + Eigen::Vector3d(-4, 5, 6))).norm() < 1e-12);
}

TEST_CASE("four times as many triangles have the same least energy within a tenth") {
    // The printed sum would grow by four: it has no areas in it.
    const auto bent = [](int levels) {
        const Case c(shapes::bumpy_sphere(levels), 2);
        const ReducedEnergy e = c.energy();
        Columns h = Columns::Zero(e.handle_rows.back(), 3);
        h.row(7) << 0.1, 0.2, 0; // the second handle moves
        const Columns u = e.A.ldlt().solve(-e.G * h);
        return direct(c, e.P * u + e.Q * h, std::vector<Eigen::Matrix3d>(static_cast<std::size_t>(c.carriers.details.count), Eigen::Matrix3d::Identity()), 0.03);
    };
    CHECK(bent(5) == doctest::Approx(bent(4)).epsilon(0.1));
}

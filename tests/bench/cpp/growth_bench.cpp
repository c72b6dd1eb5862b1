// Times the growth of a whole head of hair, detail included, one line of JSON per count of strands.
//
//   growth_bench [--strands 20000,100000]

#include "options.h"

#include "lissom/hair/hair_session.h"
#include "lissom/mesh/stopwatch.h"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace {

using namespace lissom;
using Eigen::Vector3d;

constexpr double k_pi = std::numbers::pi;

Vector3d on_egg(double down, double round, double above = 0) {
    const Vector3d way(std::sin(down) * std::sin(round), std::cos(down), std::sin(down) * std::cos(round));
    return way.cwiseProduct(Vector3d(0.09, 0.12, 0.1)) + above * way;
}

/// An egg 24 cm high; hair grows on its upper half.
struct Egg {
    static constexpr int rows = 40, columns = 80;
    TriangleMesh mesh;
    std::vector<int> scalp;

    Egg() {
        mesh.points.resize(rows * columns + 2, 3);
        mesh.triangles.resize(2 * rows * columns, 3);
        const int top = rows * columns, bottom = top + 1;
        for (int r = 0; r < rows; ++r)
            for (int c = 0; c < columns; ++c) {
                mesh.points.row(r * columns + c) = on_egg(k_pi * (r + 1) / (rows + 1), 2 * k_pi * c / columns).transpose();
                if (2 * r < rows) scalp.push_back(r * columns + c);
            }
        mesh.points.row(top) = on_egg(0, 0).transpose();
        mesh.points.row(bottom) = on_egg(k_pi, 0).transpose();
        scalp.push_back(top);
        Eigen::Index t = 0;
        for (int c = 0; c < columns; ++c) {
            const int next = (c + 1) % columns;
            mesh.triangles.row(t++) << top, c, next;
            mesh.triangles.row(t++) << bottom, (rows - 1) * columns + next, (rows - 1) * columns + c;
            for (int r = 0; r + 1 < rows; ++r) {
                const int a = r * columns + c, b = r * columns + next;
                mesh.triangles.row(t++) << a, a + columns, b + columns;
                mesh.triangles.row(t++) << a, b + columns, b;
            }
        }
    }

    /// Combed down on all sides from a parting.
    [[nodiscard]] static HairStyle style() {
        HairStyle out;
        for (int k = 0; k < 12; ++k) {
            StreamCurve curve;
            for (double down = 0.25; down < 2.4; down += 0.1) curve.points.push_back(on_egg(down, k_pi / 6 * (k + 0.5), 0.006));
            out.streams.push_back(curve);
        }
        DividingCurve parting;
        for (double down = 0.8; down > 0; down -= 0.1) parting.points.push_back(on_egg(down, 0));
        out.partings.push_back(parting);
        return out;
    }
};

} // namespace

int main(int argc, char** argv) {
    const bench::Options options(argc, argv);
    const Egg egg;
    HairSession session(egg.mesh, egg.scalp);
    while (session.step()) {}
    session.set_style(Egg::style());
    GrowthOptions growth;
    growth.length = 0.26;
    growth.length_variation = 0;
    for (const int count : options.numbers("--strands", "20000,100000")) {
        Stopwatch watch;
        HairSession::Growth work = session.grow(0, count, growth, {});
        while (work.step()) {}
        const double seconds = watch.lap();
        const Strands hair = work.take();
        const double points = hair.offsets.back();
        std::printf("{\"strands\": %d, \"segments each\": %.1f, \"seconds\": %.2f, \"µs a point\": %.2f, \"MB held\": %.0f}\n",
                    count, points / count - 1, seconds, 1e6 * seconds / points,
                    (hair.points.capacity() + hair.root_weights.capacity() + hair.root_uvs.capacity()) * 4e-6 +
                        (hair.offsets.capacity() + hair.root_triangle.capacity() + hair.clumps.capacity()) * 4e-6);
    }
}
